#include "run/loop/reporter.hpp"
#include "support/simulations.hpp"

namespace run_test {

/// Keeps the steps at which it was called, and may ask for a stop.
struct Recorder : Observer {
  std::vector<std::int64_t> frames, ledgers, checkpoints;
  std::vector<Real> histories;
  std::vector<Progress> progresses;
  StateImage last_checkpoint;
  TableRow last_row;
  std::int64_t stop_after = -1;
  std::atomic<bool> stop{false};

  void frame(const std::shared_ptr<const Frame>& f) override { frames.push_back(f->step); }
  void rows(const std::vector<TableRow>& rows) override
  {
    const TableRow& row = rows.at(0);
    if (row.table->name == "history") histories.push_back(row["time"]);
    if (row.table->name != "ledger") return;
    ledgers.push_back(row["step"]);
    last_row = row;
    if (row["step"] == stop_after) stop = true;
  }
  void checkpoint(const std::shared_ptr<const StateImage>& image) override
  {
    checkpoints.push_back(image->step);
    last_checkpoint = *image;
  }
  void progress(const Progress& p) override { progresses.push_back(p); }
};

/// 33 steps of 1/330 s.
Case short_column()
{
  Case c = column("mpm_gp");
  c.time.end = 0.1;
  c.bodies[0].velocity = {2.0, 0.0};
  c.output.fields_every = 0.04;
  c.output.history_every = 0.05;
  c.output.ledger_every = 0.02;
  c.output.checkpoint_every = 0.03;
  c.output.history_points = {{"A", {7.6, 0.07}}};
  return c;
}

Outcome solve(Simulation& s, Recorder& recorder)
{
  s.observers = {&recorder};
  return s.run(recorder.stop);
}

TEST(Run, TellsItsObserversAtTheStartAtEachDueStepAndAtTheEnd)
{
  Simulation s = followed(short_column());
  ASSERT_EQ(s.model.n_steps, 33);
  Recorder recorder;
  EXPECT_EQ(solve(s, recorder), Outcome::finished);
  EXPECT_THAT(recorder.frames, ElementsAre(0, 13, 26, 33));          // 13.2, 26.4
  EXPECT_THAT(recorder.ledgers, ElementsAre(0, 7, 13, 20, 26, 33));  // 6.6, 13.2, 19.8, 26.4, 33
  EXPECT_THAT(recorder.checkpoints, ElementsAre(10, 20, 30, 33));    // not at the start
  EXPECT_EQ(recorder.histories.size(), 3u);                          // 0, 16.5, 33
  EXPECT_EQ(recorder.progresses.back().step, 33);
  EXPECT_EQ(recorder.progresses.back().n_points, 1600);
}

/// Joins what it is shown in parts.
struct PartsRecorder : Observer {
  std::vector<std::int64_t> ends;  ///< points of the frames so far, where one ended
  std::int64_t n_points = 0, largest = 0;
  int n_image_parts = 0, n_images = 0;

  void frame(const std::shared_ptr<const Frame>& f) override
  {
    EXPECT_EQ(f->first, n_points - (ends.empty() ? 0 : ends.back()));
    n_points += f->n_points();
    largest = std::max(largest, f->n_points());
    if (f->ends()) ends.push_back(n_points);
  }
  void checkpoint(const std::shared_ptr<const StateImage>& image) override
  {
    EXPECT_EQ(image->part, n_image_parts++);
    n_images += image->last;
  }
};

TEST(Run, OfManyPointsTellsItsFramesAndCheckpointsInParts)
{
  Case c = column("mpm_gp", 0.03125);
  c.time.end = 1e-4;
  Simulation s = followed(c);
  const std::int64_t n = s.state.n_ids();
  ASSERT_GT(n, most_points_at_once);
  PartsRecorder recorder;
  s.observers = {&recorder};
  s.run();
  EXPECT_THAT(recorder.ends, ElementsAre(n, 2 * n));
  EXPECT_EQ(recorder.largest, points_per_part);
  EXPECT_EQ(recorder.n_images, 1);
  EXPECT_GT(recorder.n_image_parts, 10);
}

TEST(Run, WithoutIntervalsTellsTheFirstAndTheLast)
{
  Case c = short_column();
  c.output.fields_every = c.output.checkpoint_every = 0.0;
  Simulation s = followed(c);
  Recorder recorder;
  solve(s, recorder);
  EXPECT_THAT(recorder.frames, ElementsAre(0, 33));
  EXPECT_THAT(recorder.checkpoints, ElementsAre(33));
}

TEST(Run, ThatIsStoppedFinishesItsStepAndWritesACheckpoint)
{
  Simulation s = followed(short_column());
  Recorder recorder;
  recorder.stop_after = 13;
  EXPECT_EQ(solve(s, recorder), Outcome::interrupted);
  EXPECT_EQ(s.state.step, 13);
  EXPECT_THAT(recorder.checkpoints, ElementsAre(10, 13));
}

TEST(Run, ThatWasStoppedGoesOnToTheSameBitsAndTellsNothingTwice)
{
  Simulation whole(short_column()), first(short_column());
  Recorder all, before, after;
  solve(whole, all);
  before.stop_after = 20;
  solve(first, before);
  Simulation second(build_model(short_column(), 2), restore(first.model, before.last_checkpoint));
  second.model.history_ids = whole.model.history_ids;
  EXPECT_EQ(solve(second, after), Outcome::finished);
  EXPECT_EQ(first_difference(all.last_checkpoint, after.last_checkpoint), "");
  const auto join = [](auto a, const auto& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  EXPECT_EQ(join(before.frames, after.frames), all.frames);
  EXPECT_EQ(join(before.ledgers, after.ledgers), all.ledgers);
  EXPECT_EQ(join(before.histories, after.histories), all.histories);
}

TEST(Run, AtItsEndHasNothingLeftToDo)
{
  Simulation s = followed(short_column());
  Recorder first, again;
  solve(s, first);
  EXPECT_EQ(solve(s, again), Outcome::finished);
  EXPECT_EQ(s.state.step, 33);
  EXPECT_TRUE(again.frames.empty());
}

TEST(Summarise, TellsTheNumbersOfTheRun)
{
  Simulation s = followed(short_column());
  Recorder recorder;
  solve(s, recorder);
  s.state.clamped = 4;
  const Summary summary = summarise(s.model, s.state);
  EXPECT_EQ(summary.scheme, "mpm_gp");
  EXPECT_EQ(summary.n_points, 1600);
  EXPECT_EQ(summary.n_cells, 32 * 6);
  EXPECT_EQ(summary.n_steps, 33);
  EXPECT_EQ(summary.dt, s.model.dt);
  EXPECT_EQ(summary.threads, 1);
  EXPECT_NEAR(summary.front_x, 8.14, 0.02);  // 7.95 m + 2 m/s * 0.1 s, less the base's pull
  EXPECT_FALSE(summary.second_failure_time.has_value());
  EXPECT_EQ(summary.softened_fraction.size(), 4u);
  EXPECT_EQ(summary.clamped_points, 4);
  EXPECT_GT(summary.wall_s, 0.0);
  EXPECT_NEAR(summary.point_steps_per_s * summary.wall_s, 1600.0 * 33.0, 1e-6);
  EXPECT_EQ(summary.v_999, s.state.largest_v_999);
}

TEST(Summarise, TheBalanceErrorIsAShareOfTheEnergyExchanged)
{
  Simulation s = followed(short_column());
  Recorder recorder;
  solve(s, recorder);
  const TableRow& row = recorder.last_row;
  const Real exchanged = std::abs(row["gravity_work"]) + std::abs(row["damping_work"]) +
                         std::abs(row["boundary_work"]) + std::abs(row["balance_work"]) + row["plastic"] +
                         s.state.start_energy;
  EXPECT_GT(std::abs(row["numerical"]), 1e-6 * exchanged);
  EXPECT_NEAR(summarise(s.model, s.state).energy_balance_error,
      std::abs(row["numerical"] + 0.5 * s.state.work.last_step) / exchanged, 1e-12);
}

TEST(Summarise, ABodyThatFallsForAFewStepsIsInBalance)
{
  Case c = free_box("mpm_gp", {1.0, 1.0}, {2.0, 1.5});
  c.forces.gravity = {0.0, -10.0};
  for (const int n : {1, 2, 8}) {
    Simulation s = followed(c);
    s.step(n);
    const TableRow row = keep_ledger(s.model, s.state, s.work);
    EXPECT_NEAR(row["numerical"] / row["gravity_work"], -1.0 / (n + 1),
        1e-9);  // n (n + 1) / 2 of work, n^2 / 2 of kinetic energy
    EXPECT_LT(summarise(s.model, s.state).energy_balance_error, 1e-9);
  }
}

TEST(Summarise, WhatAColumnOfAFewStepsIsOffByFallsWithTheirSquare)
{
  const auto error_after = [](const char* scheme, int n) {
    Simulation s = followed(column(scheme, 0.25));
    s.step(n);
    return summarise(s.model, s.state).energy_balance_error;
  };
  for (const char* scheme : {"mpm_mixed", "mpm_gp", "standard_mpm"}) {
    const Real few = error_after(scheme, 8), more = error_after(scheme, 16);
    EXPECT_LT(few, 0.02) << scheme;  // 0.09 of half a step without it
    EXPECT_LT(more, 0.35 * few) << scheme;
  }
}

TEST(Summarise, ABodyWithoutALevelSurfaceHasNoCrest)
{
  Simulation s = followed(short_column());
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) { block.row(Rows::x + 1)[lane] -= 0.06; });
  EXPECT_FALSE(summarise(s.model, s.state).crest_x.has_value());
}

}  // namespace run_test
