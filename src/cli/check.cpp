// The simulation is set up as for a run. What describes its start is printed first, since later parts make steps, which
// change that state. One shows the balance of a K0 start, others the time of a step. A law of a library is timed on an
// instance of its own, since one that fails stays failed. With --quiet the trial is made all the same: it finds a run
// that would stop itself.

#include "cli/commands.hpp"
#include "cli/cost.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "model/meshes/mesh_quality.hpp"
#include "io/files/files.hpp"
#include "io/files/section_svg.hpp"
#include "cli/progress.hpp"
#include "io/results/import_changes.hpp"
#include "model/ground/flood_level.hpp"
#include "model/ground/ground_section.hpp"
#include "model/loads/loads.hpp"
#include "run/report/output_costs.hpp"
#include "model/loads/side_shape.hpp"
#include "run/loop/simulation.hpp"
#include "run/report/slip_planes.hpp"
#include "model/soils/softening_scales.hpp"
#include "model/soils/strength_profile.hpp"
#include "model/libraries/law_cost.hpp"
#include "run/findings/setup_warnings.hpp"
#include "mpm/step/workspace.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace terp {
namespace {

Real total_mass(const State& state)
{
  Real mass = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) { mass += block.row(Rows::mass)[lane]; });
  return mass;
}

/// Of a body that comes or goes: in which stages.
std::string stages_text(const Model& model, std::size_t b)
{
  const BodyCase& body = model.description.bodies[b];
  const auto name = [&](StageNumber number) { return model.description.stages[number - 1].name; };
  return (body.placed > 0 ? fmt::format(", placed in the stage `{}`", name(body.placed)) : "") +
         (body.removed != never ? fmt::format(", removed in the stage `{}`", name(body.removed)) : "");
}

void print_bodies(const Model& model)
{
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyShare& body = model.bodies[b];
    const std::string& name = model.description.bodies[b].name;
    say("  {:<14} {}, {:.6g} m^2, {:.6g} kg per m, {} points{}\n",
        name.empty() ? fmt::format("body {}", b) : "body `" + printable(name) + "`:", printable(body.material),
        body.area, body.mass, body.n_points, stages_text(model, b));
  }
}

void print_sides(const Model& model)
{
  for (const NamedSide& side : model.mesh->sides)
    if (side.is_inside)
      say("  side {:<10}bounds nothing: its curve lies inside the mesh\n", printable(side.name));
    else
      say("  side {:<10}{}, {:.4g} m\n", printable(side.name), describe(condition_of(model.description, side.name)),
          shape_of_side(*model.mesh, side).length);
}

void check_picture(const std::string& path)
{
  if (path.empty() || path.ends_with(".svg")) return;
  throw CaseError(
      printable(fmt::format("error: --picture {0}: the picture is an SVG file, which every browser opens\n"
                            "  Write --picture {1}. For PNG: rsvg-convert {1} -o {0} (Debian package librsvg2-bin)\n",
          path, std::filesystem::path(path).replace_extension(".svg").string())));
}

void write_picture(const std::string& path, const Model& model, const State& state, bool tells)
{
  write_file_atomically(path, draw_section(model, state));
  if (tells) say("picture in {}\n", path);
}

std::string count(std::int64_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string megabytes(double bytes) { return fmt::format("{:.{}f} MB", bytes / 1e6, bytes < 9.95e6 ? 1 : 0); }

void print_output(const OutputCost& cost)
{
  say("  output         {} of {}, {} of {}, {}\n", count(cost.n_frames, "frame"), megabytes(cost.frame_bytes),
      count(cost.n_checkpoints, "checkpoint"), megabytes(cost.checkpoint_bytes),
      count(cost.n_ledger_rows + cost.n_history_rows, "row"));
  say("  disk           {} at the end, with {}\n", megabytes(cost.bytes), count(cost.n_kept, "checkpoint"));
}

/// Some end is only the latest one.
bool may_end_early(const Case& c)
{
  const auto may = [](const StageCase& stage) { return stage.until != Until::end; };
  return c.time.until != Until::end || std::ranges::any_of(c.stages, may);
}

bool ends_with_verdict(const Case& c)
{
  return (c.stages.empty() ? c.time.until : c.stages.back().until) == Until::verdict;
}

/// all_s: expected time of all steps [s].
void print_stages(const Model& model, double all_s)
{
  Real start = 0.0;
  for (const StageCase& stage : model.description.stages) {
    const bool early = stage.until != Until::end;
    std::string changes;
    for (const std::string& name : stage.place) changes += (changes.empty() ? ": places " : ", places ") + name;
    for (const std::string& name : stage.remove) changes += (changes.empty() ? ": removes " : ", removes ") + name;
    for (const auto& [key, value] : stage.changes) changes += (changes.empty() ? ": " : ", ") + key + " = " + value;
    say("  stage {:<8} t = {:g} to {}{:g} s, solved in {}{}{}\n", stage.name, start, early ? "at most " : "",
        start + stage.longest(), early ? "at most " : "",
        readable_duration(all_s * stage.longest() / model.description.time.end), printable(changes));
    start += stage.longest();
  }
}

void print_loads(const Model& model, const State& state)
{
  const std::span<const Load> loads = loads_of(model);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Load& load = loads[k];
    Index n = 0;
    Real low = INFINITY, high = -INFINITY;  // places of these points [m]
    for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
      if (!(block.row(load.row)[lane] > 0.0)) return;
      const Real y = block.row(Rows::x + 1)[lane];
      ++n, low = std::min(low, y), high = std::max(high, y);
    });
    say("  load {:<10}{} on x = {:g} to {:g} m, {:.4g} kN per m{}\n", printable(load.name),
        printable(describe_pressures(model.whole(), k)), load.from, load.to,
        load.pressure * (load.to - load.from) / 1e3,
        n > 0 ? fmt::format(", on {} points at y = {:.4g} to {:.4g} m", n, low, high)
              : fmt::format(", from t = {:g} s on", load.start));
  }
}

void print_flood(const FloodLevel& level)
{
  if (!level.is_known()) return;
  const std::string river = !level.river                   ? ""
                            : *level.river == Facing::left ? ", river on the left"
                                                           : ", river on the right";
  say("  flood          judged at {:.4g} m, {}{}\n", level.value, printable(level.origin), river);
}

/// K0 stress is at rest on level ground alone: elsewhere, how much of the weight it does not carry.
void print_start(Simulation& simulation)
{
  const Model& model = simulation.model;
  if (model.description.initial.stress != InitialStress::k0) return;
  if (is_flat(first_section(model, simulation.state.points, ground_of(model)))) return;
  make_steps(model, simulation.state, simulation.work, {.most_steps = 1});
  say("  initial stress k0 on ground that is not level: {:.2g} % of the weight is out of balance at t = 0 and acts at "
      "once;\n                 at rest begins stress = \"equilibrium\", or a first stage with until = \"at_rest\"\n",
      100.0 * simulation.work.unbalanced_ratio);
}

constexpr std::size_t rows_of_profile = 16;

void print_profile(const Model& model, const State& state, Real x)
{
  const std::vector<ProfileRow> rows = thinned(strength_profile(model, state, x), rows_of_profile);
  if (rows.empty()) {
    say("  profile        no soil at x = {:g} m\n", x);
    return;
  }
  const auto has = [&](Real ProfileRow::*value) {
    return std::ranges::any_of(rows, [&](const ProfileRow& row) { return !std::isnan(row.*value); });
  };
  const bool has_last = has(&ProfileRow::last_stress), has_yield = has(&ProfileRow::yield_stress);
  const auto column = [](bool shown, const std::string& text) { return shown ? fmt::format("{:>15}", text) : ""; };
  std::string last_water;  // its name
  for (const StageCase& stage : model.description.stages)
    if (!stage.water.empty()) last_water = stage.water;
  say("  profile at x = {:g} m, water at the start{}{}\n", x,
      has_last ? fmt::format("; last sigma'_v: in the water `{}`", printable(last_water)) : "",
      has_yield ? "; sigma'_p: yield stress of SHANSEP" : "");
  say("    {:>8}{:>9}  {:<14}{:>13}{:>10}{}{}{:>10}  {}\n", "depth m", "y m", "material", "sigma'_v kPa", "p_w kPa",
      column(has_last, "last sigma'_v"), column(has_yield, "sigma'_p kPa"), "G MPa", "strength");
  const auto number = [](Real value, Real scale) {
    return std::isnan(value) ? std::string("-") : fmt::format("{:.2f}", value / scale);
  };
  for (const ProfileRow& row : rows) {
    std::string strengths;
    for (const ProfileStrength& s : row.strengths)
      strengths += fmt::format("{}{} {:.2f} {}", strengths.empty() ? "" : ", ", s.name,
          s.unit == "Pa" ? s.value / 1e3 : s.value, s.unit == "Pa" ? "kPa" : s.unit);
    say("    {:>8}{:>9.2f}  {:<14}{:>13}{:>10}{}{}{:>10}  {}\n", number(row.depth, 1.0), row.x[1],
        printable(row.material), number(row.stress, 1e3), number(row.pore, 1e3),
        column(has_last, number(row.last_stress, 1e3)), column(has_yield, number(row.yield_stress, 1e3)),
        number(row.shear, 1e6), strengths);
  }
}

/// At the places that were asked for; else, where a parameter varies, at a few.
void print_profiles(const RunOptions& options, const Model& model, const State& state)
{
  for (const Real x : !options.profiles.empty() ? options.profiles
                      : model.ground()          ? usual_profiles(model, state)
                                                : std::vector<Real>{})
    print_profile(model, state, x);
}

void print_strength_beside(const Model& model, const State& state)
{
  for (const SlipPlaneCase& plane : model.description.slip_planes) {
    if (plane.su.empty()) continue;
    const StrengthComparison c = compare_strength(model, state, plane);
    const std::string name = printable(plane.name) + (plane.method.empty() ? "" : ", " + printable(plane.method));
    if (c.n == 0)
      say("  S_u            none at the {} places of `{}`\n", c.n_all, name);
    else
      say("  S_u            over that of `{}`: {:.3f} in the mean of {} of {} places, {:.3f} at [{:.2f}, {:.2f}] to "
          "{:.3f} at [{:.2f}, {:.2f}]\n",
          name, c.mean, c.n, c.n_all, c.low, c.x_low[0], c.x_low[1], c.high, c.x_high[0], c.x_high[1]);
  }
}

/// Numbers as they are handed to a law: by name, or by their place.
/// units: of each, or none; "-": none.
std::string numbers_text(const std::vector<NamedNumber>& numbers, std::span<const StateInfo> units = {})
{
  std::string text;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::string_view unit = k < units.size() ? units[k].unit : "-";
    text += fmt::format("{}{} = {:g}{}{}", k == 0 ? ": " : ", ",
        numbers[k].name.empty() ? fmt::format("({})", k + 1) : numbers[k].name, numbers[k].value,
        unit == "-" ? "" : " ", unit == "-" ? "" : unit);
  }
  return text;
}

void print_given(const MaterialCase& material)
{
  const LibraryCase& library = material.library;
  say("  {} is given  {}{}\n", printable(material.name), count(std::ssize(library.parameters), "parameter"),
      printable(numbers_text(library.parameters)));
  say("  {} remembers {}{}\n", printable(material.name), count(std::ssize(library.state), "state variable"),
      printable(numbers_text(library.state, material.from_library->state)));
}

/// What laws from libraries are given and what they cost, which Terp cannot know. Returns the faults of those that
/// failed meanwhile.
std::vector<std::string> print_laws(const Model& model, const State& state)
{
  std::vector<std::string> faults;
  for (Index m = 0; m < std::ssize(model.materials); ++m) {
    const MaterialCase& material = model.description.materials[static_cast<std::size_t>(m)];
    const PointBlock<2>* first = nullptr;
    Index n = 0;
    for_each_block(state.points, [&](const PointBlock<2>& block) {
      if (block.material != m) return;
      n += block.n;
      if (first == nullptr || block.n > first->n) first = &block;
    });
    if (material.from_library == nullptr || first == nullptr) continue;
    print_given(material);
    const Real cell_size = std::sqrt(model.mesh->geometry(first->cell).volume);
    SoilMaterial trial = model.materials[m];  // a law that fails stays failed: the step below has its own
    trial.law = trial.type->make(material.parameters);
    const LawCost cost = time_law(trial, *first, cell_size, model.dt);
    if (!cost.fault.empty()) {
      faults.push_back(fmt::format("the law of {} failed when it was timed with a small shear strain: {}",
          printable(material.name), cost.fault));
      continue;
    }
    const int threads = material.library.thread_safe ? model.threads : 1;
    const double all = cost.seconds * static_cast<double>(n) * static_cast<double>(model.n_steps) / threads;
    say("  law of {:<8}{}: {:.2g} us per point and step, {} of all steps{}\n", printable(material.name),
        printable(material.library.file), 1e6 * cost.seconds, readable_duration(all),
        material.library.thread_safe ? "" : ", one thread at a time (thread_safe = false)");
  }
  return faults;
}

/// Whether it is the scheme of the paper, and in what it is not.
void print_form(const Model& model)
{
  if (!looks_at(*model.scheme, "as")) return;
  const std::vector<std::string> differences = differences_from_paper(model.method, *model.scheme);
  say("  method         {}{}\n",
      differences.empty() ? "as in the paper" : "not the paper's: ", fmt::join(differences, ", "));
  if (model.method.shares == Shares::overlap && !model.scheme->with_overlap.empty())
    say("                 {}\n", model.scheme->with_overlap);
}

void print_check(const CaseFile& file, Simulation& simulation, const RunOptions& options)
{
  const Model& model = simulation.model;
  const State& state = simulation.state;
  say("{}\n", printable(file.values.title.empty() ? file.values.name : file.values.title));
  say("  scheme         {}\n", file.values.scheme);
  print_form(model);
  say("{}", describe(measure_quality(*model.mesh)));
  say("  cells of soil  {}\n", state.points.occupied().size());
  say("  points         {}\n", state.points.n_points());
  say("  mass           {:.6g} kg per m\n", total_mass(state));
  print_bodies(model);
  print_sides(model);
  for (const std::string& note : std::set<std::string>(file.notes.begin(), file.notes.end()))  // parts of a soil share
    say("  read as        {}\n", printable(note));
  for (const Sentence& change : changes_since_import(file.source.root, file.values.folder))
    say("  changed        {}\n", printable(change.en));
  print_profiles(options, model, state);
  print_strength_beside(model, state);
  if (softens_point_by_point(model))
    say("  softening      no length, no reference width: the result will depend on the cells (docs/convergence.md)\n");
  say("  time step      {:.4g} s\n", model.dt);
  say("  steps          {}{} to t = {:g} s\n", may_end_early(file.values) ? "at most " : "", model.n_steps,
      file.values.time.end);
  if (ends_with_verdict(file.values)) say("  ends           as soon as the answer to [flood] is known\n");
  print_loads(model, state);
  print_flood(model.flood_level);
  print_start(simulation);
  say("  memory         {:.0f} MB\n", static_cast<double>(bytes_of(model, state)) / 1e6);
  const OutputCost cost = estimate_output(model, state);
  print_output(cost);
  const std::vector<std::string> faults = print_laws(model, state);
  const double step_s = time_a_step(simulation);  // a law that fails there, too, is reported once
  for (const std::string& fault : faults) say(stderr, "warning: {}\n", fault);
  print_stages(model, seconds_of_steps(model, step_s));
  say("  expected time  {} on {}, {} of it for output ({:.1f} M point-steps/s in a trial)\n",
      readable_duration(seconds_of_steps(model, step_s) + cost.seconds), count(model.threads, "thread"),
      readable_duration(cost.seconds), static_cast<double>(state.points.n_points()) / step_s / 1e6);
  say("nothing was run\n");
}

/// What speaks against an imported section, by language.
nlohmann::ordered_json doubts_json(const CaseFile& file)
{
  nlohmann::ordered_json json;
  for (const auto& [language, key] : {std::pair{"en", "reference.doubts"}, {"nl", "reference.doubts_nl"}}) {
    json[language] = nlohmann::ordered_json::array();
    if (const Node* const doubts = find_node(file.source.root, key))
      for (const Node& doubt : doubts->items) json[language].push_back(doubt.text);
  }
  return json;
}

/// The numbers and names of print_check, for a program.
std::string check_json(const CaseFile& file, Simulation& simulation)
{
  using Json = nlohmann::ordered_json;
  const Model& model = simulation.model;
  const State& state = simulation.state;
  Json bodies = Json::array(), sides = Json::array();
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    bodies.push_back({{"name", file.values.bodies[b].name}, {"material", model.bodies[b].material},
        {"area", model.bodies[b].area}, {"points", model.bodies[b].n_points}});
  for (const NamedSide& side : model.mesh->sides)
    sides.push_back({{"name", side.name}, {"condition", describe(condition_of(model.description, side.name))},
        {"length", shape_of_side(*model.mesh, side).length}});
  Json flood = nullptr;
  if (const FloodLevel& level = model.flood_level; level.is_known())
    flood = {{"level", level.value}, {"origin", level.origin},
        {"river", !level.river ? Json(nullptr) : Json(*level.river == Facing::left ? "left" : "right")}};
  const OutputCost cost = estimate_output(model, state);
  Json json{{"title", file.values.title.empty() ? file.values.name : file.values.title}, {"scheme", file.values.scheme},
      {"cells", model.mesh->n_cells()}, {"cell_size", measure_quality(*model.mesh).median_altitude},
      {"cells_of_soil", state.points.occupied().size()}, {"points", state.points.n_points()},
      {"mass", total_mass(state)}, {"bodies", bodies}, {"sides", sides}, {"doubts", doubts_json(file)},
      {"read_as", std::set<std::string>(file.notes.begin(), file.notes.end())}, {"time_step", model.dt},
      {"steps", model.n_steps}, {"may_end_early", may_end_early(file.values)}, {"end", file.values.time.end},
      {"flood", flood}, {"memory_bytes", bytes_of(model, state)}, {"disk_bytes", cost.bytes},
      {"threads", model.threads}};
  json["expected_s"] = seconds_of_steps(model, time_a_step(simulation)) + cost.seconds;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

int check_case(const RunOptions& options)
{
  check_picture(options.picture);
  const CaseFile file = read_case(options.path, options.changes);
  say(stderr, "{}", render_warnings(file));
  try {
    Simulation simulation(file.values, threads_of(options));
    warn_of_missing_threads(options, simulation.model.threads);
    say(stderr, "{}", render_warnings(find_warnings(simulation.model, simulation.state), file));
    if (!options.picture.empty()) write_picture(options.picture, simulation.model, simulation.state, !options.json);
    if (options.quiet)
      time_a_step(simulation);  // a run that would stop itself is told all the same
    else if (options.json)
      say("{}", check_json(file, simulation));
    else
      print_check(file, simulation, options);
    return solved;
  } catch (const RunError& error) {
    say(stderr, "error: the run would stop itself: {}\n", error.what());
    return stopped_itself;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
}

}  // namespace terp
