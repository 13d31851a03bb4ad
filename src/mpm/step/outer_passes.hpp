// What acts on the soil from outside in a step: footings, loads, weight that is held, water.
// Not for: what carries them (loads, placed_bodies, nodal_water), nor their forces (cell_passes, node_passes).
#pragma once

#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <cmath>

namespace terp {

/// Puts the footings where they are in the coming step. While the soil settles before t = 0 there are none.
inline void place_footings(const StepModel& model, const StepState& state, Workspace& work)
{
  work.footings.clear();
  if (work.settling) return;
  for (const Footing& footing : model.footings)
    work.footings.push_back(place_footing(footing, state.time, model.dt, outline_slack(*model.mesh)));
}

/// Step before which the points of bodies that the stage digs away are taken out.
inline std::int64_t step_of_removal(const StepModel& model, const StepState& state)
{
  return state.stage_start + std::llround(model.ramp.duration / model.dt);
}

/// Which part of the weight of the points of bodies that come or go is held in the coming step: that in its middle.
inline void set_held_shares(const StepModel& model, const StepState& state, Workspace& work)
{
  work.held = {};
  if (model.held_row < 0 || work.settling) return;
  const Real let_go = model.ramp.share_at(state.time + 0.5 * model.dt);
  if (model.places_bodies) work.held.placed = 1.0 - let_go;
  if (model.removes_bodies && state.step < step_of_removal(model, state)) work.held.removed = let_go;
}

/// Says which loads act in the coming step, and with which pressure: that in the middle of the step.
inline void set_load_pressures(const StepModel& model, const StepState& state, Workspace& work)
{
  const Real time = state.time + 0.5 * model.dt;
  bool acts = false;
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    const Load& load = model.loads[k];
    const bool waits = work.settling && !load.is_permanent();
    work.load_pressure[k] = waits ? 0.0 : model.pressure_of(load, time);
    acts |= work.load_pressure[k] != 0.0;
  }
  set_held_shares(model, state, work);
  work.outer[outer_load].acts = acts || work.held.act() || model.body_force;
}

/// Water of the time of the step, or of the stage, under the gravity and the loads of the step; set anew only where any
/// of these changes.
inline void set_water(const StepModel& model, const StepState& state, Workspace& work)
{
  const Real share = model.ramp.share_at(state.time + 0.5 * model.dt);
  const WaterMoment moment =
      model.water->moment_at(model.stage.water, state.time, share, -work.gravity[1], model.held_row >= 0);
  if (moment == work.water_moment && work.load_pressure == work.water_loads) return;
  model.water->set(moment, work.load_pressure, share, work.pore);
  work.water_moment = moment;
  work.water_loads = work.load_pressure;
}

}  // namespace terp
