// The return to a Mohr-Coulomb surface against all ways to choose active planes, solved one by one.
#include "soil/laws/mohr_coulomb_return.hpp"
#include "support/random.hpp"
#include <optional>

namespace mohr_coulomb_return_test {

using Vector = std::array<Real, 3>;

constexpr Real degree = std::numbers::pi / 180.0;

struct Soil {
  Real bulk = 5e6, shear = 2e6, phi = 30.0, psi = 10.0, cohesion = 5e3,
       tension = 2e3;  // Pa, deg; tension at most c cot(phi)

  MohrCoulombStrength<Real> strength() const
  {
    return {std::sin(phi * degree), std::cos(phi * degree), std::sin(psi * degree), cohesion, tension};
  }
};

/// A plane of the surface: n . s <= limit, with the direction of its flow.
struct Plane {
  Vector n, flow;
  Real limit;
};

/// Six shear planes, one per ordered pair of directions, and three tension planes.
std::vector<Plane> planes_of(const Soil& soil)
{
  const auto s = soil.strength();
  std::vector<Plane> planes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      Plane plane{{}, {}, 2.0 * s.cohesion * s.cos_phi};
      plane.n[i] = 1.0 + s.sin_phi, plane.n[j] = -(1.0 - s.sin_phi);
      plane.flow[i] = 1.0 + s.sin_psi, plane.flow[j] = -(1.0 - s.sin_psi);
      planes.push_back(plane);
    }
  for (int i = 0; i < 3; ++i) {
    Plane plane{{}, {}, s.tension};
    plane.n[i] = plane.flow[i] = 1.0;
    planes.push_back(plane);
  }
  return planes;
}

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector elastic(const Soil& soil, const Vector& eps)
{
  const Real lame = soil.bulk - 2.0 / 3.0 * soil.shear, volumetric = lame * (eps[0] + eps[1] + eps[2]);
  return {volumetric + 2.0 * soil.shear * eps[0], volumetric + 2.0 * soil.shear * eps[1],
      volumetric + 2.0 * soil.shear * eps[2]};
}

/// Multipliers of the chosen planes by Gauss elimination; none if they depend on each other.
std::optional<std::vector<Real>> multipliers(const Soil& soil, const std::vector<Plane>& active, const Vector& trial)
{
  const std::size_t n = active.size();
  std::vector<std::vector<Real>> rows(n, std::vector<Real>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(active[i].n, elastic(soil, active[j].flow));
    rows[i][n] = dot(active[i].n, trial) - active[i].limit;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    std::swap(rows[k], rows[pivot]);
    if (std::abs(rows[k][k]) < 1e-6 * soil.shear) return {};
    for (std::size_t i = 0; i < n; ++i) {
      const Real factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; i != k && j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<Real> answer;
  for (std::size_t k = 0; k < n; ++k) answer.push_back(rows[k][n] / rows[k][k]);
  return answer;
}

/// The stress that these planes together lead to, if their multipliers are not negative and no plane forbids it.
std::optional<Vector> admissible(const Soil& soil, const std::vector<Plane>& active, const Vector& trial)
{
  const auto found = multipliers(soil, active, trial);
  if (!found) return {};
  Vector s = trial;
  for (std::size_t k = 0; k < active.size(); ++k) {
    if ((*found)[k] < -1e-12) return {};
    const Vector moved = elastic(soil, active[k].flow);
    for (int i = 0; i < 3; ++i) s[i] -= (*found)[k] * moved[i];
  }
  for (const Plane& plane : planes_of(soil))
    if (dot(plane.n, s) > plane.limit + 1e-6) return {};
  return s;
}

struct Answers {
  std::vector<Vector> stresses;
  std::size_t fewest_planes = 4;
};

/// Every stress that one, two or three active planes lead to and that all of them allow.
Answers all_answers(const Soil& soil, const Vector& trial)
{
  const auto planes = planes_of(soil);
  Answers answers;
  const auto attempt = [&](const std::vector<Plane>& active) {
    if (const auto s = admissible(soil, active, trial)) {
      answers.stresses.push_back(*s);
      answers.fewest_planes = std::min(answers.fewest_planes, active.size());
    }
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    attempt({planes[i]});
    for (std::size_t j = 0; j < i; ++j) {
      attempt({planes[i], planes[j]});
      for (std::size_t k = 0; k < j; ++k) attempt({planes[i], planes[j], planes[k]});
    }
  }
  return answers;
}

bool is_outside(const Soil& soil, const Vector& s)
{
  for (const Plane& plane : planes_of(soil))
    if (dot(plane.n, s) > plane.limit) return true;
  return false;
}

/// The return agrees with every admissible choice of planes. Counts the cases by the number of planes that are needed.
void expect_the_only_answer(const Soil& soil, Vector trial, std::array<int, 4>& count)
{
  std::sort(trial.begin(), trial.end(), std::greater<>());
  if (!is_outside(soil, trial)) return;
  const Answers answers = all_answers(soil, trial);
  ASSERT_FALSE(answers.stresses.empty()) << trial[0] << ' ' << trial[1] << ' ' << trial[2];
  ++count[answers.fewest_planes];
  const Sorted<Real> s =
      MohrCoulombReturn<Real>(soil.strength(), soil.bulk, soil.shear)(Sorted<Real>{trial[0], trial[1], trial[2]});
  for (const Vector& answer : answers.stresses) {
    const Real tolerance = 1e-5 + 1e-11 * std::abs(trial[2]);
    ASSERT_NEAR(s.major, answer[0], tolerance)
        << trial[0] << ' ' << trial[1] << ' ' << trial[2] << ", phi " << soil.phi << ", psi " << soil.psi;
    ASSERT_NEAR(s.middle, answer[1], tolerance) << trial[0] << ' ' << trial[1] << ' ' << trial[2];
    ASSERT_NEAR(s.minor, answer[2], tolerance) << trial[0] << ' ' << trial[1] << ' ' << trial[2];
  }
}

TEST(MohrCoulombReturn, IsTheOneChoiceOfActivePlanesThatIsAdmissible)
{
  Random random(81);
  std::array<int, 4> count{};
  for (int k = 0; k < 20000; ++k) {
    Soil soil;
    soil.phi = random.between(1.0, 55.0);
    soil.psi = k % 3 == 0 ? 0.0 : k % 3 == 1 ? soil.phi : random.between(0.0, soil.phi);
    soil.bulk = random.between(0.7, 50.0) * soil.shear;
    soil.cohesion = k % 7 == 0 ? 0.0 : 5e3;
    const Real apex = soil.cohesion / std::tan(soil.phi * degree);
    soil.tension = k % 5 == 0 ? apex : k % 5 == 1 ? 0.0 : random.between(0.0, apex);
    const Real p = random.between(-60e3, 30e3);
    expect_the_only_answer(soil,
        {p + random.between(-20e3, 20e3), p + random.between(-20e3, 20e3), p + random.between(-20e3, 20e3)}, count);
    if (HasFatalFailure()) return;
  }
  for (const int planes : {1, 2, 3}) EXPECT_GT(count[planes], 1000) << planes << " planes";
}

TEST(MohrCoulombReturn,
    TakesTheStressOfTheClosedFormOnAPlane)  // by hand: phi = 30, psi = 0, c = 0: 3 s1 = s3, s1 + s3 stays
{
  const Soil soil{.psi = 0.0, .cohesion = 0.0, .tension = 0.0};
  const Sorted<Real> s = MohrCoulombReturn<Real>(soil.strength(), soil.bulk, soil.shear)({-5e3, -30e3, -75e3});
  EXPECT_NEAR(s.major, -20e3, 1e-8);
  EXPECT_EQ(s.middle, -30e3);
  EXPECT_NEAR(s.minor, -60e3, 1e-8);
}

TEST(MohrCoulombReturn, DilatancyRaisesThePressureThatFrictionNeeds)
{
  const Sorted<Real> trial{-5e3, -30e3, -75e3};
  Real before = 0.0;
  for (const Real psi : {0.0, 10.0, 20.0, 30.0}) {
    const Soil soil{.psi = psi};
    const Sorted<Real> s = MohrCoulombReturn<Real>(soil.strength(), soil.bulk, soil.shear)(trial);
    EXPECT_LT(s.major + s.middle + s.minor, before);
    before = s.major + s.middle + s.minor;
  }
}

TEST(MohrCoulombReturn, EndsAtTheApexOfSoilWithoutCohesionThatIsPulledApart)
{
  const Soil soil{.cohesion = 0.0, .tension = 0.0};
  const Sorted<Real> s = MohrCoulombReturn<Real>(soil.strength(), soil.bulk, soil.shear)({40e3, 30e3, 25e3});
  EXPECT_EQ(s.major, 0.0);
  EXPECT_EQ(s.middle, 0.0);
  EXPECT_EQ(s.minor, 0.0);
}

}  // namespace mohr_coulomb_return_test
