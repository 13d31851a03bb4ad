// Each field is a closure that owns its lines and names, so it may outlive what it was read from. NaN means that there
// is no value at a place; a lower limit of SHANSEP that is NaN leaves no strength either. Stress is asked for by the
// name of a situation. It is looked up when a value is asked for, since fields are made while the case is still being
// read.

#include "model/soils/soil_fields.hpp"

#include "math/errors.hpp"
#include "math/interpolate.hpp"
#include "math/nan.hpp"
#include "model/soils/overburden.hpp"
#include "model/water/water_pressure.hpp"

#include <cmath>

namespace terp {
namespace {

/// Effective vertical stress at a place in the water of that name [Pa].
Real effective_stress(const PlaceInSoil& at, const std::string& water)
{
  TERP_ASSERT(at.ground != nullptr);
  const WaterCase& all = at.ground->water();
  const WaterSituation& situation = situation_of(all, situation_number(all, water));
  return at.ground->effective(at.x, situation, std::isnan(situation.time) ? 0.0 : situation.time);
}

}  // namespace

FieldValue depth_below_ground()
{
  return [](const PlaceInSoil& at) {
    TERP_ASSERT(at.ground != nullptr);
    const std::optional<Real> ground = at.ground->ground(at.x[0]);
    return ground ? *ground - at.x[1] : nan;
  };
}

FieldValue elevation_in_soil()
{
  return [](const PlaceInSoil& at) { return at.x[1]; };
}

FieldValue vertical_stress(std::string water)
{
  return [water = std::move(water)](const PlaceInSoil& at) { return effective_stress(at, water); };
}

FieldValue by_line(std::vector<Vec<2>> line, FieldValue argument)
{
  return [line = std::move(line), argument = std::move(argument)](const PlaceInSoil& at) {
    const Real here = argument(at);
    return std::isnan(here) ? nan : interpolate(line, here);
  };
}

FieldValue by_map(ValueMap map)
{
  return [map = std::move(map)](const PlaceInSoil& at) { return map.at(at.x); };
}

FieldValue yield_stress_of(const Shansep& soil)
{
  if (soil.yield_stress && soil.pop)
    return [soil](const PlaceInSoil& at) { return soil.yield_stress(at) + soil.pop(at); };
  if (soil.yield_stress) return soil.yield_stress;
  return [soil](const PlaceInSoil& at) {
    const Real daily = effective_stress(at, soil.daily);
    return soil.ocr ? soil.ocr(at) * daily : daily + soil.pop(at);
  };
}

FieldValue by_shansep(const Shansep& soil)
{
  return [soil, yield_stress = yield_stress_of(soil)](const PlaceInSoil& at) {
    const Real now = effective_stress(at, soil.water), yield = yield_stress(at);
    const Real m = soil.m(at), strength = soil.S(at) * std::pow(now, 1.0 - m) * std::pow(yield, m);
    const Real least = soil.minimum ? soil.minimum(at) : 0.0;
    return strength < least || std::isnan(least) ? least : strength;
  };
}

FieldValue within(Range range, FieldValue value)
{
  return [range, value = std::move(value)](const PlaceInSoil& at) {
    const Real found = value(at);
    return range.contains(found) ? found : nan;
  };
}

}  // namespace terp
