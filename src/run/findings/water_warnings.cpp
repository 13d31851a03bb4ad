// A situation has from the start what it does not give itself. So most checks pass over what equals the start, or one
// line would be reported once per situation. Checks against the ground need drawn outlines: where bodies come as
// points, they are left out. Checks at nodes come last, and look only at nodes of cells with soil.

#include "run/findings/water_warnings.hpp"
#include "run/findings/soil_size.hpp"

#include "model/ground/section.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/ground/ground_section.hpp"
#include "model/water/nodal_water.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace terp {
namespace {

/// Soil beyond the grid of a water situation.
void find_uncovered_water(const Model& model, std::span<const Index> nodes, std::vector<Problem>& warnings)
{
  const WaterCase& water = model.description.water;
  const Real slack = 1e-6 * model.mesh->smallest_altitude;  // round-off
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    if (of.grid_file.empty() || (k > 0 && of.grid_file == water.start.grid_file)) continue;
    Index n = 0;
    Real farthest = 0.0;
    for (const Index i : nodes) {
      const Vec<2>& x = model.mesh->nodes[i];
      Real beyond = 0.0;
      for (int d = 0; d < 2; ++d) beyond = std::max({beyond, of.grid_low[d] - x[d], x[d] - of.grid_high[d]});
      n += beyond > slack;
      farthest = std::max(farthest, beyond);
    }
    if (n == 0) continue;
    warnings.push_back({"water", fmt::format("the grid `{}` does not cover all of the soil", of.grid_file),
        fmt::format(
            "It covers x = {} to {} m, y = {} to {} m; {} of {} nodes at the soil lie beyond it, by up to {:.3g} "
            "m.\nThey take the value of its nearest edge.",
            coordinate_text(of.grid_low[0]), coordinate_text(of.grid_high[0]), coordinate_text(of.grid_low[1]),
            coordinate_text(of.grid_high[1]), n, nodes.size(), farthest),
        "water"});
  }
}

std::string path_of(std::size_t situation)
{
  return situation == 0 ? "water" : fmt::format("water.situation[{}]", situation - 1);
}

std::string in_situation(const WaterSituation& of) { return of.name.empty() ? "" : fmt::format(" of `{}`", of.name); }

struct NamedLine {
  std::string key, name;
  std::vector<Vec<2>> places;  ///< [m]
};

/// The lines of all situations, each once: a situation has those of the start that it does not give itself.
std::vector<NamedLine> lines_of(const WaterCase& water)
{
  std::vector<NamedLine> lines;
  const auto add = [&](NamedLine line) {
    const auto same = [&](const NamedLine& other) { return other.places == line.places; };
    if (line.places.size() > 1 && std::ranges::none_of(lines, same)) lines.push_back(std::move(line));
  };
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    const std::string path = path_of(k), in = in_situation(of);
    add({path + ".phreatic_line", "the phreatic line" + in, of.phreatic_line});
    for (const HeadLine& line : of.head_lines)
      add({fmt::format("{}.head_lines.\"{}\"", path, line.name), fmt::format("the head line `{}`{}", line.name, in),
          line.places});
    for (std::size_t r = 0; r < of.reference_lines.size(); ++r)
      add({fmt::format("{}.reference_lines[{}]", path, r), fmt::format("the reference line {}{}", r, in),
          of.reference_lines[r].places});
  }
  return lines;
}

/// Lines that do not reach over the soil: beyond its ends a line keeps its level, which is meant only where it is level
/// there, or has one place.
void find_short_lines(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  constexpr Real little = 0.05;  // of the width of the soil
  const auto [low, high] = ends_of_soil(state);
  const Real most = std::max(little * (high - low), typical_cell_size(*model.mesh));
  for (const NamedLine& line : lines_of(model.description.water)) {
    const Vec<2>&first = line.places.front(), &last = line.places.back();
    const auto warn = [&, low = low, high = high](std::string what, const std::string& where) {
      warnings.push_back({line.key, std::move(what),
          fmt::format("It runs from x = {:.4g} to {:.4g} m, the soil from {:.4g} to {:.4g} m. {}", first[0], last[0],
              low, high, where),
          "water", false, {"water"}});
    };
    if (last[0] < low || first[0] > high) {
      warn(line.name + " lies beside the soil",
          fmt::format(
              "Beyond its ends a line keeps its level: {:.4g} m in all of the soil.\nx is in m, in the frame of "
              "the mesh. For a level line one place is enough.",
              last[0] < low ? last[1] : first[1]));
      continue;
    }
    const bool rises_first = line.places[1][1] != first[1], rises_last = line.places.rbegin()[1][1] != last[1];
    const bool short_left = rises_first && first[0] - low > most, short_right = rises_last && high - last[0] > most;
    if (!short_left && !short_right) continue;
    const Vec<2>& end = short_right ? last : first;
    warn(line.name + " ends within the soil",
        fmt::format("From x = {:.4g} m on to the {} it keeps the level {:.4g} m.\nContinue the line to the end of the "
                    "soil; a level part at its end says that this is meant.",
            end[0], short_right ? "right" : "left", end[1]));
  }
}

/// A phreatic line above all of the soil, where some soil is land.
void find_drowned_soil(const Model& model, std::vector<Problem>& warnings)
{
  const Overburden overburden(model);
  const WaterCase& water = model.description.water;
  if (!overburden.is_known()) return;
  const Columns columns = columns_of_section(*model.mesh);
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    if (of.phreatic_line.empty() || (k > 0 && of.phreatic_line == water.start.phreatic_line)) continue;
    Real least = INFINITY, top = -INFINITY, x_top = 0.0;  // depth of the water; the highest ground
    for (Index c = 0; c < columns.n; ++c) {
      const Real x = columns.left + (static_cast<Real>(c) + 0.5) * columns.width;
      const std::optional<Real> ground = overburden.ground(x);
      if (!ground) continue;
      least = std::min(least, elevation_at(of.phreatic_line, x) - *ground);
      if (*ground > top) top = *ground, x_top = x;
    }
    if (!std::isfinite(least) || !(least > 0.0)) continue;
    warnings.push_back({path_of(k) + ".phreatic_line",
        fmt::format("the water{} stands above all of the soil", of.name.empty() ? "" : fmt::format(" `{}`", of.name)),
        fmt::format(
            "It is {:.3g} m above the highest ground, at x = {:.4g} m, y = {:.4g} m. Terp then computes soil "
            "under still water:\nwater that flows over the ground is not simulated. Elevations are in m, in the "
            "frame of the mesh.",
            elevation_at(of.phreatic_line, x_top) - top, x_top, top),
        "water.phreatic_line", false, {"water"}});
  }
}

/// Where a head lies deepest below a line in the soil.
struct Shortfall {
  Real depth = 0.0;  ///< [m]
  Real x = 0.0, head = 0.0, line = 0.0;
};

/// Heads that do not reach the reference line at which they act: the water of that layer would hang below its roof.
void find_low_heads(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  constexpr Real little = 0.01;  // of a line drawn by hand [m]
  const auto [low, high] = ends_of_soil(state);
  const WaterCase& water = model.description.water;
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    for (const HeadLine& head : of.head_lines) {
      Shortfall most;
      for (const ReferenceLine& line : of.reference_lines) {
        if (line.head != head.name && line.head_bottom != head.name) continue;
        std::vector<Real> places{low, high};  // both lines are straight between the places of either
        for (const auto* other : {&line.places, &head.places})
          for (const Vec<2>& at : *other) places.push_back(std::clamp(at[0], low, high));
        for (const Real x : places) {
          const Real h = elevation_at(head.places, x), y = elevation_at(line.places, x);
          if (y - h > most.depth) most = {y - h, x, h, y};
        }
      }
      const auto& first = water.start.head_lines;  // a situation has those of the start that it does not give itself
      const bool reported = k > 0 && std::ranges::any_of(first, [&](const HeadLine& other) {
        return other.name == head.name && other.places == head.places;
      });
      if (!(most.depth > little) || reported) continue;
      warnings.push_back({fmt::format("{}.head_lines.\"{}\"", path_of(k), head.name),
          fmt::format("the head `{}`{} lies below the line at which it acts", head.name, in_situation(of)),
          fmt::format(
              "At x = {:.4g} m it is {:.4g} m, {:.3g} m below the reference line at {:.4g} m: the pore pressure "
              "there is zero.\nA head is the elevation in m to which the water of the layer rises, in the "
              "frame of the mesh.",
              most.x, most.head, most.depth, most.line),
          "water.head_lines", false, {"water"}});
    }
  }
}

/// Reference lines below all of the soil: their head acts in part, or nowhere.
void find_deep_lines(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  Real lowest = INFINITY;
  for_each_point(state.points,
      [&](const PointBlock<2>& block, Index lane) { lowest = std::min(lowest, block.row(Rows::x + 1)[lane]); });
  const Real slack = typical_cell_size(*model.mesh);
  const WaterCase& water = model.description.water;
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    for (std::size_t r = 0; r < of.reference_lines.size(); ++r) {
      const auto& places = of.reference_lines[r].places;
      const Real top = std::ranges::max(places, {}, [](const Vec<2>& at) { return at[1]; })[1];
      const auto& first = water.start.reference_lines;  // a situation has those of the start
      if (!(top < lowest - slack) || (k > 0 && r < first.size() && first[r].places == places)) continue;
      warnings.push_back({fmt::format("{}.reference_lines[{}]", path_of(k), r),
          fmt::format("the reference line {}{} lies below all of the soil", r, in_situation(of)),
          fmt::format(
              "It lies at {:.4g} m, the soil ends at {:.4g} m: no soil has the head of this line.\nA reference line "
              "is where in the soil a head acts; the head itself is a head line.",
              top, lowest),
          "water.reference_lines", false, {"water"}});
    }
  }
}

/// Reference lines above the ground of most of the section: depths given as elevations.
void find_high_lines(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Overburden overburden(model);
  if (!overburden.is_known()) return;
  const auto [low, high] = ends_of_soil(state);
  const WaterCase& water = model.description.water;
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    for (std::size_t r = 0; r < of.reference_lines.size(); ++r) {
      const auto& places = of.reference_lines[r].places;
      const auto& first = water.start.reference_lines;  // a situation has those of the start
      if (k > 0 && r < first.size() && first[r].places == places) continue;
      constexpr int n = 40;
      int n_over = 0;
      for (int i = 0; i < n; ++i) {
        const Real x = std::lerp(low, high, (i + 0.5) / n);
        n_over += elevation_at(places, x) > overburden.ground(x).value_or(INFINITY) + typical_cell_size(*model.mesh);
      }
      if (2 * n_over <= n) continue;
      warnings.push_back({fmt::format("{}.reference_lines[{}]", path_of(k), r),
          fmt::format("the reference line {}{} lies above the ground", r, in_situation(of)),
          "It does so over most of the section, so that its head acts in no soil there. A reference line is where in "
          "the "
          "soil a head\nacts; its elevations are in m, in the frame of the mesh, no depths.",
          "water.reference_lines", false, {"water"}});
    }
  }
}

/// A yield stress that follows from the water of a flood: what the soil bore is what it bore in daily water.
void find_yield_stress_of_flood(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  for (const MaterialCase& material : whole.materials)
    for (const ParameterField& field : material.fields) {
      const std::string& daily = field.needs.daily_water;
      const auto comes = [&](const StageCase& stage) { return stage.water == daily; };
      if (daily.empty() || daily == name_of_start || daily != field.needs.stress_water || whole.stages.empty() ||
          comes(whole.stages.front()) || std::ranges::none_of(whole.stages, comes))
        continue;
      warnings.push_back({parameter_key(material, material.type()->parameters[field.parameter].name),
          fmt::format("the yield stress follows from the water `{}`, which a stage brings", daily),
          "daily_water is that in which the soil has lain for long, before the stages. Leave it out for that of the "
          "start.",
          "field", false, {"material"}});
    }
}

/// A water table below all of the soil, above which the case draws heads of layers.
void find_deep_table(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  Real lowest = INFINITY;
  for_each_point(state.points,
      [&](const PointBlock<2>& block, Index lane) { lowest = std::min(lowest, block.row(Rows::x + 1)[lane]); });
  const WaterCase& water = model.description.water;
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(water, k);
    if (of.phreatic_line.empty() || of.head_lines.empty() || (k > 0 && of.phreatic_line == water.start.phreatic_line))
      continue;
    const Real top = std::ranges::max(of.phreatic_line, {}, [](const Vec<2>& at) { return at[1]; })[1];
    if (top >= lowest) continue;
    warnings.push_back(
        {path_of(k) + ".phreatic_line", fmt::format("the phreatic line{} lies below all of the soil", in_situation(of)),
            fmt::format("Its highest place is at {:.4g} m, the lowest soil at {:.4g} m. Elevations are in m, in the "
                        "frame of the mesh; "
                        "a depth\nbelow the ground is none.",
                top, lowest),
            "water.phreatic_line", false, {"water"}});
  }
}

/// A reference line with the head of the phreatic line below one with the head of a layer: water under pressure lies
/// deeper, so the heads of the two look swapped.
void find_swapped_heads(const Model& model, std::vector<Problem>& warnings)
{
  const WaterCase& water = model.description.water;
  for (std::size_t k = 0; k <= water.situations.size(); ++k) {
    const auto& lines = situation_of(water, k).reference_lines;
    const auto& first = water.start.reference_lines;  // a situation has those of the start that it does not give itself
    const auto same = [](const ReferenceLine& a, const ReferenceLine& b) {
      return a.places == b.places && a.head == b.head && a.head_bottom == b.head_bottom;
    };
    if (k > 0 && std::ranges::equal(lines, first, same)) continue;
    for (std::size_t upper = 0; upper < lines.size(); ++upper)
      for (std::size_t lower = 0; lower < lines.size(); ++lower) {
        const ReferenceLine &above = lines[upper], &below = lines[lower];
        const Real x = below.places.front()[0];  // they do not cross
        const bool is_phreatic = below.head == phreatic_head && below.head_bottom == phreatic_head;
        const bool is_under = elevation_at(above.places, x) > elevation_at(below.places, x);
        if (!is_phreatic || !is_under || above.head == phreatic_head || above.head_bottom == phreatic_head) continue;
        warnings.push_back({fmt::format("{}.reference_lines[{}]", path_of(k), lower),
            fmt::format("the heads of the reference lines {} and {}{} look swapped", upper, lower,
                in_situation(situation_of(water, k))),
            fmt::format("The lower line has the head of the phreatic line, the upper one the head `{}`. Between them "
                        "the head runs\nlinearly, and below the lower one it is that of the phreatic line.",
                above.head_bottom),
            "water.reference_lines", false, {"water"}});
      }
  }
}

/// Whether a stage or a strength asks for the situation of a name.
bool is_asked_for(const Case& whole, const std::string& name)
{
  const auto asks = [&](const MaterialCase& material) {
    return std::ranges::any_of(material.fields, [&](const ParameterField& field) {
      return std::ranges::find(field.needs.situations, name) != field.needs.situations.end();
    });
  };
  const auto changes = [&](const StageCase& stage) {
    return stage.water == name || (stage.changed != nullptr && std::ranges::any_of(stage.changed->materials, asks));
  };
  return std::ranges::any_of(whole.stages, changes) || std::ranges::any_of(whole.materials, asks);
}

/// Situations that never come: nothing asks for them, or the run ends before their time.
void find_idle_water(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const WaterCase& water = whole.water;
  const auto changes_water = [](const StageCase& stage) {
    return !stage.water.empty() && stage.water != name_of_start;
  };
  const bool stays = whole.stages.size() > 1 && !water.standing && std::ranges::none_of(whole.stages, changes_water);
  for (std::size_t k = 0; k < water.situations.size(); ++k) {
    const WaterSituation& situation = water.situations[k];
    const std::string path = fmt::format("water.situation[{}]", k);
    const std::string called = situation.name.empty() ? "" : fmt::format(" `{}`", situation.name);
    if (std::isnan(situation.time) && !water.standing && !is_asked_for(whole, situation.name))
      warnings.push_back({path, fmt::format("nothing asks for the water{}", called),
          fmt::format("Give water = \"{}\" in a stage, or time = T in s.", situation.name), "water.situation", true,
          {"water", "stage"}});
    else if (std::isnan(situation.time) && stays)
      warnings.push_back({path, fmt::format("no stage takes the water{}", called),
          fmt::format("A strength asks for it, but the water of the start acts in all {} stages.\n"
                      "Give water = \"{}\" in the stage in which it comes.",
              whole.stages.size(), situation.name),
          "stage.water", false, {"water", "stage"}});
    if (situation.time > whole.time.end && !water.series)
      warnings.push_back({path + ".time", fmt::format("the run ends before the water{} is reached", called),
          fmt::format(
              "It is reached at {:.4g} s, and the run ends at {:.4g} s at the latest.", situation.time, whole.time.end),
          "water.situation", false, {"time.end", "time.at_most"}});
  }
}

/// A stage brings other water, and an S_u that follows from sigma'_v keeps that of another situation.
void find_strengths_of_other_water(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  std::vector<std::string> told;
  for (const StageCase& stage : whole.stages) {
    if (stage.water.empty() || stage.water == name_of_start || stage.trigger || !stage.changed) continue;
    for (const MaterialCase& material : stage.changed->materials)
      for (const ParameterField& field : material.fields) {
        const std::string& water = field.needs.stress_water;
        if (water.empty() || water == stage.water) continue;
        const std::string parameter = parameter_key(material, material.type()->parameters[field.parameter].name);
        if (std::ranges::find(told, parameter) != told.end()) continue;
        told.push_back(parameter);
        const std::string key =
            parameter + (field.text.find("shansep") != std::string::npos ? ".shansep.water" : ".water");
        warnings.push_back({parameter,
            fmt::format("it follows from the water `{}`, and the stage `{}` has `{}`", water, stage.name, stage.water),
            fmt::format("Where the water of the stage lowers sigma'_v, the strength there is less. Give {} = \"{}\" in "
                        "[material],\nor in `set` of that stage; leave it if the strength of `{}` is meant.",
                key, stage.water, water),
            "stage.water", false, {"material"}});
      }
  }
}

}  // namespace

void find_odd_water(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  if (!model.with.water) return;
  find_strengths_of_other_water(model, warnings);
  find_yield_stress_of_flood(model, warnings);
  find_idle_water(model, warnings);
  find_short_lines(model, state, warnings);
  find_drowned_soil(model, warnings);
  find_odd_free_water(model, state, warnings);
  find_low_heads(model, state, warnings);
  find_deep_lines(model, state, warnings);
  find_high_lines(model, state, warnings);
  find_deep_table(model, state, warnings);
  find_swapped_heads(model, warnings);
  std::vector<Index> nodes;
  for (const Index cell : state.points.occupied())
    nodes.insert(nodes.end(), model.mesh->cells[cell].begin(), model.mesh->cells[cell].end());
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (model.nodal_water->is_dry(nodes))
    warnings.push_back({"water", "the water touches no soil",
        "Its pressure is zero in all soil, in every situation. Elevations are in m, in the frame of the mesh.",
        "water"});
  find_uncovered_water(model, nodes, warnings);
  const CappedWater capped = model.nodal_water->find_capped(nodes);
  if (capped.n == 0) return;
  const WaterSituation& of = situation_of(model.description.water, capped.situation);
  warnings.push_back({"water", fmt::format("the pore pressure was cut at {} of {} nodes", capped.n, nodes.size()),
      fmt::format("It was up to {:.3g} kPa more than the weight of the soil and the water above, most at {} m{}.\n"
                  "There the effective stress is zero: the soil is on the point of uplift.",
          1e-3 * capped.most, place_text(capped.where),
          of.name.empty() ? "" : fmt::format(", in the situation `{}`", of.name)),
      "water", true});
}

}  // namespace terp
