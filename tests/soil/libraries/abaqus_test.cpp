// A UMAT for Abaqus needs its utility routines, beside the example (cases/user_law/abaqus.f90), and six components.
#include "os/shared_library.hpp"
#include "support/law_cases.hpp"

namespace abaqus_test {

using Tensor = std::array<std::array<double, 3>, 3>;

class Abaqus : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!is_built("abaqus.so")) GTEST_SKIP() << "there is no gfortran";
    library_ = std::make_unique<SharedLibrary>(law_folder() + "/abaqus.so");
  }
  template <class... Arguments>
  void call(const char* name, Arguments*... arguments) const
  {
    reinterpret_cast<void (*)(Arguments * ...)>(library_->find(name))(arguments...);
  }

  int stress_ = 1, strain_ = 2, ndi_ = 3, one_ = 1, three_ = 3;

 private:
  std::unique_ptr<SharedLibrary> library_;
};

/// Turned about z, then about x.
Tensor turned_axes()
{
  const double c = 0.8, s = 0.6, d = 5.0 / 13.0, e = 12.0 / 13.0;
  return {{{c, d * s, e * s}, {-s, d * c, e * c}, {0.0, -e, d}}};  // rows: directions
}

constexpr std::array<double, 3> principal{5.0, 2.0, -1.0};

/// Components 11 22 33 12 13 23.
std::array<double, 6> stress_of_axes()
{
  const Tensor axes = turned_axes();
  const auto component = [&](int i, int j) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += principal[k] * axes[k][i] * axes[k][j];
    return sum;
  };
  return {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(0, 2), component(1, 2)};
}

TEST_F(Abaqus, SinvGivesTheMeanAndTheStressOfVonMises)
{
  std::array<double, 6> s{1.0, -2.0, 3.0, 0.5, -0.7, 1.1};
  double mean = 0.0, mises = 0.0;
  call("sinv_", s.data(), &mean, &mises, &ndi_, &three_);
  EXPECT_NEAR(mean, 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(mises, std::sqrt(0.5 * (9.0 + 25.0 + 4.0) + 3.0 * (0.25 + 0.49 + 1.21)), 1e-14);
  call("sinv_", s.data(), &mean, &mises, &ndi_, &one_);
  EXPECT_NEAR(mises, std::sqrt(0.5 * (9.0 + 25.0 + 4.0) + 3.0 * 0.25), 1e-14);
}

TEST_F(Abaqus, SprincGivesThePrincipalValuesLargestFirst)
{
  std::array<double, 6> s = stress_of_axes();
  std::array<double, 3> values{};
  call("sprinc_", s.data(), values.data(), &stress_, &ndi_, &three_);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(values[k], principal[k], 1e-14);
  std::array<double, 4> strain{10.0, 2.0, -1.0, 3.0};  // engineering shear
  call("sprinc_", strain.data(), values.data(), &strain_, &ndi_, &one_);
  EXPECT_NEAR(values[0], 6.0 + std::sqrt(16.0 + 2.25), 1e-14);
  EXPECT_NEAR(values[1], 6.0 - std::sqrt(16.0 + 2.25), 1e-14);
  EXPECT_EQ(values[2], -1.0);
}

TEST_F(Abaqus, SprindGivesTheDirectionsToo)
{
  std::array<double, 6> s = stress_of_axes();
  std::array<double, 3> values{};
  std::array<double, 9> cosines{};  // an(k, i), column-major
  call("sprind_", s.data(), values.data(), cosines.data(), &stress_, &ndi_, &three_);
  const Tensor axes = turned_axes();
  for (int k = 0; k < 3; ++k) {
    double along = 0.0;
    for (int i = 0; i < 3; ++i) along += axes[k][i] * cosines[k + 3 * i];
    EXPECT_NEAR(std::abs(along), 1.0, 1e-14);
  }
  std::array<double, 6> none{};
  call("sprind_", none.data(), values.data(), cosines.data(), &stress_, &ndi_, &three_);
  EXPECT_THAT(cosines, ElementsAre(1, 0, 0, 0, 1, 0, 0, 0, 1));
}

TEST_F(Abaqus, RotsigTurnsStressAndStrain)
{
  const double c = 0.8, s = 0.6;
  std::array<double, 9> turn{c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0};  // counter-clockwise, column-major
  std::array<double, 4> along_x{10.0, 0.0, 4.0, 0.0}, turned{};
  call("rotsig_", along_x.data(), turn.data(), turned.data(), &stress_, &ndi_, &one_);
  EXPECT_THAT(turned, ElementsAre(DoubleNear(6.4, 1e-15), DoubleNear(3.6, 1e-15), 4.0, DoubleNear(4.8, 1e-15)));
  std::array<double, 4> shear{0.0, 0.0, 0.0, 1.0};
  call("rotsig_", shear.data(), turn.data(), turned.data(), &strain_, &ndi_, &one_);
  EXPECT_THAT(turned, ElementsAre(DoubleNear(-0.48, 1e-15), DoubleNear(0.48, 1e-15), 0.0, DoubleNear(0.28, 1e-15)));
}

TEST_F(Abaqus, GetoutdirAndGetjobnameFillTheirTexts)
{
  std::string text(256, 'x');
  int length = 0;
  const auto fill = [&](const char* name) {
    const SharedLibrary library(law_folder() + "/abaqus.so");
    reinterpret_cast<void (*)(char*, int*, std::size_t)>(library.find(name))(text.data(), &length, text.size());
    return text.substr(0, static_cast<std::size_t>(length));
  };
  EXPECT_EQ(fill("getoutdir_"), ".");
  EXPECT_EQ(text[1], ' ');
  EXPECT_EQ(fill("getjobname_"), "terp");
}

TEST(Umat, ThatCountsToSixIsElasticToo)
{
  Simulation mine(moving_box("mpm_gp", wrong_umat(counts_to_six)), 1);
  Simulation own(moving_box("mpm_gp", elastic(shear, poisson, 1900.0)), 1);
  Simulation parts(moving_box("mpm_gp", wrong_umat(counts_to_six, 0.0, -100.0, 1, 0.15 * own.model.dt)), 1);
  Simulation esm(
      moving_box("mpm_gp", of_library(library_case("wrong_umat.so", LawInterface::esm, {shear, poisson}))), 1);
  own.step(30);
  for (Simulation* s : {&mine, &parts, &esm}) {
    s->step(30);
    expect_same_stresses(*s, own);
  }
}

/// six_components.f90 in soil that falls. only: NTENS that it takes, 0: any. oblique: its stress 13 over strain 12.
MaterialCase of_components(LawInterface interface, Index n_components, Real only, Real oblique = 0.0)
{
  return of_library(library_case("six_components.so", interface, {shear, poisson, 4e3, 1e5, only, oblique},
                        {{"eps_eq_p", 0.0}, {"k", 4e3}}),
      {.n_components = n_components});
}

/// Stress of all points after 200 steps; stops if no point has yielded.
std::vector<Real> stresses_of(LawInterface interface, Index n_components)
{
  Simulation s(moving_box("mpm_gp", of_components(interface, n_components, 0.0)), 1);
  s.step(200);
  std::vector<Real> all;
  Real strain = 0.0;
  for (const Point& p : points_by_id(s.state)) {
    all.insert(all.end(), p.sigma.begin(), p.sigma.end());
    strain = std::max(strain, p.values[0]);
  }
  EXPECT_GT(strain, 1e-3);
  return all;
}

TEST(SixComponents, GiveTheResultsOfFour)
{
  if (!is_built("six_components.so")) GTEST_SKIP() << "there is no gfortran";
  for (const LawInterface interface : {LawInterface::umat, LawInterface::esm}) {
    const std::vector<Real> six = stresses_of(interface, 6), four = stresses_of(interface, 4);
    const Real scale = std::abs(*std::ranges::max_element(four, {}, [](Real s) { return std::abs(s); }));
    ASSERT_EQ(six.size(), four.size());
    for (std::size_t k = 0; k < six.size(); ++k) ASSERT_NEAR(six[k], four[k], 1e-12 * scale) << k;
  }
}

TEST(SixComponents, AreGivenToALawThatTakesNoOther)
{
  if (!is_built("six_components.so")) GTEST_SKIP() << "there is no gfortran";
  for (const LawInterface interface : {LawInterface::umat, LawInterface::esm}) {
    EXPECT_EQ(fault_of("mpm_gp", of_components(interface, 6, 6.0)), "");
    EXPECT_THAT(fault_of("mpm_gp", of_components(interface, 4, 6.0)), HasSubstr("a stress that is not a number"));
  }
}

TEST(SixComponents, WhoseShearLeavesThePlaneStopTheRun)
{
  if (!is_built("six_components.so")) GTEST_SKIP() << "there is no gfortran";
  for (const LawInterface interface : {LawInterface::umat, LawInterface::esm}) {
    EXPECT_THAT(fault_of("mpm_gp", of_components(interface, 6, 0.0, 0.1)),
        AllOf(HasSubstr("the law returned a shear stress out of the plane, 13 or 23, of "),
            HasSubstr("plane strain has no place for it"), HasSubstr("material `soft clay`")));
    for (const Real share : {1e-13, 8e-5})
      EXPECT_EQ(fault_of("mpm_gp", of_components(interface, 6, 0.0, share)), "") << "an artificial viscosity is none";
  }
}

TEST(Umat, TurnsItsStateByTheUtilityRoutinesOfAbaqus)
{
  if (!is_built("calls_abaqus.so")) GTEST_SKIP() << "there is no gfortran";
  LibraryCase library = library_case("calls_abaqus.so", LawInterface::umat, {1.0, poisson, 1e9});
  for (int k = 0; k < 6; ++k) library.state.push_back({"s" + std::to_string(k), k == 0 ? 0.01 : 0.0});
  Simulation s(turning_box(of_library(library), true));
  s.step(20);
  const Real w = 0.4 * 20.0 * s.model.dt;
  for (const Point& p : points_by_id(s.state)) {
    if (std::abs(p.x[0] - 2.0) > 0.4 || std::abs(p.x[1] - 1.0) > 0.2) continue;
    constexpr Real small = 2e-5;  // the strain since then, 3e-4, has turned with the soil too
    EXPECT_NEAR(p.values[0] - p.strain[0], 0.01 * std::cos(w) * std::cos(w), small);
    EXPECT_NEAR(p.values[3] - 2.0 * p.strain[3], 0.02 * std::cos(w) * std::sin(w), small);
    EXPECT_NEAR(p.values[4] - p.strain[0], 0.01, small);
  }
}

TEST(UmatDeathTest, ThatCallsStdbAbqerrToEndTheRunIsNamedAfterItsMessage)
{
  if (!is_built("calls_abaqus.so")) GTEST_SKIP() << "there is no gfortran";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  LibraryCase library = library_case("calls_abaqus.so", LawInterface::umat, {shear, poisson, 0.0});
  for (int k = 0; k < 6; ++k) library.state.push_back({"s" + std::to_string(k), 0.0});
  EXPECT_EXIT(fault_of("mpm_gp", of_library(library)), testing::ExitedWithCode(3),
      "the law looks at its stress\n"
      "error of the law: +SOFT CLA of cell [0-9]+ has a stress of [0-9.]+E[+][0-9]+ Pa\n(.|\n)*"
      "the law of material `soft clay` ended the program \\(STOP, XIT or exit\\)");
}

}  // namespace abaqus_test
