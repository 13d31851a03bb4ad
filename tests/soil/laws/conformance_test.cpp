// What every constitutive model must do. Runs over materials.def: a new law is tested the moment its line is added.
#include "soil/laws/material_axes.hpp"
#include "mpm/points/soil_material.hpp"
#include "soil/laws/probe.hpp"
#include <bit>

namespace conformance_test {

/// Everything that the law knows is on.
std::vector<Real> typical_parameters(const MaterialType& type)
{
  std::vector<Real> values;
  for (const ParameterInfo& info : type.parameters) values.push_back(info.typical);
  return values;
}

/// Only what must be given is given.
std::vector<Real> default_parameters(const MaterialType& type)
{
  std::vector<Real> values;
  for (const ParameterInfo& info : type.parameters)
    values.push_back(info.fallback || !info.fallback_of.empty() ? std::nan("") : info.typical);
  return type.complete(values);
}

std::vector<int> all_that_may_vary(const MaterialType& type)
{
  std::vector<int> varying;
  for (std::size_t k = 0; k < type.parameters.size(); ++k)
    if (type.parameters[k].may_vary) varying.push_back(static_cast<int>(k));
  return varying;
}

std::vector<Real> values_of(const std::vector<int>& numbers, const std::vector<Real>& parameters)
{
  std::vector<Real> values;
  for (const int k : numbers) values.push_back(parameters[static_cast<std::size_t>(k)]);
  return values;
}

/// No strength is raised by the rate of a step that takes as long [s].
constexpr Real slow_step = 1e9;

/// A law with everything on, or with its defaults.
struct Setting {
  const MaterialType* type;
  bool everything_on;
};

class EveryMaterial : public TestWithParam<Setting> {
 protected:
  const MaterialType& type() const
  {
    const MaterialType& law = *GetParam().type;
    return GetParam().everything_on && law.torn != nullptr ? *law.torn : law;
  }
  std::vector<Real> parameters() const
  {
    return GetParam().everything_on ? typical_parameters(type()) : default_parameters(type());
  }
  Probe probe() const { return Probe(type(), parameters()); }

  /// A point after n random increments.
  Probe walked(int n, std::uint64_t seed) const
  {
    Probe point = probe();
    Random random(seed);
    for (int k = 0; k < n; ++k) point.strain(random_tensor(0.02, random));
    return point;
  }
};

/// Stress and state to the last bit; -0 counts as 0, which adding a zero increment makes of it.
std::vector<std::uint64_t> bits_of(const Probe& point)
{
  std::vector<std::uint64_t> bits;
  for (int c = 0; c < 4; ++c) bits.push_back(std::bit_cast<std::uint64_t>(point.sigma[c] + 0.0));
  for (const Real value : point.state) bits.push_back(std::bit_cast<std::uint64_t>(value + 0.0));
  return bits;
}

TEST_P(EveryMaterial, HasParametersThatItsTableAndItsCheckAllow)
{
  const auto values = parameters();
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_TRUE(type().parameters[k].range.contains(values[k])) << type().parameters[k].name;
  EXPECT_TRUE(type().check(values).empty());
}

TEST_P(EveryMaterial, DescribesItselfInFull)
{
  EXPECT_EQ(find_material(type().name), GetParam().type);
  EXPECT_FALSE(type().summary.empty());
  for (const auto& info : type().parameters)
    EXPECT_TRUE(!info.name.empty() && !info.unit.empty() && !info.meaning.empty()) << info.name;
  for (const auto& info : type().state)
    EXPECT_TRUE(!info.name.empty() && !info.unit.empty() && !info.meaning.empty()) << info.name;
  for (const auto& info : type().derived)
    EXPECT_TRUE(!info.name.empty() && !info.unit.empty() && !info.meaning.empty()) << info.name;
}

TEST_P(EveryMaterial, NamesNoParametersButItsOwn)
{
  const auto has = [&](std::string_view name) {
    return std::ranges::count(type().parameters, name, &ParameterInfo::name) == 1;
  };
  for (const auto& info : type().parameters) {
    EXPECT_TRUE(has(info.name) && (info.fallback_of.empty() || has(info.fallback_of))) << info.name;
    EXPECT_TRUE(info.acts_with.empty() || has(info.acts_with)) << info.name;
    if (!info.acts_with.empty()) {
      EXPECT_TRUE(info.fallback || !info.fallback_of.empty()) << info.name << ": it always acts";
    }
  }
}

TEST_P(EveryMaterial, HasOneQuantityOfEachRoleAtMostInItsUnit)
{
  int strains = 0, strengths = 0;
  const auto look = [&](const auto& info, Role role_in_pascal) {
    strains += info.role == Role::plastic_strain;
    strengths += info.role == Role::strength;
    if (info.role == Role::none) return;
    EXPECT_EQ(info.unit, info.role == Role::strength || info.role == role_in_pascal ? "Pa" : "-") << info.name;
  };
  for (const auto& info : type().state) look(info, Role::strength);
  for (const auto& info : type().derived) look(info, Role::carried_pressure);
  EXPECT_LE(strains, 1);
  EXPECT_LE(strengths, 1);
  // A pressure that was carried is a field, and remembered by its logarithm.
  EXPECT_EQ(find_role(type().state, Role::carried_pressure) < 0, find_role(type().derived, Role::carried_pressure) < 0);
}

TEST_P(EveryMaterial, KeepsItsStateWhenNothingDeforms)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Probe point = walked(seed == 0 ? 0 : 20, seed);
    if (type().depends_on_rate) {  // ends the flow: stress that the rate has raised takes its time to relax
      point.dt = slow_step;
      point.strain(Stress{});
      point.dt = 1e-3;
    }
    const auto before = bits_of(point);
    point.strain(Stress{});
    ASSERT_EQ(bits_of(point), before) << "seed " << seed;
    EXPECT_EQ(point.plastic_work, 0.0);
  }
}

TEST_P(EveryMaterial, LooksAtTheLengthOfTheStepIfItSaysSoAndNotOtherwise)
{
  Probe once = probe(), slower = probe();
  slower.dt = 2.0 * once.dt;
  bool same = true;
  Random random(55);
  for (int step = 0; step < 50; ++step) {
    const Stress d_eps = random_tensor(0.002, random);
    once.strain(d_eps);
    slower.strain(d_eps);
    same = same && bits_of(once) == bits_of(slower);
  }
  EXPECT_TRUE(same || type().depends_on_rate);
  EXPECT_FALSE(same && type().depends_on_rate && GetParam().everything_on) << "its typical values leave the rate off";
}

TEST_P(EveryMaterial, GivesTheSameBitsWhenItsParametersComeFromThePoints)
{
  const std::vector<int> varying = all_that_may_vary(type());
  Probe uniform = probe(), from_point(type(), parameters(), varying, values_of(varying, parameters()));
  Random random(56);
  for (int step = 0; step < 200; ++step) {
    const Stress d_eps = random_tensor(step % 2 ? 0.02 : 0.0005, random);
    uniform.strain(d_eps);
    from_point.strain(d_eps);
    ASSERT_EQ(bits_of(from_point), bits_of(uniform)) << "step " << step;
    ASSERT_EQ(from_point.plastic_work, uniform.plastic_work);
  }
  for (std::size_t k = 0; k < type().derived.size(); ++k)
    EXPECT_EQ(from_point.derived(static_cast<int>(k)), uniform.derived(static_cast<int>(k)));
}

// As in the ramp of a stage: from one step to the next, in all points alike.
TEST_P(EveryMaterial, AtAStrengthIsTheLawOfReducedParameters)
{
  const std::vector<int> varying = all_that_may_vary(type());
  std::vector<Real> reduced_values = parameters();
  bool has_strength = false;
  for (std::size_t k = 0; k < reduced_values.size(); ++k) {
    const Reduction reduction = type().parameters[k].reduction;
    has_strength = has_strength || (is_strength(reduction) && reduced_values[k] > 0.0);
    reduced_values[k] = reduced(reduction, reduced_values[k], 1.6);
  }
  Probe uniform = probe(), from_point(type(), parameters(), varying, values_of(varying, parameters()));
  Probe weak(type(), reduced_values), whole = probe();
  uniform.at_strength = from_point.at_strength = 1.6;
  Random random(58);
  for (int step = 0; step < 50; ++step) {
    const Stress d_eps = random_tensor(step % 2 ? 0.02 : 0.0005, random);
    for (Probe* point : {&uniform, &from_point, &weak, &whole}) point->strain(d_eps);
    ASSERT_EQ(bits_of(uniform), bits_of(weak)) << "step " << step;
    ASSERT_EQ(bits_of(from_point), bits_of(weak)) << "step " << step;
  }
  EXPECT_EQ(bits_of(weak) != bits_of(whole), has_strength);
}

TEST_P(EveryMaterial, ActsOnEachPointWithItsOwnParameters)  // lanes side by side, of which some may not soften
{
  const std::vector<int> varying = all_that_may_vary(type());
  const std::vector<Real> on = typical_parameters(type()), off = default_parameters(type());
  std::vector<Probe> together, alone;
  for (int k = 0; k < pack_width; ++k) {
    std::vector<Real> own = k % 2 ? parameters() : k % 4 ? on : off;
    for (const int p : varying) {
      const Real other = own[static_cast<std::size_t>(p)] * (1.0 - 0.01 * k);
      if (type().parameters[static_cast<std::size_t>(p)].range.contains(other))
        own[static_cast<std::size_t>(p)] = other;
    }
    std::vector<Real> values = parameters();
    for (const int p : varying) values[static_cast<std::size_t>(p)] = own[static_cast<std::size_t>(p)];
    ASSERT_TRUE(type().check(values).empty());
    together.emplace_back(type(), parameters(), varying, values_of(varying, values));
    alone.emplace_back(type(), values);
  }
  Random random(57);
  for (int step = 0; step < 200; ++step) {
    std::vector<Stress> d_eps;
    for (int k = 0; k < pack_width; ++k) d_eps.push_back(random_tensor(k % 3 ? 0.001 : 0.02, random));
    std::vector<Probe*> all;
    for (auto& point : together) all.push_back(&point);
    Probe::strain_together(all, d_eps, 0);
    for (int k = 0; k < pack_width; ++k) {
      alone[k].strain(d_eps[k]);
      ASSERT_EQ(bits_of(alone[k]), bits_of(together[k])) << "point " << k << ", step " << step;
    }
  }
}

TEST_P(EveryMaterial, GivesTheSameAnswerInPacksAndOneByOne)
{
  Random random(51);
  std::vector<Probe> together, alone;
  for (int k = 0; k < pack_width; ++k) together.push_back(probe()), alone.push_back(probe());
  for (int step = 0; step < 300; ++step) {
    std::vector<Stress> d_eps;
    const Real size = std::pow(10.0, random.between(-6.0, -1.7));  // elastic, face and edge lanes side by side
    for (int k = 0; k < pack_width; ++k) d_eps.push_back(random_tensor(k % 3 ? size : 0.02, random));
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

/// The parameters of the same soil as seen from a frame turned by `degrees`: a law with axes has them elsewhere.
std::vector<Real> seen_from(const MaterialType& type, std::vector<Real> parameters, Real degrees)
{
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (type.parameters[k].name == axis_angle_info.name) parameters[k] -= degrees;
  return parameters;
}

TEST_P(EveryMaterial, DoesNotDependOnTheFrame)  // turn input and axes by 30 degrees, turn the answer back
{
  constexpr Real angle = std::numbers::pi / 6.0;
  Random random(52);
  Probe straight = probe(), turned(type(), seen_from(type(), parameters(), 30.0));
  Real largest = 0.0;
  for (int step = 0; step < 200; ++step) {
    const Stress d_eps = random_tensor(0.002, random);
    straight.strain(d_eps);
    turned.strain(rotated(d_eps, angle));
    const Stress back = rotated(turned.sigma, -angle);
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(straight.sigma[c]));
    for (int c = 0; c < 4; ++c)
      ASSERT_NEAR(back[c], straight.sigma[c], 1e-12 * largest) << "component " << c << ", step " << step;
    for (std::size_t s = 0; s < straight.state.size(); ++s) ASSERT_NEAR(turned.state[s], straight.state[s], 1e-12);
  }
}

TEST_P(EveryMaterial, StaysFiniteAndInsideItsYieldSurfaceOnRandomWalks)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Probe point = probe();
    const bool fast = type().depends_on_rate && seed % 4 < 2;  // the rate may raise the strength
    if (type().depends_on_rate && !fast) point.dt = slow_step;
    Random random(53 + seed);
    const Real size = seed % 2 ? 0.02 : 0.0005;
    const int strain = find_role(type().state, Role::plastic_strain);
    for (int step = 0; step < 1000; ++step) {
      const Real before = strain < 0 ? 0.0 : point.state[strain];
      point.strain(random_tensor(size, random));
      ASSERT_TRUE(strain < 0 || point.state[strain] >= before) << "step " << step;
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(point.sigma[c]));
      for (const Real value : point.state) ASSERT_TRUE(std::isfinite(value));
      ASSERT_GE(point.plastic_work, 0.0);
      const int strength = find_role(type().derived, Role::strength);
      if (strength < 0 || fast) continue;
      const Real su = point.derived(strength);
      const auto principal = sorted_principal(point.sigma);
      const Real size_of_stress = std::max(std::abs(principal[0]), std::abs(principal[2]));
      ASSERT_LE(principal[0] - principal[2], 2.0 * su * (1.0 + 1e-9) + 1e-14 * size_of_stress) << "step " << step;
    }
  }
}

/// What the step left in the soil for good: its strain less the elastic part of what it did to the stress.
Stress plastic_part(const Stress& d_eps, const Stress& before, const Stress& after, const Moduli& m)
{
  Stress d_sigma, part;
  for (int c = 0; c < 4; ++c) d_sigma[c] = after[c] - before[c];
  const Real mean = trace(d_sigma) / 3.0;
  for (int c = 0; c < 4; ++c)
    part[c] = d_eps[c] -
              (c < 3 ? (d_sigma[c] - mean) / (2.0 * m.shear) + mean / (3.0 * m.bulk) : d_sigma[c] / (2.0 * m.shear));
  return part;
}

/// Of tensors with the components xx, yy, zz, xy.
Real product(const Stress& a, const Stress& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * a[3] * b[3]; }

TEST_P(EveryMaterial, WorksByItsStressOnThePlasticStrainWhichItsHistoryCounts)  // laws of constant elastic moduli
{
  if (type().stiffness_by_stress || type().name == "newtonian_fluid") GTEST_SKIP();  // a fluid has no plastic strain
  const int strain = find_role(type().state, Role::plastic_strain);
  const int opening = find_role(type().state, Role::opening);
  Real all_work = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(90 + seed);
    Probe point = probe();
    const Real size = seed % 2 ? 0.004 : 0.0005;
    for (int step = 0; step < 200; ++step) {
      const Stress before = point.sigma, d_eps = random_tensor(size, random);
      const std::vector<Real> state = point.state;
      point.strain(d_eps);
      if (opening >= 0 && state[static_cast<std::size_t>(opening)] > 0.0) continue;  // it closes without plastic strain
      const Stress part = plastic_part(d_eps, before, point.sigma, point.moduli());
      const Real work = product(point.sigma, part), scale = std::sqrt(product(point.sigma, point.sigma)) * size;
      ASSERT_NEAR(point.plastic_work, work, 1e-9 * scale) << "seed " << seed << ", step " << step;
      all_work += work;
      if (strain < 0) continue;
      Stress deviator = part;
      for (int c = 0; c < 3; ++c) deviator[c] -= trace(part) / 3.0;
      const auto row = static_cast<std::size_t>(strain);
      ASSERT_NEAR(point.state[row] - state[row], std::sqrt(0.5 * product(deviator, deviator)), 1e-9 * size)
          << "seed " << seed << ", step " << step;
    }
  }
  EXPECT_EQ(all_work > 0.0, strain >= 0);
}

TEST_P(EveryMaterial, IsIsotropicElasticNearTheOriginAndViscousWhereItSaysSo)
{
  Probe point = probe();
  const auto [K, G] = point.moduli();
  const Real twice = 2.0 * (G + point.law().viscosity() / point.dt);
  point.strain({{-3e-6, 1e-6, -2e-6, 5e-7}});
  const Real volumetric = -4e-6, mean = volumetric / 3.0;
  const Real expected[] = {K * volumetric + twice * (-3e-6 - mean), K * volumetric + twice * (1e-6 - mean),
      K * volumetric + twice * (-2e-6 - mean), twice * 5e-7};
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(point.sigma[c], expected[c], -1e-12 * K * volumetric);
  if (type().stiffness_by_stress) return;
  EXPECT_DOUBLE_EQ(K, point.law().bulk_modulus());
  EXPECT_DOUBLE_EQ(G, point.law().shear_modulus());
  EXPECT_DOUBLE_EQ(point.law().p_wave_modulus(), K + 4.0 * G / 3.0);
}

TEST_P(EveryMaterial, IsNeverStifferThanTheModuliThatTheTimeStepHoldsFor)
{
  Probe point = probe();
  Random random(58);
  for (int step = 0; step < 1000; ++step) {
    point.strain(random_tensor(step % 2 ? 0.02 : 0.0005, random));
    const Moduli now = point.moduli();
    ASSERT_LE(now.bulk, point.law().bulk_modulus()) << "step " << step;
    ASSERT_LE(now.shear, point.law().shear_modulus()) << "step " << step;
    ASSERT_GE(now.shear, 0.0);
    ASSERT_GT(now.bulk, 0.0);
  }
}

TEST_P(EveryMaterial, HasTheSameStressesAtSmallerStrainsInShorterTimesWhenScaledAsItsTableSays)
{
  constexpr Real s = 256.0;  // its root is exact
  std::vector<Real> stiffer = parameters();
  for (std::size_t k = 0; k < stiffer.size(); ++k) stiffer[k] *= std::pow(s, type().parameters[k].strain_exponent);
  Probe soft = probe(), stiff(type(), stiffer);
  stiff.dt = soft.dt / std::sqrt(s);
  Random random(7);
  for (int step = 0; step < 200; ++step) {
    Stress d_eps = random_tensor(0.002, random);
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

std::vector<Setting> all_settings()
{
  std::vector<Setting> settings;
  for (const MaterialType* type : all_materials())
    for (const bool on : {true, false})
      if (!type->by_library) settings.push_back({type, on});
  return settings;
}

INSTANTIATE_TEST_SUITE_P(Materials, EveryMaterial, ValuesIn(all_settings()), [](const auto& info) {
  return std::string(info.param.type->name) + (info.param.everything_on ? "_with_everything_on" : "_by_default");
});

TEST(AllMaterials, ShareRowsOnlyWhereTheyMeanTheSame)  // one table for all of them; its assertions look
{
  RowTable table;
  for (const MaterialType* type : all_materials()) {
    if (type->by_library) continue;
    SoilMaterial material{
        "soil", type, type->make_varying(typical_parameters(*type), all_that_may_vary(*type)), 1.0, {}};
    add_rows(0, material, table);
    EXPECT_EQ(material.n_rows(), static_cast<int>(type->state.size() + all_that_may_vary(*type).size()));
  }
  std::set<std::string> names;
  for (const RowInfo& row : table.entries()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

}  // namespace conformance_test
