// What a run reports while it goes on, and when: rows of tables, frames, checkpoints. The loop (run) asks at every
// step.
#pragma once

#include "run/loop/observer.hpp"
#include "run/loop/state.hpp"

#include <span>

namespace terp {

struct Workspace;

/// True at the steps nearest to whole multiples of `every` [s]; never if every is 0.
/// step: counted from the time `from` [s].
bool due(std::int64_t step, Real dt, Real every, Real from = 0.0);

class Reporter {
 public:
  Reporter(const Model& model, State& state, Workspace& work, std::span<Observer* const> observers)
      : model_(model), state_(state), work_(work), observers_(observers)
  {
  }

  /// Reports what is due at this step; last: all of it, as at the end of a stage. Returns why the run must stop itself,
  /// or nothing.
  std::string report_due(bool last);
  void report_checkpoint();
  void report(const Progress& progress) const;
  /// Keeps the evidence of a run that must stop. Returns the message with where it is.
  std::string keep_evidence(std::string message);
  /// The same, and stops it: throws RunError.
  [[noreturn]] void stop_run(std::string message);

 private:
  template <class F>
  void tell(F&& f) const
  {
    for (Observer* observer : observers_) f(*observer);
  }
  void report_rows(const std::vector<TableRow>& rows);
  std::string report_ledger();
  /// Before a checkpoint: rows with times since the last row of the ledger, so that its time divides each table.
  void report_rows_between();
  void report_frame();

  const Model& model_;
  State& state_;
  Workspace& work_;
  std::span<Observer* const> observers_;
  std::vector<PointPlace> history_places_;
};

}  // namespace terp
