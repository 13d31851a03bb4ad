// All is evaluated along vertical lines: one line through one stage, and then through all stages up to the one asked
// for. An OCR or a yield stress becomes a POP once, with the effective stress of its own stage at its own place. The
// yield stress is the largest sum of effective stress and POP of all stages. A state point holds in its whole layer;
// only without one is the POP interpolated between state lines.

#include "import/dstability/section.hpp"

#include "math/errors.hpp"
#include "math/interpolate.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace terp {
namespace {

constexpr Real full_consolidation = 100.0;  // [%]

/// The load's stress at a depth: it spreads to both sides, its sum stays [Pa].
Real stress_of(const StixUniformLoad& load, Real x, Real depth)
{
  const Real aside = depth * std::tan(load.spread * std::numbers::pi / 180.0), width = load.end - load.start;
  const bool is_under = x >= load.start - aside && x <= load.end + aside;
  return is_under && width > 0.0 ? load.magnitude * width / (width + 2.0 * aside) : 0.0;
}

/// POP of a preload whose soil carries `effective_stress` now [Pa].
Real pop_of(const StixPreload& preload, Real effective_stress, StixBasis basis)
{
  switch (preload.kind) {
    case StixPreload::Kind::pop: return value_of(preload.pop, basis);
    case StixPreload::Kind::ocr: return std::max((preload.ocr - 1.0) * effective_stress, 0.0);
    case StixPreload::Kind::yield_stress: return std::max(preload.yield_stress - effective_stress, 0.0);
  }
  return 0.0;
}

/// Elevation from which the depth below a load counts: the mean of the ground at its two ends [m]. An end beyond the
/// section takes the ground of the other one.
Real ground_of(const StixUniformLoad& load, const StixStage& stage)
{
  const BoundingBox box = box_around(stage.layers);
  const auto is_beyond = [&](Real x) { return x < box.low[0] || x > box.high[0]; };
  const auto at = [&](Real x, Real other) {
    const std::vector<SoilBand> bands = soil_bands(stage, is_beyond(x) && !is_beyond(other) ? other : x);
    return bands.empty() ? not_given : bands.front().top;
  };
  return 0.5 * (at(load.start, load.end) + at(load.end, load.start));
}

bool needs_stress(const StixPreload& preload) { return preload.kind != StixPreload::Kind::pop; }

constexpr Real most_pop = 1e6;     // [Pa]; the tables of the Schematiseringshandleiding have 10 to 30 kPa
constexpr Real near_layer = 0.05;  // [m]; coordinates of drawings are in cm

/// Whether its place is in its layer, or next to it. Beyond the ends of the section there is none.
bool is_in_its_layer(const StixStage& stage, const StixStatePoint& point)
{
  const auto layer = std::ranges::find(stage.layers, point.layer, &StixLayer::id);
  if (layer == stage.layers.end() || layer->outline.empty()) return false;
  const auto [left, right] = std::ranges::minmax(layer->outline, {}, [](const Vec<2>& x) { return x[0]; });
  if (point.place[0] < left[0] - near_layer || point.place[0] > right[0] + near_layer) return false;
  for (const Vec<2> aside : {Vec<2>{0, 0}, {0, near_layer}, {0, -near_layer}, {near_layer, 0}, {-near_layer, 0}}) {
    const std::vector<SoilBand> bands = soil_bands(stage, point.place[0] + aside[0]);
    const SoilBand* const band = band_at(bands, point.place[1] + aside[1]);
    if (band != nullptr && stage.layers[band->layer].id == point.layer) return true;
  }
  return false;
}

/// Of a state that is below what the soil carries [Pa], which counts as none; empty: it is not.
Sentence doubt_of(const StixPreload& preload, Real effective_stress)
{
  if (preload.kind == StixPreload::Kind::ocr && preload.ocr < 1.0)
    return filled<reported_texts::ocr_below_one>(preload.ocr);
  if (preload.kind == StixPreload::Kind::yield_stress && preload.yield_stress < effective_stress)
    return filled<reported_texts::yield_below_stress>(preload.yield_stress / 1e3, effective_stress / 1e3);
  return {};
}

/// Of the layer with an id; the id alone where the stage has no such layer.
Sentence name_of_layer(const StixProject& project, const StixStage& stage, const std::string& id)
{
  const auto found = std::ranges::find(stage.layers, id, &StixLayer::id);
  if (found == stage.layers.end()) return filled<reported_texts::layer_of_id>(id);
  const std::string name = '`' + name_of_layer(project, *found) + '`';
  return {name, name};
}

}  // namespace

std::string name_of_layer(const StixProject& project, const StixLayer& layer)
{
  const std::string label = layer.label.empty() ? layer.id : layer.label;
  return layer.soil ? fmt::format("{} ({})", project.soils[*layer.soil].name, label) : label;
}

std::vector<std::string> layers_with_two_states(const StixStage& stage)
{
  std::set<std::string> seen, twice;
  for (const StixStatePoint& point : stage.state_points)
    if (!seen.insert(point.layer).second) twice.insert(point.layer);
  return {twice.begin(), twice.end()};
}

// ---- one stage along a vertical line ----

StixStageColumn::StixStageColumn(const StixProject& project, const StixStage& stage, Real x)
    : project_(&project),
      stage_(&stage),
      x_(x),
      bands_(soil_bands(stage, x)),
      ground_(bands_.empty() ? not_given : bands_.front().top),
      water_(stage.water, x, ground_)
{
  for (const StixUniformLoad& load : stage.loads) load_grounds_.push_back(ground_of(load, stage));
}

Real StixStageColumn::stress_of_load(std::size_t k, Real z) const
{
  const Real depth = (std::isfinite(load_grounds_[k]) ? load_grounds_[k] : ground_) - z;
  return stress_of(stage_->loads[k], x_, std::max(depth, 0.0));
}

Real StixStageColumn::load_stress(Real z) const
{
  Real sum = 0.0;
  for (std::size_t k = 0; k < stage_->loads.size(); ++k) sum += stress_of_load(k, z);
  return sum;
}

Real StixStageColumn::total_stress(Real z) const
{
  Real sum = load_stress(z) + water_.unit_weight() * (water_.free_water() - std::max(z - ground_, 0.0));
  const Real level = water_.phreatic();
  for (const SoilBand& band : bands_) {
    const Real bottom = std::max(band.bottom, z);
    if (!(band.top > bottom)) break;
    const StixSoil& soil = project_->soils[*stage_->layers[band.layer].soil];
    const Real wet = std::clamp(level - bottom, 0.0, band.top - bottom);
    sum += soil.weight_below * wet + soil.weight_above * (band.top - bottom - wet);
  }
  return std::max(sum, 0.0);
}

Real StixStageColumn::pore_pressure(Real z) const
{
  Real pressure = water_.pressure(z);
  const SoilBand* const band = band_at(bands_, z);
  if (band != nullptr && water_.is_below(z))
    for (std::size_t k = 0; k < stage_->loads.size(); ++k) {
      const auto& consolidation = stage_->loads[k].consolidation;
      const auto found = consolidation.find(stage_->layers[band->layer].id);
      const Real degree = found == consolidation.end() ? full_consolidation : found->second;
      pressure += (1.0 - degree / full_consolidation) * stress_of_load(k, z);
    }
  return std::min(pressure, total_stress(z));
}

// ---- a stage with its history ----

StixSection::StixSection(const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis)
    : project_(&project), basis_(basis)
{
  for (std::size_t k = 0; k <= stage; ++k) stages_.push_back(&project.scenarios.at(scenario).stages.at(k));
  check(scenario);
  set_preloads();
}

StixSection::~StixSection() = default;

void StixSection::check(std::size_t scenario) const
{
  std::vector<Problem> problems;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const std::string where = fmt::format("{}, scenario {}, stage {}", project_->path, scenario + 1, k + 1);
    const auto fault = [&](const std::string& what, const std::string& detail) {
      problems.push_back({.key = where, .what = what, .detail = detail, .topic = ""});
    };
    if (stages_[k]->layers.empty()) fault("has no soil layers", "Draw the section in D-Stability.");
    for (const std::string& layer : layers_with_two_states(*stages_[k]))
      fault(fmt::format("the layer with the id {} has two state points", layer),
          "Which one holds cannot be known. Take one out in D-Stability.");
    for (const StixLayer& layer : stages_[k]->layers) {
      const std::string name = fmt::format("the layer `{}` (id {})", layer.label, layer.id);
      if (!layer.soil)
        fault(name + " has no soil", "Give it one in D-Stability.");
      else if (const StixSoil& soil = project_->soils[*layer.soil];
               !(soil.weight_above >= 0.0) || !(soil.weight_below >= 0.0))
        fault(name + " has no weight", fmt::format("The soil `{}` has the unit weights {} and {} N/m3.", soil.name,
                                           soil.weight_above, soil.weight_below));
    }
  }
  if (!problems.empty()) throw InputError(problems);
}

void StixSection::set_preloads()
{
  std::vector<Problem> problems;
  const auto pop_at = [&](const StixStage& stage, const StixPreload& preload, Vec<2> place, const Sentence& state) {
    const Real stress =
        needs_stress(preload) ? StixStageColumn(*project_, stage, place[0]).effective_stress(place[1]) : 0.0;
    const Real pop = pop_of(preload, stress, basis_);
    const auto add_doubt = [&](const Sentence& doubt) {
      if (!doubt.empty()) state_doubts_.push_back(filled<reported_texts::of_state>(stage.label, state, doubt));
    };
    add_doubt(doubt_of(preload, stress));
    if (pop > most_pop) add_doubt(filled<reported_texts::large_pop>(pop / 1e3));
    if (!(pop >= 0.0 && std::isfinite(pop)))
      problems.push_back({fmt::format("{}, stage `{}`, {}", project_->path, stage.label, state.en),
          std::isnan(pop) ? "its POP has no value" : fmt::format("its POP is {:g} kPa", pop / 1e3),
          "It is at least zero. Design values need a mean and a standard deviation.", ""});
    return pop;
  };
  for (const StixStage* stage : stages_) {
    auto& points = point_pops_.emplace_back();
    for (const StixStatePoint& point : stage->state_points) {
      const Sentence state =
          filled<reported_texts::state_of_layer>(point.label, name_of_layer(*project_, *stage, point.layer));
      points.push_back(pop_at(*stage, point.preload, point.place, state));
      if (!is_in_its_layer(*stage, point))
        state_doubts_.push_back(filled<reported_texts::of_state>(
            stage->label, state, filled<reported_texts::state_outside>(point.place[0], point.place[1])));
    }
    auto& lines = line_pops_.emplace_back();
    for (const StixStateLine& line : stage->state_lines) {
      LinePops& pops = lines.emplace_back();
      for (const StixStateLine::Value& value : line.values) {
        const Vec<2> place{value.x, interpolate(line.line, value.x)};
        const Sentence name = filled<reported_texts::state_of_line>(value.label);
        pops.above.push_back({value.x, pop_at(*stage, value.above, place, name)});
        pops.below.push_back({value.x, pop_at(*stage, value.below, place, name)});
      }
    }
  }
  if (!problems.empty()) throw InputError(problems);
}

StixColumn StixSection::column(Real x) const { return {*this, x}; }

std::optional<StixPlace> StixSection::at(Vec<2> place) const { return column(place[0]).at(place[1]); }

// ---- along a vertical line, with history ----

StixColumn::StixColumn(const StixSection& section, Real x) : section_(&section), x_(x)
{
  for (const StixStage* stage : section.stages_) stages_.emplace_back(*section.project_, *stage, x);
}

Real StixColumn::pop(std::size_t stage, Real z) const
{
  const StixStage& of = *section_->stages_[stage];
  const std::string& layer = of.layers[band_at(stages_[stage].bands(), z)->layer].id;
  const auto point = std::ranges::find(of.state_points, layer, &StixStatePoint::layer);
  if (point != of.state_points.end())
    return section_->point_pops_[stage][static_cast<std::size_t>(point - of.state_points.begin())];
  struct At {
    Real z, above, below;
  };
  std::optional<At> upper, lower;  // the nearest lines above and below z
  for (std::size_t k = 0; k < of.state_lines.size(); ++k) {
    const StixSection::LinePops& pops = section_->line_pops_[stage][k];
    if (pops.above.empty()) continue;
    const At at{interpolate(of.state_lines[k].line, x_), interpolate(pops.above, x_), interpolate(pops.below, x_)};
    if (at.z > z && (!upper || at.z < upper->z)) upper = at;
    if (at.z <= z && (!lower || at.z > lower->z)) lower = at;
  }
  if (upper && lower) return std::lerp(upper->below, lower->above, (upper->z - z) / (upper->z - lower->z));
  if (upper) return upper->below;
  return lower ? lower->above : 0.0;
}

Real StixColumn::yield_stress(Real z) const
{
  Real largest = 0.0;
  for (std::size_t k = 0; k < stages_.size(); ++k)
    if (band_at(stages_[k].bands(), z) != nullptr)
      largest = std::max(largest, stages_[k].effective_stress(z) + pop(k, z));
  return largest;
}

std::vector<Real> StixColumn::pops(Real z) const
{
  std::vector<Real> all;
  for (std::size_t k = 0; k < stages_.size(); ++k)
    all.push_back(band_at(stages_[k].bands(), z) != nullptr ? pop(k, z) : 0.0);
  return all;
}

Real StixColumn::largest_effective_stress(Real z) const
{
  Real largest = 0.0;
  for (const StixStageColumn& stage : stages_)
    if (band_at(stage.bands(), z) != nullptr) largest = std::max(largest, stage.effective_stress(z));
  return largest;
}

void StixColumn::set_strength(StixPlace& place) const
{
  const StixSoil& soil = *place.soil;
  const StixBasis basis = section_->basis_;
  place.model = place.below_water ? soil.below : soil.above;
  switch (place.model) {
    case StixStrengthModel::shansep:
      place.ratio = value_of(soil.ratio, basis);
      place.exponent = value_of(soil.exponent, basis);
      place.su = shansep_strength(place.ratio, place.exponent, place.effective_stress, place.yield_stress);
      break;
    case StixStrengthModel::su_table: place.su = table_strength(soil.su_table, place.effective_stress, basis); break;
    default: break;
  }
  const DavisStrength drained = drained_strength(soil, place.model, basis);
  place.cohesion = drained.cohesion;
  place.friction = drained.friction;
}

std::optional<StixPlace> StixColumn::at(Real z) const
{
  const StixStageColumn& stage = now();
  const SoilBand* const band = band_at(stage.bands(), z);
  if (band == nullptr) return std::nullopt;
  StixPlace place{.layer = band->layer};
  place.soil = &section_->project_->soils[*section_->stage().layers[band->layer].soil];
  place.below_water = stage.water().is_below(z);
  place.total_stress = stage.total_stress(z);
  place.load_stress = stage.load_stress(z);
  place.pore_pressure = stage.pore_pressure(z);
  place.effective_stress = place.total_stress - place.pore_pressure;
  place.yield_stress = yield_stress(z);
  set_strength(place);
  return place;
}

}  // namespace terp
