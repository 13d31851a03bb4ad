#include "model/meshes/polygon_mesh.hpp"
#include "support/test.hpp"

namespace polygon_mesh_test {

PolygonMesh rectangle()
{
  PolygonMesh mesh;
  mesh.polygon = {{1e5, 0.0}, {1e5 + 4.0, 0.0}, {1e5 + 4.0, 2.0}, {1e5, 2.0}};
  mesh.cell = 0.1;
  return mesh;
}

TEST(EstimateCells, IsTheAreaOverThatOfACell) { EXPECT_NEAR(estimate_cells(rectangle()), 800.0, 1e-6); }

TEST(EstimateCells, CountsABoxWhereItLiesInThePolygon)
{
  const Refinement box{{}, {1e5 + 3.0, 1.0}, {1e5 + 9.0, 9.0}, 0.01, 0.0};
  EXPECT_NEAR(estimate_more_cells(rectangle(), box), 1.0 * 1.0 / 1e-4, 1e-3);
}

TEST(EstimateCells, CountsTheStripsAlongALine)  // 2 sides x 1 m x 0.5 m / (0.02 m x 0.1 m)
{
  const Refinement line{{{1e5 + 1.0, 0.5}, {1e5 + 1.0, 1.5}}, {}, {}, 0.02, 0.5};
  EXPECT_NEAR(estimate_more_cells(rectangle(), line), 500.0, 1e-9);
}

TEST(EstimateCells, TakesNothingFromARefinementThatIsNone)
{
  EXPECT_EQ(estimate_more_cells(rectangle(), {{}, {1e5, 0.0}, {1e5 + 1.0, 1.0}, 0.2, 0.0}), 0.0);
}

}  // namespace polygon_mesh_test
