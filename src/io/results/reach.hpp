// A reach of sections, each imported and solved in a folder of its own: what became of them, as tables for programs.
// Not for: solving them (cli/assess), the page (web/).
#pragma once

#include "io/results/run_results.hpp"
#include "run/report/summary.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace terp {

/// A result that the file of a section holds.
struct StoredFactor {
  std::string method = {};                 ///< "Bishop", "UpliftVanParticleSwarm"
  Real factor = 0.0;                       ///< [-]
  bool stale = false;                      ///< of another section than the one in the file
  std::string strength = "deterministic";  ///< that it was computed with: deterministic, design, mean, probabilistic
};

/// What section.json holds: written after each step, so that a later process goes on with the next one.
struct SectionRecord {
  std::string name = {};                   ///< of its folder
  std::string file = {};                   ///< as the user gave it
  std::string title = {};                  ///< of the case
  std::string question = {};               ///< digits that change with the file and the options
  std::string program = {};                ///< digits of the build of terp that the results are of
  std::string language = {};               ///< of the report page
  std::string strength = "deterministic";  ///< of the case
  /// Digits of the files of the case as terp wrote them; others were changed by hand.
  std::map<std::string, std::string> files = {};
  /// Those that it is writing: a kill leaves files of either.
  std::map<std::string, std::string> files_next = {};
  std::string case_found = {};                  ///< digits of the case that the factor of safety is of
  std::string run_of = {};                      ///< digits of the case that the run was begun with
  std::string step = {};                        ///< the last one that was begun: "import", "check", "stability", "run"
  std::string fault = {};                       ///< why there is no result; empty: none so far
  bool is_refused = false;                      ///< the fault is one of the file, the case or the options
  std::vector<std::string> notes = {};          ///< what is in doubt since the import
  std::vector<std::string> notes_nl = {};       ///< the same in Dutch
  bool is_done = false;                         ///< all steps were made, or one has failed
  bool has_report = false;                      ///< it was imported: report.md says what was assumed
  bool has_trigger = false;                     ///< the case has its trigger, or needs none
  bool is_held = false;                         ///< its case holds the soil until it is at rest
  std::string trigger = {};                     ///< why it has none, if one was asked for
  std::string ignored = {};                     ///< options that do not act on it, and why
  std::optional<Real> factor = {};              ///< of safety, by strength reduction [-]
  std::optional<Real> uncertainty = {};         ///< of the factor; none: it is at most that
  std::optional<Real> stands = {}, fails = {};  ///< factors at which it stands and fails
  std::optional<Real> creeps = {};              ///< largest factor of which nothing is known
  std::vector<StoredFactor> stored = {};
  Real cell = 0.0;            ///< size [m]
  std::int64_t n_points = 0;  ///< material points
  double expected_s = 0.0;    ///< of the run, before it
  double seconds = 0.0;       ///< spent on it, without what a killed process spent
};

std::string record_text(const SectionRecord& record);
/// An empty record where there is none, or none that can be read.
SectionRecord read_record(const std::string& folder);

inline constexpr const char* record_file = "section.json";
inline constexpr const char* run_of_section = "run";  ///< folder of its run, in its own

/// A section with what its run says.
struct ReachSection {
  SectionRecord record;
  bool is_solved = false;                         ///< its run has come to its end
  Summary summary = {};                           ///< of such a run
  std::vector<std::array<Real, 3>> profile = {};  ///< x, ground at the start and at the end [m]
};

/// What of a section its folder holds. profile_of: x, ground at the start and at the end of a run [m].
ReachSection read_section(
    const std::string& folder, std::vector<std::array<Real, 3>> (*profile_of)(const RunResults& run));

/// Whether its run, or the last stage of it, ended at rest; none: nothing looked for rest.
std::optional<bool> ended_at_rest(const ReachSection& section);

/// The soil had not come to rest when the trigger began, so that there is no verdict before it.
bool moved_before_trigger(const ReachSection& section);

/// What a reader of its verdict must know.
enum class Hint {
  doubt,         ///< the import was not sure of something that decides the verdict
  ignored,       ///< options of the command do not act on its case
  moves,         ///< it stands or is damaged, but was not at rest at the end
  held,          ///< it does not stand by itself
  stored_below,  ///< it stands as it is, though a stored factor of the same strengths is below one
  stored_above,  ///< it floods as it is, though all stored factors of the same strengths are at least one
};
std::vector<Hint> hints_on(const ReachSection& section);
std::string words_of(Hint hint, const ReachSection& section, bool dutch);

std::string state_of(const ReachSection& section);
/// Its verdict, or why it has none.
std::string sentence_on(const ReachSection& section);
/// "Bishop 1.004, Spencer 1.085 (design strengths, stale)"; empty: none.
std::string stored_text(const SectionRecord& record, bool dutch);

std::string reach_csv(const std::vector<ReachSection>& sections);
/// The table of stability that VRTOOL (Veiligheidsrendement) reads, of the sections whose factor of safety is known;
/// empty: of none. beta = (F/1.06 - 0.41)/0.15, at most 8, as the Dutch assessment rules calibrate it.
std::string vrtool_csv(const std::vector<ReachSection>& sections);
/// with_ground: for the page, which draws it.
std::string reach_json(const std::vector<ReachSection>& sections, const std::string& written, bool with_ground = false);

}  // namespace terp
