// What becomes of the parameters; that the stresses stay is in tests/materials/conformance_test.cpp.
#include "stability/stiffen.hpp"
#include "materials/material.hpp"
#include "support/cases.hpp"
#include "support/test.hpp"

namespace {

TEST(Stiffen, MultipliesStiffnessAndSofteningPerStrainAndLeavesStrength)
{
  Case c = column("mpm_gp");
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

TEST(Stiffen, ScalesAViscosityByTheRoot)
{
  Case c = column("mpm_gp");
  c.materials[0] = {"clay", "newtonian_fluid", 1000.0, {2e6, 5.0, 0.0}};
  EXPECT_EQ(stiffen(c, 100.0).materials[0].parameters, (std::vector<Real>{2e8, 50.0, 0.0}));
}

TEST(Stiffen, ScalesAParameterThatVariesAtEachPlace)
{
  Case c = column("mpm_gp");
  c.materials[0].fields = {{0, [](Vec<2> x) { return 1e6 * (1.0 + x[0]); }}};
  EXPECT_DOUBLE_EQ(stiffen(c, 100.0).materials[0].fields[0].value_at({2.0, 0.0}), 3e8);
}

}  // namespace
