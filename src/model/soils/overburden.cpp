// What lies above a place is found in its column of soil: per place there is no list to make.

#include "model/soils/overburden.hpp"

#include "model/bodies/setup_points.hpp"
#include "mpm/features/loads.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>

namespace terp {

namespace {

bool is_there(const BodyCase& body) { return body.is_there; }

}  // namespace

Overburden::Overburden(const Model& model, Real gravity) : Overburden(model, gravity, is_there) { add_loads(model); }

Overburden Overburden::without_loads(const StageSoil& soil)
{
  return Overburden(soil, -soil.description.forces.gravity[1], is_there);
}

Overburden Overburden::before_stage(const Model& model)
{
  const StageNumber now = model.stage.number + 1;
  Overburden before(model, -model.gravity[1],
      [now](const BodyCase& body) { return body.removed == now || (body.is_there && body.placed != now); });
  before.add_loads(model);
  return before;
}

void Overburden::add_loads(const Model& model)
{
  for (const Load& load : loads_of(model))
    if (load.is_permanent()) loads_.push_back({load.from, load.to, pressure_of(model, load, 0.0)});
}

Overburden::Overburden(const StageSoil& soil, Real gravity, const IsThere& is_there)
    : water_(soil.description.water), gravity_(gravity)
{
  const std::vector<BodyOutline> outlines = outlines_of(soil);
  std::vector<std::vector<Side>> sides;
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const BodyCase& body = soil.description.bodies[b];
    if (!is_there(body)) continue;
    if (!body.points_file.empty()) {
      is_known_ = false;
      continue;
    }
    const auto density = [&](Zone zone) { return soil.materials[material_number(soil, body.material, zone)].density; };
    sides.push_back(outline_sides(*soil.mesh, outlines[b]));
    drawn_.push_back({density(Zone::below), density(Zone::above)});
  }
  columns_ = DrawnColumns(sides);
}

/// Mass per area of a body between two elevations [kg/m^2].
Real Overburden::mass_between(const DrawnBody& body, Real x, Real low, Real high) const
{
  if (body.below == body.above) return (high - low) * body.above;
  const Real level = std::clamp(elevation_at(water_.start.phreatic_line, x), low, high);
  return (high - level) * body.above + (level - low) * body.below;
}

Real Overburden::mass_above(Vec<2> x) const
{
  const std::span<const DrawnLayer> layers = columns_.at(x[0]);
  Real mass = 0.0;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const Real top = height_at(layers[k].top, x[0]);
    if (!(top > x[1])) break;
    if (layers[k].body == DrawnColumns::nothing) continue;
    const Real low = k + 1 < layers.size() ? std::max(height_at(layers[k + 1].top, x[0]), x[1]) : x[1];
    mass += mass_between(drawn_[static_cast<std::size_t>(layers[k].body)], x[0], low, top);
  }
  return mass;
}

std::optional<Real> Overburden::ground(Real x) const
{
  const std::span<const DrawnLayer> layers = columns_.at(x);
  if (layers.empty()) return std::nullopt;
  return height_at(layers.front().top, x);
}

/// Pressure of the water that stands on the ground above a place, or at the place if it is above the ground [Pa].
Real Overburden::free_water(Vec<2> x, const WaterSituation& situation, Real time) const
{
  if (!situation.is_given()) return 0.0;
  const Real surface = std::max(ground(x[0]).value_or(x[1]), x[1]);
  return water_pressure(water_, situation, {x[0], surface}, time);
}

Real Overburden::loads_on(Vec<2> x) const
{
  Real pressure = 0.0;
  for (const LoadAbove& load : loads_)
    if (x[0] >= load.from && x[0] <= load.to) pressure += load.pressure;
  return pressure > 0.0 && x[1] <= ground(x[0]).value_or(x[1]) ? pressure : 0.0;
}

Real Overburden::total(Vec<2> x, const WaterSituation& situation, Real time) const
{
  return gravity_ * mass_above(x) + free_water(x, situation, time) + loads_on(x);
}

Real Overburden::pore_pressure(Vec<2> x, const WaterSituation& situation, Real time) const
{
  if (!situation.is_given()) return 0.0;
  const Real pressure = water_pressure(water_, situation, x, time);
  return is_known_ ? std::min(pressure, total(x, situation, time)) : pressure;
}

Real Overburden::effective(Vec<2> x, const WaterSituation& situation, Real time) const
{
  const Real above = total(x, situation, time);  // once: it takes longer than the water
  if (!situation.is_given()) return above;
  const Real pressure = water_pressure(water_, situation, x, time);
  return above - (is_known_ ? std::min(pressure, above) : pressure);
}

}  // namespace terp
