// What a run will write, counted; its size against a written run: tests/cli/check_test.cpp.
#include "run/report/output_costs.hpp"
#include "run/loop/simulation.hpp"
#include "support/cases.hpp"

namespace output_costs_test {

/// 1600 points of tresca_softening, 0.1 s.
OutputCost cost_of(const OutputCase& output)
{
  Case c = column("mpm_gp");
  c.time.end = 0.1;
  c.output = output;
  const Simulation s(c);
  return estimate_output(s.model, s.state);
}

TEST(OutputCost, CountsWhatTheCaseAsksFor)
{
  OutputCase output;
  output.fields_every = 0.04, output.history_every = 0.05, output.ledger_every = output.checkpoint_every = 0.02;
  output.history_points = {{"A", {7.6, 0.07}}, {"B", {7.6, 1.0}}};
  output.checkpoint_keep = 3;
  const OutputCost cost = cost_of(output);
  EXPECT_EQ(cost.n_frames, 4);       // 0, 0.04, 0.08, 0.1 s
  EXPECT_EQ(cost.n_checkpoints, 5);  // not at 0
  EXPECT_EQ(cost.n_kept, 3);
  EXPECT_EQ(cost.n_ledger_rows, 6);
  EXPECT_EQ(cost.n_history_rows, 6);  // two points
}

TEST(OutputCost, WithoutIntervalsThereAreTheFirstAndTheLast)
{
  OutputCase output;
  output.checkpoint_keep = 0;
  const OutputCost cost = cost_of(output);
  EXPECT_EQ(cost.n_frames, 2);
  EXPECT_EQ(cost.n_checkpoints, 1);
  EXPECT_EQ(cost.n_kept, 1);
}

TEST(OutputCost, GrowsWithFramesAndFields)
{
  OutputCase output;
  output.fields_every = 0.1;
  const OutputCost all = cost_of(output);
  output.field_names = {"volume"};
  const OutputCost few = cost_of(output);
  output.fields_every = 0.01;
  const OutputCost more = cost_of(output);
  EXPECT_NEAR((more.bytes - few.bytes) / few.frame_bytes, 9.0, 1e-9);
  EXPECT_GT(all.frame_bytes, 4.0 * few.frame_bytes);
  EXPECT_GT(more.seconds, few.seconds);
}

}  // namespace output_costs_test
