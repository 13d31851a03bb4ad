// The failure path of a study (Dutch: faalpad): how often a first slide comes, what follows from it, up to the water
// that flows over. Each event is given the one before it. docs/probability.md, "The failure path".
// Not for: P(I), P(F) and P(F|I) (estimates.hpp).
#pragma once

#include "math/sentence.hpp"
#include "batch/estimates.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

struct PathEvent {
  std::string_view key, given_key;  ///< in results.json; given_key: "" of all realisations
  Sentence name, given;
  EventEstimate estimate = {};
};

/// The realisations of the study count alike, so that shares of them are probabilities.
bool has_failure_path(const Study& study);

/// At a level of the load, counted from 0; of a study without one level 0 is all of it.
std::vector<PathEvent> failure_path(const Study& study, const Realisations& rows, std::size_t level = 0);

/// For the terminal; empty: there is none.
std::string failure_path_text(const Study& study, const Realisations& rows);
/// level, event, event_nl, given, given_nl, happened, of, unknown, P, P_low, P_high.
std::string failure_path_csv(const Study& study, const Realisations& rows);

}  // namespace terp
