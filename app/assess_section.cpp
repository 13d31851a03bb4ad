// How it thinks: each step leaves a file, and section.json says which file and which options it is of. So what was
// killed goes on with the step that it was in, and the run in it from its newest checkpoint.

#include "assess.hpp"
#include "base/checksum.hpp"
#include "base/errors.hpp"
#include "cost.hpp"
#include "dstability/read_stix.hpp"
#include "dstability/slices.hpp"
#include "import_options.hpp"
#include "input/case_file.hpp"
#include "output/files.hpp"
#include "output/run_folder.hpp"
#include "output/summary_json.hpp"
#include "simulation/setup_mesh.hpp"
#include "stop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <new>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr double trial_seconds = 0.5;

bool is_stix(const std::string& file) { return fs::path(file).extension() == ".stix"; }

std::string case_of(const PlannedSection& section)
{
  if (is_stix(section.file)) return path_in(section.folder, case_file);
  return fs::is_directory(section.file) ? path_in(section.file, case_file) : section.file;
}

/// Digits that change with the file and with every option that its result depends on.
std::string question_of(const PlannedSection& section, const AssessCommand& command)
{
  const ImportCommand& import = command.import;
  std::string text = is_stix(section.file) ? read_file(section.file) : "";
  text += fmt::format("|{}|{}|{}|{}|{}|{}", import.scenario, import.stage, import.strength, import.cell, import.trigger,
      command.stability);
  if (import.base) text += fmt::format("|{}", *import.base);
  for (const double x : import.between) text += fmt::format("|{}", x);
  if (!import.soil_defaults.empty()) text += read_file(import.soil_defaults);
  return digits_of(text);
}

/// Digits that change with the case and with every table that it names.
std::string digits_of_case(const PlannedSection& section)
{
  const CaseFile file = read_case(case_of(section));
  std::string all = file.text;
  for (const InputFile& input : file.inputs) all += read_file(input.path);
  return digits_of(all);
}

/// Sees how long the run still takes.
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
    make_folder(section_.folder);
    const std::string question = question_of(section_, command_);
    const bool is_changed = is_changed_by_hand();
    if (record_.question != question || command_.force) {
      if (is_changed && !command_.force)
        refuse_import(
            fmt::format("{} was changed by hand, and the file or the options changed, too", case_of(section_)),
            "--force imports it anew. Or choose another folder: -o FOLDER.");
      record_ = {.question = question};
    }
    if (is_changed && !command_.force) take_changed_case();
    record_.fault.clear();
    record_.name = section_.name, record_.file = section_.file;
    const bool goes_on = make_steps();
    record_.is_done = goes_on;
    if (goes_on) note_time();
    return goes_on;
  }

  void note_fault(const std::string& text)
  {
    record_.fault = text.starts_with("error: ") ? text.substr(7) : text;
    while (record_.fault.ends_with('\n')) record_.fault.pop_back();
    record_.is_done = true;
    note_time();
  }

 private:
  bool make_steps()
  {
    if (is_stix(section_.file) && (record_.case_found.empty() || !fs::exists(case_of(section_)))) {
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
    fmt::print("{}\n", record_.step);
    note_time();
  }

  void note_time()
  {
    const auto now = Clock::now();
    record_.seconds += std::chrono::duration<double>(now - last_).count();
    last_ = now;
    write_file_atomically(path_in(section_.folder, record_file), record_text(record_));
  }

  void note_case() { record_.case_found = digits_of_case(section_); }

  bool is_changed_by_hand() const
  {
    const std::string path = case_of(section_);
    return !record_.case_found.empty() && fs::exists(path) && digits_of_case(section_) != record_.case_found;
  }

  /// The case is as the user wants it: nothing is known of it, and no trigger is put into it.
  void take_changed_case()
  {
    record_.factor = record_.uncertainty = std::nullopt;
    record_.has_trigger = true;
    record_.trigger.clear();
    note_case();
  }

  // --------------------------------------------------------------------------------------------------- file to case

  /// The stage that is asked for; by default the last one of the last scenario.
  void read_project()
  {
    project_ = read_stix(section_.file);
    ImportCommand import = command_.import;
    import.path = section_.file;
    if (import.scenario == 0) import.scenario = static_cast<int>(project_.scenarios.size());
    options_ = folder_options(project_, import);
  }

  bool needs_search() const { return is_stix(section_.file) && command_.import.trigger == "strength"; }

  void write_case(const FolderTrigger& trigger)
  {
    FolderOptions options = options_;
    options.trigger = trigger;
    options.is_held = record_.is_held;
    const CaseFolder folder = case_folder_of(project_, options);
    write_case_folder(section_.folder, folder);
    for (const std::string& note : folder.notes) fmt::print("warning: {}\n", note);
    record_.has_report = true;
    note_case();
  }

  void import()
  {
    try {
      read_project();
      remember_stored();
      record_.has_trigger = options_.trigger.kind == TriggerKind::none;
      write_case({});
      remove_run(path_in(section_.folder, run_of_section));
    } catch (const InputError& error) {
      refuse_import(section_.file, error);
    }
  }

  void remember_stored()
  {
    record_.stored.clear();
    const std::vector<ResultSlices> slices = compare_slices(project_);
    const auto& calculations = project_.scenarios[options_.scenario].calculations;
    for (std::size_t k = 0; k < calculations.size(); ++k) {
      const StixCalculation& c = calculations[k];
      if (c.stage != options_.stage || !c.result || !std::isfinite(c.result->factor_of_safety)) continue;
      const bool stale = std::ranges::any_of(slices, [&](const ResultSlices& of) {
        return of.scenario == options_.scenario && of.calculation == k && !of.stale.empty();
      });
      record_.stored.push_back({c.method, c.result->factor_of_safety, stale});
    }
  }

  void add_trigger()
  {
    if (is_stix(section_.file)) {
      try {
        read_project();
        FolderTrigger trigger = options_.trigger;
        if (asks_for_search(trigger)) trigger = trigger_after(record_.stands, record_.fails);
        if (trigger.kind == TriggerKind::none) record_.trigger = trigger.origin;
        record_.is_held = record_.is_held || (trigger.kind == TriggerKind::none && needs_search());
        write_case(trigger);
      } catch (const InputError& error) {
        refuse_import(section_.file, error);
      }
    }
    record_.has_trigger = true;
    note_time();
  }

  // -------------------------------------------------------------------------------------------------- case to result

  void check()
  {
    const CaseFile file = read_case(case_of(section_));
    fmt::print("{}", render_warnings(file));
    record_.title = file.values.title.empty() ? file.values.name : file.values.title;
    try {
      Simulation simulation(file.values, command_.threads);
      record_.cell = typical_cell_size(*simulation.model.mesh);
      record_.n_points = simulation.state.points.n_points();
      record_.expected_s = expected_seconds(simulation, trial_seconds);
    } catch (const InputError& error) {
      throw CaseError(render(error.problems(), file));
    }
    if (record_.case_found.empty()) note_case();
    note_time();
  }

  bool find_factor()
  {
    begin_step(2);
    RunOptions search = options_of_run();
    search.path = case_of(section_), search.output = path_in(section_.folder, "stability");
    const StabilityResult result = search_stability(search);
    if (result.stopped || stop_requested) return false;
    record_.stands = result.search.stable, record_.fails = result.search.highest();
    if (result.search.found()) record_.factor = result.factor(), record_.uncertainty = result.uncertainty();
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
    const std::string found = digits_of_case(section_);
    const bool is_same = record_.run_of == found;
    record_.run_of = found;
    note_time();
    if (!is_same || !has_finished(folder)) {
      RunWatcher watcher(progress_);
      std::string fault;
      const PartOfSet part{.label = section_.name + "  ", .fault = &fault, .observer = &watcher};
      RunOptions options = options_of_run();
      options.part = &part;
      if (is_same && has_checkpoint(folder)) {
        options.path = folder;
        resume_run(options);
      } else {
        options.path = case_of(section_), options.output = folder, options.force = true;
        run_case(options);
      }
      if (stop_requested) return false;
      if (fault.starts_with("no equilibrium") && hold()) return run();
      if (!fault.empty()) throw RunError(fault);
    }
    begin_step(4);
    report_runs({.runs = {folder}, .output = path_in(folder, report_file), .language = command_.language});
    record_.step = section_steps[3];
    return true;
  }

  /// A section that does not stand by itself is held until it is at rest. False: it was, or is no file of D-Stability.
  bool hold()
  {
    if (record_.is_held || !is_stix(section_.file) || is_changed_by_hand()) return false;
    fmt::print("it does not stand by itself: held until it is at rest\n");
    record_.is_held = true;
    add_trigger();
    return true;
  }

  static bool has_finished(const std::string& folder)
  {
    return fs::exists(path_in(folder, summary_file)) && read_summary(path_in(folder, summary_file)).finished;
  }

  static bool has_checkpoint(const std::string& folder)
  {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
      if (step_of_checkpoint(entry.path().filename().string()) >= 0) return true;
    return false;
  }

  using Clock = std::chrono::steady_clock;
  const PlannedSection& section_;
  const AssessCommand& command_;
  SectionProgress& progress_;
  SectionRecord record_;
  StixProject project_;
  FolderOptions options_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace

bool is_done(const PlannedSection& section, const AssessCommand& command)
{
  const SectionRecord& record = section.record;
  if (command.force || !record.is_done || !record.fault.empty()) return false;
  const std::string summary = path_in(path_in(section.folder, run_of_section), summary_file);
  if (!fs::exists(section.file) || !fs::exists(case_of(section)) || !fs::exists(summary)) return false;
  try {
    return record.question == question_of(section, command) && record.run_of == digits_of_case(section) &&
           read_summary(summary).finished;
  } catch (const CaseError&) {
    return false;
  }
}

bool assess_section(const PlannedSection& section, const AssessCommand& command, SectionProgress& progress)
{
  Assessment assessment(section, command, progress);
  try {
    return assessment.make();
  } catch (const std::bad_alloc&) {
    assessment.note_fault("not enough memory");
  } catch (const std::exception& error) {
    if (stop_requested) return false;
    assessment.note_fault(error.what());
  }
  return true;
}

}  // namespace terp
