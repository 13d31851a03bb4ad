// A case on several cell sizes: how each measure follows the size, its observed order, the limit to which it tends and
// the error that is left. `terp converge` fills it and prints it.
// Not for: solving the runs (cli/converge).
#pragma once

#include "math/convergence.hpp"
#include "io/results/measures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace terp {

/// One cell size of a sequence.
struct StudyRun {
  Real cell = 0.0;          ///< as it was asked for [m]
  Real size = 0.0;          ///< root of the mean area of the cells that came of it [m]
  std::string folder;       ///< in that of the study
  std::string fault = {};   ///< why there is no result; empty: solved
  RunResults results = {};  ///< of a run that was solved
};

/// A case, changed in nothing but the size of its cells.
struct StudySequence {
  std::string name;                  ///< "as written", or what was changed: "scheme=mpm_mixed"
  std::vector<std::string> changes;  ///< KEY=VALUE of --set, without those of the cells
  std::vector<StudyRun> runs;        ///< from the largest cells to the smallest
  std::string input = {};            ///< what was changed: "S_u" of "S_u x 0.85"; empty: the name says it
};

/// What the sizes of a sequence say of one measure.
enum class MeshAnswer {
  none,        ///< fewer than two runs have it, or none of the sizes was solved
  same,        ///< equal at all sizes
  settled,     ///< the last change and the uncertainty are within the tolerance
  unresolved,  ///< they are not, but the change cannot be told from none
  tends,       ///< they are not; it tends to a limit with a usable order
  depends,     ///< they are not, and there is no such order
  some_sizes,  ///< an event, or a measure, that some sizes have and others do not
};

struct AnswerInfo {
  const char* key;    ///< in convergence.json
  const char* words;  ///< in a table
};
const AnswerInfo& info_of(MeshAnswer answer);

struct StudyQuantity {
  RunMeasure measure;
  std::vector<std::optional<Real>> values;  ///< of each run, as StudySequence::runs
  MeshAnswer answer = MeshAnswer::none;
  std::optional<Real> change;   ///< between the two finest that were solved, finer less coarser
  std::optional<Real> scale;    ///< what it counts as a share of (MeasureKind); none: of zero
  Real resolution = 0.0;        ///< a smaller difference cannot be told from none
  RefinementEstimate estimate;  ///< of the three finest that were solved
  bool has_order = false;       ///< of the estimate: usable, and not of steps that cannot be told from none

  bool has_values() const
  {
    return std::ranges::any_of(values, [](const auto& value) { return value.has_value(); });
  }
  /// A difference as a share of the scale [-].
  std::optional<Real> relative(std::optional<Real> difference) const
  {
    return difference && scale ? std::optional(std::abs(*difference) / *scale) : std::nullopt;
  }
  std::optional<Real> relative_change() const { return relative(change); }
  std::optional<Real> relative_error() const { return has_order ? relative(estimate.uncertainty) : std::nullopt; }
};

struct StudiedSequence {
  StudySequence sequence;
  std::vector<StudyQuantity> quantities;  ///< without those that no run of the study has
};

/// One measure on cells of one size in all sequences: what a choice that should not matter does.
struct StudySpread {
  RunMeasure measure;
  std::vector<std::optional<Real>> values;  ///< of each sequence, as MeshStudy::sequences
  std::optional<Real> range;                ///< largest less smallest; none: of a word, or a sequence lacks it
  std::optional<Real> share;                ///< range over what it counts as a share of (MeasureKind)
  bool matters = false;                     ///< beyond tolerance and resolution, or not in all sequences
};

struct MeshStudy {
  std::string case_name, title;
  Real tolerance = 0.02;  ///< share from which on a change between the two finest sizes counts
  std::vector<StudiedSequence> sequences;
  Real spread_cell = 0.0;                 ///< smallest size that all sequences have solved [m]
  std::vector<StudySpread> spreads = {};  ///< there; empty with one sequence
};

/// sequences: at least one, each with runs of different sizes from coarse to fine.
MeshStudy study_mesh(const std::vector<StudySequence>& sequences, Real tolerance);

/// Values by size, from coarse to fine, of one measure. Absent values are of runs that were not solved (`solved` false)
/// or do not have it.
StudyQuantity judge_sizes(const RunMeasure& measure, const std::vector<StudyRun>& runs, Real tolerance);

/// "front at the end: 12.43 m, changes by 0.04 m (0.9 % of its distance) between the last two sizes; ...".
std::string sentence_on(const StudyQuantity& quantity);

/// What the sequence as a whole says, in one sentence or two.
std::string answer_of(const StudiedSequence& sequence, Real tolerance);

/// What the variants say together, in one sentence; empty if there are no spreads.
std::string answer_on_variants(const MeshStudy& study);

/// Remarks on a sequence that weaken what its numbers say: sizes too near to each other, too few, runs that failed.
std::vector<std::string> remarks_on(const StudySequence& sequence);

/// A value of a measure with its digits, or its word; "-" if there is none.
std::string text_of(const RunMeasure& measure, std::optional<Real> value);

/// After the point, with which each of the values has at least those of its measure, and an amount three that count.
int digits_for(const RunMeasure& measure, const std::vector<std::optional<Real>>& values);

std::string percent_text(Real share);

/// Plain text for a terminal: the answer, a table, sentences.
std::string study_text(const MeshStudy& study);

/// convergence.json (docs/formats.md). written: time, UTC, ISO 8601.
std::string study_json(const MeshStudy& study, const std::string& written);

/// Keys of a quantity in convergence.json, as docs/formats.md lists them.
std::vector<QuantityInfo> study_keys();

}  // namespace terp
