// Cases are compared by their records, that is by values. A variant that changes nothing is refused, as it would look
// as if it did not matter.

#include "cli/converge_plan.hpp"

#include "cli/cost.hpp"
#include "io/case/case_record.hpp"
#include "io/case/cell_size.hpp"
#include "io/case/printable.hpp"
#include "model/meshes/mesh_error.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/summary_json.hpp"
#include "cli/progress.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/meshes/turned_mesh.hpp"
#include "run/findings/setup_warnings.hpp"
#include "cli/what_decides.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_of_trial = 0.5;

std::vector<double> sizes_of(const ConvergeOptions& options)
{
  const std::vector<double> cells = descending_sizes(options.cells);
  if (options.what_decides && !cells.empty()) return cells;
  if (cells.size() < 2)
    throw CaseError(
        "error: --cells: one size says nothing of the mesh\n"
        "  Give two or more, and three for an order and an error, each half of the one before: --cells 1,0.5,0.25\n");
  return cells;
}

/// "a=1; b=2" -> "a=1", "b=2".
std::vector<std::string> changes_of_variant(const std::string& text)
{
  std::vector<std::string> changes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
    if (first < end) changes.push_back(text.substr(first, text.find_last_not_of(' ', end - 1) + 1 - first));
    begin = end + 1;
  }
  if (changes.empty())
    throw CaseError("error: --variant: there is no change in it\n  As in --variant scheme=mpm_mixed\n");
  return changes;
}

class Sequences {
 public:
  std::vector<StudySequence> all{{"as given", {}, {}}};
  std::vector<double> turns{0.0};  ///< of each the direction of its cells against x [deg]; 0: as given
  std::vector<std::string> not_varied = {};

  void add(const std::string& option, StudySequence sequence, double turn = 0.0)
  {
    const auto is_like = [&](const StudySequence& s) { return s.name == sequence.name; };
    if (std::ranges::any_of(all, is_like))
      throw CaseError(printable(fmt::format("error: {} is given twice\n", option)));
    all.push_back(std::move(sequence));
    turns.push_back(turn);
  }
};

Sequences sequences_of(const ConvergeOptions& options, const Case& given)
{
  Sequences sequences;
  if (options.what_decides) {
    Levers levers = levers_of(options);
    sequences.not_varied = std::move(levers.not_varied);
    for (StudySequence& sequence : levers.sequences) {
      const std::string name = sequence.name;
      sequences.add(name, std::move(sequence));
    }
  }
  for (const std::string& variant : options.variants)
    sequences.add("--variant " + variant, {variant, changes_of_variant(variant), {}});
  for (const double turn : options.turns) {
    if (turn == 0.0) continue;  // as given
    if (const std::string why = why_not_turned(given); !why.empty())
      throw CaseError(
          printable(fmt::format("error: {}: --turn: the mesh cannot be turned, as {}\n"
                                "  A rectangle of equal square cells can, and a polygon without mesh.refine "
                                "whose cells follow no bodies.\n",
              options.run.path, why)));
    sequences.add(fmt::format("--turn {:g}", turn),
        {fmt::format("turned by {:g} degrees", turn), {}, {}, "direction of cells"}, turn);
  }
  for (const int n : options.points) {
    const auto has_them = [&](const BodyCase& b) { return b.points_per_cell == std::array<Index, 2>{n, n}; };
    if (std::ranges::all_of(given.bodies, has_them)) continue;  // as given
    sequences.add(fmt::format("--points {}", n),
        {fmt::format("{0} x {0} points per cell", n), {fmt::format("body.*.points_per_cell=[{0}, {0}]", n)}, {},
            "points per cell"});
  }
  if (sequences.all.size() == 1 && options.turns.size() + options.points.size() > 0)
    throw CaseError(
        "error: --turn and --points name nothing but what the case has\n"
        "  As in --turn 10,22.5,45 --points 3,4,5\n");
  return sequences;
}

/// A name for a folder: "cell_0.5", "cell_0.5_scheme_mpm_mixed".
std::string folder_name(double cell, const StudySequence& sequence, bool is_first)
{
  std::string name = fmt::format("cell_{}", cell);
  if (is_first) return name;
  name += '_';
  for (const unsigned char c : sequence.name)
    if (std::isalnum(c) != 0 || c == '.' || c == '-')
      name += static_cast<char>(c);
    else if (!name.ends_with('_'))
      name += '_';
  while (name.ends_with('_')) name.pop_back();
  return name;
}

/// Keys that leave no trace in what a study looks at.
bool leaves_no_trace(const std::string& key)
{
  return key == "title" || key == "output.checkpoint.every" || key == "output.checkpoint.keep";
}

/// Whether the run in a folder is one of this case, compared by content. Throws FileError if it is one of another.
void check_same_case(const std::string& folder, const CaseFile& file, const Mesh<2>& mesh)
{
  std::string changes;
  try {
    const CaseFile there = read_case(path_in(folder, case_file));
    for (const ChangedValue& change :
        changes_since(record_text(make_case_record(there, mesh)), make_case_record(file, mesh)))
      if (!leaves_no_trace(change.key)) changes += "\n  " + change.text();
  } catch (const CaseError&) {
    changes = "\n  its case cannot be read";
  }
  if (changes.empty()) return;
  throw FileError(
      fmt::format("{}: this folder holds a run of another case{}\n  Use --force to solve all sizes anew, or -o DIR for "
                  "another folder.",
          folder, changes));
}

RunStart find_start(const std::string& folder, const CaseFile& file, const Mesh<2>& mesh, std::int64_t& step)
{
  step = 0;
  std::error_code none;
  if (!fs::exists(folder, none) || fs::is_empty(folder, none)) return RunStart::anew;
  if (!fs::exists(path_in(folder, case_file), none))
    throw FileError(fmt::format("{}: this folder is not empty, and holds no run\n  Choose another: -o DIR", folder));
  check_same_case(folder, file, mesh);
  if (fs::exists(path_in(folder, summary_file), none)) {
    const SavedSummary summary = read_summary(path_in(folder, summary_file));
    if (summary.finished && summary.terp_version != TERP_VERSION)
      say(stderr, "warning: {} was solved by terp {}, this is {}; --force solves it anew\n", folder,
          summary.terp_version, TERP_VERSION);
    if (summary.finished && !summary.values.method)
      say(stderr, "warning: {} was solved when [method] had other defaults; --force solves it anew\n", folder);
    if (summary.finished) return RunStart::kept;
  }
  const std::int64_t newest = newest_step(folder);
  step = std::max<std::int64_t>(newest, 0);
  return newest >= 0 ? RunStart::goes_on : RunStart::again;
}

/// Each warning once, with the numbers of the first size that has it.
class Warnings {
 public:
  void show(const std::vector<Problem>& warnings, const CaseFile& file)
  {
    std::vector<Problem> fresh;
    for (const Problem& warning : warnings)
      if (seen_.insert(warning.key + '\n' + warning.what).second) fresh.push_back(warning);
    say(stderr, "{}", render_warnings(fresh, file));
  }

 private:
  std::set<std::string> seen_;
};

/// Of a run that has come to a step already [s].
double expected_rest(Simulation& simulation, std::int64_t step)
{
  const auto n_steps = static_cast<double>(std::max<std::int64_t>(simulation.model.n_steps, 1));
  return (1.0 - static_cast<double>(step) / n_steps) * expected_seconds(simulation, seconds_of_trial);
}

struct Planner {
  const ConvergeOptions& options;
  Plan& plan;
  const std::vector<double>& turns;  ///< of each sequence
  Warnings warnings = {};
  std::vector<std::string> first_records = {};  ///< of the case as given, by size

  void add(std::size_t sequence, double cell, const CaseFile& base)
  {
    StudySequence& s = plan.sequences[sequence];
    const std::string name = folder_name(cell, s, sequence == 0);
    PlannedRun run{.sequence = sequence,
        .number = s.runs.size(),
        .label = fmt::format("cells of {:g} m{}", cell, sequence == 0 ? "" : ", " + s.name),
        .folder = path_in(plan.folder, name),
        .changes = changes_with(s)};
    for (std::string& change : changes_to_cell_size(base, cell)) {
      check_not_given(change);
      run.changes.push_back(std::move(change));
    }
    if (turns[sequence] != 0.0) turn(run, turns[sequence]);
    const CaseFile file = read_case(options.run.path, run.changes);
    warnings.show(file.warnings, file);
    try {
      const SharedMesh mesh = std::make_shared<const Mesh<2>>(build_mesh(file.values));
      check_that_it_differs(s, record_text(make_case_record(file, *mesh)), sequence == 0);
      std::int64_t step = 0;
      run.start = options.run.force ? RunStart::again : find_start(run.folder, file, *mesh, step);
      s.runs.push_back({.cell = cell, .size = typical_cell_size(*mesh), .folder = name});
      if (run.start != RunStart::kept) estimate(run, file, mesh, step);
    } catch (const InputError& error) {
      throw CaseError(printable(fmt::format("On {}:\n", run.label)) + render(error.problems(), file));
    }
    plan.runs.push_back(std::move(run));
  }

  std::vector<std::string> changes_with(const StudySequence& sequence) const
  {
    std::vector<std::string> changes = options.run.changes;
    changes.insert(changes.end(), sequence.changes.begin(), sequence.changes.end());
    return changes;
  }

 private:
  /// Gives a run a mesh file in place of what its case says of the mesh.
  void turn(PlannedRun& run, double angle) const
  {
    try {
      Node file;
      file.kind = NodeKind::text, file.text = turned_mesh_file(read_case(options.run.path, run.changes).values, angle);
      run.changes.push_back(fmt::format("mesh={{ file = {} }}", toml_value(file)));
    } catch (const MeshError& error) {
      throw CaseError(printable(fmt::format("error: {}: {}\n", run.label, error.what())));
    }
  }

  void check_that_it_differs(const StudySequence& s, std::string record, bool is_first)
  {
    if (is_first)
      first_records.push_back(std::move(record));
    else if (record == first_records[s.runs.size()])
      throw CaseError(printable(fmt::format(
          "error: --variant {}: the case is the same without it\n  The sizes of the cells are those of --cells.\n",
          s.name)));
  }

  /// change: KEY=VALUE of a size. It would overrule one of --set without a word.
  void check_not_given(const std::string& change) const
  {
    const std::string key = change.substr(0, change.find('=') + 1);
    for (const std::string& given : options.run.changes)
      if (given.starts_with(key))
        throw CaseError(printable(
            fmt::format("error: --set {}: the sizes of the cells are those of --cells\n  Leave it out.\n", given)));
  }

  void estimate(PlannedRun& run, const CaseFile& file, const SharedMesh& mesh, std::int64_t step)
  {
    Simulation simulation(file.values, mesh, threads_of(options.run));
    const Model& model = simulation.model;
    warnings.show(find_warnings(model, simulation.state), file);
    run.what = fmt::format(
        "{} cells, {} points, {} steps", mesh->n_cells(), simulation.state.points.n_points(), model.n_steps);
    if (step > 0) run.what += fmt::format(" of which {} are done", step);
    run.seconds = expected_rest(simulation, step);
  }
};

void warn_of_given_points(const CaseFile& file)
{
  for (const BodyCase& body : file.values.bodies)
    if (!body.points_file.empty())
      say(stderr,
          "warning: the points of {} are the same at all sizes: smaller cells hold fewer of them, until cells are "
          "empty\n",
          printable(body.points_file));
}

}  // namespace

Plan plan_study(const ConvergeOptions& options)
{
  const std::vector<double> cells = sizes_of(options);
  const CaseFile file = read_case(options.run.path, options.run.changes);
  Sequences sequences = sequences_of(options, file.values);
  Plan plan{.case_name = file.values.name,
      .title = file.values.title,
      .folder = options.run.output.empty()
                    ? default_run_folder(options.run.path) + (options.what_decides ? "_decides" : "_convergence")
                    : options.run.output,
      .sequences = std::move(sequences.all),
      .not_varied = std::move(sequences.not_varied)};
  if (fs::exists(path_in(plan.folder, case_file)))
    throw FileError(
        fmt::format("{}: this is the folder of one run; the sizes get folders of their own\n  Choose another: -o DIR",
            plan.folder));
  warn_of_given_points(file);
  Planner planner{options, plan, sequences.turns};
  for (std::size_t k = 0; k < plan.sequences.size();) try {
      const CaseFile base = k == 0 ? file : read_case(options.run.path, planner.changes_with(plan.sequences[k]));
      for (const double cell : cells)
        if (k == 0 || !options.what_decides || cell == cells.front()) planner.add(k, cell, base);
      ++k;
    } catch (const CaseError& error) {
      const bool may_be_left_out = options.what_decides && !plan.sequences[k].input.empty();
      if (!may_be_left_out) throw;
      plan.not_varied.push_back(fmt::format("{} ({})", plan.sequences[k].name, first_line_of(error.what())));
      plan.sequences.erase(plan.sequences.begin() + static_cast<std::ptrdiff_t>(k));
      sequences.turns.erase(sequences.turns.begin() + static_cast<std::ptrdiff_t>(k));
    }
  refuse_if_nothing_decides(options, plan);
  std::set<std::string> folders;
  for (const PlannedRun& run : plan.runs)
    if (!folders.insert(run.folder).second)
      throw CaseError(printable(fmt::format(
          "error: two variants would have one folder, {}\n  Write one of them differently.\n", run.folder)));
  return plan;
}

std::string plan_text(const Plan& plan, int threads)
{
  std::string text;
  double seconds = 0.0;
  std::size_t width = 0;
  for (const PlannedRun& run : plan.runs) width = std::max(width, run.label.size());
  for (const PlannedRun& run : plan.runs) {
    seconds += run.seconds;
    text += fmt::format("  {:<{}}  {}\n", run.label, width,
        run.start == RunStart::kept ? "solved before, is kept"
                                    : fmt::format("{}, about {}", run.what, readable_duration(run.seconds)));
  }
  if (!plan.not_varied.empty()) text += fmt::format("  not varied: {}\n", fmt::join(plan.not_varied, "; "));
  return printable(fmt::format("{}\n{}  {:<{}}  about {} on {} thread{}\n",
      plan.title.empty() ? plan.case_name : plan.title, text, fmt::format("all {} runs", plan.runs.size()), width,
      readable_duration(seconds), threads, threads == 1 ? "" : "s"));
}

}  // namespace terp
