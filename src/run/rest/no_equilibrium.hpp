// What is said when the search for equilibrium finds none: where, and what to do. Not for: the search itself
// (equilibrium.hpp).
#pragma once

#include "math/errors.hpp"
#include "run/loop/state.hpp"

namespace terp {

struct Workspace;

/// The soil cannot stand in the section as it is drawn, and slides before the run begins. Not thrown where a search
/// only ran out of steps: then nothing is known.
class SlidesAsDrawn : public RunError {
 public:
  using RunError::RunError;
};

/// The soil runs away in the search: a hundredth of it had moved further than `moved` [m]. stiffening: of the model.
std::string describe_failure(const Model& model, const State& state, Real moved, Real stiffening);

/// After all steps the soil is not at rest; `work` is that of the last one.
std::string describe_no_equilibrium(const Model& model, const State& state, const Workspace& work, Real stiffening);

}  // namespace terp
