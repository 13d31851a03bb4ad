#include "mpm/mesh/geometry_lanes.hpp"
#include "mpm/mesh/mesh.hpp"
#include "support/meshes.hpp"

namespace geometry_lanes_test {

void expect_lane(const GeometryLanes<Quad4>& lanes, int c, const CellGeometry<Quad4>& cell)
{
  EXPECT_EQ(lanes.volume[c], cell.volume);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(lanes.gauss_volume[i][c], cell.gauss_volume[i]);
    for (int d = 0; d < 2; ++d) {
      EXPECT_EQ(lanes.centre_gradient[i][d][c], cell.centre_gradient[i][d]);
      for (int g = 0; g < 4; ++g) EXPECT_EQ(lanes.gradient[i][d][g][c], cell.gradient[i][d][g]);
    }
  }
}

TEST(GeometryLanes, HoldEachCellInItsLane)
{
  const Mesh<2> distorted = distorted_rectangle(4, 2, 1.0, 0.3, 3),
                equal = make_rectangle({0.0, 0.0}, {4.0, 1.0}, {4, 2});
  for (const Mesh<2>* mesh : {&distorted, &equal}) {
    std::array<const CellGeometry<Quad4>*, pack_width> cells;
    for (Index c = 0; c < pack_width; ++c) cells[c] = &mesh->geometry(c);
    const GeometryLanes<Quad4> lanes = geometry_lanes(cells);
    for (int c = 0; c < pack_width; ++c) expect_lane(lanes, c, *cells[c]);
  }
}

}  // namespace geometry_lanes_test
