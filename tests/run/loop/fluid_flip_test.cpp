#include "support/simulations.hpp"

namespace fluid_flip_test {

/// Water and clay beside each other.
Model water_and_clay(Real flip)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {1.0, 1.0});
  c.materials.push_back({"water", "newtonian_fluid", 1000.0, {2.0e6, 1.0e-3}});
  c.bodies.push_back(body("water", {1.0, 0.0}, {2.0, 1.0}));
  c.method.flip = flip;
  return build_model(c, 1);
}

TEST(FluidFlip, IsATwentiethOfPicInAFluidAlone)
{
  const Model model = water_and_clay(std::numeric_limits<Real>::quiet_NaN());
  EXPECT_EQ(model.materials[0].flip, 1.0);
  EXPECT_EQ(model.materials[1].flip, 0.95);
  EXPECT_EQ(model.method.flip, 0.95);
}

TEST(FluidFlip, IsWhatTheCaseSays)
{
  const Model model = water_and_clay(0.9);
  EXPECT_EQ(model.materials[0].flip, 0.9);
  EXPECT_EQ(model.materials[1].flip, 0.9);
}

}  // namespace fluid_flip_test
