// What a study found, as text for a terminal and as a table.
#pragma once

#include "batch/estimates.hpp"

#include <string>

namespace terp {

/// "0.125, 0.082 to 0.18"; "-" of nothing.
std::string estimate_text(const EventEstimate& event);

/// "12 solved, 3 slide as drawn, 0 failed".
std::string counts_text(const EventCounts& counts);

/// The points are not independent, and no bound is proven: Latin hypercube, Sobol.
inline bool is_of_points(Estimator kind) { return kind == Estimator::latin_hypercube || kind == Estimator::sobol; }

/// A column of the table that only some estimators have: what a realisation is.
struct RowLabel {
  const char* name;
  std::string (*word)(const Study& study, const Realisation& realisation);
};
/// Of two stages `screening`; of two levels `sample` and `resolution`.
std::vector<RowLabel> row_labels(const Study& study);

/// Of what the number of events is counted, in a table: "pairs", or nothing where it is all realisations.
const char* words_of_counted(const Study& study);

/// What two levels found and are worth.
std::vector<std::string> remarks_on_levels(const Study& study, const StudyEstimates& estimates);

/// What the events are, for people.
std::string slide_words(const StudySettings& settings);
inline constexpr const char* flood_words = "the land floods (docs/flood.md)";

/// How many of the slides end in a flood, in a sentence; empty where floods are not judged or nothing slid.
std::string worth_of_residual_strength(const StudyEstimates& estimates);

/// What to know before the numbers are used: failures, the stop rule, the estimator.
std::vector<std::string> remarks_on_study(
    const Study& study, const Realisations& rows, const StudyEstimates& estimates);

std::string study_text(const Study& study, const Realisations& rows);

/// results.csv: a line per realisation of the table; numbers to the bit, nan where there is none.
std::string study_csv(const Study& study, const Realisations& rows);

/// results.json, for other programs: null where nothing is known. Keys: docs/formats.md.
std::string study_json(const Study& study, const Realisations& rows);

}  // namespace terp
