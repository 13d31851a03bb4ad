// One section of a reach, from its file to its report page, within a process of its own.
// Not for: the reach (assess.cpp).
#pragma once

#include "cli/commands.hpp"
#include "io/results/reach.hpp"

#include <atomic>
#include <string>

namespace terp {

struct SectionProgress {
  std::atomic<int> step{0};          ///< number in section_steps
  std::atomic<double> left_s{-1.0};  ///< expected time until the end of the step [s]; negative: not known
};

inline constexpr const char* section_steps[] = {"import", "check", "stability", "run", "report"};

struct PlannedSection {
  std::string file = {};      ///< .stix, case.toml or the folder of one
  std::string name = {};      ///< of its folder
  std::string folder = {};    ///< its path
  SectionRecord record = {};  ///< of an earlier process
};

/// The result of the section is there, and is of this file, these options and the case as it stands in its folder.
bool is_done(const PlannedSection& section, const AssessCommand& command);

/// The section has a result of another file, other options or another program, which an import would overwrite.
bool would_replace_result(const PlannedSection& section, const AssessCommand& command);

/// Makes what is left to do, and notes each step in section.json. False: stopped from outside.
bool assess_section(const PlannedSection& section, const AssessCommand& command, SectionProgress& progress);

}  // namespace terp
