#include "soil/laws/probe.hpp"

namespace ngi_adp_test {

constexpr Real G = 2.0e6, nu = 0.49, active = 14e3, direct = 9e3, passive = 6e3;
constexpr Real a = 0.5 * (active + passive), b = direct, c = 0.5 * (active - passive);

const MaterialType& type() { return *find_material("ngi_adp"); }
Probe soil(Real share = 1.0, Real eta = 0.0, Real angle = 0.0)
{
  return Probe(type(), {G, nu, active, direct, passive, share, eta, angle});
}

Real x_of(const Probe& point) { return 0.5 * (point.sigma[0] - point.sigma[1]); }

TEST(NgiAdp, ResistsSlipAlongAPlaneOfAnyDirectionAsItsEllipseSays)
{
  constexpr Real eighth = 0.25 * std::numbers::pi;  // at which the strengths are the passive and the active one
  for (const Real beta : {-eighth, -0.7, -0.3, 0.0, 0.1, 0.4, eighth, 1.2}) {  // slip along (cos, -sin)
    Probe point = soil();
    const Real s = std::sin(2.0 * beta), k = std::cos(2.0 * beta);
    strain_in_parts(point, {{0.2 * s, -0.2 * s, 0.0, 0.2 * k}}, 4000);
    EXPECT_NEAR(x_of(point) * s + point.sigma[3] * k, c * s + std::sqrt(a * a * s * s + b * b * k * k), 1e-6) << beta;
  }
}

TEST(NgiAdp, TurnsItsStrengthsWithItsAxes)
{
  constexpr Real angle = 25.0 * std::numbers::pi / 180.0;
  Probe upright = soil(), turned = soil(1.0, 0.0, 25.0);
  const Stress d{{0.01, -0.012, 0.0, 0.02}};
  strain_in_parts(upright, d, 50);
  strain_in_parts(turned, rotated(d, -angle), 50);
  const Stress back = rotated(turned.sigma, angle);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(back[k], upright.sigma[k], 1e-7) << k;
}

TEST(NgiAdp, IsTrescasLawWhereAllStrengthsAreEqual)
{
  for (const bool softens : {false, true}) {
    const Real eta = softens ? 40.0 : 0.0;
    Probe adp(type(), {G, nu, 8e3, 8e3, 8e3, 0.25, eta, 0.0});
    Probe tresca(*find_material("tresca_softening"), {G, nu, 8e3, 2e3, eta});
    Random random(3);
    for (int step = 0; step < 400; ++step) {
      const Real size = step % 3 ? 2e-4 : 1e-2, shear = random.between(-size, size);
      const Stress d{{shear, -shear, 0.0, random.between(-size, size)}};  // sigma_zz is the middle one
      adp.strain(d);
      tresca.strain(d);
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(adp.sigma[k], tresca.sigma[k], 1e-9 * 8e3) << "step " << step;
      ASSERT_NEAR(adp.state[0], tresca.state[0], 1e-10 * (1.0 + tresca.state[0]));
      ASSERT_NEAR(adp.plastic_work, tresca.plastic_work, 1e-8 * (1.0 + tresca.plastic_work));
    }
  }
}

Real elastic_product(const Stress& u, const Stress& v)  // of stress differences: u : C : v [J/m^3]
{
  const Real K = 2.0 * G * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu)), mean = trace(u) / 3.0;
  Real sum = trace(u) * trace(v) / (9.0 * K);
  for (int k = 0; k < 3; ++k) sum += (u[k] - mean) * v[k] / (2.0 * G);
  return sum + u[3] * v[3] / G;
}

TEST(NgiAdp, WithALimitOfTensionGoesToTheNearestStressThatBothSurfacesAdmit)
{
  Random random(12);
  int on_both = 0;
  for (const Real cutoff : {0.0, 4e3}) {
    for (int trial = 0; trial < 200; ++trial) {
      Probe point(*type().torn, {G, nu, active, direct, passive, 1.0, 0.0, 20.0, cutoff});
      const Stress d = random_tensor(0.004, random);
      point.strain(d);
      const auto s = sorted_principal(point.sigma);
      ASSERT_LE(s[0], cutoff + 1e-6);
      Probe elastic(*find_material("linear_elastic"), {G, nu});
      elastic.strain(d);
      Stress away;
      for (int k = 0; k < 4; ++k) away[k] = elastic.sigma[k] - point.sigma[k];
      on_both += s[0] > cutoff - 1e-6 && s[0] - s[2] > 1e3;
      for (int other = 0; other < 200; ++other) {  // no admissible stress lies on the side to which it was pulled back
        Probe admitted(*type().torn, {G, nu, active, direct, passive, 1.0, 0.0, 20.0, cutoff});
        admitted.strain(random_tensor(other % 2 ? 0.004 : 0.0005, random));
        Stress to;
        for (int k = 0; k < 4; ++k) to[k] = admitted.sigma[k] - point.sigma[k];
        ASSERT_LE(elastic_product(away, to), 1e-9 * (1.0 + elastic_product(elastic.sigma, elastic.sigma))) << trial;
      }
    }
  }
  EXPECT_GT(on_both, 20);
}

TEST(NgiAdp, TornIsTrescasLawWhereAllStrengthsAreEqual)
{
  constexpr Real left_out = std::numeric_limits<Real>::quiet_NaN();
  for (const Real eta : {0.0, 40.0}) {
    Random random(4);
    for (int walk = 0; walk < 50; ++walk) {
      Probe adp(*type().torn, {G, nu, 8e3, 8e3, 8e3, 0.25, eta, 0.0, 1e3});
      Probe tresca(*find_material("tresca_softening")->torn,
          {G, nu, 8e3, 2e3, eta, left_out, left_out, left_out, left_out, 1e3});
      const Real way = random.between(-1e-3, 1e-3), turn = random.between(-1e-3, 1e-3);
      for (int step = 0; step < 30; ++step) {
        const Real swell = step < 20 ? 2e-5 : -4e-5;  // sigma_zz stays the middle one
        const Stress d{{way + swell, swell - way, swell, turn}};
        adp.strain(d);
        tresca.strain(d);
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(adp.sigma[k], tresca.sigma[k], 1e-8 * 8e3) << "step " << step;
        for (int k = 0; k < 2; ++k) ASSERT_NEAR(adp.state[k], tresca.state[k], 1e-10 * (1.0 + tresca.state[k]));
        ASSERT_NEAR(adp.plastic_work, tresca.plastic_work, 1e-8 * (1.0 + tresca.plastic_work));
      }
    }
  }
}

TEST(NgiAdp, EndsEveryStepOnOrInsideTheEllipseOfItsStrainAndDissipates)
{
  for (const bool softens : {false, true}) {
    Probe point = softens ? soil(0.3, 50.0) : soil();
    Random random(5);
    for (int step = 0; step < 2000; ++step) {
      const Real size = std::pow(10.0, random.between(-6.0, -1.0)), before = point.state[0];
      point.strain(random_tensor(size, random));
      const Real share = softens ? 0.3 + 0.7 * std::exp(-50.0 * point.state[0]) : 1.0;
      EXPECT_NEAR(point.derived(0), active * share, 1e-9 * active);
      const Real u = (x_of(point) - c * share) / (a * share), v = point.sigma[3] / (b * share);
      ASSERT_LE(u * u + v * v, 1.0 + 1e-9) << "step " << step;
      ASSERT_GE(point.state[0], before);
      ASSERT_GE(point.plastic_work, 0.0);
    }
  }
}

TEST(NgiAdp, GoesToTheNearestPointOfTheEllipse)  // found by walking around it
{
  Random random(9);
  for (int trial = 0; trial < 50; ++trial) {
    Probe point = soil();
    const Real x = random.between(-0.02, 0.02), y = random.between(-0.02, 0.02);
    point.strain({{x, -x, 0.0, y}});
    const Real X = 2.0 * G * x, Y = 2.0 * G * y;
    if (std::pow((X - c) / a, 2) + std::pow(Y / b, 2) < 1.0) continue;
    Real nearest = 1e30;
    for (int k = 0; k < 20000; ++k) {
      const Real t = 2.0 * std::numbers::pi * k / 20000.0;
      nearest = std::min(nearest, std::hypot(X - c - a * std::cos(t), Y - b * std::sin(t)));
    }
    EXPECT_NEAR(std::hypot(X - x_of(point), Y - point.sigma[3]), nearest, 1.0);
    EXPECT_NEAR(point.state[0], nearest / (2.0 * G), 1e-6);
  }
}

TEST(NgiAdp, RefusesSofteningThatIsTooSteep)
{
  EXPECT_THAT(type().check(std::vector<Real>{1e5, nu, active, direct, passive, 0.5, 50.0, 0.0}),
      ElementsAre(problem("eta", "softening is too steep",
          "eta (1 - residual_share) (|c| + max(a, b)) = 3.5e+05 Pa, at most 1.5 G = 1.5e+05 Pa\n"
          "(beyond 2 G the return mapping has no unique answer). Use eta <= 21.4, or a stiffer soil.")));
}

}  // namespace ngi_adp_test
