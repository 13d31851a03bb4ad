// Bodies that a stage places or digs away. A body comes without stress and weight, so that it changes nothing at first;
// over the ramp of the stage its weight is let go. One that goes loses its weight over the ramp, then its points are
// taken out. What holds the weight meanwhile is a force from outside. docs/stages.md, decision 0051.
// Not for: how a stage names them (io/case), nor which are there (BodyCase).
#pragma once

#include "model/bodies/setup_points.hpp"
#include "run/loop/state.hpp"

namespace terp {

/// At the start of a stage: adds the points of bodies that the model has and the state has not, at rest and without
/// effective stress, and marks those of bodies that the model has not. Throws RunError where soil has moved to the
/// place of a body.
void change_bodies(const Model& model, const Seeds& seeds, State& state);

/// Takes the marked points out; their energy leaves the balance, too.
void remove_held_bodies(const Model& model, State& state);

/// The same before the step at which their weight is gone. True: there were some.
bool remove_due_bodies(const Model& model, State& state);

}  // namespace terp
