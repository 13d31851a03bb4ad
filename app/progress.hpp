// How a run looks while it goes on: one line that renews itself on a terminal, plain lines in a pipe.
#pragma once

#include "simulation/observer.hpp"

#include <cstdio>
#include <string>

namespace terp {

/// Seconds as a person reads them: "12 s", "3 min 05 s", "2 h 07 min".
std::string readable_duration(double seconds);

/// Writes what is of use at this moment alone: where nobody reads it any more, in a closed terminal or pipe, it is
/// dropped.
void show(std::FILE* to, const std::string& text);

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
