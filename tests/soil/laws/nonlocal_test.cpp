#include "soil/laws/nonlocal.hpp"

#include "soil/laws/probe.hpp"

namespace nonlocal_test {

enum Row { eps, nonlocal, driver, increment };  // of tresca_softening

const MaterialType& tresca() { return *find_material("tresca_softening")->nonlocal; }
const std::vector<Real> clay{2e6, 0.48, 8e3, 2e3, 50.0};
const SofteningOptions options{.length = 0.2, .over_nonlocal = 1.5};

/// The strength of the next step, after `spread` came from around.
void soften(Probe& point, Real spread, const SofteningOptions& with = options)
{
  alignas(64) Real rows[4][pack_width], all[pack_width];
  std::fill_n(all, pack_width, spread);
  for (int r = 0; r < 4; ++r) std::fill_n(rows[r], pack_width, point.state[static_cast<std::size_t>(r)]);
  point.law().soften(with, {.law = {.state = {.data = rows[0], .stride = pack_width}, .parameters = {}},
                               .spread = all,
                               .n = pack_width,
                               .n_points = pack_width});
  for (int r = 0; r < 4; ++r) point.state[static_cast<std::size_t>(r)] = rows[r][0];
}

TEST(Nonlocal, LawsThatSoftenHaveSuchAForm)
{
  for (const char* name : {"tresca_softening", "mohr_coulomb"}) {
    const MaterialType* local = find_material(name);
    ASSERT_NE(local->nonlocal, nullptr);
    EXPECT_EQ(find_material(name, options), local->nonlocal);
    EXPECT_EQ(find_material(name, {}), local);
    EXPECT_EQ(local->nonlocal->name, name);
  }
  EXPECT_EQ(find_material("linear_elastic")->nonlocal, nullptr);
}

TEST(Nonlocal, TheStrengthIsThatOfTheDriverAndStaysWithinAStep)
{
  Probe point(tresca(), clay);
  point.state = {0.3, 0.0, 0.01, 0.0};
  const Real su = 2e3 + 6e3 * std::exp(-0.5);
  point.strain({{0.0, 0.0, 0.0, 0.02}});  // far beyond the strength
  EXPECT_NEAR(point.sigma[3], su, 1e-9 * su);
  EXPECT_NEAR(point.derived(0), su, 1e-9 * su);
  EXPECT_NEAR(point.state[eps], 0.3 + 0.02 - su / (2.0 * 2e6), 1e-12);
  EXPECT_EQ(point.state[driver], 0.01);
  EXPECT_NEAR(point.state[increment], (point.state[eps] - 0.3) * 50.0 / 3.0, 1e-12);  // over the strain of 95 %
}

TEST(Nonlocal, YieldsAsSoonAsTheStressIsBeyondTheStrengthOfTheDriver)
{
  const Real su = 2e3 + 6e3 * std::exp(-2.5), e = 0.001;  // driver 0.05, beyond the point's own strain
  for (const Real part : {0.5, 1.0 - 1e-6, 1.0 + 1e-6, 1.5}) {
    Probe point(tresca(), clay);
    point.state = {e, 0.0, 0.05, 0.7};
    Probe beside_others = point;
    const Stress d_eps{{0.0, 0.0, 0.0, part * su / (2.0 * 2e6)}};
    point.strain_in_all_lanes(d_eps);
    beside_others.strain(d_eps);
    EXPECT_EQ(point.sigma.c, beside_others.sigma.c);
    EXPECT_EQ(point.state, beside_others.state);
    EXPECT_NEAR(point.sigma[3], std::min(part, 1.0) * su, 1e-9 * su);
    EXPECT_EQ(point.state[eps] > e, part > 1.0);
    EXPECT_EQ(point.state[increment] > 0.0, part > 1.0);
    EXPECT_EQ(point.state[driver], 0.05);
  }
}

TEST(Nonlocal, TheDriverIsTheOverNonlocalStrainAndNeverFalls)
{
  Probe point(tresca(), clay);
  point.state = {0.0, 0.0, 0.0, 0.2};
  soften(point, 0.3);
  const Real first = 3.0 / 50.0 * (1.5 * 0.3 - 0.5 * 0.2);
  EXPECT_NEAR(point.state[nonlocal], first, 1e-15);
  EXPECT_NEAR(point.state[driver], first, 1e-15);
  point.state[increment] = 0.9;
  soften(point, 0.1);
  EXPECT_NEAR(point.state[nonlocal], first + 3.0 / 50.0 * (1.5 * 0.1 - 0.5 * 0.9), 1e-15);
  EXPECT_NEAR(point.state[driver], first, 1e-15);
}

TEST(Nonlocal, WithMOfOneItIsTheMeanAndWithoutHaloNoMoreThanThePointSheared)
{
  Probe point(tresca(), clay);
  point.state = {0.001, 0.0, 0.0, 0.2};
  soften(point, 0.3, {.length = 0.2, .over_nonlocal = 1.0});
  EXPECT_NEAR(point.state[driver], 3.0 / 50.0 * 0.3, 1e-15);
  point.state = {0.001, 0.0, 0.0, 0.2};
  soften(point, 0.3, {.length = 0.2, .over_nonlocal = 1.0, .halo = false});
  EXPECT_NEAR(point.state[nonlocal], 3.0 / 50.0 * 0.3, 1e-15);
  EXPECT_EQ(point.state[driver], 0.001);
}

TEST(Nonlocal, SoilThatHasSoftenedSpreadsNoMore)
{
  Probe point(tresca(), clay);
  point.state = {1.0, 0.0, 7.001 / 50.0, 0.0};
  point.strain({{0.0, 0.0, 0.0, 0.02}});
  EXPECT_EQ(point.state[increment], 0.0);
  point.state[driver] = 6.999 / 50.0;
  point.strain({{0.0, 0.0, 0.0, 0.02}});
  EXPECT_GT(point.state[increment], 0.0);
}

TEST(Nonlocal, SoilThatCannotSoftenTakesNoPart)
{
  for (const std::vector<Real>& without : {std::vector<Real>{2e6, 0.48, 8e3, 2e3, 0.0}, {2e6, 0.48, 8e3, 8e3, 50.0}}) {
    Probe point(tresca(), without);
    point.strain({{0.0, 0.0, 0.0, 0.02}});
    EXPECT_EQ(point.state[increment], -1.0);
    soften(point, 0.3);
    EXPECT_EQ(point.state[driver], 0.0);
    EXPECT_EQ(point.law().softened_strain(), INFINITY);
  }
}

TEST(Nonlocal, MohrCoulombKeepsAllThatSoftens)
{
  Probe point(*find_material("mohr_coulomb")->nonlocal, {2e6, 0.3, 8e3, 30.0, 8.0, INFINITY, 2e3, 20.0, 0.0, 40.0});
  point.state = {0.0, 0.0, 0.0, 0.02, 0.0};
  const Real decay = std::exp(-0.8);
  EXPECT_NEAR(point.derived(0), 2e3 + 6e3 * decay, 1e-9);
  EXPECT_NEAR(point.derived(1), 20.0 + 10.0 * decay, 1e-12);
  EXPECT_NEAR(point.derived(2), 8.0 * decay, 1e-12);
  Probe firm(*find_material("mohr_coulomb"), {2e6, 0.3, point.derived(0), point.derived(1), point.derived(2), INFINITY,
                                                 point.derived(0), point.derived(1), point.derived(2), 0.0});
  for (Probe* p : {&point, &firm}) p->strain({{-0.01, 0.002, 0.0, 0.01}});
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(point.sigma[k], firm.sigma[k], 1e-6);
  EXPECT_NEAR(point.state[0], firm.state[0], 1e-12);
}

TEST(Nonlocal, SofteningMayBeSteeperThanAPointCouldBear)
{
  const std::vector<Real> steep =
      tresca().complete(std::vector<Real>{2e5, 0.48, 8e3, 2e3, 100.0});  // eta (S_p - S_r) = 3 G
  EXPECT_THAT(find_material("tresca_softening")->check(steep), SizeIs(1));
  EXPECT_THAT(tresca().check(steep), IsEmpty());
  EXPECT_THAT(tresca().check(tresca().complete(std::vector<Real>{2e6, 0.48, 2e3, 8e3, 50.0})),
      SizeIs(1));  // what is wrong anywhere
}

TEST(Nonlocal, NoStrainKeepsStressAndHistory)
{
  Probe point(tresca(), clay);
  point.state = {0.02, 0.013, 0.011, 0.4};
  point.sigma = {{-1e3, -2e3, -1.5e3, 500.0}};
  const auto before = point.sigma;
  point.strain({});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(point.sigma[k], before[k]);
  EXPECT_THAT(point.state, ElementsAre(0.02, 0.013, 0.011, 0.0));
}

}  // namespace nonlocal_test
