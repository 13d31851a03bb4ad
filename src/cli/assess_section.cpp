// How it thinks: each step leaves a file, and section.json says which file and which options it is of. So what was
// killed goes on with the step that it was in, and the run in it from its newest checkpoint.

#include "cli/assess.hpp"
#include "math/checksum.hpp"
#include "math/errors.hpp"
#include "cli/cost.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/slices.hpp"
#include "import/dstability/soil_defaults.hpp"
#include "import/dstability/soil_strength.hpp"
#include "cli/import_options.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/summary_json.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "os/files.hpp"
#include "os/stop.hpp"
#include "os/say.hpp"
#include "run/findings/setup_warnings.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/ranges.h>
#include <map>
#include <new>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr double trial_seconds = 0.5;
constexpr const char* report_of_import = "report.md";
constexpr const char* anew_or_elsewhere = "--force imports it anew. Or choose another folder: -o FOLDER.";

bool is_stix(const std::string& file) { return fs::path(file).extension() == ".stix"; }

std::string case_of(const PlannedSection& section)
{
  if (is_stix(section.file)) return path_in(section.folder, case_file);
  return fs::is_directory(section.file) ? path_in(section.file, case_file) : section.file;
}

/// Digits that change with the file and with every option that its result depends on.
std::string question_of(const PlannedSection& section, const AssessCommand& command)
{
  ImportCommand import = command.import;
  const std::string table = import.soil_defaults.empty() ? soil_defaults_table() : read_file(import.soil_defaults);
  import.soil_defaults.clear();  // what it says counts, not where it lies
  std::string text = is_stix(section.file) ? read_file(section.file) : "";
  text += fmt::format("|{}|{}|", command.stability, fmt::join(given_options(import), "|"));
  return digits_of(text + table);
}

/// Digits of this build of terp: another one may import and solve otherwise.
const std::string& this_program()
{
  static const std::string digits = [] {
    try {
      return digits_of(read_file(program_file()));
    } catch (const FileError&) {
      return digits_of(TERP_VERSION);
    }
  }();
  return digits;
}

/// Digits that change with what a case says, and with every table that it names. Comments at its head do not count:
/// those of a case with tables name its path as it was given. Throws CaseError, FileError.
std::string digits_of_case(const std::string& path)
{
  const CaseFile file = read_case(path);
  std::string all = file.text;
  while (all.starts_with('#') || all.starts_with('\n')) all.erase(0, std::min(all.find('\n'), all.size() - 1) + 1);
  for (const InputFile& input : file.inputs) all += read_file(input.path);
  return digits_of(all);
}

/// The same; none of a case that cannot be read.
std::optional<std::string> digits_if_read(const std::string& path)
{
  try {
    if (fs::exists(path)) return digits_of_case(path);
  } catch (const CaseError&) {
  } catch (const FileError&) {
  }
  return std::nullopt;
}

/// Digits of the files of a case that are to be written, by their names.
std::map<std::string, std::string> digits_by_name(const CaseFolder& folder)
{
  std::map<std::string, std::string> digits;
  for (const auto& [name, contents] : folder.files)
    if (name != report_of_import) digits[name] = digits_of(contents);
  return digits;
}

bool has_trigger(const Case& c)
{
  return c.at_strength > 1.0 || std::ranges::any_of(c.stages, [](const StageCase& stage) {
    return stage.trigger || stage.changed->at_strength > 1.0;
  });
}

bool has_finished(const std::string& folder, const std::string& digits)
{
  const std::string summary = path_in(folder, summary_file);
  try {
    return fs::exists(summary) && read_summary(summary).finished &&
           digits_if_read(path_in(folder, case_file)) == digits;
  } catch (const FileError&) {
    return false;
  }
}

/// Another terp may be writing to it: FileError.
void remove_run_alone(const std::string& folder)
{
  if (!fs::exists(folder)) return;
  const FolderLock lock(folder);
  remove_run(folder);
}

class RunWatcher : public Observer {
 public:
  explicit RunWatcher(SectionProgress& progress) : progress_(progress) {}
  void progress(const Progress& p) override { progress_.left_s = p.out_of_balance >= 0.0 ? -1.0 : p.eta_s; }

 private:
  SectionProgress& progress_;
};

class Assessment {
 public:
  Assessment(const PlannedSection& section, const AssessCommand& command, SectionProgress& progress)
      : section_(section), command_(command), progress_(progress), record_(section.record)
  {
  }

  /// False: stopped from outside.
  bool make()
  {
    record_.step = section_steps[0];
    make_folder(section_.folder);
    const std::string question = question_or_refusal();
    const bool is_edited = !command_.force && is_changed_by_hand();
    if (is_edited && record_.question != question)
      refuse_import(fmt::format("{} was changed by hand, and the file or the options changed, too", case_of(section_)),
          anew_or_elsewhere);
    const bool is_other_program = record_.program != this_program();
    if (command_.force || record_.question != question || (is_other_program && !is_edited))
      record_ = {.question = question, .files = record_.files, .files_next = record_.files_next};
    if (!record_.files_next.empty()) record_.has_report = false;  // a kill cut the import short: once more
    if (is_other_program || digits_if_read(case_of(section_)) != record_.case_found) forget_results();
    record_.program = this_program();
    record_.is_done = false;
    record_.fault.clear(), record_.is_refused = false;
    record_.name = section_.name, record_.file = printable(section_.file);
    note_time();
    const bool goes_on = make_steps();
    record_.is_done = goes_on && !command_.estimate;
    if (goes_on) note_time();
    return goes_on;
  }

  /// is_refused: it is one of the file, the case or the options.
  void note_fault(const std::string& text, bool is_refused)
  {
    record_.is_refused = is_refused;
    record_.name = section_.name, record_.file = printable(section_.file);
    record_.fault = printable(text.starts_with("error: ") ? text.substr(7) : text);
    while (record_.fault.ends_with('\n')) record_.fault.pop_back();
    record_.is_done = true;
    note_time();
  }

 private:
  std::string question_or_refusal() const
  {
    try {
      return question_of(section_, command_);
    } catch (const FileError& error) {
      throw CaseError(error.what());
    }
  }

  bool make_steps()
  {
    if (is_stix(section_.file) && (!record_.has_report || !fs::exists(case_of(section_)))) {
      begin_step(0);
      import();
    }
    begin_step(1);
    check();
    if (command_.estimate) return true;
    if ((command_.stability || needs_search()) && !record_.factor && !find_factor()) return false;
    if (!record_.has_trigger) add_trigger();
    begin_step(3);
    return run();
  }

  void begin_step(int number)
  {
    progress_.step = number;
    progress_.left_s = -1.0;
    record_.step = section_steps[number];
    say("{}\n", record_.step);
    note_time();
  }

  void note_time()
  {
    const auto now = Clock::now();
    record_.seconds += std::chrono::duration<double>(now - last_).count();
    last_ = now;
    write_file_atomically(path_in(section_.folder, record_file), record_text(record_));
  }

  /// The case in the folder of a D-Stability file is not the one that terp wrote there.
  bool is_changed_by_hand() const
  {
    if (!is_stix(section_.file) || !fs::exists(case_of(section_))) return false;
    return std::ranges::any_of(record_.files, [&](const auto& file) {
      const auto& [name, digits] = file;
      const std::string path = path_in(section_.folder, name), now = fs::exists(path) ? digits_of(read_file(path)) : "";
      const auto next = record_.files_next.find(name);
      return now != digits && (next == record_.files_next.end() || now != next->second);
    });
  }

  /// Those of another case.
  void forget_results()
  {
    record_.factor = record_.uncertainty = record_.stands = record_.fails = record_.creeps = std::nullopt;
    record_.run_of.clear(), record_.trigger.clear();
    record_.has_trigger = false;
    record_.case_found = digits_if_read(case_of(section_)).value_or("");
  }

  /// The stage that is asked for; by default the last one of the last scenario.
  void read_project()
  {
    project_ = read_stix(section_.file);
    ImportCommand import = command_.import;
    import.path = section_.file;
    if (import.scenario == 0) import.scenario = static_cast<int>(project_.scenarios.size());
    options_ = folder_options(project_, import);
  }

  bool needs_search() const
  {
    return is_stix(section_.file) && command_.import.trigger == "strength" && !is_changed_by_hand();
  }

  /// A case that terp did not write stays as it is, also where nothing is known of it.
  bool may_write(const CaseFolder& folder) const
  {
    const std::string path = case_of(section_);
    if (is_forced_ || !fs::exists(path)) return true;
    if (!record_.files.empty()) return !is_changed_by_hand();
    return read_file(path) == folder.files.front().second;
  }

  void write_case(const FolderTrigger& trigger)
  {
    FolderOptions options = options_;
    options.trigger = trigger;
    options.is_held = record_.is_held;
    const CaseFolder folder = case_folder_of(project_, options);
    if (!may_write(folder))
      refuse_import(fmt::format("{} is not as terp wrote it", case_of(section_)), anew_or_elsewhere);
    is_forced_ = false;
    record_.files_next = digits_by_name(folder);
    note_time();  // before the files: a kill leaves some of either case
    write_case_folder(section_.folder, folder);
    record_.notes.clear();
    record_.notes_nl.clear();
    for (const Sentence& note : folder.notes) {
      say("warning: {}\n", note.en);
      record_.notes.push_back(printable(note.en));
      record_.notes_nl.push_back(printable(note.nl));
    }
    record_.has_report = true;
    record_.files = std::move(record_.files_next);
    record_.files_next.clear();
    record_.case_found = digits_of_case(case_of(section_));
  }

  void import()
  {
    try {
      read_project();
      remember_stored();
      record_.has_trigger = options_.trigger.kind == TriggerKind::none;
      write_case({});
    } catch (const InputError& error) {
      refuse_import(section_.file, error);
    }
  }

  void remember_stored()
  {
    record_.stored.clear(), record_.strength = strengths_of(options_.basis);
    const std::vector<ResultSlices> slices = compare_slices(project_);
    const auto& calculations = project_.scenarios[options_.scenario].calculations;
    for (std::size_t k = 0; k < calculations.size(); ++k) {
      const StixCalculation& c = calculations[k];
      if (c.stage != options_.stage || !c.result || !std::isfinite(c.result->factor_of_safety)) continue;
      const auto found = std::ranges::find_if(
          slices, [&](const ResultSlices& of) { return of.scenario == options_.scenario && of.calculation == k; });
      const SliceState state = found == slices.end() ? SliceState::fits : found->state;
      record_.stored.push_back({c.method, c.result->factor_of_safety,
          state == SliceState::other_section || command_.import.river.has_value(),
          std::string(state == SliceState::other_strengths ? "other" : strengths_of(c.kind))});
    }
  }

  void add_trigger()
  {
    if (!is_stix(section_.file) || is_changed_by_hand()) return note_time();
    try {
      read_project();
      FolderTrigger trigger = options_.trigger;
      if (asks_for_search(trigger)) trigger = trigger_after({record_.stands, record_.fails, record_.creeps});
      if (trigger.kind == TriggerKind::none) record_.trigger = trigger.origin;
      record_.is_held = record_.is_held || trigger.needs_hold;
      write_case(trigger);
    } catch (const InputError& error) {
      refuse_import(section_.file, error);
    }
    record_.has_trigger = true;
    note_time();
  }

  void check()
  {
    const CaseFile file = read_case(case_of(section_));
    say("{}", render_warnings(file));
    ImportCommand given = command_.import;
    if (has_trigger(file.values)) given.trigger.clear();
    const bool is_edited = is_changed_by_hand();
    record_.ignored = is_edited || !is_stix(section_.file) ? ignored_options(given, is_edited) : "";
    const auto& stages = file.values.stages;
    record_.is_held = !stages.empty() && stages.front().changed->at_strength < 1.0;
    record_.title = printable(file.values.title.empty() ? file.values.name : file.values.title);
    try {
      Simulation simulation(file.values, command_.threads);
      say("{}", render_warnings(find_warnings(simulation.model, simulation.state), file));
      record_.cell = typical_cell_size(*simulation.model.mesh);
      record_.n_points = simulation.state.points.n_points();
      record_.expected_s = expected_seconds(simulation, trial_seconds);
    } catch (const InputError& error) {
      throw CaseError(render(error.problems(), file));
    }
    note_time();
  }

  bool find_factor()
  {
    begin_step(2);
    RunOptions search = options_of_run();
    search.path = case_of(section_), search.output = path_in(section_.folder, "stability");
    const StabilityResult result = search_stability(search);
    if (result.stopped || stop_requested) return false;
    const FoundFactors found = factors_of(result);
    record_.stands = found.stands, record_.fails = found.fails, record_.creeps = found.creeps;
    if (result.search.found()) {
      record_.factor = result.answer();
      if (!result.is_upper_bound()) record_.uncertainty = result.answer_uncertainty();
    }
    if (!record_.has_trigger) add_trigger();
    note_time();
    return true;
  }

  RunOptions options_of_run() const
  {
    RunOptions options;
    options.threads = command_.threads, options.language = command_.language;
    return options;
  }

  bool run()
  {
    const std::string folder = path_in(section_.folder, run_of_section);
    const std::string found = digits_of_case(case_of(section_));
    const bool is_same = record_.run_of == found;
    if (!is_same) remove_run_alone(folder);  // before the record says that the run is of this case
    record_.run_of = found;
    note_time();
    if (!has_finished(folder, found)) {
      RunWatcher watcher(progress_);
      std::string fault;
      bool slides = false;
      const PartOfSet part{.label = section_.name + "  ", .fault = &fault, .slides = &slides, .observer = &watcher};
      RunOptions options = options_of_run();
      options.part = &part;
      if (is_same && newest_step(folder) >= 0) {
        options.path = folder;
        resume_run(options);
      } else {
        options.path = case_of(section_), options.output = folder, options.force = true;
        run_case(options);
      }
      if (stop_requested) return false;
      if (slides && hold(fault)) return run();
      if (!fault.empty()) throw RunError(fault);
    }
    begin_step(4);
    report_runs({.runs = {folder}, .output = path_in(folder, report_file), .language = command_.language});
    record_.language = command_.language;
    record_.step = section_steps[3];
    return true;
  }

  /// A section that does not stand by itself is held at first. False: it was, or is no file of D-Stability.
  bool hold(const std::string& fault)
  {
    if (record_.is_held || !is_stix(section_.file)) return false;
    if (is_changed_by_hand())
      throw RunError(
          fault +
          "\n  The case was changed by hand, so it is not imported anew with held soil. Write the stages for "
          "that yourself (docs/dstability.md, \"Soil that cannot stand\"), or import it anew: --force.");
    say("it does not stand by itself: held at first\n");
    record_.is_held = true;
    add_trigger();
    return true;
  }

  using Clock = std::chrono::steady_clock;
  const PlannedSection& section_;
  const AssessCommand& command_;
  SectionProgress& progress_;
  SectionRecord record_;
  StixProject project_;
  FolderOptions options_;
  bool is_forced_ = command_.force;  ///< whatever case is in the folder, the import replaces it
  Clock::time_point last_ = Clock::now();
};

}  // namespace

bool is_done(const PlannedSection& section, const AssessCommand& command)
{
  const SectionRecord& record = section.record;
  if (command.force || !record.is_done || !record.fault.empty()) return false;
  if (record.program != this_program() || record.language != command.language) return false;
  try {
    return record.question == question_of(section, command) &&
           record.run_of == digits_if_read(case_of(section)).value_or("") &&
           has_finished(path_in(section.folder, run_of_section), record.run_of);
  } catch (const std::exception&) {  // of whatever cannot be read: its own process says what is wrong
    return false;
  }
}

bool would_replace_result(const PlannedSection& section, const AssessCommand& command)
{
  const SectionRecord& record = section.record;
  if (!is_stix(section.file) || command.force || !record.is_done || !record.fault.empty()) return false;
  try {
    return has_finished(path_in(section.folder, run_of_section), record.run_of) &&
           (record.question != question_of(section, command) || record.program != this_program());
  } catch (const std::exception&) {  // of whatever cannot be read: its own process says what is wrong
    return false;
  }
}

bool assess_section(const PlannedSection& section, const AssessCommand& command, SectionProgress& progress)
{
  Assessment assessment(section, command, progress);
  try {
    return assessment.make();
  } catch (const std::bad_alloc&) {
    assessment.note_fault("not enough memory", false);
  } catch (const std::exception& error) {
    if (stop_requested) return false;
    assessment.note_fault(error.what(), dynamic_cast<const CaseError*>(&error) != nullptr);
  }
  return true;
}

}  // namespace terp
