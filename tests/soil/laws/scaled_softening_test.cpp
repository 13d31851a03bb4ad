#include "soil/laws/scaled_softening.hpp"

#include "soil/laws/probe.hpp"

namespace scaled_softening_test {

const std::vector<Real> clay{2e6, 0.48, 8e3, 2e3, 50.0};
const std::vector<Real> quick_clay{2e6, 0.48, 8e3, 2e3, 50.0, 200.0, 3.0, 0.1, 1e-3};
const std::vector<Real> sand{5e6, 0.3, 4e3, 35.0, 5.0, INFINITY, 500.0, 28.0, 0.0, 40.0};

const MaterialType& scaled(const char* law) { return *find_material(law)->scaled; }

TEST(ScaledSoftening, IsAFormOfLawsThatSoften)
{
  for (const char* law : {"tresca_softening", "mohr_coulomb"}) {
    EXPECT_EQ(find_material(law, {.reference_width = 0.1}), &scaled(law));
    EXPECT_EQ(find_material(law, {}), find_material(law));
    EXPECT_EQ(scaled(law).name, law);
    EXPECT_EQ(scaled(law).state.back().role, Role::softening);
  }
  for (const char* law : {"linear_elastic", "newtonian_fluid"})
    EXPECT_EQ(find_material(law, {.reference_width = 0.1}), find_material(law)) << "it does not soften";
}

TEST(ScaledSoftening, IsTheLawItselfInCellsOfTheReferenceWidth)
{
  const std::pair<const char*, std::vector<Real>> soils[] = {
      {"tresca_softening", clay}, {"tresca_softening", quick_clay}, {"mohr_coulomb", sand}};
  for (const auto& [law, parameters] : soils) {
    Probe point(*find_material(law), parameters), form(scaled(law), parameters);
    Random random(31);
    for (int step = 0; step < 400; ++step) {
      const Stress d_eps = random_tensor(step % 2 ? 0.01 : 0.0005, random);
      point.strain(d_eps);
      form.strain(d_eps);
      for (int c = 0; c < 4; ++c) ASSERT_NEAR(form.sigma[c], point.sigma[c], 1e-6) << law << ", step " << step;
      for (std::size_t s = 0; s < point.state.size(); ++s) ASSERT_NEAR(form.state[s], point.state[s], 1e-12);
      ASSERT_EQ(form.state.back(), form.state[0]) << "the strain that the strength follows";
    }
  }
}

/// Energy that a band of one cell takes above the residual strength, and its plastic slip [J/m^2, m].
std::array<Real, 2> sheared_band(const std::vector<Real>& parameters, Real width, Real reference)
{
  Probe point(scaled("tresca_softening"), parameters);
  point.scale = width / reference;
  Real energy = 0.0;
  for (int k = 0; k < 40000; ++k) {
    const Real before = point.state[0];
    point.strain({{0.0, 0.0, 0.0, 2.5e-6 / point.scale}});
    energy += (point.plastic_work - 2e3 * 2.0 * (point.state[0] - before)) * width;
  }
  return {energy, 2.0 * width * point.state[0]};
}

TEST(ScaledSoftening, ABandOfOneCellTakesTheEnergyOfTheReferenceWidthWhateverTheCell)
{
  const Real reference = 0.1, expected = 2.0 * reference * (8e3 - 2e3) / 50.0;  // G_f = 2 t_ref (S_p - S_r)/eta
  for (const Real width : {0.025, 0.1, 0.5, 0.9}) {
    const auto [energy, slip] = sheared_band(clay, width, reference);
    EXPECT_NEAR(energy, expected, 0.01 * expected) << width;
    EXPECT_GT(slip, 0.018) << width;
  }
}

TEST(ScaledSoftening, ShowsTheStrengthOfTheScaledStrainAndThePlasticStrainAsItIs)
{
  Probe point(scaled("tresca_softening"), clay);
  point.scale = 3.0;
  for (int k = 0; k < 20; ++k) point.strain({{0.0, 0.0, 0.0, 5e-4}});
  EXPECT_NEAR(point.state[1], 3.0 * point.state[0], 1e-15);
  EXPECT_NEAR(point.derived(0), 2e3 + 6e3 * std::exp(-150.0 * point.state[0]), 1e-8);
  EXPECT_NEAR(point.sigma[3], point.derived(0), 1e-8);
  EXPECT_EQ(point.law().softened_strain(), 0.06) << "of the scaled strain";
}

TEST(ScaledSoftening, AStrengthNeverRisesWhenThePointComesToAnotherCell)
{
  Probe point(scaled("tresca_softening"), quick_clay);
  Random random(32);
  Real strength = point.derived(0);
  for (int step = 0; step < 3000; ++step) {
    point.scale = std::pow(10.0, random.between(-1.0, 0.5));
    point.strain(random_tensor(0.001, random));
    ASSERT_LE(point.derived(0), strength * (1.0 + 1e-15));
    strength = point.derived(0);
  }
  EXPECT_LT(strength, 300.0);
}

TEST(ScaledSoftening, WithAShapeFactorOfZeroIsTheLaw)
{
  Probe point(*find_material("tresca_softening"), {2e6, 0.48, 8e3}), form(scaled("tresca_softening"), {2e6, 0.48, 8e3});
  form.scale = 7.0;
  for (int k = 0; k < 10; ++k) {
    point.strain({{1e-3, 0.0, 0.0, 3e-3}});
    form.strain({{1e-3, 0.0, 0.0, 3e-3}});
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(form.sigma[c], point.sigma[c], 1e-8);
  }
  EXPECT_EQ(form.law().softened_strain(), INFINITY);
}

}  // namespace scaled_softening_test
