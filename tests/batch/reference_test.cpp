// A known probability: the undrained slope of 2:1 on a foundation layer as deep as the slope is high, of one lognormal
// strength everywhere, fails below c_u = 0.17 gamma H (Taylor 1937), so that P = Phi((ln 0.17 - mu)/sigma); Griffiths &
// Fenton, J. Geotech. Geoenviron. Eng. 130 (2004) 507-518, with a correlation length without end.
#include "batch/engine.hpp"

#include "batch/samples.hpp"

namespace reference_test {

const std::string slope_case = R"([time]
end = 40.0
[mesh]
size = [60.0, 22.0]
cell = 2.0
[[body]]
material = "clay"
polygon = [[0.0, 0.0], [60.0, 0.0], [60.0, 10.0], [40.0, 10.0], [20.0, 20.0], [0.0, 20.0]]
points_per_cell = 3
[material.clay]
model = "tresca_softening"
density = 2000.0
shear_modulus = 10.0e6
poisson_ratio = 0.45
su_peak = 49.05e3
sensitivity = 1.0
[forces]
gravity = [0.0, -9.81]
damping = { local = 0.1 }
[initial]
stress = "k0"
k0 = 1.0
[boundary]
left = "roller"
right = "roller"
bottom = "fixed"
[output]
ledger = { every = 1.0 }
)";

// Mean 0.25 gamma H, coefficient of variation 0.5. A Latin hypercube of one number has one realisation in each n-th of
// its distribution, so that its P errs by 1/n at most, beside what cells of 2 m err in the critical strength.
TEST(StudyReference, ASlopeFailsWithTheProbabilityOfItsCriticalStrength)
{
  constexpr Real n = 20.0, exact = 0.2809;
  const StudyWithStores place(R"(case = "column.toml"
[[random]]
key = "material.clay.su_peak"
distribution = "lognormal"
mean = 49050.0
cov = 0.5
[estimator]
kind = "latin_hypercube"
[stop]
number = 20
[events]
volume = 50.0
displacement = 0.3
)",
      slope_case);
  const Realisations rows = place.run("all", {.threads = 2});
  Real strongest = 0.0, weakest = 1e9;
  for (const auto& [number, r] : rows) {
    ASSERT_TRUE(r.solved()) << r.fault;
    if (r.slid)
      strongest = std::max(strongest, r.inputs[0]);
    else
      weakest = std::min(weakest, r.inputs[0]);
  }
  const StudyEstimates e = estimate(place.study, rows);
  EXPECT_NEAR(*e.slide.probability(), exact, 1.0 / n);
  EXPECT_LE(e.slide.bounds.low, exact);
  EXPECT_GE(e.slide.bounds.high, exact);
  EXPECT_LT(strongest, weakest) << "what slides is weaker than what stands";
  constexpr Real gamma_h = 2000.0 * 9.81 * 10.0;
  EXPECT_LT(strongest / gamma_h, 0.18);
  EXPECT_GT(weakest / gamma_h, 0.16);
}

}  // namespace reference_test
