// The vertical line through a place is cut by the sides of all bodies and followed from the highest crossing down. Each
// crossing turns its body on or off; of the bodies that are on, the last one of the case counts.

#include "model/soils/overburden.hpp"

#include "model/bodies/setup_points.hpp"
#include "mpm/features/loads.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>

namespace terp {
namespace {

/// Where the vertical line through a place enters or leaves a body above it.
struct Crossing {
  Real y;  ///< [m]
  std::size_t body;
};

}  // namespace

Overburden::Overburden(const Model& model, Real gravity)
    : Overburden(model, gravity, [](const BodyCase& body) { return body.is_there; })
{
}

Overburden Overburden::before_stage(const Model& model)
{
  const StageNumber now = model.stage.number + 1;
  return Overburden(model, -model.gravity[1],
      [now](const BodyCase& body) { return body.removed == now || (body.is_there && body.placed != now); });
}

Overburden::Overburden(const Model& model, Real gravity, const IsThere& is_there)
    : water_(model.description.water), gravity_(gravity)
{
  for (const Load& load : loads_of(model))
    if (load.is_permanent()) loads_.push_back({load.from, load.to, pressure_of(model, load, 0.0)});
  const std::vector<BodyOutline> outlines = outlines_of(model);
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const BodyCase& body = model.description.bodies[b];
    if (!is_there(body)) continue;
    if (!body.points_file.empty()) {
      is_known_ = false;
      continue;
    }
    const auto density = [&](Zone zone) {
      return model.materials[material_number(model, body.material, zone)].density;
    };
    drawn_.push_back({outline_sides(*model.mesh, outlines[b]), density(Zone::below), density(Zone::above)});
  }
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
  std::vector<Crossing> above;
  for (std::size_t b = 0; b < drawn_.size(); ++b)
    for (const Real y : crossings_of_vertical(drawn_[b].sides, x[0]))
      if (y > x[1]) above.push_back({y, b});
  std::ranges::sort(above, [](const Crossing& a, const Crossing& b) { return a.y > b.y; });
  std::vector<char> is_there(drawn_.size(), 0);  // going down
  Real mass = 0.0;
  for (std::size_t k = 0; k < above.size(); ++k) {
    is_there[above[k].body] ^= 1;
    const auto top = std::find(is_there.rbegin(), is_there.rend(), 1);
    if (top == is_there.rend()) continue;
    const Real below = k + 1 < above.size() ? above[k + 1].y : x[1];
    mass += mass_between(drawn_[static_cast<std::size_t>(is_there.rend() - top) - 1], x[0], below, above[k].y);
  }
  return mass;
}

std::optional<Real> Overburden::ground(Real x) const
{
  std::optional<Real> highest;
  for (const DrawnBody& body : drawn_)
    for (const Real y : crossings_of_vertical(body.sides, x)) highest = std::max(highest.value_or(y), y);
  return highest;
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
