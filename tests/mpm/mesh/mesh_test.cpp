#include "mpm/mesh/mesh.hpp"
#include "support/meshes.hpp"

namespace mesh_test {

using testing::Pair;

// Cells 3 4 5 above 0 1 2; nodes 0 ... 3 at the bottom, 4 ... 7, 8 ... 11 at the top.
Mesh<2> three_by_two() { return make_rectangle({1.0, -2.0}, {3.0, 1.0}, {3, 2}); }

std::vector<std::pair<Index, int>> edges_of(const Mesh<2>& mesh, std::string_view name)
{
  std::vector<std::pair<Index, int>> edges;
  for (const auto& side : mesh.sides)
    if (side.name == name)
      for (const auto& edge : side.edges) edges.emplace_back(edge.cell, edge.side);
  return edges;
}

TEST(Rectangle, HasItsNodesAndCells)
{
  const auto mesh = three_by_two();
  EXPECT_EQ(mesh.n_nodes(), 12);
  EXPECT_EQ(mesh.n_cells(), 6);
  EXPECT_THAT(mesh.nodes[6], ElementsAre(DoubleEq(3.0), DoubleEq(-1.5)));
  EXPECT_THAT(mesh.cells[4], ElementsAre(5, 6, 10, 9));
  EXPECT_THAT(mesh.centres[4], ElementsAre(DoubleEq(2.5), DoubleEq(-1.25)));
}

TEST(Rectangle, NamesItsFourSides)
{
  const auto mesh = three_by_two();
  EXPECT_THAT(edges_of(mesh, "left"), ElementsAre(Pair(0, 3), Pair(3, 3)));
  EXPECT_THAT(edges_of(mesh, "right"), ElementsAre(Pair(2, 1), Pair(5, 1)));
  EXPECT_THAT(edges_of(mesh, "bottom"), ElementsAre(Pair(0, 0), Pair(1, 0), Pair(2, 0)));
  EXPECT_THAT(edges_of(mesh, "top"), ElementsAre(Pair(3, 2), Pair(4, 2), Pair(5, 2)));
}

TEST(Rectangle, KnowsTheNeighbourOverEachSide)
{
  const auto mesh = three_by_two();
  EXPECT_THAT(mesh.neighbours[0], ElementsAre(outside, 1, 3, outside));
  EXPECT_THAT(mesh.neighbours[4], ElementsAre(1, 5, outside, 3));
}

TEST(Rectangle, ListsTheCellsOfANodeInOrder)
{
  const auto mesh = three_by_two();
  const auto cells_of = [&](Index node) {
    std::vector<std::pair<Index, Index>> list;
    for (Index k = mesh.first_cell_of_node[node]; k < mesh.first_cell_of_node[node + 1]; ++k)
      list.emplace_back(
          static_cast<Index>(mesh.cells_of_node[k].cell), static_cast<Index>(mesh.cells_of_node[k].corner));
    return list;
  };
  EXPECT_THAT(cells_of(5), ElementsAre(Pair(0, 2), Pair(1, 3), Pair(3, 1), Pair(4, 0)));
  EXPECT_THAT(cells_of(0), ElementsAre(Pair(0, 0)));
  EXPECT_THAT(cells_of(11), ElementsAre(Pair(5, 2)));
}

TEST(Rectangle, KeepsOneGeometryForAllItsEqualCells)
{
  const auto mesh = make_rectangle({0.0, 0.0}, {16.0, 3.0}, {160, 30});
  EXPECT_EQ(mesh.geometries.size(), 1u);
  EXPECT_NEAR(mesh.geometry(4000).volume, 0.01, 1e-15);
  EXPECT_NEAR(mesh.smallest_altitude, 0.1, 1e-14);
}

TEST(Connect, FindsNeighboursThatShareTwoNodes)
{
  const auto mesh = distorted_rectangle(7, 5, 0.2, 0.3, 1);
  Index n_inner = 0;
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < 4; ++s) {
      const Index other = mesh.neighbours[e][s];
      if (other == outside) continue;
      ++n_inner;
      EXPECT_THAT(mesh.neighbours[other], Contains(e));
      for (const Index node : {mesh.cells[e][s], mesh.cells[e][(s + 1) % 4]})
        EXPECT_THAT(mesh.cells[other], Contains(node));
    }
  EXPECT_EQ(n_inner, 2 * (6 * 5 + 7 * 4));
}

TEST(Connect, GivesDifferentCellsTheirOwnGeometry)
{
  const auto mesh = distorted_rectangle(7, 5, 0.2, 0.3, 2);
  Real volume = 0.0, smallest = 1.0;
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const auto own = make_cell_geometry<Quad4>(mesh.corners(e));
    EXPECT_EQ(mesh.geometry(e).gauss_volume, own.gauss_volume);
    volume += mesh.geometry(e).volume;
    smallest = std::min(smallest, own.altitude);
  }
  EXPECT_NEAR(volume, 1.4 * 1.0, 1e-13);
  EXPECT_EQ(mesh.smallest_altitude, smallest);
  EXPECT_EQ(mesh.geometry(mesh.cell_of_smallest_altitude).altitude, smallest);
}

TEST(Connect, TellsCellsApartThatDifferByAMillionth)
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {2.0, 1.000001}};
  mesh.cells = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  connect(mesh);
  EXPECT_EQ(mesh.geometries.size(), 2u);
  EXPECT_THAT(mesh.neighbours[0], ElementsAre(outside, 1, outside, outside));
}

TEST(Connect, JoinsCellsWhoseCornersStartAnywhere)
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}};
  mesh.cells = {{4, 3, 0, 1}, {2, 5, 4, 1}};
  connect(mesh);
  EXPECT_THAT(mesh.neighbours[0], ElementsAre(outside, outside, outside, 1));
  EXPECT_THAT(mesh.neighbours[1], ElementsAre(outside, outside, 0, outside));
}

}  // namespace mesh_test
