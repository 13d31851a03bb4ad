#include "simulation/side_shape.hpp"

#include "support/cases.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

TEST(SideShape, HasTheLengthAndTheOutwardNormalOfASide)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {8, 4});
  for (const NamedSide& side : mesh.sides) {
    const SideShape shape = shape_of_side(mesh, side);
    const bool upright = side.name == "left" || side.name == "right";
    EXPECT_DOUBLE_EQ(shape.length, upright ? 2.0 : 4.0);
    EXPECT_DOUBLE_EQ(shape.normal[0], side.name == "left" ? -1.0 : side.name == "right" ? 1.0 : 0.0);
    EXPECT_DOUBLE_EQ(shape.normal[1], side.name == "bottom" ? -1.0 : side.name == "top" ? 1.0 : 0.0);
  }
}

TEST(SideShape, AConditionIsDescribedByWhatItDoes)
{
  const Case c = test::column("mpm_gp");
  EXPECT_EQ(describe(condition_of(c, "bottom")), "contact that never opens, adhesion 8 kPa");
  EXPECT_EQ(describe(condition_of(c, "left")), "roller, no motion across");
  EXPECT_EQ(describe(condition_of(c, "top")), "free, holds nothing");
  SideCase side = test::side("right", SideKind::contact_separating);
  EXPECT_EQ(describe(side), "contact that may open, smooth");
  side.friction = 0.4;
  EXPECT_EQ(describe(side), "contact that may open, friction 0.4");
  side.kind = SideKind::velocity;
  side.velocity = {0.0, -0.01};
  side.slip = true;
  EXPECT_EQ(describe(side), "velocity [0, -0.01] m/s, smooth");
  EXPECT_EQ(describe(test::side("right", SideKind::open)), "open, soil leaves there");
  EXPECT_EQ(describe(test::side("right", SideKind::fixed)), "fixed");
}

}  // namespace
}  // namespace terp
