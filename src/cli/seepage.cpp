// Computes the water of a case and nothing else: each situation in the steady state, or one that follows levels over
// hours. A moment that is asked for becomes water that a run takes (water.toml and its heads).

#include "cli/commands.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "io/files/level_table.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/seepage_files.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/parts/stage_case.hpp"
#include "model/water/water_pressure.hpp"
#include "os/say.hpp"
#include "run/findings/water_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real day = 86400.0, hour = 3600.0;  // [s]

std::string name_of(const WaterSituation& situation, std::size_t number)
{
  return !situation.name.empty()         ? situation.name
         : number == 0                   ? std::string(name_of_start)
         : std::isfinite(situation.time) ? fmt::format("{:g} s", situation.time)
                                         : fmt::format("{}", number);
}

/// The soil at t = 0 without what strength and stress take time for.
Case section_alone(const Case& solved, std::size_t standing)
{
  Case of = case_of_stage(solved, 0);
  of.water = solved.water;
  of.water.standing = standing;
  of.stages.clear();
  of.initial.stress = InitialStress::none;
  for (MaterialCase& material : of.materials) material.fields.clear();
  for (BodyCase& body : of.bodies) body.points_per_cell = {1, 1};
  return of;
}

void print_flow(const std::string& name, const SeepageCase& of, const FlowResult& flow)
{
  say("water `{}`: {} iterations, in and out differ by {:.1e} of the flow\n", printable(name), flow.iterations,
      flow.imbalance);
  const std::vector<std::string> names = names_of_parts(of);
  for (std::size_t k = 0; k < names.size(); ++k)
    say("  {:<24} {:>11.4g} m2/s  {:>11.4g} m2/day  {}\n", printable(names[k]), std::abs(flow.outflow[k]),
        std::abs(flow.outflow[k]) * day,
        flow.outflow[k] == 0.0  ? "no flow"
        : flow.outflow[k] > 0.0 ? "out of the soil"
                                : "into the soil");
}

void print_dangers(const std::vector<UpliftPlace>& places, const ExitGradient& exit, Real cell)
{
  if (!places.empty()) {
    const UpliftPlace& worst = *std::ranges::min_element(places, {}, &UpliftPlace::factor);
    say("  uplift: least factor {:.3f} at x = {:.4g} m, base of the cover at {:.4g} m; head gradient over the cover "
        "there {:.3f}\n",
        worst.factor(), worst.x[0], worst.x[1], worst.gradient);
  }
  if (exit.gradient > 0.0)
    say("  steepest way out: gradient {:.3f} at ({:.4g}, {:.4g}) m, over {:.3g} m\n", exit.gradient, exit.x[0],
        exit.x[1], cell);
}

void find_steady(
    const SeepageCommand& command, const CaseFile& file, const std::string& folder, const SeepageSection& section)
{
  const Mesh<2>& mesh = *section.walled.mesh;
  SeepageFiles files(folder, mesh, section, "situation");
  const Real band = suction_band_of(file.values.water, section);
  Case solved = file.values;
  std::vector<ComputedWater> waters;
  for (std::size_t k = 0; k <= solved.water.situations.size(); ++k) {
    WaterSituation& situation = k == 0 ? solved.water.start : solved.water.situations[k - 1];
    waters.push_back(compute_water(mesh, section, situation.seepage, {.band = band},
        k == 0 ? "water" : fmt::format("water.situation[{}]", k - 1)));
    set_computed(situation, section, waters.back());
  }
  for (std::size_t k = 0; k < waters.size(); ++k) {
    const Simulation simulation(section_alone(solved, k), 1);
    std::vector<Problem> warnings;
    if (k == 0) find_odd_seepage(simulation.model, warnings);
    say(stderr, "{}", render_warnings(warnings, file));
    const WaterSituation& situation = situation_of(simulation.model.description.water, k);
    const std::string name = name_of(situation, k);
    const std::vector<UpliftPlace> places = uplift_over_land(simulation.model, section, situation);
    if (!command.run.quiet) {
      print_flow(name, situation.seepage, waters[k].flow);
      print_dangers(places, steepest_exit(mesh, section, waters[k]), section.cell);
    }
    files.add_flows(name, situation.seepage, waters[k]);
    files.add_uplift(name, places);
    if (!command.along.empty()) files.add_along(name, waters[k], command.along, solved.water.unit_weight);
    files.write_water(name, situation.seepage, waters[k]);
    files.write_picture(name, simulation, waters[k], band);
  }
  files.write_tables();
}

LevelWave read_levels(const std::string& path)
{
  try {
    return read_level_table(path, hour).wave;
  } catch (const FileError& error) {
    throw CaseError(fmt::format(
        "error: {}\n  The table has the columns hours and the names of levels: river, and those of ponds and heads.\n",
        error.what()));
  }
}

void follow_hours(
    const SeepageCommand& command, const CaseFile& file, const std::string& folder, const SeepageSection& section)
{
  const Mesh<2>& mesh = *section.walled.mesh;
  const LevelWave wave = read_levels(command.levels);
  const Real first = wave.times.front(), last = wave.times.back();
  std::vector<Real> moments;
  for (const Real h : command.at) {
    if (h * hour < first || h * hour > last)
      throw CaseError(fmt::format(
          "error: --at lies outside the table of levels, which has {:g} to {:g} h\n", first / hour, last / hour));
    moments.push_back(h * hour);
  }
  SeepageFiles files(folder, mesh, section, "hours");
  std::vector<std::string> kept;
  const auto use = [&](Real time, const SeepageCase& conditions, const ComputedWater& water) {
    const std::string hours = fmt::format("{:g}", time / hour);
    files.add_flows(hours, conditions, water);
    files.add_table(hours, water);
    if (!command.along.empty()) files.add_along(hours, water, command.along, file.values.water.unit_weight);
    Real in = 0.0, out = 0.0;
    for (const Real q : water.flow.outflow) (q < 0.0 ? in : out) += std::abs(q);
    if (!command.run.quiet)
      say("{:>8.3g}  {:>10}  {:>12.4g}  {:>12.4g}\n", time / hour, water.flow.iterations, in * day, out * day);
    if (time != first && std::ranges::find(moments, time) == moments.end()) return;
    kept.push_back(hours + "h");
    files.write_water(kept.back(), conditions, water);
  };
  if (!command.run.quiet) say("{:>8}  {:>10}  {:>12}  {:>12}\n", "hours", "iterations", "in m2/day", "out m2/day");
  const auto write = [&] {
    files.write_tables();
    files.write_for_case(kept);
  };
  try {
    follow_levels(mesh, section, file.values.water.start.seepage, with_times(wave, moments), command.step * hour,
        suction_band_of(file.values.water, section), use);
  } catch (const InputError&) {
    write();  // what there is up to then
    throw;
  }
  write();
}

}  // namespace

int compute_seepage(const SeepageCommand& command)
{
  const CaseFile file = read_case(command.run.path, command.run.changes);
  say(stderr, "{}", render_warnings(file));
  if (file.values.water.kind != WaterKind::seepage)
    throw CaseError(fmt::format(
        "error: {}: the water of this case is drawn, not computed\n  Give model = \"seepage\" in [water] with river, "
        "ponds or boundary, and a permeability to each soil.\n  More: terp explain water.model\n",
        command.run.path));
  if (!command.along.empty() && command.along.size() != 4)
    throw CaseError("error: --along takes four numbers: x and y of both ends, in m\n");
  if (!command.at.empty() && command.levels.empty())
    throw CaseError("error: --at is for --levels: it names hours of that table\n");
  const std::string folder =
      command.run.output.empty() ? default_run_folder(command.run.path) + "_seepage" : command.run.output;
  make_folder(folder);
  const FolderLock lock(folder);
  try {
    const SeepageSection section =
        seepage_section(file.values, std::make_shared<const Mesh<2>>(build_mesh(file.values)));
    write_file_atomically(path_in(folder, "case.toml"), file.text);
    command.levels.empty() ? find_steady(command, file, folder, section) : follow_hours(command, file, folder, section);
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
  if (!command.run.quiet) say("results in {}\n", folder);
  return solved;
}

}  // namespace terp
