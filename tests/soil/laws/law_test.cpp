// What a law's file may leave out, and what it says about rates: a strength that grows with the rate is no viscosity.
#include "soil/laws/law.hpp"
#include "soil/laws/elastic_constants.hpp"
#include "support/test.hpp"

namespace law_test {

/// Shear stress up to a limit that grows with the rate of shear: one component, for tests of the frame around a law.
template <class P>
struct RateLimited {
  static constexpr std::string_view equations = "|tau| <= tau_0 (1 + |d_gamma/dt| / rate)\n";
  static constexpr std::array parameters{shear_modulus_info, poisson_ratio_info,
      ParameterInfo{.name = "strength",
          .unit = "Pa",
          .range = positive,
          .typical = 1e3,
          .meaning = "tau_0",
          .reduction = Reduction::divide,
          .may_vary = true},
      ParameterInfo{.name = "rate",
          .unit = "1/s",
          .range = positive,
          .typical = 2.0,
          .meaning = "reference rate",
          .strain_exponent = -0.5}};
  static constexpr std::array state{StateInfo{"age", "-", Averaging::sub_cell, "steps so far", Role::none, 3.0}};
  static constexpr std::array<DerivedInfo, 0> derived{};
  static constexpr bool depends_on_rate = true;

  explicit RateLimited(std::span<const P> v)
      : shear(v[0]), bulk(bulk_from_poisson(v[0], v[1])), strength(v[2]), rate(v[3])
  {
  }

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, 1>& age, const SymTensor<R, Dim>& d_eps, Real dt) const
  {
    add_elastic_stress(sigma, d_eps, bulk, shear);
    const R limit = R(strength) * (R(1.0) + abs(d_eps[3]) * R(2.0) / (R(rate) * R(dt)));
    sigma[3] = max(-limit, min(limit, sigma[3]));
    age[0] = age[0] + R(1.0);
    return R(0.0);
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return shear; }

  P shear, bulk;     // [Pa]
  P strength, rate;  // [Pa], [1/s]
};

constexpr MaterialType type = define_law<RateLimited>("rate_limited", "for tests");
const std::vector<Real> values{2e6, 0.3, 1e3, 2.0};

TEST(Law, MayLeaveOutWhatItDoesNotHave)
{
  const auto law = type.make(values);
  EXPECT_TRUE(type.check(values).empty());
  EXPECT_EQ(law->softened_strain(), INFINITY);
  EXPECT_TRUE(std::isnan(law->derived(0, {.state = {.data = std::vector<Real>{3.0}.data()}, .parameters = {}})));
  EXPECT_TRUE(type.not_judged.empty());
}

TEST(Law, WhoseStrengthDependsOnTheRateHasNoViscosityForTheTimeStep)
{
  EXPECT_TRUE(type.depends_on_rate);
  EXPECT_EQ(type.make(values)->viscosity(), 0.0);
}

/// sigma_xy of eight points after one strain of 0.01 in 1 ms; four of them in use.
std::array<Real, pack_width> shear_stress(const std::vector<int>& varying, Real* rows)
{
  alignas(64) Real numbers[4 + 4 + 1][pack_width] = {};
  std::fill_n(numbers[7], pack_width, 0.01);
  StressArrays<2> arrays{};
  for (int k = 0; k < 4; ++k) arrays.sigma[k] = numbers[k], arrays.d_eps[k] = numbers[4 + k];
  arrays.law.state = {.data = rows, .stride = pack_width};
  arrays.law.parameters = {.data = rows + pack_width, .stride = pack_width};
  arrays.plastic_work = numbers[8];
  arrays.n = pack_width;
  arrays.n_points = 4;
  arrays.dt = 1e-3;
  type.make_varying(values, varying)->update(arrays);
  std::array<Real, pack_width> tau;
  std::copy_n(numbers[3], pack_width, tau.begin());
  return tau;
}

TEST(Law, TakesAParameterFromEachPointAndTheReferenceValueInPadding)
{
  alignas(64) Real rows[2][pack_width] = {{}, {1e3, 2e3, 500.0, 1e3, 0.0, 0.0, 0.0, 0.0}};
  const auto own = shear_stress({2}, rows[0]), same = shear_stress({}, rows[0]);
  const Real factor = 1.0 + 0.02 / (2.0 * 1e-3);
  EXPECT_DOUBLE_EQ(same[0], 1e3 * factor);
  EXPECT_EQ(own[0], same[0]);
  EXPECT_DOUBLE_EQ(own[1], 2e3 * factor);
  EXPECT_DOUBLE_EQ(own[2], 500.0 * factor);
  for (int k = 4; k < pack_width; ++k) EXPECT_EQ(own[static_cast<std::size_t>(k)], same[0]) << k;
}

}  // namespace law_test
