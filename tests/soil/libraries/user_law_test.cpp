#include "io/case/case_file.hpp"
#include "run/loop/follower.hpp"
#include "support/laws.hpp"
#include "support/process.hpp"
#include "support/simulations.hpp"
#include "soil/libraries/user_law.hpp"

namespace user_law_test {

const std::string example = source_path("cases/user_law/column.toml");

/// The example as a case whose libraries lie in the folder of the tests.
Case case_with(const std::vector<std::string>& changes)
{
  return read_case_text(text_of(example), law_folder() + "/column.toml", changes).values;
}

const std::vector<std::string> own_law{"material.clay.model=\"tresca_softening\"", "material.clay.su_peak=8e3",
    "material.clay.su_residual=2e3", "material.clay.eta=50.0"};

/// The example with Terp's own law instead.
Case case_of_own_law(const std::vector<std::string>& changes)
{
  std::string text;
  std::istringstream lines(text_of(example));
  for (std::string line; std::getline(lines, line);) {
    const auto begins = [&](const char* key) { return line.starts_with(key); };
    if (!begins("library") && !begins("interface") && !begins("parameters") && !begins("state") &&
        !begins("thread_safe"))
      text += line + '\n';
  }
  std::vector<std::string> all = changes;
  all.insert(all.end(), own_law.begin(), own_law.end());
  return read_case_text(text, law_folder() + "/column.toml", all).values;
}

/// Largest difference of a number of the points, over its largest size.
Real difference(const std::vector<Point>& a, const std::vector<Point>& b, const std::function<Real(const Point&)>& of)
{
  Real most = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    most = std::max(most, std::abs(of(a[k]) - of(b[k])));
    scale = std::max(scale, std::abs(of(b[k])));
  }
  return most / scale;
}

class UserLaw : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override
  {
    if (!is_built("tresca.so")) GTEST_SKIP() << "there is no gfortran";
  }
};

TEST_P(UserLaw, OfTrescaInFortranGivesTheNumbersOfTerpsOwn)
{
  // Local damping and contact follow the sign of velocities, be they round-off: not here.
  const std::vector<std::string> changes{std::string("scheme=\"") + GetParam() + '"', "mesh.cell=0.5",
      "forces.damping.local=0", "boundary.bottom=\"fixed\"",
      "method.pressure=\"constant\""};  // a law of a library does not say that its strength ignores the pressure
  Simulation mine(case_with(changes)), own(case_of_own_law(changes));
  make_steps(mine, 100), make_steps(own, 100);
  const std::vector<Point> a = points_by_id(mine.state), b = points_by_id(own.state);
  EXPECT_GT(std::ranges::max(b, {}, &Point::eps_eq_p).eps_eq_p(), 0.01);  // it has failed and softened
  for (int k = 0; k < 4; ++k) EXPECT_LT(difference(a, b, [k](const Point& p) { return p.sigma[k]; }), 1e-12);
  EXPECT_LT(difference(a, b, [](const Point& p) { return p.eps_eq_p(); }), 1e-12);
  EXPECT_LT(difference(a, b, [](const Point& p) { return p.x[0]; }), 1e-12);
  EXPECT_NEAR(mine.state.work.plastic, own.state.work.plastic, 1e-12 * own.state.work.plastic);
}

TEST_P(UserLaw, GivesTheSameBitsOnOneAndTwoThreadsAndFromACheckpoint)
{
  const std::string scheme = std::string("scheme=\"") + GetParam() + '"';
  for (const char* safe : {"true", "false"})
    expect_same_bits(case_with({scheme, std::string("material.clay.thread_safe=") + safe}), {2}, {}, 60);
  const Case coarse = case_with({scheme, "mesh.cell=0.5"});
  expect_same_bits(coarse, {2}, {30.0 * build_model(coarse, 1).dt}, 60);
}

INSTANTIATE_TEST_SUITE_P(Schemes, UserLaw, testing::Values("mpm_gp", "mpm_mixed", "standard_mpm"),
    [](const auto& info) { return info.param; });

/// A cell of four points of a law that remembers a plastic strain and a strength in kPa.
Case cell_of_library(Real residual_strength)
{
  LibraryCase library{
      .file = "wrong_umat.so", .interface = LawInterface::umat, .state = {{"k", 0.0}, {"cu", 8.0}}, .stress_unit = 1e3};
  Case c = clamped_cell("mpm_gp");
  MaterialCase& clay = c.materials[0];
  clay.model = "library";
  clay.parameters = {1e6, 0.3};
  clay.from_library = load_user_law("clay", law_folder(), clay.parameters, library,
      {.plastic_strain = "k", .strength = "cu", .residual_strength = residual_strength});
  return c;
}

/// Gives one point a plastic strain and a strength [kPa].
void set_one(Simulation& s, Real strain, Real strength)
{
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    if (block.row(Rows::id)[lane] != 2.0) return;
    block.row(Rows::state)[lane] = strain, block.row(Rows::state + 1)[lane] = strength;
  });
}

/// Leaves one point with 4.9 kPa, and looks at the soil.
void soften_one(Simulation& s)
{
  set_one(s, 0.3, 4.9);
  for (const ActiveFollower& active : s.state.followers) active.follower->frame(s.model, s.state);
}

std::vector<Real> softened(Real residual_strength)
{
  Simulation s = followed(cell_of_library(residual_strength));
  soften_one(s);
  std::vector<Real> shares;
  for (const auto& [time, share] : summarise(s.model, s.state).softened_fraction) shares.push_back(share);
  return shares;
}

TEST(UserLawRoles, CountSoilThatSoftenedByTheStrengthThatTheCaseNames)
{
  EXPECT_THAT(softened(2e3), ElementsAre(DoubleNear(0.25, 1e-15)));  // half of the drop is done at 5 kPa
  EXPECT_THAT(softened(1e3), ElementsAre(0.0));                      // at 4.5 kPa
  EXPECT_THAT(softened(std::numeric_limits<Real>::quiet_NaN()), ElementsAre()) << "nobody said what softening leaves";
}

TEST(UserLawRoles, MayHardenAsTheyStrain)
{
  for (const Real second_strain : {0.2, 0.05}) {
    Simulation s = followed(cell_of_library(2e3));
    set_one(s, 0.1, 8.5);
    keep_ledger(s.model, s.state, s.work);
    set_one(s, second_strain, 9.0);
    keep_ledger(s.model, s.state, s.work);
    const bool fell = second_strain < 0.1;
    EXPECT_EQ(summarise(s.model, s.state).points_eps_eq_p_fell, fell ? 1 : 0);
    EXPECT_EQ(summarise(s.model, s.state).points_su_rose, fell ? 1 : 0);
  }
}

TEST(UserLawRoles, KeepTheLowestStrengthForTheSummary)
{
  const auto lowest = [](const Simulation& s) {
    return summarise(s.model, s.state).numbers.at("lowest_library_strength");
  };
  Simulation s = followed(cell_of_library(2e3));
  EXPECT_EQ(lowest(s), 8e3);
  set_one(s, 0.3, -0.5);
  keep_ledger(s.model, s.state, s.work);
  set_one(s, 0.4, 1.0);
  keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(lowest(s), -500.0);
  Simulation later = followed(cell_of_library(2e3));
  later.restore(s.save());
  EXPECT_EQ(lowest(later), -500.0);
  EXPECT_TRUE(std::isnan(lowest(followed(clamped_cell("mpm_gp"))))) << "Terp keeps its own strengths above zero";
}

TEST(UserLawRoles, ShowTheStrengthInPascal)
{
  Simulation s = followed(cell_of_library(2e3));
  soften_one(s);
  EXPECT_THAT(s.field("su").values, ElementsAre(8e3, 8e3, DoubleNear(4.9e3, 1e-9), 8e3));
}

/// A case of two bodies of an ESM, one of which a stage places.
std::string message_of_esm(const std::string& scheme, const std::string& material)
{
  const std::string law =
      "model = \"library\"\nlibrary = \"wrong_umat.so\"\ninterface = \"esm\"\nstate = 1\ndensity = 2000.0\n"
      "shear_modulus = 1e6\npoisson_ratio = 0.3\n";
  const std::string text = "scheme = \"" + scheme +
                           "\"\n[mesh]\nsize = [4.0, 2.0]\ncell = 0.5\n[[body]]\nmaterial = \"clay\"\n"
                           "box = [[0, 0], [4, 1]]\n[[body]]\nname = \"berm\"\nmaterial = \"" +
                           material +
                           "\"\nbox = [[0, 1], [2, 2]]\n[[stage]]\nname = \"a\"\nduration = 1\n[[stage]]\n"
                           "name = \"b\"\nduration = 1\nramp = 0.5\nplace = [\"berm\"]\n[material.clay]\n" +
                           law + "[material.sand]\n" + law;
  return refusal<CaseError>([&] { read_case_text(text, law_folder() + "/esm.toml", {}); });
}

TEST(EsmInStages, ThatSetsItsStateInItsFirstCallIsNotPlacedBesideItselfInASchemeThatAverages)
{
  EXPECT_THAT(message_of_esm("mpm_mixed", "clay"),
      AllOf(HasSubstr("soil of the ESM `clay` cannot come to soil of it that is there"), HasSubstr("place = [")));
  EXPECT_EQ(message_of_esm("mpm_mixed", "sand"), "");
  EXPECT_EQ(message_of_esm("mpm_gp", "clay"), "");
}

}  // namespace user_law_test
