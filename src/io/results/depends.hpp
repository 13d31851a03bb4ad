// What the outcome of a case turns on, from runs that each changed one input: depends.json and its text.
// Not for: which inputs are changed (cli/what_decides).
#pragma once

#include <string>
#include <vector>

namespace terp {

inline constexpr const char* depends_file = "depends.json";

/// A run of the case as given, on some size of cells, or with one input changed.
struct SolvedInput {
  std::string what, run, outcome, folder;  ///< "POP", "POP x 0.7", "floods", "cell_1_POP_x_0.7"
};

/// "floods", "stands", or without [flood] "slides", "still moves", "rests", and "no slide" where nothing waited for
/// rest. Throws FileError.
std::string outcome_of_run(const std::string& folder);

struct Decision {
  std::string json, text;
};

/// The first run is that of the case as given, with which the others are compared. not_varied: inputs, with the reason.
Decision decide(const std::string& case_name, const std::vector<SolvedInput>& runs,
    const std::vector<std::string>& not_varied = {});

}  // namespace terp
