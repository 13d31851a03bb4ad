// How a run looks while it goes on: one line that renews itself on a terminal, plain lines in a pipe.
#pragma once

#include "simulation/observer.hpp"

namespace terp {

/// Seconds as a person reads them: "12 s", "3 min 05 s", "2 h 07 min".
std::string readable_duration(double seconds);

class ProgressLine : public Observer {
 public:
  /// quiet: says nothing at all.
  explicit ProgressLine(bool quiet);
  void progress(const Progress& now) override;
  /// Ends the line, so that the next text starts on its own.
  void finish();

 private:
  bool quiet_, terminal_;
  bool open_ = false;
  int next_tenth_ = 1;  // of the run, when lines are plain
};

}  // namespace terp
