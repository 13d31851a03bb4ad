#include "import/drawing/region_chains.hpp"
#include "support/test.hpp"

namespace region_chains_test {

/// Two layers, 10 m wide; between them a boundary with the given corners.
ChainMap two_layers(const Polygon& boundary)
{
  Polygon lower{{0, 0}, {10, 0}}, upper(boundary);
  lower.insert(lower.end(), boundary.rbegin(), boundary.rend());
  upper.insert(upper.end(), {{10, 6}, {0, 6}});
  const auto graph = join_lines({{lower, true, 0}, {upper, true, 1}}, 1e-3);
  const auto faces = find_faces(graph);
  std::vector<int> region(faces.rings.size(), -1);
  for (std::size_t k = 0; k < graph.edges.size(); ++k)
    if (graph.edges[k].owners.size() == 1) {
      const Index inside = faces.left[k] == 0 ? faces.right[k] : faces.left[k];
      region[inside] = graph.edges[k].owners[0];
    }
  return find_chains(graph, faces, region, 1e-3);
}

const Chain& boundary_of(const ChainMap& map)
{
  return *std::ranges::find_if(map.chains, [](const Chain& chain) { return chain.left >= 0 && chain.right >= 0; });
}

TEST(Chains, EndAtJunctionsAndCornersOfTheLimits)
{
  const auto map = two_layers({{0, 3}, {4, 3.5}, {6, 2.5}, {10, 3}});
  EXPECT_EQ(map.chains.size(), 7u);  // two on each side, one below, one above, the boundary
  EXPECT_EQ(boundary_of(map).places.size(), 4u);
  const auto areas = region_areas(map, 2);
  EXPECT_THAT(areas[0] + areas[1], DoubleNear(60.0, 1e-12));
}

TEST(Chains, KeepTheAreaOnBothSidesWhenCornersAreTakenOut)
{
  auto map = two_layers({{0, 3}, {3, 3}, {3.02, 3.01}, {7, 3.01}, {10, 3.5}});
  const auto before = region_areas(map, 2);
  ChainChanges changes;
  simplify(map, {0.05, 0.02, 1e-6}, changes);
  EXPECT_GE(changes.removed, 1);
  EXPECT_LE(changes.largest, 0.05);
  EXPECT_THAT(region_areas(map, 2)[0], DoubleNear(before[0], 1e-5));  // the grid rounds corners by up to 0.5e-6 m
}

TEST(Chains, OfManyCornersStayNearTheDrawnLineAndKeepTheirArea)
{
  Polygon rough{{0, 3}};
  for (int k = 1; k < 2000; ++k) rough.push_back({0.005 * k, 3.0 + 0.01 * std::sin(0.1 * k) + 0.004 * (k % 3)});
  rough.push_back({10, 3});
  auto map = two_layers(rough);
  const auto before = region_areas(map, 2);
  ChainChanges changes;
  simplify(map, {0.05, 0.02, 1e-6}, changes);
  EXPECT_GE(changes.removed, 1800);
  EXPECT_LE(changes.largest, 0.05);
  EXPECT_THAT(region_areas(map, 2)[0], DoubleNear(before[0], 1e-5));
  EXPECT_TRUE(lines_are_apart(graph_of(map)));
}

TEST(Chains, LeaveCornersThatLieFartherThanTheTolerance)
{
  auto map = two_layers({{0, 3}, {3, 3.1}, {5, 2.9}, {7, 3.1}, {10, 3}});
  ChainChanges changes;
  simplify(map, {0.05, 0.02, 1e-3}, changes);
  EXPECT_EQ(changes.removed, 0);
}

TEST(Chains, MoveACornerToGiveAnArea)
{
  auto map = two_layers({{0, 3}, {5, 3}, {10, 3.2}});
  auto asked = region_areas(map, 2);
  asked[0] += 0.01;
  asked[1] -= 0.01;
  ChainChanges changes;
  balance_areas(map, asked, 0.01, changes);
  EXPECT_THAT(region_areas(map, 2)[0], DoubleNear(asked[0], 1e-10));
  EXPECT_THAT(changes.area_move, DoubleNear(0.002, 1e-5));  // 10 m between its neighbours: 5 m2 per metre
}

TEST(Chains, GiveAStraightBoundaryACornerIfAnAreaNeedsIt)
{
  auto map = two_layers({{0, 3}, {10, 3}});
  ChainChanges changes;
  balance_areas(map, {30.005, 29.995}, 0.01, changes);
  EXPECT_THAT(region_areas(map, 2)[0], DoubleNear(30.005, 1e-10));
  EXPECT_EQ(boundary_of(map).places.size(), 3u);
}

TEST(Chains, DoNotMoveFartherThanAllowed)
{
  auto map = two_layers({{0, 3}, {5, 3}, {10, 3.2}});
  const auto areas = region_areas(map, 2);
  ChainChanges changes;
  balance_areas(map, {areas[0] + 1.0, areas[1] - 1.0}, 0.01, changes);
  EXPECT_LT(changes.area_move, 1e-9);
}

TEST(Chains, SeeLinesThatCrossOrTouch)
{
  const auto line = [](Index a, Index b) { return GraphEdge{a, b, {}}; };
  const std::vector<Vec<2>> places{{0, 0}, {2, 2}, {0, 2}, {2, 0}, {1, 1}};
  EXPECT_TRUE(lines_are_apart({places, {line(0, 2), line(1, 3)}, {}, {}}));
  EXPECT_FALSE(lines_are_apart({places, {line(0, 1), line(2, 3)}, {}, {}}));
  EXPECT_FALSE(lines_are_apart({places, {line(0, 1), line(2, 4)}, {}, {}}));
  EXPECT_TRUE(lines_are_apart({places, {line(0, 4), line(2, 4)}, {}, {}}));
}

}  // namespace region_chains_test
