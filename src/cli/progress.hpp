// How what goes on looks: one line that renews itself on a terminal, plain lines in a pipe.
#pragma once

#include "run/loop/observer.hpp"

#include <cstdio>
#include <string>

namespace terp {

/// Seconds as a person reads them: "12 s", "3 min 05 s", "2 h 07 min".
std::string readable_duration(double seconds);

/// As pages say when they were written.
std::string now_in_utc();

/// Writes what is of use at this moment alone: where nobody reads it any more, in a closed terminal or pipe, it is
/// dropped.
void show(std::FILE* to, const std::string& text);

/// On a terminal each text takes the place of the one before; in a pipe each is a line.
class LiveLine {
 public:
  explicit LiveLine(std::FILE* to = stdout);
  bool renews() const { return renews_; }
  void show(const std::string& text);
  void clear();  ///< takes away what stands there
  void end();    ///< leaves it: the next text starts on its own

 private:
  std::FILE* to_;
  bool renews_, open_ = false;
};

/// How far the search for equilibrium has come. A time is named where it is known how the search goes on; before that
/// it says how many steps it may take.
std::string search_text(const Progress& p);

class ProgressLine : public Observer {
 public:
  /// quiet: says nothing at all. label: what stands before each line; later_s: what comes after this run, with which
  /// the line says when all is done [s].
  explicit ProgressLine(bool quiet, std::string label = {}, double later_s = 0.0);
  void progress(const Progress& now) override;
  void finish() { line_.end(); }

 private:
  void show_search(const Progress& p);

  LiveLine line_;
  bool quiet_;
  std::string label_;
  double later_s_;
  double next_search_s_ = 5.0;  // wall time of the next line about the search for equilibrium, when lines are plain
  double next_line_s_ = 60.0;   // the same about the run
  int next_tenth_;              // of the run, when lines are plain; half of a run of several
};

}  // namespace terp
