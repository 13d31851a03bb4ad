// What every constitutive model must do. Runs over materials.def: a new law is tested the moment its line is added.

#include "materials/material.hpp"

#include "materials/probe.hpp"
#include "support/random.hpp"

#include <bit>
#include <gmock/gmock.h>
#include <numbers>
#include <optional>

namespace terp {
namespace {

using test::Probe;
using test::Stress;

/// Parameters of the paper's soil where a law has them, of a soil or fluid like it; elsewhere the default, or the
/// middle of the usual or allowed range.
std::vector<Real> typical_parameters(const MaterialType& type)
{
  const std::pair<std::string_view, Real> known[] = {{"shear_modulus", 2e6}, {"poisson_ratio", 0.48}, {"su_peak", 8e3},
      {"su_residual", 2e3}, {"eta", 50.0}, {"cohesion", 8e3}, {"friction_angle", 30.0}, {"dilatancy_angle", 8.0},
      {"tension_cutoff", 5e3}, {"cohesion_residual", 2e3}, {"friction_angle_residual", 25.0},
      {"dilatancy_angle_residual", 0.0}, {"bulk_modulus", 2e6}, {"viscosity", 300.0}};
  std::vector<Real> values;
  for (const ParameterInfo& info : type.parameters) {
    std::optional<Real> value = info.fallback;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (type.parameters[k].name == info.fallback_of) value = values[k];
    for (const auto& [name, typical] : known)
      if (info.name == name) value = typical;
    const Range range = std::isfinite(info.usual.low + info.usual.high) ? info.usual : info.range;
    if (!value && std::isfinite(range.low + range.high)) value = 0.5 * (range.low + range.high);
    values.push_back(value.value_or(1.0));
  }
  return values;
}

Stress random_increment(Real size, test::Random& random)
{
  Stress d_eps;
  for (int c = 0; c < 4; ++c) d_eps[c] = random.between(-size, size);
  return d_eps;
}

class EveryMaterial : public testing::TestWithParam<const MaterialType*> {
 protected:
  Probe probe() const { return Probe(*GetParam(), typical_parameters(*GetParam())); }

  /// A point after n random increments.
  Probe walked(int n, std::uint64_t seed) const
  {
    Probe point = probe();
    test::Random random(seed);
    for (int k = 0; k < n; ++k) point.strain(random_increment(0.02, random));
    return point;
  }
};

/// Stress and state to the last bit; -0 counts as 0, which adding a zero increment makes of it.
std::array<std::uint64_t, 4 + max_state> bits_of(const Probe& point)
{
  std::array<std::uint64_t, 4 + max_state> bits;
  for (int c = 0; c < 4; ++c) bits[c] = std::bit_cast<std::uint64_t>(point.sigma[c] + 0.0);
  for (int s = 0; s < max_state; ++s) bits[4 + s] = std::bit_cast<std::uint64_t>(point.state[s] + 0.0);
  return bits;
}

TEST_P(EveryMaterial, HasTypicalParametersThatItsTableAndItsCheckAllow)
{
  const auto values = typical_parameters(*GetParam());
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_TRUE(GetParam()->parameters[k].range.contains(values[k]));
  EXPECT_TRUE(GetParam()->check(values).empty());
}

TEST_P(EveryMaterial, DescribesItselfInFull)
{
  const MaterialType& type = *GetParam();
  EXPECT_EQ(find_material(type.name), &type);
  EXPECT_FALSE(type.summary.empty());
  EXPECT_LE(type.state.size(), static_cast<std::size_t>(max_state));
  for (const auto& info : type.parameters)
    EXPECT_TRUE(!info.name.empty() && !info.unit.empty() && !info.meaning.empty()) << info.name;
  for (const auto& info : type.state)
    EXPECT_TRUE(!info.name.empty() && !info.unit.empty() && !info.meaning.empty()) << info.name;
  for (const auto& info : type.derived)
    EXPECT_TRUE(!info.name.empty() && !info.unit.empty() && !info.meaning.empty()) << info.name;
}

TEST_P(EveryMaterial, KeepsItsStateWhenNothingDeforms)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Probe point = walked(seed == 0 ? 0 : 20, seed);
    if (point.law().viscosity() > 0.0) point.strain(Stress{});  // ends the flow
    const auto before = bits_of(point);
    point.strain(Stress{});
    ASSERT_EQ(bits_of(point), before) << "seed " << seed;
    EXPECT_EQ(point.plastic_work, 0.0);
  }
}

TEST_P(EveryMaterial, GivesTheSameAnswerInPacksAndOneByOne)
{
  test::Random random(51);
  std::vector<Probe> together, alone;
  for (int k = 0; k < pack_width; ++k) together.push_back(probe()), alone.push_back(probe());
  for (int step = 0; step < 300; ++step) {
    std::vector<Stress> d_eps;
    const Real size = std::pow(10.0, random.between(-6.0, -1.7));  // elastic, face and edge lanes side by side
    for (int k = 0; k < pack_width; ++k) d_eps.push_back(random_increment(k % 3 ? size : 0.02, random));
    std::vector<Probe*> all;
    for (auto& point : together) all.push_back(&point);
    Probe::strain_together(all, d_eps, 0);
    for (int k = 0; k < pack_width; ++k) {
      alone[k].strain(d_eps[k]);
      ASSERT_EQ(bits_of(alone[k]), bits_of(together[k])) << "point " << k << ", step " << step;
      ASSERT_EQ(alone[k].plastic_work, together[k].plastic_work);
    }
  }
}

TEST_P(EveryMaterial, DoesNotDependOnTheFrame)  // turn the input by 30 degrees, turn the answer back
{
  constexpr Real angle = std::numbers::pi / 6.0;
  test::Random random(52);
  Probe straight = probe(), turned = probe();
  Real largest = 0.0;
  for (int step = 0; step < 200; ++step) {
    const Stress d_eps = random_increment(0.002, random);
    straight.strain(d_eps);
    turned.strain(test::rotated(d_eps, angle));
    const Stress back = test::rotated(turned.sigma, -angle);
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(straight.sigma[c]));
    for (int c = 0; c < 4; ++c)
      ASSERT_NEAR(back[c], straight.sigma[c], 1e-12 * largest) << "component " << c << ", step " << step;
    for (int s = 0; s < max_state; ++s) ASSERT_NEAR(turned.state[s], straight.state[s], 1e-12);
  }
}

TEST_P(EveryMaterial, StaysFiniteAndInsideItsYieldSurfaceOnRandomWalks)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Probe point = probe();
    test::Random random(53 + seed);
    const Real size = seed % 2 ? 0.02 : 0.0005;
    for (int step = 0; step < 1000; ++step) {
      point.strain(random_increment(size, random));
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(point.sigma[c]));
      for (int s = 0; s < max_state; ++s) ASSERT_TRUE(std::isfinite(point.state[s]));
      ASSERT_GE(point.plastic_work, 0.0);
      for (std::size_t k = 0; k < GetParam()->derived.size(); ++k) {
        if (GetParam()->derived[k].name != "su") continue;
        const Real su = point.law().derived(static_cast<int>(k), point.state.data());
        const auto principal = test::sorted_principal(point.sigma);
        const Real size_of_stress = std::max(std::abs(principal[0]), std::abs(principal[2]));
        ASSERT_LE(principal[0] - principal[2], 2.0 * su * (1.0 + 1e-9) + 1e-14 * size_of_stress) << "step " << step;
      }
    }
  }
}

TEST_P(EveryMaterial, IsIsotropicElasticNearTheOriginAndViscousWhereItSaysSo)
{
  Probe point = probe();
  const Real K = point.law().bulk_modulus(), G = point.law().shear_modulus();
  const Real twice = 2.0 * (G + point.law().viscosity() / Probe::dt);
  point.strain({{-3e-6, 1e-6, -2e-6, 5e-7}});
  const Real volumetric = -4e-6, mean = volumetric / 3.0;
  const Real expected[] = {K * volumetric + twice * (-3e-6 - mean), K * volumetric + twice * (1e-6 - mean),
      K * volumetric + twice * (-2e-6 - mean), twice * 5e-7};
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(point.sigma[c], expected[c], -1e-12 * K * volumetric);
  EXPECT_DOUBLE_EQ(point.law().p_wave_modulus(), K + 4.0 * G / 3.0);
}

// The time step is the same here, so that a viscosity takes the whole factor.
TEST_P(EveryMaterial, HasTheSameStressesAtSmallerStrainsWhenScaledAsItsTableSays)
{
  constexpr Real s = 256.0;
  std::vector<Real> stiffer = typical_parameters(*GetParam());
  for (std::size_t k = 0; k < stiffer.size(); ++k)
    if (GetParam()->parameters[k].strain_scale != StrainScale::none) stiffer[k] *= s;
  Probe soft = probe(), stiff(*GetParam(), stiffer);
  test::Random random(7);
  for (int step = 0; step < 200; ++step) {
    Stress d_eps = random_increment(0.002, random);
    soft.strain(d_eps);
    for (int c = 0; c < 4; ++c) d_eps[c] /= s;
    stiff.strain(d_eps);
    for (int c = 0; c < 4; ++c)
      ASSERT_NEAR(stiff.sigma[c], soft.sigma[c], 1e-6 * std::abs(soft.sigma[c]) + 1e-3) << "step " << step;
  }
}

TEST_P(EveryMaterial, PassesOnWhatIsNotANumber)  // so that the run can stop on it, and no other point suffers
{
  std::vector<Probe> points;
  for (int k = 0; k < 3; ++k) points.push_back(walked(5, 54));
  std::vector<Probe*> all{&points[0], &points[1], &points[2]};
  const Stress d_eps{{0.01, 0.002, 0.0, 0.003}};
  Stress bad = d_eps;
  bad[0] = std::numeric_limits<Real>::quiet_NaN();
  Probe::strain_together(all, {d_eps, bad, d_eps}, 1);
  EXPECT_TRUE(std::isnan(points[1].sigma[0]));
  EXPECT_TRUE(std::isfinite(points[0].sigma[0]));
  EXPECT_EQ(bits_of(points[0]), bits_of(points[2]));
}

INSTANTIATE_TEST_SUITE_P(Materials, EveryMaterial, testing::ValuesIn(all_materials().begin(), all_materials().end()),
    [](const auto& info) { return std::string(info.param->name); });

}  // namespace
}  // namespace terp
