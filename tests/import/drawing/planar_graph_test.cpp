#include "import/drawing/planar_graph.hpp"
#include "support/test.hpp"

namespace planar_graph_test {

std::vector<Real> face_areas(const PlanarGraph& graph)
{
  std::vector<Real> areas;
  const PlanarFaces faces = find_faces(graph);
  for (std::size_t k = 1; k < faces.rings.size(); ++k) areas.push_back(area_of_face(graph, faces.rings[k]));
  std::ranges::sort(areas);
  return areas;
}

TEST(PlanarGraph, CutsLinesWhereTheyCross)
{
  const auto graph = join_lines({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true, 0}, {{{-1, 1}, {5, 1}}, false, 1}}, 1e-3);
  EXPECT_EQ(graph.counts.crossings, 2);
  EXPECT_EQ(graph.loose.size(), 2u);
  EXPECT_THAT(face_areas(graph), ElementsAre(DoubleNear(4.0, 1e-13), DoubleNear(12.0, 1e-13)));
}

TEST(PlanarGraph, GivesAHoleToTheFaceAroundIt)
{
  const auto graph = join_lines({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true, 0}, {{{1, 1}, {2, 1}, {2, 2}}, true, 1},
                                    {{{6, 0}, {7, 0}, {7, 1}}, true, 2}},
      1e-3);
  EXPECT_THAT(face_areas(graph), ElementsAre(DoubleNear(0.5, 1e-13), DoubleNear(0.5, 1e-13), DoubleNear(15.5, 1e-13)));
  EXPECT_EQ(find_faces(graph).rings[0].size(), 2u);
}

TEST(PlanarGraph, JoinsPlacesAndEdgesThatAreNear)
{
  const auto graph =
      join_lines({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true, 0}, {{{2, 0.0004}, {4.0003, 4}}, false, 1}}, 1e-3);
  EXPECT_EQ(graph.counts.merged, 1);
  EXPECT_EQ(graph.counts.joined, 1);
  EXPECT_THAT(graph.counts.largest, DoubleNear(4e-4, 1e-12));
  EXPECT_EQ(face_areas(graph).size(), 2u);
}

TEST(PlanarGraph, KnowsALineOnce)
{
  const auto graph = join_lines({{{{0, 0}, {4, 0}, {4, 4}}, true, 0}, {{{1, 0}, {3, 0}}, false, 1}}, 1e-3);
  EXPECT_EQ(graph.edges.size(), 5u);
  for (const GraphEdge& edge : graph.edges) {
    const bool shared = graph.places[edge.a][1] == 0.0 && graph.places[edge.b][1] == 0.0 &&
                        std::abs(graph.places[edge.a][0] - graph.places[edge.b][0]) == 2.0;
    EXPECT_EQ(edge.owners.size(), shared ? 2u : 1u);
  }
}

TEST(PlanarGraph, ForgetsASpikeOfAnOutline)
{
  const auto graph = join_lines({{{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {4, 2}, {4, 4}, {0, 4}}, true, 0}}, 1e-3);
  EXPECT_EQ(graph.edges.size(), 5u);
  EXPECT_THAT(face_areas(graph), ElementsAre(DoubleNear(16.0, 1e-13)));
}

}  // namespace planar_graph_test
