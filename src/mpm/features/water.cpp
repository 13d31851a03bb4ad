#include "mpm/features/water.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/features/loads.hpp"
#include "mpm/step/state_arrays.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>

namespace terp {
namespace {

void fit_water(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.water) return work.with.water.clear();
  work.with.water.made().loads.reserve(load_pressures(work).size());
  work.outer[outer_water].acts = true;
  fit_outer(model, state, work.outer[outer_water]);
}

void save_array(const ArrayWriter& arrays, const char* name, const CarriedWater& carried)
{
  ArrayWriter below = arrays.below(name);
  below.refer("share", carried.share);
  below.refer("table", carried.table);
  below.refer("ground", carried.ground);
  below.refer("mass", carried.mass);
  below.refer("head", carried.head);
}

CarriedWater read_array(const ArrayReader& arrays, const char* name)
{
  const ArrayReader below = arrays.below(name);
  CarriedWater carried{.share = below.reals("share")};
  const std::size_t n = carried.share.size();
  carried.table = below.reals("table", n);
  carried.ground = below.reals("ground", n);
  carried.mass = below.reals("mass", n);
  if (below.has("head")) carried.head = below.reals("head");  // a checkpoint of before has none
  return carried;
}

void save_water(const StepState& state, ArrayWriter& all)
{
  if (!state.with.water || state.with.water->places.empty()) return;
  const WaterState& water = *state.with.water;
  ArrayWriter arrays = all.below("water");
  arrays.copy("looks", std::vector<std::int64_t>{water.looked, water.next});
  arrays.copy("way", std::vector<Real>{water.way});
  arrays.refer("places", water.places);
  arrays.refer("ground_at_start", water.ground);
  save_array(arrays, "before", water.before);
  save_array(arrays, "last", water.last);
}

void load_water(const StepModel&, const ArrayReader& all, StepState& state)
{
  const ArrayReader arrays = all.below("water");
  if (!arrays.has("looks")) return;  // of a run that had no such water
  WaterState water;
  const std::vector<std::int64_t>& looks = arrays.wholes("looks", 2);
  water.looked = looks[0], water.next = looks[1];
  if (arrays.has("way")) water.way = arrays.reals("way", 1)[0];
  water.places = arrays.reals("places", state.x_initial.size());
  water.ground = arrays.reals("ground_at_start");
  water.before = read_array(arrays, "before");
  water.last = read_array(arrays, "last");
  state.with.water.set(std::move(water));
}

}  // namespace

const WaterState* carried_water(const StepState& state)
{
  const bool any = state.with.water && !(state.with.water->before.is_empty() && state.with.water->last.is_empty());
  return any ? state.with.water.get() : nullptr;
}

void set_water(const StepModel& model, const StepState& state, Workspace& work)
{
  WaterScratch& water = *work.with.water;
  const Real share = model.ramp.share_at(state.time + 0.5 * model.dt);
  const bool holds_bodies = model.with.bodies != nullptr;
  const WaterMoment moment =
      model.with.water->moment_at(model.stage.water, state.time, share, -work.gravity[1], holds_bodies);
  const std::span<const Real> loads = load_pressures(work);
  const WaterState* carried = carried_water(state);
  const bool anew = !(moment == water.moment && std::ranges::equal(loads, water.loads));
  if (carried == nullptr && !anew) return;
  model.with.water->set(moment, loads, share, carried, state.step, anew, water.pore);
  water.moment = moment;
  water.loads.assign(loads.begin(), loads.end());
}

std::span<const Real> node_pressures(const Workspace& work)
{
  if (!work.with.water) return {};
  return work.with.water->pore.pressure;
}

void forget_water(Workspace& work)
{
  if (work.with.water) work.with.water->moment.time = std::numeric_limits<Real>::quiet_NaN();
}

TERP_FEATURE_DEFINITION(water, .fit = &fit_water, .save = &save_water, .load = &load_water)

}  // namespace terp
