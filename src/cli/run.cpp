// New runs, resumed ones, and those that begin with another run differ only in how their simulation comes about; then
// all are a StartedRun. All tests of the case come first; only then does RunWriter touch earlier results. A resumed run
// is built with its first time.end, to which its time step belongs; then the end is moved. The record in a checkpoint
// says what the run began with; the case file beside it must agree, but for a few keys.

#include "cli/started_run.hpp"
#include "run/measure/followers.hpp"
#include "io/case/case_record.hpp"
#include "io/case/printable.hpp"
#include "io/files/checkpoint.hpp"
#include "io/files/summary_json.hpp"
#include "os/instructions.hpp"
#include "model/parts/initial.hpp"
#include "run/loop/other_run.hpp"
#include "run/loop/simulation.hpp"
#include "run/loop/stages.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/state_image.hpp"
#include "run/findings/setup_warnings.hpp"
#include "os/say.hpp"
#include "math/number_from.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace terp {
namespace {

/// What the summary of a run says; as of a run that has not begun where it cannot be read.
Summary summary_so_far(const std::string& folder)
{
  try {
    return read_summary(path_in(folder, summary_file)).values;
  } catch (const FileError&) {  // the run was killed before it wrote one
    return {};
  }
}

/// The instruction sets that a run was solved with, those of `before` first. Says so where the present one is another
/// than the last.
std::string instructions_after(const std::string& before)
{
  const std::string now(instructions()), last = before.substr(before.rfind(' ') + 1);  // of "avx512, avx2"
  if (before.empty() || last == now) return before.empty() ? now : before;
  const auto of_same_bits = [](const std::string& set) { return set == "avx512" || set == "avx2"; };
  say(stderr, "warning: the run was solved with the instruction set {} so far, and goes on with {}{}\n", last, now,
      of_same_bits(last) && of_same_bits(now)
          ? ", which gives the same bits"
          : "; its results may differ in the last digits from those of one set (TERP_INSTRUCTIONS chooses)");
  return before + ", " + now;
}

constexpr Real never_ends = std::numeric_limits<Real>::infinity();

/// A run folder, from a folder or from the path of one of its checkpoints.
std::string run_folder_of(const std::string& path)
{
  std::filesystem::path p(path);
  std::error_code none;
  if (p.extension() == ".toml" && !std::filesystem::is_directory(p, none))
    throw CaseError(fmt::format(
        "error: {0}: `terp resume` takes a run folder, as in terp resume {1}\n"
        "  It goes on from the newest checkpoint there. To solve a case file from its start: terp run {0}\n",
        path, p.filename() == case_file ? folder_of(path) : default_run_folder(path)));
  if (std::filesystem::is_regular_file(p)) p = p.parent_path();
  if (!std::filesystem::is_directory(p.empty() ? "." : p)) throw FileError(fmt::format("{}: no such run folder", path));
  return p.empty() ? "." : p.string();
}

struct Checkpoint {
  std::string path;
  StateImage image;
};

/// The checkpoint that was named, or the newest good one of the folder.
Checkpoint find_checkpoint(const std::string& path)
{
  if (std::filesystem::is_regular_file(path)) return {path, read_checkpoint(path)};
  CheckpointSearch found = newest_good_checkpoint(path);
  for (const auto& bad : found.skipped) say(stderr, "warning: skipped {}: {}\n", bad.path, bad.reason);
  if (!found.image)
    throw FileError(fmt::format("{}: no checkpoint to resume from. Start the case anew with `terp run`.", path));
  return {found.path, std::move(*found.image)};
}

/// What changed in the case since the run began, of what may, and the lines of what may not.
std::vector<ChangedValue> split_changes(const StateImage& image, const CaseRecord& now, std::string& refused)
{
  std::vector<ChangedValue> allowed;
  for (ChangedValue& change : changes_since(image.case_record, now)) {
    if (!may_change_on_resume(change.key))
      refused += "\n  " + change.text();
    else
      allowed.push_back(std::move(change));
  }
  return allowed;
}

/// Throws FileError where anything else changed: no result may come from two cases.
std::vector<ChangedValue> check_unchanged(const std::string& folder, const StateImage& image, const CaseRecord& now)
{
  std::string refused;
  std::vector<ChangedValue> allowed = split_changes(image, now, refused);
  if (refused.empty()) return allowed;
  throw FileError(fmt::format(
      "cannot resume from step {0}: {1} was changed since the run began{2}\n"
      "  Put back what it began with, or solve the changed case from its start: terp run {1} -o NEW_FOLDER\n"
      "  These may change: title, time.end, time.at_most, output.fields.every, output.checkpoint",
      image.step, path_in(folder, case_file), refused));
}

State restore_from(const std::string& path, const Model& model, const StateImage& image)
{
  try {
    State state = restore(model, image);
    if (state.has_no_start)
      throw FileError(
          "it is the end of a search for equilibrium that found none, kept to look at: nothing can be "
          "judged that goes on from there");
    return state;
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}: {}\n  Resume from another: terp resume CHECKPOINT", path, error.what()));
  }
}

/// The case as the run began with it, as far as its time step goes: that of the first end.
Case with_first_end(Case description, const StateImage& image)
{
  const std::string text = value_in_record(image.case_record, "time.end");
  from_chars(text.data(), text.data() + text.size(), description.time.end);  // where there is none, it is left
  return description;
}

/// The end as the case has it now must lie after the checkpoint. Of a run that began with the end of another, time.end
/// counts from there.
void check_end(const Case& now, const Model& model, const State& state)
{
  if (last_step_of_run(model, state) >= state.step) return;
  throw FileError(fmt::format(
      "cannot resume from step {}, t = {:.4g} s: time.end = {} s{} lies before it\n"
      "  Set a later time.end in {} of the folder, or name an earlier checkpoint.",
      state.step, state.time, now.time.end,
      state.stage_start > 0 ? fmt::format(" from t = {:.4g} s on", model.time_of(state.stage_start)) : "", case_file));
}

/// Finds the history points; the case must still seed the points of the checkpoint.
void seed_again(const StateImage& image, Model& model)
{
  const std::int64_t n_seeded = build_state(model).n_ids(), n = count_points(image);
  if (n_seeded != n)
    throw FileError(
        fmt::format("cannot resume from step {}: the case seeds {} material points, the checkpoint holds {}\n"
                    "  {} of the folder, or a file that it names, is not what the run began with.",
            image.step, n_seeded, n, case_file));
}

/// What the files of the run must hold: rows and frames were counted as they were written.
ResumePoint resume_point(const Model& model, const State& state, const std::string& tables)
{
  const OutputCase& output = model.description.output;
  return {.step = state.step,
      .time = state.time,
      .n_frames = state.frames_reported,
      .n_mesh_frames = output.mesh ? state.frames_reported : 0,
      .n_rows = state.rows_reported,
      .tables = tables};
}

std::string unquoted(const std::string& text)
{
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

struct Beginning {
  std::string path;  ///< of the checkpoint
  StateImage image;
  std::string stage;  ///< that ended there; empty: none
};

/// RUN:STAGE, a run folder, or the path of a checkpoint.
Beginning find_beginning(const std::string& from)
{
  const std::size_t colon = from.rfind(':');
  const bool names_stage = colon != std::string::npos && from.find_first_of("/\\", colon) == std::string::npos;
  std::string path = from;
  if (path.ends_with(".toml") && std::filesystem::is_regular_file(path))
    throw FileError(
        fmt::format("{}: this is a case file; give the run to begin with: RUN, RUN:STAGE, or a checkpoint", path));
  if (!std::filesystem::exists(path) && names_stage)  // a colon before a slash is that of a drive
    path = find_stage_file(from.substr(0, colon), from.substr(colon + 1));
  if (!std::filesystem::exists(path))
    throw FileError(
        fmt::format("{}: there is no such run or checkpoint\n  Give RUN:STAGE, the end of a stage of a run, "
                    "a run folder, or a checkpoint in it.",
            from));
  auto [checkpoint, image] = find_checkpoint(path);
  Beginning found{std::move(checkpoint), std::move(image), ""};
  const ArrayReader arrays(found.image.arrays);
  if (!arrays.has("stages_done")) return found;
  const auto number = arrays.wholes("stage", 3)[0];
  if (std::ssize(arrays.reals("stages_done")) / 5 > number)
    found.stage = unquoted(value_in_record(found.image.case_record, fmt::format("stage[{}].name", number)));
  return found;
}

/// The mesh and the points must be those of the run that it begins with.
void check_same_soil(const std::string& from, const StateImage& image, const CaseRecord& now)
{
  std::string refused;
  for (const ChangedValue& change : changes_since(image.case_record, now)) {
    const bool is_material = change.key.starts_with("body[") && change.key.ends_with(".material");
    for (const char* of_soil : {"mesh", "body", "material (in order)", "method.shares", "scheme"})
      if (change.key.starts_with(of_soil) && !is_material) refused += "\n  " + change.text();
  }
  if (refused.empty()) return;
  throw FileError(
      fmt::format("cannot begin with {}: it is of another mesh, other bodies or another scheme{}\n"
                  "  Loads, strengths, water and stages may differ.",
          from, refused));
}

/// The model of the run that another one begins with, from the case in its folder.
Model model_before(const Beginning& beginning, const SharedMesh& mesh, int threads)
{
  const std::string folder = folder_of(beginning.path), path = path_in(folder, case_file);
  const std::string why =
      "\n  What the soil of the checkpoint is made of stands there: its drainage, densities and loads.";
  if (!std::filesystem::exists(path))
    throw FileError(fmt::format("cannot begin with {}: there is no {} beside it{}", beginning.path, case_file, why));
  const CaseFile file = read_case(path);
  std::string refused;
  split_changes(beginning.image, make_case_record(file, *mesh), refused);
  if (!refused.empty())
    throw FileError(
        fmt::format("cannot begin with {}: {} was changed since that run began{}{}\n  Put back what it "
                    "began with.",
            beginning.path, path, refused, why));
  Model model = build_model(with_first_end(file.values, beginning.image), mesh, threads);
  model.followers = all_followers();
  return model;
}

/// The simulation at the state with which it begins.
Simulation begin(const CaseFile& file, const RunOptions& options)
{
  if (options.from.empty()) return Simulation(file.values, threads_of(options), all_followers());
  const Beginning beginning = find_beginning(options.from);
  Model model = build_model(file.values, threads_of(options));
  model.followers = all_followers();
  check_same_soil(options.from, beginning.image, make_case_record(file, *model.mesh));
  seed_again(beginning.image, model);
  Model before = model_before(beginning, model.mesh, threads_of(options));
  State state = restore_from(options.from, before, beginning.image);
  before = model_for(std::move(before), state);
  begin_from(before, beginning.stage, model, state);
  return Simulation(std::move(model), std::move(state));
}

}  // namespace

int run_case(const RunOptions& options) { return *start_run(options)->go_on(never_ends); }

int resume_run(const RunOptions& options) { return *start_resumed_run(options)->go_on(never_ends); }

std::unique_ptr<StartedRun> start_run(const RunOptions& options)
{
  std::vector<std::string> changes = options.changes;
  if (!options.at_strength.empty()) changes.push_back("at_strength=" + options.at_strength);
  CaseFile file = read_case(options.path, changes);
  const std::string folder = options.output.empty() ? default_run_folder(options.path) : options.output;
  file.run = folder;
  if (is_alone(options)) say(stderr, "{}", render_warnings(file));
  try {
    auto run = std::make_unique<StartedRun>(options, file, folder, [&] { return begin(file, options); });
    const Simulation& simulation = run->simulation;
    warn_of_missing_threads(options, simulation.model.threads);
    if (is_alone(options)) say(stderr, "{}", render_warnings(find_warnings(simulation.model, simulation.state), file));
    run->write_to(RunWriter::start({folder, {file.values.name, file.text}, file.values.output.checkpoint_keep,
                                       record_text(make_case_record(file, *simulation.model.mesh)), file.inputs,
                                       all_tables(), options.exact_fields},
        options.force));
    return run;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
}

std::unique_ptr<StartedRun> start_resumed_run(const RunOptions& options)
{
  const std::string folder = run_folder_of(options.path);
  FolderLock lock(folder);
  if (!std::filesystem::exists(path_in(folder, case_file)))
    throw FileError(fmt::format("{}: this is no run folder, it holds no {}", folder, case_file));
  const CaseFile file = read_case(path_in(folder, case_file));
  const auto [checkpoint, image] = find_checkpoint(options.path);
  try {
    Model model = build_model(with_first_end(file.values, image), threads_of(options));
    model.followers = all_followers();
    const CaseRecord record = make_case_record(file, *model.mesh);
    const auto changes = check_unchanged(folder, image, record);
    seed_again(image, model);
    if (file.values.time.end != model.description.time.end) move_end(model, file.values.time.end);
    State restored = restore_from(checkpoint, model, image);
    auto run = std::make_unique<StartedRun>(
        options, file, folder, [&] { return Simulation(std::move(model), std::move(restored)); });
    Simulation& simulation = run->simulation;
    check_end(file.values, simulation.model, simulation.state);
    warn_of_missing_threads(options, simulation.model.threads);
    const State& state = simulation.state;
    const Summary before = summary_so_far(folder);
    simulation.state.wall_s = before.wall_s, simulation.state.search_s = before.search_s;
    simulation.state.instructions = instructions_after(before.instructions);
    RunWriterSettings settings{.folder = folder,
        .case_text = {case_name_in(folder), file.text},
        .checkpoint_keep = file.values.output.checkpoint_keep,
        .case_record = image.case_record,
        .tables = all_tables()};
    auto writer =
        RunWriter::resume(std::move(settings), std::move(lock), resume_point(simulation.model, state, image.tables));
    if (!options.quiet && is_alone(options))
      say("resuming {} at t = {:.4g} s, step {} of {}\n", folder, state.time, state.step, simulation.model.n_steps);
    for (const auto& warning : writer->warnings()) say(stderr, "warning: {}\n", warning);
    for (const ChangedValue& change : changes)
      if (!options.quiet) say("  from here on with another {}\n", change.text());
    run->write_to(std::move(writer));
    return run;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
}

}  // namespace terp
