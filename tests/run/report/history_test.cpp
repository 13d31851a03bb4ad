#include "run/report/history.hpp"
#include "support/simulations.hpp"

namespace history_test {

TEST(History, HoldsOneRowForEachNamedPointInTheOrderOfTheCase)
{
  Case c = column("mpm_gp");
  c.output.history_points = {{"B", {7.6, 1.93}}, {"A", {7.6, 0.07}}};
  Model model = build_model(c, 1);
  State state = build_state(model);
  Simulation s(std::move(model), std::move(state));
  s.step(60);
  std::vector<PointPlace> places;
  const auto rows = make_history(s.model, s.state, places);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].text, "B");
  EXPECT_EQ(rows[1].text, "A");
  const Point p = points_by_id(s.state)[static_cast<std::size_t>(rows[1]["id"])];
  EXPECT_EQ(rows[1]["time"], s.state.time);
  EXPECT_EQ(rows[1]["x"], p.x[0]);
  EXPECT_EQ(rows[1]["y"], p.x[1]);
  EXPECT_EQ(rows[1]["eps_eq_p"], p.eps_eq_p());
  EXPECT_GT(rows[1]["eps_eq_p"], 0.0);
  EXPECT_NEAR(rows[1]["su"], 2000.0 + 6000.0 * std::exp(-50.0 * p.eps_eq_p()), 1e-8);
  EXPECT_NEAR(rows[1]["pressure"], (p.sigma[0] + p.sigma[1] + p.sigma[2]) / 3.0, 1e-9);
  EXPECT_LT(rows[1]["pressure"], -1000.0);  // tension positive: compressed at the toe
}

TEST(History, OfAPointThatLeftKeepsItsNameAndThePlaceWhereItLeft)
{
  Simulation s(column("mpm_gp"));
  s.model.description.output.history_points = {{"A", {7.6, 0.07}}};
  s.model.history_ids = {5000};  // not among the points
  s.state.left.push_back({.time = 0.2, .id = 5000, .x = {9.5, 0.25}, .v = {1.0, 0.0}, .mass = 2.0});
  s.state.time = 0.3;
  std::vector<PointPlace> places;
  const auto rows = make_history(s.model, s.state, places);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["time"], 0.3);
  EXPECT_EQ(rows[0].text, "A");
  EXPECT_EQ(rows[0]["id"], 5000);
  EXPECT_EQ(rows[0]["x"], 9.5);
  EXPECT_EQ(rows[0]["y"], 0.25);
  EXPECT_TRUE(std::isnan(rows[0]["pressure"]) && std::isnan(rows[0]["eps_eq_p"]) && std::isnan(rows[0]["su"]));
}

TEST(History, FollowsItsPointsFromCellToCell)
{
  Case c = column("mpm_gp");
  c.output.history_points = {{"B", {7.6, 1.93}}, {"A", {7.6, 0.07}}};
  c.bodies[0].velocity = {4.0, 0.0};
  Simulation s(c);
  std::vector<PointPlace> places;
  for (int k = 0; k < 40; ++k) {
    std::vector<PointPlace> none;
    const auto followed = make_history(s.model, s.state, places), fresh = make_history(s.model, s.state, none);
    const auto points = points_by_id(s.state);
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_EQ(followed[r]["x"], points[static_cast<std::size_t>(followed[r]["id"])].x[0]);
      EXPECT_EQ(followed[r]["pressure"], fresh[r]["pressure"]);
    }
    s.step(10);
  }
}

}  // namespace history_test
