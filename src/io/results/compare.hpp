// Runs side by side: one table of what differs, and the differences in words. `terp compare` prints it, the report
// shows it.
#pragma once

#include "io/results/measures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace terp {

/// One quantity of all runs.
struct ComparisonRow {
  std::string label, unit;
  std::vector<std::optional<Real>> values;  ///< one per run; none: not defined, or not recorded
  int digits = 2;                           ///< after the point, when printed
};

struct Comparison {
  std::vector<std::string> names, schemes;  ///< of the runs
  std::vector<ComparisonRow> rows;
  std::vector<std::string> text;  ///< sentences; the first run against each of the others
};

/// names: what to call the runs.
Comparison compare_runs(const std::vector<RunResults>& runs, const std::vector<std::string>& names);

/// Columns of plain text, with a line break at the end of each line.
std::string comparison_table(const Comparison& comparison);

/// One JSON object, without a line break.
std::string comparison_json(const Comparison& comparison);

/// "MPM-GP" for "mpm_gp"; the name itself of a scheme that is not in this build.
std::string scheme_title(std::string_view scheme);

/// The differences in words: the first run against each of the others. comparison: its rows.
std::vector<std::string> describe_differences(const std::vector<RunResults>& runs, const Comparison& comparison);

/// In what the cases of two runs differ: "mesh.cell (0.1 against 0.2)" for each key with another value, in the order of
/// the first case. The scheme, which is there to be compared, the title, the end and what is written do not count. Of a
/// text that is not TOML nothing.
std::vector<std::string> case_differences(const std::string& first_toml, const std::string& other_toml);

}  // namespace terp
