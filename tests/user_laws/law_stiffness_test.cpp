#include "user_laws/law_stiffness.hpp"
#include "simulation/simulation.hpp"
#include "support/cases.hpp"
#include "support/laws.hpp"
#include "support/test.hpp"
#include "user_laws/user_law.hpp"

namespace law_stiffness_test {

constexpr Real shear = 3.0e6, poisson = 0.3;

/// kind: of wrong_umat.c.
LawStiffness stiffness_of(Real kind)
{
  MaterialCase material = elastic(shear, poisson, 1900.0);
  material.model = "library";
  material.library = {.file = "wrong_umat.so", .interface = LawInterface::umat};
  for (const Real value : {shear, poisson, kind, 0.0, -100.0, 0.0}) material.library.parameters.push_back({"", value});
  material.from_library = load_user_law("clay", law_folder(), material.parameters, material.library);
  const Simulation s(free_box("mpm_gp", {0.5, 0.0}, {3.5, 1.0}, material), 1);
  return measure_stiffness(s.model.materials[0], s.state.points.block(0), 0, 0.25, s.model.dt);
}

TEST(LawStiffness, IsThatOfAnElasticLaw)
{
  const LawStiffness found = stiffness_of(0.0);
  EXPECT_NEAR(found.normal, 2.0 * shear * (1.0 - poisson) / (1.0 - 2.0 * poisson), 1e-6 * shear);
  EXPECT_NEAR(found.shear, shear, 1e-6 * shear);
  EXPECT_NEAR(found.shear_of_axes, shear, 1e-6 * shear);
  EXPECT_TRUE(found.is_elastic);
}

TEST(LawStiffness, ShowsAShearStrainThatIsTakenAsTensorial)
{
  const LawStiffness found = stiffness_of(21.0);
  EXPECT_NEAR(found.shear, 2.0 * shear, 1e-6 * shear);
  EXPECT_NEAR(found.shear_of_axes, shear, 1e-6 * shear);
}

TEST(LawStiffness, HasTheFaultOfALawThatFails) { EXPECT_THAT(stiffness_of(1.0).fault, HasSubstr("not a number")); }

}  // namespace law_stiffness_test
