#include "model/parts/setup_history.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

namespace setup_history_test {

std::vector<Problem> warnings_for(std::vector<std::pair<std::string, Vec<2>>> places)
{
  Case c = column("mpm_gp");  // 8 m x 2 m of soil in cells of 0.5 m, 5 x 5 points each
  c.output.history_points = std::move(places);
  Model model = build_model(c, 1);
  return find_far_history_points(model, build_state(model));
}

TEST(SetupHistory, APlaceInTheSoilOrUpToACellFromItsPointsIsWell)
{
  EXPECT_TRUE(warnings_for({{"A", {7.6, 0.07}}, {"corner", {0.0, 0.0}}, {"above", {4.05, 2.44}}}).empty());
}

TEST(SetupHistory, APlaceMoreThanACellFromAnyPointIsAWarning)
{
  const auto warnings = warnings_for({{"A", {7.6, 0.07}}, {"far", {11.95, 1.95}}, {"above", {4.05, 2.46}}});
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0], told("output.history.points.\"far\"", "no soil is near the history point `far`",
                               "The nearest material point, which is followed, lies 4 m away at (7.95, 1.95) m; a cell "
                               "there is 0.5 m wide."));
  EXPECT_EQ(warnings[1].key, "output.history.points.\"above\"");
}

}  // namespace setup_history_test
