#include "model/loads/side_shape.hpp"
#include "support/cases.hpp"

namespace side_shape_test {

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

TEST(SideShape, ASideThatTheCaseDoesNotNameIsFree)
{
  const Case c = column("mpm_gp");
  EXPECT_EQ(condition_of(c, "left").kind, SideKind::roller);
  EXPECT_EQ(condition_of(c, "top").kind, SideKind::free);
}

}  // namespace side_shape_test
