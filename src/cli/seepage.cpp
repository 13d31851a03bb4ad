// Computes the water of a case and nothing else: each situation in the steady state, or one that follows levels over
// hours. A moment that is asked for becomes water that a run takes (water.toml and its heads).

#include "cli/commands.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "io/files/level_wave.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/section_svg.hpp"
#include "io/files/svg.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/parts/stage_case.hpp"
#include "model/seepage/seepage_in_time.hpp"
#include "model/seepage/seepage_results.hpp"
#include "model/water/water_pressure.hpp"
#include "os/say.hpp"
#include "run/findings/water_warnings.hpp"
#include "run/loop/simulation.hpp"

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

/// A cell of a CSV file.
std::string quoted(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

std::string file_name(std::string_view kind, const std::string& name, std::string_view ending)
{
  std::string file = fmt::format("{}_{}.{}", kind, name, ending);
  for (char& c : file)
    if (c == ' ' || c == '/' || c == '\\' || c == ':') c = '_';
  return file;
}

class SeepageCommandRun {
 public:
  SeepageCommandRun(const SeepageCommand& command, const CaseFile& file, std::string folder)
      : command_(command),
        file_(file),
        folder_(std::move(folder)),
        mesh_(std::make_shared<const Mesh<2>>(build_mesh(file.values))),
        section_(seepage_section(file.values, mesh_)),
        band_(suction_band_of(file.values.water, section_))
  {
  }

  void steady()
  {
    Case solved = file_.values;
    std::vector<ComputedWater> waters;
    const std::size_t n = solved.water.situations.size() + 1;
    for (std::size_t k = 0; k < n; ++k) {
      WaterSituation& situation = k == 0 ? solved.water.start : solved.water.situations[k - 1];
      waters.push_back(compute_water(*mesh_, section_, situation.seepage, {.band = band_},
          k == 0 ? "water" : fmt::format("water.situation[{}]", k - 1)));
      set_computed(situation, mesh_, waters.back());
    }
    flows_ = "situation,part,outflow_m2_per_s,outflow_m2_per_day\n";
    std::string uplift = "situation,x_m,base_y_m,ground_y_m,total_stress_Pa,pore_pressure_Pa,factor,gradient\n";
    std::string along = "situation,x_m,y_m,head_m,pore_pressure_Pa\n";
    for (std::size_t k = 0; k < n; ++k) {
      Case of = section_alone(solved);
      of.water.standing = k;
      const Simulation simulation(of, 1);
      if (k == 0) {
        std::vector<Problem> warnings;
        find_odd_seepage(simulation.model, warnings);
        say(stderr, "{}", render_warnings(warnings, file_));
      }
      const WaterSituation& situation = situation_of(simulation.model.description.water, k);
      const std::string name = name_of(situation, k);
      print_flow(name, situation.seepage, waters[k]);
      print_dangers(name, simulation.model, situation, waters[k], uplift);
      write_water(name, situation.seepage, waters[k]);
      add_along(name, waters[k], along);
      write(file_name("seepage", name, "svg"), draw(simulation, waters[k], name));
    }
    write("seepage.csv", flows_);
    write("uplift.csv", uplift);
    if (!command_.along.empty()) write("along.csv", along);
  }

  void in_time()
  {
    const LevelWave wave = read_level_wave(command_.levels);
    flows_ = "hours,part,outflow_m2_per_s,outflow_m2_per_day\n";
    std::string tables = "hours,x_m,y_m\n";
    std::vector<std::pair<std::string, std::string>> kept;  // name and file of heads
    std::vector<Real> at = command_.at;
    const Real last = wave.times.back();
    if (std::ranges::any_of(at, [&](Real h) { return h * hour < wave.times.front() || h * hour > last; }))
      throw CaseError(fmt::format("error: --at lies outside the table of levels, which has {:g} to {:g} h\n",
          wave.times.front() / hour, last / hour));
    if (!command_.run.quiet) say("{:>8}  {:>10}  {:>12}  {:>12}\n", "hours", "iterations", "in m2/day", "out m2/day");
    LevelWave with_moments = wave;  // steps end at the moments that are asked for
    for (const Real h : at) insert_time(h * hour, with_moments);
    follow_levels(*mesh_, section_, file_.values.water.start.seepage, with_moments, command_.step * hour, band_,
        "water", [&](Real time, const SeepageCase& conditions, const ComputedWater& water) {
          const std::string name = fmt::format("{:g}h", time / hour);
          add_flows(fmt::format("{:g}", time / hour), conditions, water);
          for (const Vec<2>& x : water.table) tables += fmt::format("{:g},{:.6g},{:.6g}\n", time / hour, x[0], x[1]);
          Real in = 0.0, out = 0.0;
          for (const Real q : water.flow.outflow) (q < 0.0 ? in : out) += std::abs(q);
          if (!command_.run.quiet)
            say("{:>8.3g}  {:>10}  {:>12.4g}  {:>12.4g}\n", time / hour, water.flow.iterations, in * day, out * day);
          const bool asked = std::ranges::any_of(at, [&](Real h) { return std::abs(h * hour - time) < 1e-6 * hour; });
          if (!asked && time != with_moments.times.front()) return;
          write_water(name, conditions, water);
          kept.emplace_back(name, file_name("heads", name, "csv"));
        });
    write("seepage.csv", flows_);
    write("tables.csv", tables);
    std::string toml =
        "# Water of moments of a flood, in place of [water] of the case: give a stage water = \"NAME\".\n"
        "[water]\n";
    for (std::size_t k = 0; k < kept.size(); ++k)
      toml += fmt::format("{}head = {{ csv = \"{}\" }}\n",
          k == 0 ? std::string() : fmt::format("\n[[water.situation]]\nname = \"{}\"\n", kept[k].first),
          kept[k].second);
    write("water.toml", toml);
  }

 private:
  static void insert_time(Real time, LevelWave& wave)
  {
    const auto after = std::ranges::lower_bound(wave.times, time);
    const auto k = static_cast<std::size_t>(after - wave.times.begin());
    if (k < wave.times.size() && wave.times[k] == time) return;
    const Real share = (time - wave.times[k - 1]) / (wave.times[k] - wave.times[k - 1]);
    std::vector<Real> levels;
    for (std::size_t n = 0; n < wave.names.size(); ++n)
      levels.push_back(std::lerp(wave.levels[k - 1][n], wave.levels[k][n], share));
    wave.times.insert(after, time);
    wave.levels.insert(wave.levels.begin() + static_cast<std::ptrdiff_t>(k), std::move(levels));
  }

  /// The soil at t = 0 without what strength and stress take time for.
  static Case section_alone(const Case& solved)
  {
    Case of = case_of_stage(solved, 0);
    of.water = solved.water;
    of.stages.clear();
    of.initial.stress = InitialStress::none;
    for (MaterialCase& material : of.materials) material.fields.clear();
    for (BodyCase& body : of.bodies) body.points_per_cell = {1, 1};
    return of;
  }

  void write(const std::string& name, std::string_view text) const
  {
    write_file_atomically(path_in(folder_, name), text);
  }

  void add_flows(const std::string& when, const SeepageCase& of, const ComputedWater& water)
  {
    const std::vector<std::string> names = names_of_parts(of);
    for (std::size_t k = 0; k < names.size(); ++k)
      flows_ += fmt::format(
          "{},{},{:.9g},{:.9g}\n", quoted(when), quoted(names[k]), water.flow.outflow[k], water.flow.outflow[k] * day);
  }

  void print_flow(const std::string& name, const SeepageCase& of, const ComputedWater& water)
  {
    add_flows(name, of, water);
    if (command_.run.quiet) return;
    const FlowResult& flow = water.flow;
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

  void print_dangers(const std::string& name, const Model& model, const WaterSituation& situation,
      const ComputedWater& water, std::string& table)
  {
    const UpliftPlace* worst = nullptr;
    const std::vector<UpliftPlace> places = uplift_over_land(model, section_, situation);
    for (const UpliftPlace& p : places) {
      if (worst == nullptr || p.factor() < worst->factor()) worst = &p;
      table += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", quoted(name), p.x[0], p.x[1],
          p.ground, p.stress, p.pressure, p.factor(), p.gradient);
    }
    if (command_.run.quiet) return;
    if (worst != nullptr)
      say("  uplift: least factor {:.3f} at x = {:.4g} m, base of the cover at {:.4g} m; head gradient over the cover "
          "there {:.3f}\n",
          worst->factor(), worst->x[0], worst->x[1], worst->gradient);
    const ExitGradient exit = steepest_exit(*mesh_, section_, water);
    if (exit.gradient > 0.0)
      say("  steepest way out: gradient {:.3f} at ({:.4g}, {:.4g}) m, over {:.3g} m\n", exit.gradient, exit.x[0],
          exit.x[1], section_.cell);
  }

  /// Heads on a grid that a case can take, and the phreatic line.
  void write_water(const std::string& name, const SeepageCase& of, const ComputedWater& water) const
  {
    const BoundingBox box = box_around(mesh_->nodes);
    const Real step = section_.cell;
    const auto n = [&](int d) { return static_cast<int>(std::lround((box.high[d] - box.low[d]) / step)); };
    const FreeWaterLevels free(section_, of);
    std::string heads = "x,y,value\n";
    for (int i = 0; i <= n(0); ++i)
      for (int j = 0; j <= n(1); ++j) {
        const Vec<2> x{box.low[0] + (box.high[0] - box.low[0]) * i / std::max(n(0), 1),
            box.low[1] + (box.high[1] - box.low[1]) * j / std::max(n(1), 1)};
        heads += fmt::format("{:.9g},{:.9g},{:.9g}\n", x[0], x[1],
            head_at(*mesh_, water.flow.heads, x).value_or(std::max(free.level_over(x[0]), x[1])));
      }
    write(file_name("heads", name, "csv"), heads);
    std::string table = "x_m,y_m\n";
    for (const Vec<2>& x : water.table) table += fmt::format("{:.9g},{:.9g}\n", x[0], x[1]);
    write(file_name("table", name, "csv"), table);
  }

  void add_along(const std::string& name, const ComputedWater& water, std::string& text) const
  {
    if (command_.along.size() != 4) return;
    constexpr int parts = 200;
    for (int k = 0; k <= parts; ++k) {
      const Vec<2> x{std::lerp(command_.along[0], command_.along[2], static_cast<Real>(k) / parts),
          std::lerp(command_.along[1], command_.along[3], static_cast<Real>(k) / parts)};
      const std::optional<Real> head = head_at(*mesh_, water.flow.heads, x);
      if (head)
        text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g}\n", quoted(name), x[0], x[1], *head,
            file_.values.water.unit_weight * std::max(*head - x[1], 0.0));
    }
  }

  std::string draw(const Simulation& simulation, const ComputedWater& water, const std::string& name) const
  {
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (const SurfacePlace& place : water.soil.surface)
      if (place.condition != FlowCondition::seep) low = std::min(low, place.head), high = std::max(high, place.head);
    for (std::size_t k = 0; k < water.soil.surface.size(); ++k)
      if (water.flow.is_wet[k]) low = std::min(low, water.soil.surface[k].head);
    SectionOverlay overlay;
    overlay.subtitle = fmt::format("computed water `{}`", name);
    constexpr int about = 16;
    if (high > low) {
      const Real step = nice_step(high - low, about);
      overlay.curves.push_back({lines_of_equal(*mesh_, section_, water, water.flow.heads, step), "#0e7c86",
          fmt::format("equal head, every {:g} m", step)});
      const std::vector<Real> psi = stream_function(*mesh_, water, band_);
      Real out = 0.0;
      for (const Real q : water.flow.outflow) out += std::max(q, 0.0);
      const Real share = nice_step(out * day, about) / day;
      if (out > 0.0)
        overlay.curves.push_back({lines_of_equal(*mesh_, section_, water, psi, share), "#1f3fa8",
            fmt::format("flow line, {:.2g} m2/day between two", share * day)});
    }
    return draw_section(simulation.model, simulation.state, overlay);
  }

  const SeepageCommand& command_;
  const CaseFile& file_;
  const std::string folder_;
  const SharedMesh mesh_;
  const SeepageSection section_;
  const Real band_;
  std::string flows_;
};

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
    SeepageCommandRun run(command, file, folder);
    write_file_atomically(path_in(folder, "case.toml"), file.text);
    command.levels.empty() ? run.steady() : run.in_time();
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
  if (!command.run.quiet) say("results in {}\n", folder);
  return solved;
}

}  // namespace terp
