#include "model/meshes/structured.hpp"
#include "model/meshes/check_mesh.hpp"
#include "support/test.hpp"

namespace structured_test {

using Sides = std::array<std::vector<Vec<2>>, 4>;

/// A parallelogram: the base rises 1 in 4, the sides lean by 0.5 over 2.
Sides sheared()
{
  return {{{{1.0, 1.0}, {5.0, 2.0}}, {{5.0, 2.0}, {5.5, 4.0}}, {{1.5, 3.0}, {5.5, 4.0}}, {{1.0, 1.0}, {1.5, 3.0}}}};
}

TEST(GradedShares, GrowGeometricallyToTheWholeLength)
{
  EXPECT_THAT(graded_shares(3, 4.0), ElementsAre(0.0, DoubleEq(1.0 / 7.0), DoubleEq(3.0 / 7.0), 1.0));
  EXPECT_THAT(graded_shares(4, 1.0), ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
  EXPECT_THAT(graded_shares(1, 5.0), ElementsAre(0.0, 1.0));
}

TEST(GradedRectangle, HasTheLastCellOverTheFirstInBothDirections)
{
  const auto mesh = make_graded_rectangle({2.0, -1.0}, {10.0, 3.0}, {20, 7}, {5.0, 0.25});
  const auto width = [&](Index i) { return mesh.nodes[i + 1][0] - mesh.nodes[i][0]; };
  const auto height = [&](Index j) { return mesh.nodes[(j + 1) * 21][1] - mesh.nodes[j * 21][1]; };
  EXPECT_NEAR(width(19) / width(0), 5.0, 1e-12);
  EXPECT_NEAR(height(6) / height(0), 0.25, 1e-12);
  for (Index i = 1; i < 20; ++i) EXPECT_NEAR(width(i) / width(i - 1), std::pow(5.0, 1.0 / 19.0), 1e-12);
  EXPECT_EQ(mesh.nodes.front(), (Vec<2>{2.0, -1.0}));
  EXPECT_EQ(mesh.nodes.back(), (Vec<2>{12.0, 2.0}));
  EXPECT_NEAR(mesh.smallest_altitude, std::min(width(0), height(6)), 1e-14);
}

TEST(GradedRectangle, NamesItsSidesAsTheRectangleDoes)
{
  const auto graded = make_graded_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 2}, {2.0, 2.0}),
             regular = make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 2});
  ASSERT_EQ(graded.sides.size(), 4u);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(graded.sides[s].name, regular.sides[s].name);
    ASSERT_EQ(graded.sides[s].edges.size(), regular.sides[s].edges.size());
    for (std::size_t k = 0; k < graded.sides[s].edges.size(); ++k) {
      EXPECT_EQ(graded.sides[s].edges[k].cell, regular.sides[s].edges[k].cell);
      EXPECT_EQ(graded.sides[s].edges[k].side, regular.sides[s].edges[k].side);
    }
  }
  EXPECT_EQ(graded.cells, regular.cells);
}

TEST(MappedRectangle, IsExactForAShearedGrid)
{
  const auto mesh = make_mapped_rectangle(sheared(), {8, 4}, {1.0, 1.0});
  for (Index j = 0; j <= 4; ++j)
    for (Index i = 0; i <= 8; ++i) {
      const Vec<2> x = mesh.nodes[j * 9 + i];
      EXPECT_NEAR(x[0], 1.0 + 0.5 * i + 0.125 * j, 2e-15);
      EXPECT_NEAR(x[1], 1.0 + 0.125 * i + 0.5 * j, 2e-15);
    }
  EXPECT_EQ(mesh.geometries.size(), 1u);
  EXPECT_TRUE(mesh.geometries[0].map.affine);
}

TEST(MappedRectangle, GradesAlongTheSides)
{
  const auto mesh = make_mapped_rectangle(sheared(), {8, 4}, {3.0, 0.5});
  const auto s = graded_shares(8, 3.0), t = graded_shares(4, 0.5);
  EXPECT_NEAR(mesh.nodes[2 * 9 + 3][0], 1.0 + 4.0 * s[3] + 0.5 * t[2], 2e-15);
  EXPECT_NEAR(mesh.nodes[2 * 9 + 3][1], 1.0 + 1.0 * s[3] + 2.0 * t[2], 2e-15);
}

TEST(MappedRectangle, PutsTheNodesOfCurvedSidesOnThePolyline)
{
  Sides sides{{{}, {{4.0, 0.0}, {4.0, 3.0}}, {{0.0, 2.0}, {1.0, 2.5}, {4.0, 3.0}}, {{0.0, 0.0}, {0.0, 2.0}}}};
  for (int k = 0; k <= 200; ++k) sides[0].push_back({0.02 * k, 0.3 * std::sin(std::numbers::pi * k / 200.0)});
  sides[0].back()[1] = 0.0;
  const auto mesh = make_mapped_rectangle(sides, {16, 6}, {1.0, 1.0});
  check_mesh(mesh);
  for (Index i = 1; i < 16; ++i)  // the polyline's places are 0.02 m apart: chords leave the sine by up to 1e-5 m
    EXPECT_NEAR(mesh.nodes[i][1], 0.3 * std::sin(std::numbers::pi * mesh.nodes[i][0] / 4.0), 1.1e-5);
  EXPECT_EQ(mesh.nodes[0], (Vec<2>{0.0, 0.0}));
  EXPECT_EQ(mesh.nodes[16], (Vec<2>{4.0, 0.0}));
  EXPECT_EQ(mesh.nodes[6 * 17], (Vec<2>{0.0, 2.0}));
  EXPECT_EQ(mesh.nodes[6 * 17 + 16], (Vec<2>{4.0, 3.0}));
  const auto step = [&](Index i) {
    return std::hypot(mesh.nodes[i + 1][0] - mesh.nodes[i][0], mesh.nodes[i + 1][1] - mesh.nodes[i][1]);
  };
  for (Index i = 0; i < 16; ++i) EXPECT_NEAR(step(i), step(0), 0.003 * step(0));  // equal arcs, chords nearly so
  EXPECT_GT(mesh.smallest_altitude, 0.2);
}

TEST(MappedRectangle, NamesTheSidesThatItWasGiven)
{
  const auto mesh = make_mapped_rectangle(sheared(), {8, 4}, {1.0, 1.0});
  const auto lies_on = [&](const NamedSide& side, Vec<2> a, Vec<2> b) {
    for (const CellSide& edge : side.edges)
      for (const Index i : {mesh.cells[edge.cell][edge.side], mesh.cells[edge.cell][(edge.side + 1) % 4]}) {
        const Vec<2> x = mesh.nodes[i];
        if (std::abs((b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])) > 1e-13) return false;
      }
    return true;
  };
  for (const NamedSide& side : mesh.sides) {
    const int number = side.name == "bottom" ? 0 : side.name == "right" ? 1 : side.name == "top" ? 2 : 3;
    EXPECT_EQ(side.edges.size(), number % 2 == 0 ? 8u : 4u);
    EXPECT_TRUE(lies_on(side, sheared()[number][0], sheared()[number][1])) << side.name;
  }
}

}  // namespace structured_test
