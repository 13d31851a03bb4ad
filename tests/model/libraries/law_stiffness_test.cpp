#include "model/libraries/law_stiffness.hpp"
#include "run/loop/simulation.hpp"
#include "support/law_cases.hpp"

namespace law_stiffness_test {

LawStiffness stiffness_of(Kind kind)
{
  const Simulation s(free_box("mpm_gp", {0.5, 0.0}, {3.5, 1.0}, wrong_umat(kind)), 1);
  return measure_stiffness(s.model.materials[0], s.state.points.block(0), 0, 0.25, s.model.dt);
}

TEST(LawStiffness, IsThatOfAnElasticLaw)
{
  const LawStiffness found = stiffness_of(elastic_law);
  EXPECT_NEAR(found.normal, 2.0 * shear * (1.0 - poisson) / (1.0 - 2.0 * poisson), 1e-6 * shear);
  EXPECT_NEAR(found.shear, shear, 1e-6 * shear);
  EXPECT_NEAR(found.shear_of_axes, shear, 1e-6 * shear);
  EXPECT_TRUE(found.is_elastic);
}

TEST(LawStiffness, ShowsAShearStrainThatIsTakenAsTensorial)
{
  const LawStiffness found = stiffness_of(tensorial_shear);
  EXPECT_NEAR(found.shear, 2.0 * shear, 1e-6 * shear);
  EXPECT_NEAR(found.shear_of_axes, shear, 1e-6 * shear);
}

TEST(LawStiffness, HasTheFaultOfALawThatFails)
{
  EXPECT_TRUE(stiffness_of(nan_stress).failed);
  EXPECT_FALSE(stiffness_of(elastic_law).failed);
}

}  // namespace law_stiffness_test
