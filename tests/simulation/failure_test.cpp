// What is followed of the failure while the column of the paper collapses, on coarse cells.
#include "simulation/failure.hpp"

#include "simulation/ledger.hpp"
#include "support/cases.hpp"
#include "support/simulations.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::Simulation;

/// The column for a time, with a row of the ledger every 0.02 s.
struct Collapse : Simulation {
  std::vector<LedgerRow> rows;

  explicit Collapse(Real end);
};

Collapse::Collapse(Real end) : Simulation(test::column("mpm_gp", 0.25))
{
  Simulation& s = *this;
  start_audit(s.model, s.state);
  for (Real next = 0.0; s.state.time < end; next += 0.02) {
    while (s.state.time < next) s.step();
    rows.push_back(keep_ledger(s.model, s.state));
  }
}

TEST(Failure, OfTheColumnIsASlideWithASlipSurfaceFromTheCrestToTheToe)
{
  const Collapse s(1.2);
  Summary summary;
  summarise_failure(s.state, summary);
  ASSERT_EQ(summary.slides.size(), 1);
  const auto& [slide, slip] = summary.slides[0];
  EXPECT_GT(slide.begins, 0.1);
  EXPECT_LT(slide.begins, 0.3);
  EXPECT_EQ(slide.crest_from, 8.0);
  EXPECT_LT(slide.crest_to, 7.5);
  EXPECT_GT(slip.time, slide.begins);
  ASSERT_GT(slip.line.size(), 8);
  EXPECT_GT(slip.line.front()[1], 1.0);  // up at the crest
  EXPECT_LT(slip.line.back()[1], 0.3);   // down at the base
  EXPECT_LT(slip.line.front()[0], 7.0);
  EXPECT_GT(slip.line.back()[0], 8.0);
}

TEST(Failure, MovedSoilAndRunOutGrowFromNothing)
{
  const Collapse s(0.8);
  const auto& rows = s.rows;
  EXPECT_EQ(rows.front().moved_volume, 0.0);
  EXPECT_EQ(rows.front().crest_x, 8.0);
  EXPECT_NEAR(rows.front().crest_y, 1.975, 1e-12);
  for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_GE(rows[k].moved_volume, rows[k - 1].moved_volume - 0.05);
  Summary summary;
  summarise_failure(s.state, summary);
  EXPECT_NEAR(summary.moved_distance, 1.95 / 20.0, 1e-12);
  EXPECT_EQ(summary.moved_volume, rows.back().moved_volume);
  EXPECT_NEAR(summary.moved_fraction, summary.moved_volume / 16.0, 1e-3);
  EXPECT_GT(summary.moved_fraction, 0.1);
  EXPECT_NEAR(summary.run_out, rows.back().front_x - rows.front().front_x, 1e-12);
}

TEST(Failure, TheSlipSurfaceIsOfTheTimeAtWhichTheStrainGrewFastest)
{
  Collapse s(0.5);
  const SlipSurface before = s.state.slip.at(0);
  EXPECT_GT(before.rate, 0.0);
  std::fill(s.state.audit.growth.begin(), s.state.audit.growth.end(), 0.0);
  LedgerRow row;
  row.time = s.state.time + 0.02;
  follow_failure(s.state, row);  // nothing grew
  EXPECT_EQ(s.state.slip.at(0).time, before.time);
  EXPECT_EQ(s.state.slip.at(0).line, before.line);
}

TEST(Failure, SoilThatRestsHasNone)
{
  Case c = test::column("mpm_gp", 0.5);
  c.forces.gravity = {0.0, 0.0};
  Simulation s(c);
  start_audit(s.model, s.state);
  for (int k = 0; k < 3; ++k) {
    keep_ledger(s.model, s.state);
    s.step(5);
  }
  Summary summary;
  summarise_failure(s.state, summary);
  EXPECT_TRUE(summary.slides.empty());
  EXPECT_EQ(summary.moved_volume, 0.0);
  EXPECT_NEAR(summary.run_out, 0.0, 1e-12);
  EXPECT_FALSE(summary.second_failure_time.has_value());
}

}  // namespace
}  // namespace terp
