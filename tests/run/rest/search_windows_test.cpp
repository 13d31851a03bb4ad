#include "run/rest/search_windows.hpp"
#include "support/simulations.hpp"

namespace search_windows_test {

struct Window {
  Real moved, out_of_balance;  ///< since the last window [m]; force over weight [-]
};

/// What the last of these windows is taken for; the section is moved as a whole.
SearchWindows after(const std::vector<Window>& seen)
{
  Simulation s(column("mpm_gp", 0.5));
  SearchWindows windows(s.model, s.state, 1.0);
  for (const Window& window : seen) {
    edit_points(s.state, [&](const PointBlock<2>& block, Index lane) { block.row(Rows::x)[lane] += window.moved; });
    windows.enter(s.state, window.out_of_balance, true);
  }
  return windows;
}

TEST(SearchWindows, SoilThatMovesEverFasterUnderAForceThatDoesNotFallRunsAway)
{
  EXPECT_TRUE(after({{0.5, 1e-3}, {0.01, 1e-3}, {0.02, 1e-3}, {0.03, 1e-3}}).runs_away());
  EXPECT_FALSE(after({{0.01, 1e-3}, {0.01, 1e-3}, {0.02, 1e-3}, {0.03, 1e-3}}).runs_away()) << "not far enough";
  EXPECT_FALSE(after({{0.5, 1e-3}, {0.03, 1e-3}, {0.02, 1e-3}, {0.03, 1e-3}}).runs_away()) << "once faster";
}

TEST(SearchWindows, SoilThatMovesFasterWhileTheForceFallsMayStillComeToRest)
{
  const std::vector<Window> falls{{0.5, 4e-4}, {0.01, 3e-4}, {0.02, 2.4e-4}, {0.03, 1.9e-4}};
  EXPECT_FALSE(after(falls).runs_away());
  EXPECT_FALSE(after(falls).at_rest());
  std::vector<Window> rises = falls;
  rises.insert(rises.end(), {{0.04, 2e-4}, {0.05, 2.1e-4}});
  EXPECT_TRUE(after(rises).runs_away()) << "and if it rises again, it does not";
}

TEST(SearchWindows, SayHowManyStepsAreLeftToTheLimitAndToRest)
{
  constexpr Real limit = 1e-4;
  const SearchWindows falls = after({{0.0, 8e-4}, {0.0, 4e-4}});
  EXPECT_EQ(falls.more_steps(4e-4, limit), 2 * falls.steps()) << "the force halves with each window";
  EXPECT_EQ(falls.more_steps(limit, limit), 0) << "below the limit and at rest";
  EXPECT_EQ(after({{0.0, 4e-4}, {0.0, 8e-4}}).more_steps(8e-4, limit), std::nullopt);
  const SearchWindows moves = after({{0.4, 1e-5}, {0.4, 1e-5}, {0.2, 1e-5}});
  const auto left = moves.more_steps(1e-5, limit);
  ASSERT_TRUE(left.has_value()) << "the limit is passed, and the soil comes to rest";
  EXPECT_EQ(*left % moves.steps(), 0) << "which is judged at the end of a window";
  const auto from_less = after({{0.4, 1e-5}, {0.2, 1e-5}, {0.1, 1e-5}}).more_steps(1e-5, limit);
  EXPECT_EQ(*left - from_less.value_or(0), moves.steps()) << "half of the motion: one window less";
  EXPECT_EQ(after({{0.4, 1e-5}, {0.2, 1e-5}, {0.2, 1e-5}}).more_steps(1e-5, limit), std::nullopt) << "no slower";
  EXPECT_EQ(after({{0.4, 1e-5}, {-0.3, 1e-5}, {0.2, 1e-5}}).more_steps(1e-5, limit), std::nullopt) << "it swings";
  EXPECT_EQ(after({{0.4, 1e-5}, {0.2, 1e-5}}).more_steps(1e-5, limit), std::nullopt) << "not known yet";
}

}  // namespace search_windows_test
