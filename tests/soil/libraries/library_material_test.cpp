#include "soil/libraries/library_material.hpp"
#include "support/law_cases.hpp"
#include "support/process.hpp"
#include "support/stages.hpp"
#include "model/libraries/law_cost.hpp"

#include <cfenv>
#include <sys/wait.h>

namespace library_material_test {

TEST(LibraryMaterial, ThatReturnsNoNumberStopsTheRunAndSaysWhichPoint)
{
  const std::string said = fault_of("mpm_gp", wrong_umat(nan_stress, 0.0, 2.0));
  EXPECT_THAT(said, HasSubstr("step 1, t = "));
  EXPECT_THAT(said, HasSubstr("the law returned a stress that is not a number\n\n  where    material `soft clay`, "
                              "material point "));
  EXPECT_THAT(said, HasSubstr(" at x = 2."));
  EXPECT_THAT(said, HasSubstr("library  wrong_umat.so (umat, umat_)"));
  EXPECT_THAT(said, HasSubstr("before   stress xx yy zz xy = "));
  EXPECT_THAT(said, HasSubstr("try      the law with these numbers by itself; then mend the library"));
  EXPECT_THAT(said, HasSubstr("Or give `kinematics`, if\n           it reads STRAN, DFGRD0 or DFGRD1"));
  LibraryCase knows_all = wrong_umat(nan_stress).library;
  knows_all.kinematics = {"strain", "deformation_gradient"};
  EXPECT_THAT(fault_of("mpm_gp", of_library(knows_all)), Not(HasSubstr("kinematics")));
  EXPECT_THAT(fault_of("mpm_mixed", wrong_umat(nan_state, 0.0, 2.0)),
      AllOf(HasSubstr("a state variable that is not a number"), HasSubstr("Gauss point ")));
}

TEST(LibraryMaterial, ThatGoesWrongStopsTheRunWithAReasonAndACure)
{
  const LibraryCase esm{.file = "wrong_umat.so", .interface = LawInterface::esm, .state = {{"a", 0.0}, {"b", 0.0}}};
  const struct {
    const char* scheme;
    MaterialCase material;
    std::vector<std::string> words;
  } rows[] = {{"mpm_gp", wrong_umat(never_small),
                  {"the law asks for parts of the step smaller than 1/4096 of it (PNEWDT = 0.5)",
                      "try      a lower time.courant"}},
      {"mpm_gp", wrong_umat(nan_answer), {"the law returned a PNEWDT that is not a number"}},
      {"mpm_gp", wrong_umat(beyond_state),
          {"the law writes beyond its array STATEV, of 1 numbers\n",
              "try      a larger `state` of the material: the law has more variables"}},
      {"mpm_mixed", wrong_umat(beyond_state, 0.0, -100.0, 0), {"STATEV, of 0 numbers"}},
      {"mpm_gp", wrong_umat(adds_beyond_state), {"beyond its array STATEV, of 1 numbers"}},
      {"mpm_gp", wrong_umat(beyond_props), {"try      more `parameters` of the material"}},
      {"mpm_gp", wrong_umat(reads_props), {"a stress that is not a number"}},
      {"mpm_gp", of_library(esm), {"STATEV, of 2 numbers"}},
      {"mpm_gp", of_library(native("writing_state_law", 3e6)),
          {"the law writes beyond its state, of 2 numbers\n",
              "material points that it had at once, the first: ", "try      a larger n_state in the description"}},
      {"mpm_gp", of_library(native("failing_law", shear)),
          {"the law says: the void ratio is negative", "(native, failing_law)"}}};
  for (const auto& [scheme, material, words] : rows) {
    const std::string said = fault_of(scheme, material);
    for (const std::string& part : words) EXPECT_THAT(said, HasSubstr(part));
  }
}

TEST(LibraryMaterial, ThatFailedLeavesTheStateOfTheStepBeforeInNumbers)
{
  Simulation s(moving_box("mpm_gp", wrong_umat(nan_stress, 5e-3)), 1);
  EXPECT_THAT(refusal<RunError>([&] { s.step(100); }), HasSubstr("a stress that is not a number"));
  EXPECT_GT(s.state.step, 2);
  for (const Point& p : points_by_id(s.state))
    for (const Real value : p.sigma) EXPECT_TRUE(std::isfinite(value));
}

TEST(LibraryMaterial, ThatThrowsStopsTheRun)
{
  struct Throws final : LawCalls {
    void run(LawPoints& points) const override
    {
      points.at = 0;
      throw std::runtime_error("no convergence");
    }
  };
  const MaterialCase material = wrong_umat(elastic_law);
  LibraryInUse in_use;
  in_use.material = "clay", in_use.title = "law.so", in_use.shear_modulus = shear;
  in_use.calls = std::make_shared<Throws>();
  const LibraryMaterial law(material.from_library, in_use, material.parameters);
  std::array<Real, 8> zero{};
  StressArrays<2> arrays{};
  arrays.plastic_work = zero.data(), arrays.n = arrays.n_points = 8;
  for (int k = 0; k < 4; ++k) arrays.sigma[k] = zero.data(), arrays.d_eps[k] = zero.data();
  law.update(arrays);
  EXPECT_THAT(law.fault(), AllOf(StartsWith("the law threw an exception: no convergence\n\n  where    material `clay`"),
                               HasSubstr("library  law.so")));
}

using LibraryMaterialDeathTest = testing::Test;

TEST(LibraryMaterialDeathTest, ThatEndsTheProgramIsNamed)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(fault_of("mpm_gp", wrong_umat(leaves)), testing::ExitedWithCode(3),
      "error: the law of material `soft clay` ended the program \\(STOP, XIT or exit\\)");
}

TEST(LibraryMaterialDeathTest, ThatCopiesTheProgramMakesNoSecondTerp)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto run = [] {
    Simulation s(moving_box("mpm_gp", wrong_umat(copies_itself)), 1);
    s.step(2);
    int status = 0;  // of the copy; a copy that came to here has none, and ends with 1
    const bool is_mine = ::wait(&status) > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 3;
    std::exit(is_mine ? 0 : 1);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST(LibraryMaterial, ThatWantsSmallerStepsIsGivenThem)
{
  Simulation parts(moving_box("mpm_gp", wrong_umat(small_parts, 0.0, -100.0, 1, 1e-4)), 1);
  Simulation whole(moving_box("mpm_gp", wrong_umat(elastic_law)), 1);
  parts.step(10), whole.step(10);
  expect_same_stresses(parts, whole);
  Real most_calls = 0.0;
  for (const Point& p : points_by_id(parts.state)) most_calls = std::max(most_calls, p.values[0]);
  for (const Point& p : points_by_id(whole.state)) EXPECT_EQ(p.values[0], 10.0);
  EXPECT_GT(most_calls, 20.0);  // its state counts the calls that were taken
}

TEST(LibraryMaterial, ThatWantsTenthsOfAStepIsCalledTenTimes)
{
  const Real dt = Simulation(moving_box("mpm_gp", wrong_umat(elastic_law)), 1).model.dt;
  Simulation s(moving_box("mpm_gp", wrong_umat(tenths, 0.0, -100.0, 1, 0.15 * dt)), 1);
  s.step(1);
  for (const Point& p : points_by_id(s.state)) EXPECT_EQ(p.values[0], 10.0);
}

TEST(LibraryMaterial, ThatChangesRoundingChangesThatOfItsOwnCallsAlone)
{
  Simulation(moving_box("mpm_gp", wrong_umat(changes_rounding)), 1).step(2);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(LibraryMaterial, WhoseStateHasTheNameOfARowOfAnotherKindIsRefused)
{
  LibraryCase library{.file = "wrong_umat.so", .interface = LawInterface::umat, .state = {{"inverse_extent", 0.0}}};
  EXPECT_THAT(refusal<InputError>([&] { build_model(moving_box("mpm_gp", of_library(library)), 1); }),
      HasSubstr("two quantities of the points have the name `inverse_extent`"));
  Case c = moving_box("mpm_gp", of_library({.file = "wrong_native.so", .symbol = "held_law"}));
  library.state = {{"held", 0.0}};
  c.materials.push_back(of_library(library));
  c.materials[1].name = "other";
  c.bodies.push_back(body("other", {0.5, 1.0}, {3.5, 1.5}));
  EXPECT_THAT(refusal<InputError>([&] { build_model(c, 1); }), HasSubstr("in Pa, the other"));
}

TEST(LibraryMaterial, TakesTurnsWithAllOfTheSameFileWhateverItsPath)
{
  const ScratchFolder scratch;
  const std::string file = law_folder() + "/wrong_umat.so", link = scratch.path() + "/law.so";
  std::filesystem::create_symlink(file, link);
  EXPECT_EQ(turns_of(file), turns_of(law_folder() + "/./wrong_umat.so"));
  EXPECT_EQ(turns_of(file), turns_of(link));
  EXPECT_NE(turns_of(file), turns_of(law_folder() + "/elastic.so"));
}

TEST(LibraryMaterial, IsElasticWhereItsLawIs)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed", "standard_mpm"}) {
    Simulation mine(moving_box(scheme, wrong_umat(elastic_law)), 1);
    Simulation own(moving_box(scheme, elastic(shear, poisson, 1900.0)), 1);
    mine.step(30), own.step(30);
    expect_same_stresses(mine, own);
    EXPECT_NEAR(mine.state.work.plastic, 0.0, 1e-12 * 2850.0);  // of the energy of its motion [J]
  }
}

TEST(LibraryMaterial, ThatIsNotThreadSafeIsCalledByOneThreadAtATime)
{
  Simulation s(moving_box("mpm_gp", wrong_umat(counts)), 2);  // a static counter
  s.step(3);
  std::set<Real> counts_seen;
  for (const Point& p : points_by_id(s.state)) counts_seen.insert(p.values[0]);
  EXPECT_EQ(counts_seen.size(), points_by_id(s.state).size());  // no number twice, none lost
  EXPECT_EQ(*counts_seen.rbegin() - *counts_seen.begin(), static_cast<Real>(counts_seen.size() - 1));
}

TEST(LibraryMaterial, KeepsStrainAndDeformationGradientForALawThatAsks)
{
  LibraryCase library = library_case("wrong_umat.so", LawInterface::umat, {shear, poisson, 0.0, 0.0, -100.0, 0.0},
      {{"calls"}, {"seen_dt"}, {"seen_f11"}, {"seen_f12"}, {"seen_strain"}});
  library.kinematics = {"strain", "deformation_gradient"};
  Case c = free_box("mpm_gp", {0.5, 0.5}, {3.5, 1.5}, of_library(library));
  c.bodies[0].velocity_at = [](Vec<2> x) -> Vec<2> { return {0.5 * (x[0] - 2.0), 0.0}; };  // extension along x
  Simulation s(c);
  s.step(10);
  for (const Point& p : points_by_id(s.state)) {
    if (std::abs(p.x[0] - 2.0) > 0.5 || std::abs(p.x[1] - 1.0) > 0.3) continue;
    EXPECT_EQ(p.values[1], s.model.dt);
    EXPECT_NEAR(p.values[4], p.strain[0], 1e-14);
    EXPECT_NEAR(p.values[2], std::exp(p.strain[0]), 0.3 * p.strain[0] * p.strain[0] + 1e-4);
  }
  EXPECT_EQ(s.model.rows.added().size(), 5u + 9u + 1u);  // and the extent of overlapping shares
}

TEST(LibraryMaterial, WithMoreStateThanCellsTakeFromTheirNeighboursIsRefused)
{
  const MaterialCase material = wrong_umat(elastic_law, 0.0, -100.0, 20);
  EXPECT_THAT(refusal<InputError>([&] { build_model(moving_box("mpm_mixed", material), 1); }),
      AllOf(HasSubstr("the law has too many state variables for this scheme"),
          HasSubstr("20 numbers of each point; mpm_mixed has room for 18")));
  Simulation s(moving_box("mpm_gp", material), 1);
  s.step(2);
  EXPECT_EQ(points_by_id(s.state)[0].values[0], 2.0);
}

TEST(LibraryMaterial, IsToldOfTheRotationThatItsStressHasMade)
{
  for (const bool turned : {true, false}) {
    Simulation s(turning_box(wrong_umat(turns), turned));
    s.step(1);
    for (const Point& p : points_by_id(s.state))
      if (std::abs(p.x[0] - 2.0) < 0.5 && std::abs(p.x[1] - 1.0) < 0.25) {
        EXPECT_NEAR(p.values[0], turned ? std::sin(0.4 * s.model.dt) : 0.0, 1e-9);  // DROT(2, 1)
      }
  }
}

// Stretched in the first step, turned in the second, by velocities that are linear in the place. Almost no stress.
TEST(LibraryMaterial, IsToldTheStrainAndTheDeformationGradientOfSoilThatStretchesAndTurns)
{
  LibraryCase library = library_case("wrong_umat.so", LawInterface::umat, {1.0, poisson, 0.0, 0.0, -100.0, 0.0});
  for (int k = 0; k < 8; ++k) library.state.push_back({"seen_" + std::to_string(k), 0.0});
  library.kinematics = {"strain", "deformation_gradient"};
  Case c = free_box("mpm_gp", {0.5, 0.25}, {3.5, 1.75}, of_library(library));
  c.method.objective_rate = ObjectiveRate::jaumann;
  constexpr Real a = 8.0, b = 6.0, w = 10.0;  // [1/s]
  c.bodies[0].velocity_at = [](Vec<2> x) -> Vec<2> { return {a * (x[0] - 2.0) + 2.0 * b * (x[1] - 1.0), 0.0}; };
  Simulation s(c);
  s.step(1);
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
    block.row(Rows::v)[lane] = -w * (block.row(Rows::x + 1)[lane] - 1.0);
    block.row(Rows::v + 1)[lane] = w * (block.row(Rows::x)[lane] - 2.0);
  });
  s.step(1);
  const Real dt = s.model.dt, t = w * dt, e = a * dt, g = b * dt;  // g: tensorial shear strain, and -spin
  const Real expected[] = {1.0 + e, 2.0 * g - t, t * (1.0 + e), 1.0 + 2.0 * g * t,
      e * std::cos(t) * std::cos(t) - g * std::sin(2.0 * t), e * std::sin(t) * std::sin(t) + g * std::sin(2.0 * t),
      e * std::sin(2.0 * t) + 2.0 * g * std::cos(2.0 * t)};
  for (const Point& p : points_by_id(s.state)) {
    if (std::abs(p.x[0] - 2.0) > 0.5 || std::abs(p.x[1] - 1.0) > 0.25) continue;
    for (std::size_t k = 0; k < 7; ++k)
      EXPECT_NEAR(p.values[k + 1], expected[k], 0.2 * e * t) << k;  // a wrong sign is e t or more
  }
}

/// Soil of a library that rests under gravity, and begins so.
Case resting_box(MaterialCase material)
{
  Case c = confined_box(InitialStress::equilibrium);
  material.name = c.materials[0].name, material.density = c.materials[0].density;
  c.materials[0] = std::move(material);
  return c;
}

TEST(LibraryMaterial, FindsTheEquilibriumOfTerpsOwnElasticSoilWithTheStateOfTheStart)
{
  const std::vector<Real> moduli = confined_box(InitialStress::equilibrium).materials[0].parameters;
  const LibraryCase native =
      library_case("elastic.so", LawInterface::native, {moduli[0], moduli[1]}, {{"shear_path", 0.5}});
  const LibraryCase umat =
      library_case("wrong_umat.so", LawInterface::umat, {moduli[0], moduli[1], 0.0, 0.0, 0.0, 0.0}, {{"calls", 7.0}});
  Simulation own(confined_box(InitialStress::equilibrium));
  own.start();
  for (const LibraryCase& library : {native, umat}) {
    MaterialCase material = confined_box(InitialStress::equilibrium).materials[0];
    material.model = "library";
    material.library = library;
    material.from_library = load_user_law("clay", law_folder(), material.parameters, material.library);
    Simulation mine(resting_box(material));
    mine.start();
    expect_same_stresses(mine, own, 1e-6);
    for (const Point& p : points_by_id(mine.state)) EXPECT_EQ(p.values[0], library.state[0].value);
  }
}

TEST(LibraryMaterial, ThatAStageGivesToSoilOfAnotherKeepsItsPlasticStrainAlone)
{
  const LibraryCase first = library_case(
      "wrong_umat.so", LawInterface::umat, {shear, poisson, 0.0, 0.0, 0.0, 0.0}, {{"eps_eq_p", 0.0}, {"n", 3.0}});
  for (const bool same : {true, false}) {
    LibraryCase second = first;
    if (!same) second.file = "./wrong_umat.so", second.state[1].value = 5.0;
    Case c = moving_box("mpm_gp", of_library(first));
    c.materials.push_back(of_library(second));
    c.materials[1].name = "second";
    Simulation s(
        staged(c, {{stage("a", 0.01), {}}, {stage("b", 0.01), [](Case& now) { now.bodies[0].material = "second"; }}}));
    while (s.state.stages_done.empty()) s.step(1);
    const Real calls = static_cast<Real>(s.state.step);
    edit_points(s.state, [&](const PointBlock<2>& block, Index lane) { block.row(Rows::state + 1)[lane] = 8.0; });
    s.step(1);
    for (const Point& p : points_by_id(s.state)) {
      EXPECT_EQ(p.material, 1);
      EXPECT_EQ(p.values[0], calls + 1.0);  // it counts the calls
      EXPECT_EQ(p.values[1], same ? 8.0 : 5.0);
    }
  }
}

TEST(LawCost, IsThatOfAStepFromTheStateOfTheCase)
{
  const auto fault = [](Kind kind, Real limit) {
    const Simulation s(moving_box("mpm_gp", wrong_umat(kind, 0.0, -100.0, 1, limit)), 1);
    const LawCost cost = time_law(s.model.materials[0], s.state.points.block(0), 0.25, s.model.dt);
    EXPECT_GT(cost.seconds, 0.0);
    return cost.fault;
  };
  EXPECT_EQ(fault(breaks_at_stress, 10.0 * shear * 2e-6), "") << "the strains of its calls do not add up";
  EXPECT_EQ(fault(has_size, 0.25), "");
  EXPECT_THAT(fault(has_size, 1.0), HasSubstr("not a number"));
}

TEST(NativeLaw, IsToldOfTheSpinAndWhetherItsStressWasTurned)
{
  for (const bool turned : {true, false}) {
    Simulation s(turning_box(of_library(native("spinning_law")), turned));
    s.step(1);
    for (const Point& p : points_by_id(s.state))
      if (std::abs(p.x[0] - 2.0) < 0.5 && std::abs(p.x[1] - 1.0) < 0.25) {
        EXPECT_NEAR(p.values[0], 0.4 * s.model.dt, 1e-9);
        EXPECT_EQ(p.values[1], turned ? 1.0 : 0.0);
      }
  }
}

TEST(NativeLaw, GivesTheNumbersOfTerpsOwnElasticSoil)
{
  LibraryCase library{.file = "elastic.so", .parameters = {{"poisson", poisson}, {"stiffness", shear}}};
  const MaterialCase material = of_library(library);
  EXPECT_EQ(material.library.parameters[0].name, "stiffness");  // as the library orders them
  EXPECT_TRUE(material.library.thread_safe);
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Simulation mine(moving_box(scheme, material), 2), own(moving_box(scheme, elastic(shear, poisson, 1900.0)), 1);
    mine.step(30), own.step(30);
    expect_same_stresses(mine, own);
    for (const Point& p : points_by_id(mine.state)) EXPECT_GT(p.values[0], 0.0);
  }
}

TEST(NativeLaw, IsGivenHalvesOfAStepUntilItTakesThem)
{
  // Points of this scheme keep their own pressure.
  Simulation s(moving_box("standard_mpm", of_library(native("", 2.0 * shear, 1e-4))), 1);
  s.step(10);
  Real most_calls = 0.0;
  for (const Point& p : points_by_id(s.state)) {
    most_calls = std::max(most_calls, p.values[1]);
    EXPECT_NEAR(p.values[0], 0.25 + p.strain[0], 1e-14);  // its initial value, and what it added up
    EXPECT_NEAR(p.sigma[0], 2.0 * shear * p.strain[0], 1e-8);
  }
  EXPECT_GT(most_calls, 20.0);
}

TEST(Esm, SetsItsStateInItsFirstCallAndKeepsItsStressInItsOwnUnit)
{
  if (!is_built("esm_hardening.so")) GTEST_SKIP() << "there is no gfortran";
  constexpr Real strength = 2e3;
  LibraryCase library{.file = "esm_hardening.so", .interface = LawInterface::esm};
  library.parameters = {{"G", shear / 1e3}, {"nu", poisson}, {"k", strength / 1e3}};  // kPa
  library.state = {{"k", 0.0}, {"calls", 0.0}};
  library.stress_unit = 1e3;
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Case c = moving_box(scheme, of_library(library));
    c.method.shares = Shares::point;
    Simulation s(c, 1);
    s.step(20);
    Real largest = 0.0;
    for (const Point& p : points_by_id(s.state)) {
      const Real mean = (p.sigma[0] + p.sigma[1] + p.sigma[2]) / 3.0;
      Real square = p.sigma[3] * p.sigma[3];
      for (int k = 0; k < 3; ++k) square += 0.5 * (p.sigma[k] - mean) * (p.sigma[k] - mean);
      largest = std::max(largest, std::sqrt(square));
      EXPECT_NEAR(p.values[0], strength / 1e3, 1e-12);
      EXPECT_NEAR(p.values[1], 20.0, 1e-9);
    }
    EXPECT_NEAR(largest, strength, 1e-6 * strength);
    EXPECT_GT(s.state.work.plastic, 0.0);
  }
}

}  // namespace library_material_test
