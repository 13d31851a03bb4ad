// How far a study is, on one line that renews itself on a terminal.
#pragma once

#include "cli/progress.hpp"
#include "batch/estimates.hpp"
#include "batch/store.hpp"

#include <array>
#include <chrono>

namespace terp {

class StudyProgress {
 public:
  /// n_at_a_time: realisations that are solved at once.
  StudyProgress(const Study& study, const StudyPart& part, int n_at_a_time, bool quiet);
  void show(const Realisation& newest, const Realisations& all);
  void finish() { line_.end(); }

 private:
  using Clock = std::chrono::steady_clock;
  void count(const Realisation& r);

  const Study& study_;
  StudyPart part_;
  int n_at_a_time_;
  bool quiet_, shows_p_;
  LiveLine line_;
  Clock::time_point start_ = Clock::now();
  /// Of one level; the fine one, or the only one, first.
  struct Level {
    double spent = 0.0;  ///< [s]
    Index made = 0, left = 0;
  };
  double seconds_left() const;

  double next_ = 0.0;
  Index done_ = 0, n_all_ = 0;
  std::array<Level, 2> levels_ = {};
  bool begun_ = false;
  Sample sample_;
};

}  // namespace terp
