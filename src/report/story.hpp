// What happened in a run, in words, and what speaks for or against its numbers.
// Not for: finding the events (events, simulation/failure).
#pragma once

#include "results/run_results.hpp"

#include <string>
#include <vector>

namespace terp {

/// Something that was looked at, and whether it is as it should be.
struct Check {
  std::string name, value;
  bool passed = true;
};

/// Sentences for a person who sees the run for the first time.
std::vector<std::string> tell_story(const RunResults& run);

/// What the reader must know before trusting the numbers; empty if all is well.
std::vector<std::string> find_cautions(const RunResults& run);

std::vector<Check> list_checks(const RunResults& run);

}  // namespace terp
