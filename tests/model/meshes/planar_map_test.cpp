#include "model/meshes/planar_map.hpp"
#include "model/meshes/mesh_error.hpp"
#include "support/random.hpp"

namespace planar_map_test {

using Polygon = std::vector<Vec<2>>;

Polygon box(Real x, Real y, Real width, Real height)
{
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// Outer loop counts positive, holes negative.
Real area(const PlanarMap& map, const Face& face)
{
  Real sum = 0.0;
  for (const auto& loop : face)
    for (const Index line : loop) {
      Vec<2> a = map.places[map.lines[std::abs(line) - 1].a], b = map.places[map.lines[std::abs(line) - 1].b];
      if (line < 0) std::swap(a, b);
      sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  return sum;
}

std::vector<Real> areas(const PlanarMap& map)
{
  std::vector<Real> all;
  for (const Face& face : map.faces) all.push_back(area(map, face));
  std::sort(all.begin(), all.end());
  return all;
}

std::string error_of(const Polygon& polygon)
{
  return refusal<MeshError>([&] { cut_polygon(polygon, {}, 1e-3); });
}

TEST(CutPolygon, IsOneFaceWithoutOutlines)
{
  const auto map = cut_polygon(box(0, 0, 4, 3), {}, 0.01);
  EXPECT_EQ(map.lines.size(), 4u);
  EXPECT_THAT(areas(map), ElementsAre(12.0));
}

TEST(CutPolygon, DropsWhatLiesOutside)
{
  const auto map = cut_polygon(box(0, 0, 4, 3), {box(-1, -1, 2, 2), box(6, 6, 1, 1)}, 0.01);
  EXPECT_THAT(areas(map), ElementsAre(DoubleNear(1.0, 1e-14), DoubleNear(11.0, 1e-14)));
  EXPECT_EQ(map.lines.size(), 8u);
}

TEST(CutPolygon, CutsOutlinesWhereTheyCrossEachOther)
{
  EXPECT_THAT(areas(cut_polygon(box(0, 0, 4, 3), {box(1, 1, 2, 1), box(2, 0.5, 1.5, 1)}, 0.01)),
      ElementsAre(DoubleNear(0.5, 1e-14), DoubleNear(1.0, 1e-14), DoubleNear(1.5, 1e-14), DoubleNear(9.0, 1e-14)));
}

TEST(CutPolygon, KeepsIslandsAsHolesOfTheFaceAround)
{
  EXPECT_THAT(areas(cut_polygon(box(0, 0, 10, 10), {box(1, 1, 4, 4), box(2, 2, 1, 1), box(7, 7, 1, 1)}, 0.01)),
      ElementsAre(DoubleNear(1.0, 1e-14), DoubleNear(1.0, 1e-14), DoubleNear(15.0, 1e-13), DoubleNear(83.0, 1e-13)));
}

TEST(CutPolygon, RemembersTheEdgeOfThePolygonThatALineCameFrom)
{
  const auto map = cut_polygon(box(0, 0, 4, 3), {box(1, -1, 2, 2)}, 0.01);
  std::array<Real, 4> length{};
  int n_inside = 0;
  for (const CutLine& line : map.lines) {
    if (line.edge < 0)
      ++n_inside;
    else
      length[line.edge] +=
          std::hypot(map.places[line.b][0] - map.places[line.a][0], map.places[line.b][1] - map.places[line.a][1]);
  }
  EXPECT_THAT(length,
      ElementsAre(DoubleNear(4.0, 1e-14), DoubleNear(3.0, 1e-14), DoubleNear(4.0, 1e-14), DoubleNear(3.0, 1e-14)));
  EXPECT_EQ(n_inside, 3);
}

TEST(CutPolygon, SharesLinesOfNeighbourOutlines)
{
  EXPECT_THAT(areas(cut_polygon(box(0, 0, 4, 3), {box(0, 0, 4, 1), box(0, 1, 4, 1), box(0, 0, 2, 1)}, 0.01)),
      ElementsAre(DoubleNear(2.0, 1e-14), DoubleNear(2.0, 1e-14), DoubleNear(4.0, 1e-14), DoubleNear(4.0, 1e-14)));
}

TEST(CutPolygon, MovesPlacesOntoAnEdgeOrPlaceThatIsNearer)  // 4 mm above the base, 3 mm from a corner: no sliver
{
  const auto map = cut_polygon(box(0, 0, 4, 3), {{{0.0, 0.004}, {2.0, 0.004}, {2.0, 2.997}, {0.003, 3.0}}}, 0.01);
  EXPECT_THAT(areas(map), ElementsAre(DoubleNear(6.0, 0.01), DoubleNear(6.0, 0.01)));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(map.places[k], box(0, 0, 4, 3)[k]);
  EXPECT_THAT(map.places, testing::IsSupersetOf({Vec<2>{2.0, 0.0}, Vec<2>{2.0, 3.0}}));
  EXPECT_EQ(map.places.size(), 6u);
  Real total = 0.0;
  for (const Real part : areas(map)) total += part;
  EXPECT_NEAR(total, 12.0, 1e-13);
}

TEST(CutPolygon, LosesNoAreaWhateverOutlinesCrossIt)
{
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Polygon> follow(4);
    for (Polygon& outline : follow)
      for (int k = 0; k < 5; ++k) outline.push_back({random.between(-1.0, 5.0), random.between(-1.0, 4.0)});
    const auto map = cut_polygon(box(0, 0, 4, 3), follow, 0.02);
    Real total = 0.0;
    for (const Real part : areas(map)) {
      EXPECT_GT(part, 0.0);
      total += part;
    }
    ASSERT_NEAR(total, 12.0, 1e-12) << "trial " << trial;
  }
}

TEST(CutPolygon, RefusesPolygonsThatAreNone)
{
  EXPECT_THAT(
      error_of({{0, 0}, {3, 0}, {1, 2}, {1, -1}}), HasSubstr("crosses itself: edges 0 and 2 meet at x = 1 m, y = 0 m"));
  EXPECT_THAT(error_of({{0, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 1}, {0, 1}}),
      HasSubstr("lies on itself: edges 1 and 2 share the line from (2, 0) to (3, 0) m"));
  EXPECT_THAT(error_of({{0, 0}, {3, 0}, {2, 0}, {2, 1}, {0, 1}}),
      HasSubstr("lies on itself: edges 0 and 1 share the line from (2, 0) to (3, 0) m"));
  EXPECT_EQ(error_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), "");
  EXPECT_EQ(error_of({{0, 0}, {1e5, 0}, {1e5, 0.001}, {0, 0.001}}), "");
}

}  // namespace planar_map_test
