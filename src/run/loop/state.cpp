#include "run/loop/state.hpp"

#include "model/parts/setup.hpp"

namespace terp {

State build_state(Model& model)
{
  State state;
  static_cast<StepState&>(state) = seed_soil(model);
  start_followers(model, state);
  return state;
}

}  // namespace terp
