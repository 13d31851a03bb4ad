#include "model/meshes/turned_squares.hpp"
#include "support/test.hpp"
#include <span>

namespace turned_squares_test {

const std::vector<Vec<2>> box{{0.0, 0.0}, {8.0, 0.0}, {8.0, 4.0}, {0.0, 4.0}};

/// Places of a loop of lines, each line from the end of the one before.
std::vector<Index> places_along(const TurnedSquares& grid, std::span<const Index> lines)
{
  std::vector<Index> places;
  for (const Index line : lines) {
    const auto [a, b] = grid.lines[static_cast<std::size_t>(std::abs(line) - 1)];
    const Index start = line > 0 ? a : b, end = line > 0 ? b : a;
    if (!places.empty()) {
      EXPECT_EQ(places.back(), start);
    }
    places.push_back(end);
  }
  const auto [a, b] = grid.lines[static_cast<std::size_t>(std::abs(lines[0]) - 1)];
  EXPECT_EQ(places.back(), lines[0] > 0 ? a : b);
  return places;
}

Real area_of(const TurnedSquares& grid, std::span<const Index> lines)
{
  const std::vector<Index> places = places_along(grid, lines);
  Real twice = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec<2>&a = grid.places[places[k]], &b = grid.places[places[(k + 1) % places.size()]];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * twice;
}

TEST(TurnedSquares, LieInTheirDirectionAwayFromThePolygon)
{
  const TurnedSquares grid = turned_squares(box, 0.5, 30.0, 0.3);
  ASSERT_GT(grid.squares.size(), 60u);
  for (const auto& square : grid.squares) EXPECT_NEAR(area_of(grid, square), 0.25, 1e-12);
  const auto [a, b] = grid.lines[static_cast<std::size_t>(grid.squares[0][0] - 1)];
  EXPECT_NEAR(grid.places[b][0] - grid.places[a][0], 0.5 * std::cos(std::numbers::pi / 6.0), 1e-12);
  EXPECT_NEAR(grid.places[b][1] - grid.places[a][1], 0.5 * std::sin(std::numbers::pi / 6.0), 1e-12);
  for (const Vec<2>& x : grid.places) {
    EXPECT_THAT(x[0], AllOf(testing::Ge(0.3), testing::Le(7.7)));
    EXPECT_THAT(x[1], AllOf(testing::Ge(0.3), testing::Le(3.7)));
  }
}

TEST(TurnedSquares, HaveOneOutlineAroundTheirArea)
{
  const TurnedSquares grid = turned_squares(box, 0.5, 30.0, 0.3);
  ASSERT_EQ(grid.outline.size(), 1u);
  EXPECT_NEAR(area_of(grid, grid.outline[0]), 0.25 * static_cast<Real>(grid.squares.size()), 1e-9);
  std::map<Index, int> of_line;
  for (const auto& square : grid.squares)
    for (const Index line : square) ++of_line[std::abs(line)];
  const auto n_free = std::ranges::count_if(of_line, [](const auto& entry) { return entry.second == 1; });
  EXPECT_EQ(n_free, static_cast<std::ptrdiff_t>(grid.outline[0].size()));
}

TEST(TurnedSquares, NeverTouchAtACornerAlone)  // or a place of the outline would have two lines that begin there
{
  for (const Real turn : {3.0, 10.0, 22.5, 41.0, 45.0, -22.5})
    for (const Real side : {0.3, 0.37, 0.5, 0.9}) {
      const TurnedSquares grid = turned_squares(box, side, turn, 0.1);
      std::map<Index, int> begins;
      for (const auto& loop : grid.outline)
        for (const Index place : places_along(grid, loop)) ++begins[place];
      for (const auto& [place, n] : begins) EXPECT_EQ(n, 1) << turn << ' ' << side;
    }
}

TEST(TurnedSquares, KeepOutOfABay)
{
  const std::vector<Vec<2>> bay{{0, 0}, {8, 0}, {8, 4}, {5, 4}, {5, 1}, {3, 1}, {3, 4}, {0, 4}};
  const TurnedSquares grid = turned_squares(bay, 0.4, 20.0, 0.2);
  ASSERT_FALSE(grid.squares.empty());
  for (const Vec<2>& x : grid.places) EXPECT_FALSE(x[0] > 2.8 && x[0] < 5.2 && x[1] > 0.8) << x[0] << ' ' << x[1];
}

TEST(TurnedSquares, AreNoneWhereNoneFits) { EXPECT_TRUE(turned_squares(box, 3.5, 10.0, 0.5).squares.empty()); }

}  // namespace turned_squares_test
