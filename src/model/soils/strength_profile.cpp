// In each cell that the line crosses, one point stands for each material. It is the nearest to the line at the mean
// height of the points of that material. Parameters that vary are read from the rows of the point, so the table shows
// what the run uses. Depth and stress come from the overburden from which strengths follow, whose outlines do not
// depend on the points.

#include "model/soils/strength_profile.hpp"

#include "math/nan.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/parts/stage_case.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

Vec<2> place_of(const PointBlock<2>& block, Index lane)
{
  return {block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
}

bool is_crossed(const Mesh<2>& mesh, Index cell, Real x)
{
  Real low = INFINITY, high = -INFINITY;
  for (const Index node : mesh.cells[cell]) {
    low = std::min(low, mesh.nodes[node][0]);
    high = std::max(high, mesh.nodes[node][0]);
  }
  return x >= low && x < high;
}

/// The parameters of the law at a point, those that vary from its rows.
std::vector<Real> parameters_of(const Model& model, const PointBlock<2>& block, Index lane)
{
  const SoilMaterial& material = model.materials[block.material];
  std::vector<Real> values = model.description.materials[block.material].parameters;
  const std::span<const int> varying = material.law->varying();
  const LawRows rows = material.view(block, lane);
  for (std::size_t k = 0; k < varying.size(); ++k) values[static_cast<std::size_t>(varying[k])] = *rows.parameters(k);
  return values;
}

ProfileRow row_of(const Model& model, const Overburden& above, const PointBlock<2>& block, Index lane)
{
  const SoilMaterial& material = model.materials[block.material];
  const Vec<2> x = place_of(block, lane);
  const WaterSituation& water = model.description.water.start;
  const std::optional<Real> ground = above.is_known() ? above.ground(x[0]) : std::nullopt;
  ProfileRow row{.x = x,
      .depth = ground ? *ground - x[1] : nan,
      .stress = above.is_known() ? above.effective(x, water) : nan,
      .pore = above.pore_pressure(x, water),
      .shear = material.law->moduli(material.view(block, lane)).shear,
      .material = material.name,
      .strengths = {}};
  const Case& whole = model.whole();
  if (const std::size_t last = water_of_stage(whole, whole.stages.size()).to; last > 0 && above.is_known())
    row.last_stress = above.effective(x, situation_of(whole.water, last));
  for (const ParameterField& field : model.description.materials[block.material].fields)
    if (field.needs.yield_stress) row.yield_stress = field.needs.yield_stress({x, model.ground()});
  const std::vector<Real> values = parameters_of(model, block, lane);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ParameterInfo& info = material.type->parameters[k];
    if (is_strength(info.reduction) && !info.fallback && info.fallback_of.empty())
      row.strengths.push_back({info.name, info.unit, values[k]});
  }
  return row;
}

}  // namespace

std::vector<ProfileRow> strength_profile(const Model& model, const StepState& state, Real x)
{
  const Overburden own(model);
  const Overburden& above = model.ground() ? *model.ground() : own;  // that strengths follow from
  std::vector<ProfileRow> rows;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    if (block.n == 0 || !is_crossed(*model.mesh, block.cell, x)) return;
    Real middle = 0.0;
    for (Index lane = 0; lane < block.n; ++lane) middle += place_of(block, lane)[1] / static_cast<Real>(block.n);
    Index nearest = 0;
    const auto distance = [&](Index lane) {
      const Vec<2> at = place_of(block, lane);
      return std::hypot(at[0] - x, at[1] - middle);
    };
    for (Index lane = 1; lane < block.n; ++lane)
      if (distance(lane) < distance(nearest)) nearest = lane;
    rows.push_back(row_of(model, above, block, nearest));
  });
  std::ranges::sort(rows, std::ranges::greater{}, [](const ProfileRow& row) { return row.x[1]; });
  return rows;
}

std::vector<ProfileRow> thinned(const std::vector<ProfileRow>& rows, std::size_t n)
{
  const std::size_t each = std::max<std::size_t>(1, (rows.size() + n - 1) / std::max<std::size_t>(n, 1));
  std::vector<ProfileRow> few;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool changes = k + 1 < rows.size() && rows[k].material != rows[k + 1].material;
    const bool begins = k > 0 && rows[k].material != rows[k - 1].material;
    if (k % each == 0 || k + 1 == rows.size() || changes || begins) few.push_back(rows[k]);
  }
  return few;
}

std::vector<Real> usual_profiles(const Model& model, const StepState& state)
{
  Real low = INFINITY, high = -INFINITY, top = -INFINITY;
  for (std::size_t k = 0; k + 1 < state.x_initial.size(); k += 2) {
    low = std::min(low, state.x_initial[k]);
    high = std::max(high, state.x_initial[k]);
    top = std::max(top, state.x_initial[k + 1]);
  }
  Real from = INFINITY, to = -INFINITY;  // of the points beside the highest one, within a cell
  const Real size = model.mesh->smallest_altitude;
  for (std::size_t k = 0; k + 1 < state.x_initial.size(); k += 2)
    if (state.x_initial[k + 1] > top - 0.5 * size) {
      from = std::min(from, state.x_initial[k]);
      to = std::max(to, state.x_initial[k]);
    }
  std::vector<Real> lines{low + 0.25 * (high - low), 0.5 * (from + to), low + 0.75 * (high - low)};
  std::ranges::sort(lines);
  const auto is_close = [&](Real a, Real b) { return b - a < size; };
  lines.erase(std::unique(lines.begin(), lines.end(), is_close), lines.end());
  return lines;
}

}  // namespace terp
