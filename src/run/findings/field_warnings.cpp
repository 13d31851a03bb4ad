// What a field follows, as depth or stress, is asked at the points: a value beyond the pairs is meant at the ends of a
// layer, and hardly in all of it. A range of which the soil has next to nothing is one in another unit.

#include "run/findings/field_warnings.hpp"

#include "model/meshes/setup_mesh.hpp"
#include "model/soils/correlation_kind.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "run/findings/soil_size.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

struct Met {
  Index n = 0, n_inside = 0;
  Real low = INFINITY, high = -INFINITY;
};

Met meet_soil(const Model& model, const State& state, Index material, const FieldReach& reach)
{
  Met met;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (block.material != material) return;
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const Real value = reach.argument({x, model.ground()});
    if (std::isnan(value)) return;
    ++met.n, met.n_inside += value >= reach.low && value <= reach.high;
    met.low = std::min(met.low, value), met.high = std::max(met.high, value);
  });
  return met;
}

/// The pairs hold for next to none of the soil, or the soil has next to nothing of what lies between them.
std::optional<Problem> find_other_range(const std::string& key, const FieldReach& reach, const Met& soil, Real height)
{
  constexpr Real few = 0.02, narrow = 0.005;
  const bool outside = static_cast<Real>(soil.n_inside) < few * static_cast<Real>(soil.n);
  const Real range = reach.high - reach.low;
  const bool in_cm = reach.unit == "m" && range > 5.0 * height && soil.high - soil.low < few * range;
  const bool at_begin = soil.high - reach.low < narrow * range || in_cm;
  if (soil.n == 0 || (!outside && !at_begin)) return std::nullopt;
  const std::string unit(reach.unit);
  return Problem{key,
      outside ? fmt::format("the pairs by {} cover none of the soil", reach.what)
              : fmt::format("the soil has only a small part of the pairs by {}", reach.what),
      fmt::format("They go from {:.4g} to {:.4g} {}, the soil has {:.4g} to {:.4g} {}: {}. {}", reach.low, reach.high,
          unit, soil.low, soil.high, unit, outside ? "all of it takes the value of an end" : "its value hardly changes",
          unit == "Pa"            ? "Stresses are in Pa: 50 kPa is 50e3."
          : reach.what == "depth" ? "Depths are in m below the ground."
                                  : "Elevations are in m, in the frame of the mesh; depths are given by `depth`."),
      "field", false, {"water"}};
}

/// SHANSEP whose `minimum` holds in most of the soil: the least value is the one that points share.
std::optional<Problem> find_ruling_minimum(
    const Model& model, const State& state, Index material, const ParameterField& field, const std::string& key)
{
  constexpr Real most = 0.5;  // of the points
  std::vector<Real> values;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (block.material != material) return;
    values.push_back(field.value_at({{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]}, model.ground()}));
  });
  std::erase_if(values, [](Real value) { return std::isnan(value); });
  if (values.empty()) return std::nullopt;
  const Real least = std::ranges::min(values);
  const auto n = std::ranges::count(values, least);
  if (static_cast<Real>(n) < most * static_cast<Real>(values.size())) return std::nullopt;
  return Problem{key, "the minimum holds in most of the soil, not SHANSEP",
      fmt::format(
          "{} of {} points have the least strength of {:.4g} kPa. `minimum` is for soil near the ground, usually 1 "
          "to 5 kPa:\ngive less, or a constant strength.",
          n, values.size(), 1e-3 * least),
      "material.su_peak", false, {"material"}};
}

}  // namespace

std::optional<Problem> find_coarse_cells(const std::string& key, const FieldScale& scale, Real cell)
{
  constexpr Real resolved = 0.25;
  const Real least = std::min(scale.theta[0], scale.theta[1]);
  if (cell <= resolved * least) return std::nullopt;
  return Problem{key, "the cells hardly resolve the random field",
      fmt::format("Cells of {:.2g} m, a scale of fluctuation of {:g} m; a quarter of it or less resolves it. The mean "
                  "over\na cell has {:.0f} % of the standard deviation of a point, along the shorter scale.",
          cell, least, 100.0 * std::sqrt(scale.correlation->variance_of_mean(cell / least))),
      ""};
}

void find_odd_fields(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  constexpr Real far_more = 8.0;
  const auto [g, height, cell] = measure_soil(model, state);
  const auto [left, right] = ends_of_soil(state);
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const MaterialCase& material = model.description.materials[m];
    for (const ParameterField& field : material.fields) {
      if (field.follows) continue;
      const std::string key = parameter_key(material, model.materials[m].type->parameters[field.parameter].name);
      for (const FieldReach& reach : field.needs.reaches)
        if (auto odd = find_other_range(key, reach, meet_soil(model, state, static_cast<Index>(m), reach), height))
          warnings.push_back(std::move(*odd));
      for (const FieldCover& cover : field.needs.covers) {
        const Real wide = cover.high[0] - cover.low[0], high = cover.high[1] - cover.low[1];
        if (!std::isfinite(wide) || wide < far_more * (right - left) || high < far_more * height) continue;
        warnings.push_back({key, fmt::format("the table `{}` is far larger than the section", cover.file),
            fmt::format("Its places go over {:.4g} by {:.4g} m, the soil over {:.4g} by {:.4g} m. x and y are in m.",
                wide, high, right - left, height),
            "field"});
      }
      if (field.needs.yield_stress)
        if (auto ruled = find_ruling_minimum(model, state, static_cast<Index>(m), field, key))
          warnings.push_back(std::move(*ruled));
      for (const FieldScale& scale : field.needs.scales)
        if (auto coarse = find_coarse_cells(key, scale, cell)) warnings.push_back(std::move(*coarse));
    }
  }
}

}  // namespace terp
