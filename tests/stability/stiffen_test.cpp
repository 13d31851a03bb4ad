// What becomes of the parameters; that the stresses stay is in tests/materials/conformance_test.cpp.
#include "stability/stiffen.hpp"

#include "materials/material.hpp"
#include "support/cases.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

TEST(Stiffen, MultipliesStiffnessAndSofteningPerStrainAndLeavesStrength)
{
  Case c = test::column("mpm_gp");
  c.forces.viscous_damping = 0.3;
  const Case stiff = stiffen(c, 100.0);
  const auto parameters = find_material(c.materials[0].model)->parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const bool per_strain = parameters[k].name == "shear_modulus" || parameters[k].name == "eta";
    EXPECT_DOUBLE_EQ(stiff.materials[0].parameters[k], c.materials[0].parameters[k] * (per_strain ? 100.0 : 1.0))
        << parameters[k].name;
  }
  EXPECT_DOUBLE_EQ(stiff.forces.viscous_damping, 3.0);  // times are ten times shorter
  EXPECT_DOUBLE_EQ(stiff.time.end, c.time.end / 10.0);
  EXPECT_EQ(stiff.sides.back().adhesion, c.sides.back().adhesion);
}

}  // namespace
}  // namespace terp
