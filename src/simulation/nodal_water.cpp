#include "simulation/nodal_water.hpp"

#include "simulation/overburden.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real round_off = 1e-9;  // over the size of a cell: nodes on the surface count as below it

}  // namespace

NodalWater::NodalWater(const Model& model)
    : water_(model.description.water), mesh_(model.mesh), knots_(knots_of(model.description.water))
{
  const Overburden overburden(model);
  for (Vec<2> x : mesh_->nodes) {
    // A vertical line along the right end of a body crosses no side: just left of it, it does.
    if (!overburden.ground(x[0])) x[0] -= round_off * mesh_->smallest_altitude;
    const Real ground = overburden.ground(x[0]).value_or(-infinity);
    const bool below =
        overburden.is_known() && model.gravity[1] < 0.0 && x[1] <= ground + round_off * mesh_->smallest_altitude;
    ground_.push_back(ground);
    soil_above_.push_back(below ? -model.gravity[1] * overburden.mass_above(x) : infinity);
  }
  for (std::size_t k = 0; k <= water_.situations.size(); ++k)
    fields_.push_back(field_of(situation_of(water_, k), knots_.front().time));
}

NodalWater::Field NodalWater::field_of(const WaterSituation& situation, Real time) const
{
  Field field;
  for (std::size_t i = 0; i < mesh_->nodes.size(); ++i) {
    const Vec<2>& x = mesh_->nodes[i];
    field.at_node.push_back(unlimited_pressure(water_, situation, x, time));
    field.at_ground.push_back(soil_above_[i] == infinity
                                  ? 0.0
                                  : unlimited_pressure(water_, situation, {x[0], std::max(ground_[i], x[1])}, time));
  }
  return field;
}

bool NodalWater::changes_between(Real a, Real b) const
{
  if (std::ranges::any_of(
          knots_, [&](const WaterKnot& k) { return situation_of(water_, k.situation).formula_changes; }))
    return a != b;
  return a != b && std::min(a, b) < knots_.back().time;
}

void NodalWater::renew(Real time, PorePressure& pore) const
{
  if (!std::isnan(pore.time) && !changes_between(pore.time, time)) return;
  const auto after = std::ranges::find_if(knots_, [time](const WaterKnot& knot) { return knot.time > time; });
  const WaterKnot& a = *(after - 1);
  const WaterKnot& b = after == knots_.end() ? a : *after;
  const Real share = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0.0;
  const auto now = [&](std::size_t situation) {
    const WaterSituation& of = situation_of(water_, situation);
    return of.formula_changes ? field_of(of, time) : Field();
  };
  const Field from = now(a.situation), to = now(b.situation);
  set(from.at_node.empty() ? fields_[a.situation] : from, to.at_node.empty() ? fields_[b.situation] : to, share, pore);
  pore.time = time;
}

void NodalWater::set(std::size_t from, std::size_t to, Real share, PorePressure& pore) const
{
  set(fields_[from], fields_[to], share, pore);
}

void NodalWater::set(const Field& from, const Field& to, Real share, PorePressure& pore) const
{
  const std::size_t n = mesh_->nodes.size();
  pore.pressure.resize(n);
  pore.suction.resize(water_.suction > 0.0 ? n : 0);
  const auto between = [share](Real a, Real b) { return a + share * (b - a); };
  for (std::size_t i = 0; i < n; ++i) {
    const Real pressure = between(from.at_node[i], to.at_node[i]);
    const Real free_water = std::max(between(from.at_ground[i], to.at_ground[i]), 0.0);
    pore.pressure[i] = std::clamp(pressure, 0.0, soil_above_[i] + free_water);
    if (!pore.suction.empty()) pore.suction[i] = std::clamp(-pressure, 0.0, water_.suction);
  }
}

CappedWater NodalWater::find_capped(std::span<const Index> nodes) const
{
  const Real negligible = 1e-6 * water_.unit_weight * mesh_->smallest_altitude;  // [Pa]
  CappedWater capped;
  std::vector<bool> is_cut(mesh_->nodes.size(), false);
  for (std::size_t k = 0; k < fields_.size(); ++k)
    for (const Index i : nodes) {
      const Real free_water = std::max(fields_[k].at_ground[i], 0.0), most = soil_above_[i] + free_water;
      const Real cut = fields_[k].at_node[i] - most;
      if (!(cut > negligible)) continue;
      is_cut[i] = true;
      if (cut > capped.most) capped = {0, cut, mesh_->nodes[i], k};
    }
  capped.n = static_cast<Index>(std::ranges::count(is_cut, true));
  return capped;
}

bool NodalWater::is_dry(std::span<const Index> nodes) const
{
  return std::ranges::all_of(fields_,
      [&](const Field& field) { return std::ranges::none_of(nodes, [&](Index i) { return field.at_node[i] > 0.0; }); });
}

PorePressure water_at(const Model& model, Real time)
{
  PorePressure pore;
  if (const StageWater& water = model.stage.water; water.given)
    model.water->set(water.from, water.to, model.ramp.share_at(time), pore);
  else
    model.water->renew(time, pore);
  return pore;
}

Real pore_pressure_at(const Model& model, const PorePressure& pore, const PointBlock<2>& block, Index lane)
{
  using Rows = PointRows<2>;
  const auto shapes = Quad4::shape_functions(std::array{block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]});
  Real pressure = 0.0;
  for (int i = 0; i < Quad4::n_corners; ++i) {
    const Index node = model.mesh->cells[block.cell][i];
    pressure += shapes[i] * (pore.pressure[node] - (pore.suction.empty() ? 0.0 : pore.suction[node]));
  }
  return pressure;
}

}  // namespace terp
