// One explicit step, and its halves without motion: each plays a score (score.def).

#include "mpm/step/kernels.hpp"

#include "mpm/step/walks.hpp"

namespace terp {
namespace {

void play(ScoreOf of, const StepModel& model, StepState& state, Workspace& work)
{
  const Score& score = score_now(of, model, work);
  StepNow now{model, state, work, score, {.method = model.method, .materials = model.materials}};
  Clock clock(work);
  for (int k = 0; k < score.n_walks; ++k) {
    clock.go_on(score.walks[k].pass);
    walk(now, score.walks[k]);
  }
}

}  // namespace

void step_compiled(const StepModel& model, StepState& state, Workspace& work) { play(in_step, model, state, work); }

void find_forces_compiled(const StepModel& model, StepState& state, Workspace& work)
{
  play(in_forces, model, state, work);
}

void strain_compiled(const StepModel& model, StepState& state, Workspace& work) { play(in_strain, model, state, work); }

}  // namespace terp
