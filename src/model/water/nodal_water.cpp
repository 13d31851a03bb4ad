// Pressures without a limit are found once for each situation, and again in a step only where a formula has the time.
// Each node is then cut to the weight of soil, loads and free water above it.

#include "model/water/nodal_water.hpp"

#include "model/ground/ground_section.hpp"
#include "model/seepage/computed_water.hpp"
#include "model/soils/overburden.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/features/loads.hpp"

#include <algorithm>

namespace terp {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real round_off = 1e-9;  // over the size of a cell: nodes on the surface count as below it

}  // namespace

NodalWater::NodalWater(const Model& model)
    : water_(model.description.water),
      mesh_(model.mesh),
      knots_(knots_of(model.description.water)),
      gravity_(-model.gravity[1])
{
  const Overburden overburden(model);
  const bool has_weight = std::min(model.gravity[1], model.gravity_before[1]) < 0.0;
  sections_[0] = section_of(overburden, has_weight);
  const auto changes = [now = model.stage.number + 1](
                           const BodyCase& body) { return body.placed == now || body.removed == now; };
  if (std::ranges::any_of(model.description.bodies, changes))
    sections_[1] = section_of(Overburden::before_stage(model), has_weight);
  if (overburden.is_known()) drawn_ = draw_water(overburden);
  if (follows_soil() && water_.kind == WaterKind::seepage)
    section_ = std::make_shared<const SeepageSection>(seepage_section(model.whole(), model.mesh));
  for (std::size_t k = 0; k <= water_.situations.size(); ++k) fields_.push_back(field_of(situation_of(water_, k), 0.0));
  for (const Load& load : loads_of(model)) {
    stretches_.push_back({load.from, load.to});
    first_loads_.push_back(pressure_of(model, load, 0.0));
  }
}

NodalWater::Section NodalWater::section_of(const Overburden& overburden, bool has_weight) const
{
  Section section;
  for (Vec<2> x : mesh_->nodes) {
    // A vertical line along the right end of a body crosses no side: just left of it, it does.
    if (!overburden.ground(x[0])) x[0] -= round_off * mesh_->smallest_altitude;
    const Real ground = overburden.ground(x[0]).value_or(-infinity);
    section.ground.push_back(ground);
    const bool below = has_weight && overburden.is_known() && x[1] <= ground + round_off * mesh_->smallest_altitude;
    section.mass_above.push_back(below ? overburden.mass_above(x) : infinity);
  }
  return section;
}

Real NodalWater::weight_above(const Section& section, std::size_t node, Real gravity, std::span<const Real> loads) const
{
  if (section.mass_above[node] == infinity) return infinity;
  return with_loads(gravity * section.mass_above[node], mesh_->nodes[node][0], loads);
}

Real NodalWater::with_loads(Real weight, Real x, std::span<const Real> loads) const
{
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (x >= stretches_[k].from && x <= stretches_[k].to) weight += loads[k];
  return std::max(weight, 0.0);
}

DrawnWater NodalWater::draw_water(const Overburden& overburden) const
{
  DrawnWater drawn{.columns = columns_of_section(*mesh_)};
  drawn.levels.resize(water_.situations.size() + 1);
  const Real base = std::ranges::min(mesh_->nodes, {}, [](const Vec<2>& node) { return node[1]; })[1];
  for (Index k = 0; k < drawn.columns.n; ++k) {
    const Real x = drawn.columns.left + (static_cast<Real>(k) + 0.5) * drawn.columns.width;
    drawn.ground.push_back(overburden.ground(x).value_or(base));
    for (std::size_t s = 0; s < drawn.levels.size(); ++s)
      drawn.levels[s].push_back(level_at(x, drawn.ground.back(), water_, situation_of(water_, s)));
  }
  return drawn;
}

NodalWater::Field NodalWater::field_of(const WaterSituation& situation, Real time) const
{
  Field field;
  for (std::size_t i = 0; i < mesh_->nodes.size(); ++i) {
    const Vec<2>& x = mesh_->nodes[i];
    field.at_node.push_back(unlimited_pressure(water_, situation, x, time));
    if (follows_soil())
      field.heads.push_back(situation.formula ? Head{x[1] + field.at_node.back() / water_.unit_weight, 0.0}
                                              : WaterColumn(situation, x[0]).head_with_table(x[1]));
    for (std::size_t k = 0; k < sections_.size() && !sections_[k].ground.empty(); ++k) {
      const Vec<2> surface{x[0], std::max(sections_[k].ground[i], x[1])};
      const bool has_limit = sections_[k].mass_above[i] != infinity;
      field.at_ground[k].push_back(has_limit ? unlimited_pressure(water_, situation, surface, time) : 0.0);
    }
  }
  return field;
}

Real NodalWater::carried_pressure(
    std::size_t node, const CarriedPlace& place, const Head& head, Real gravity, std::span<const Real> loads) const
{
  const Vec<2>& x = mesh_->nodes[node];
  if (x[1] > place.ground && !place.head) return water_.unit_weight * (place.table - x[1]);
  const Real free_water = water_.unit_weight * std::max(place.table - place.ground, 0.0);
  const Real most = x[1] > place.ground ? infinity : with_loads(gravity * place.mass, x[0], loads) + free_water;
  return std::min(water_.unit_weight * (place.head.value_or(head.at(place.table)) - x[1]), most);
}

void NodalWater::set(const WaterMoment& moment, std::span<const Real> loads, Real bodies, const WaterState* carried,
    std::int64_t step, bool anew, PorePressure& pore) const
{
  const auto now = [&](std::size_t number) {
    const WaterSituation& of = situation_of(water_, number);
    return of.formula_changes ? field_of(of, moment.time) : Field();
  };
  const Field at_from = now(moment.way.from), at_to = now(moment.way.to);
  const Field& from = at_from.at_node.empty() ? fields_[moment.way.from] : at_from;
  const Field& to = at_to.at_node.empty() ? fields_[moment.way.to] : at_to;
  const std::size_t n = mesh_->nodes.size();
  pore.pressure.resize(n);
  pore.unlimited.resize(n);
  pore.suction.resize(water_.suction > 0.0 ? n : 0);
  const auto between = [share = moment.way.share](Real a, Real b) { return a + share * (b - a); };
  const auto limit = [&](std::size_t k, std::size_t i) {
    const Real free_water = std::max(between(from.at_ground[k][i], to.at_ground[k][i]), 0.0);
    return weight_above(sections_[k], i, moment.gravity, loads) + free_water;
  };
  const Real way = carried != nullptr ? std::clamp(carried->share_at(step), 0.0, 1.0) : 0.0;
  const auto carried_at = [&](std::size_t i) {
    if (carried == nullptr) return CarriedPlace{};
    // Where a look found no motion the other one has the places, and the share is 0.
    const bool first = !carried->before.is_empty(), second = !carried->last.is_empty();
    const CarriedWater &a = first ? carried->before : carried->last, &b = second ? carried->last : carried->before;
    const Real from_share = first ? a.share[i] : 0.0, to_share = second ? b.share[i] : 0.0;
    return CarriedPlace{.is_carried = from_share > 0.0 || to_share > 0.0,
        .share = std::lerp(from_share, to_share, way),
        .table = std::lerp(a.table[i], b.table[i], way),
        .ground = std::lerp(a.ground[i], b.ground[i], way),
        .mass = std::lerp(a.mass[i], b.mass[i], way),
        .head = a.head.empty() || b.head.empty() ? std::nullopt : std::optional(std::lerp(a.head[i], b.head[i], way))};
  };
  const bool changes = !sections_[1].ground.empty() && bodies < 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const CarriedPlace place = carried_at(i);
    if (!anew && !place.is_carried) continue;
    const Real pressure = between(from.at_node[i], to.at_node[i]), free = std::max(pressure, 0.0);
    Real most = limit(0, i);
    // The total stress runs from that of one section to that of the other, as bodies that come or go carry their weight
    // under water by and by (decision 0051). Above the ground the water has no limit.
    if (changes) {
      const Real before = limit(1, i);
      most = std::lerp(before == infinity ? free : before, most == infinity ? free : most, bodies);
    }
    Real unlimited = std::min(pressure, most);
    if (place.share > 0.0) {
      const Head head{
          between(from.heads[i].own, to.heads[i].own), between(from.heads[i].of_table, to.heads[i].of_table)};
      unlimited = std::lerp(unlimited, carried_pressure(i, place, head, moment.gravity, loads), place.share);
    }
    pore.pressure[i] = std::max(unlimited, 0.0);
    pore.unlimited[i] = unlimited;
    if (!pore.suction.empty()) pore.suction[i] = std::clamp(-unlimited, 0.0, water_.suction);
  }
}

CappedWater NodalWater::find_capped(std::span<const Index> nodes) const
{
  const Real negligible = 1e-6 * water_.unit_weight * mesh_->smallest_altitude;  // [Pa]
  CappedWater capped;
  std::vector<bool> is_cut(mesh_->nodes.size(), false);
  for (std::size_t k = 0; k < fields_.size(); ++k)
    for (const Index i : nodes) {
      const Real free_water = std::max(fields_[k].at_ground[0][i], 0.0),
                 most = weight_above(sections_[0], i, gravity_, first_loads_) + free_water;
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

WaterMoment NodalWater::moment_at(const StageWater& stage, Real time, Real share, Real gravity, bool holds_bodies) const
{
  const WaterWay way = stage.given ? WaterWay{stage.from, stage.to, share} : way_at(knots_, time);
  const auto changes = [&](std::size_t number) { return situation_of(water_, number).formula_changes; };
  const bool comes_or_goes = holds_bodies && share < 1.0;
  return {way, comes_or_goes || changes(way.from) || changes(way.to) ? time : 0.0, gravity};
}

static WaterMoment moment_of(const Model& model, Real time)
{
  const bool holds_bodies = model.with.bodies != nullptr;
  return model.with.water->moment_at(
      model.stage.water, time, model.ramp.share_at(time), -model.gravity_at(time)[1], holds_bodies);
}

WaterWay water_way(const Model& model, Real time) { return moment_of(model, time).way; }

WaterWay first_way(const Model& model) { return water_way(model, 0.0); }

namespace {

PorePressure water_at(const Model& model, Real time, const WaterState* carried, std::int64_t step)
{
  std::vector<Real> loads;
  for (const Load& load : loads_of(model)) loads.push_back(pressure_of(model, load, time));
  PorePressure pore;
  model.with.water->set(moment_of(model, time), loads, model.ramp.share_at(time), carried, step, true, pore);
  return pore;
}

}  // namespace

PorePressure water_at(const Model& model, Real time) { return water_at(model, time, nullptr, 0); }

PorePressure water_at(const Model& model, const StepState& state)
{
  return water_at(model, state.time, carried_water(state), state.step);
}

Real pore_pressure_at(const Model& model, const PorePressure& pore, const PointBlock<2>& block, Index lane)
{
  const auto shapes = Quad4::shape_functions(std::array{block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]});
  Real pressure = 0.0;
  for (int i = 0; i < Quad4::n_corners; ++i) {
    const Index node = model.mesh->cells[block.cell][i];
    pressure += shapes[i] * (pore.pressure[node] - (pore.suction.empty() ? 0.0 : pore.suction[node]));
  }
  return pressure;
}

}  // namespace terp
