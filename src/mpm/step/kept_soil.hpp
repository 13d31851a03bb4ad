// The soil and what the update of its stress reads beside it, kept to begin again from there.
// Not for: checkpoints, which hold a whole run (run/report/state_image.hpp).
#pragma once

#include "mpm/step/step_state.hpp"

#include <memory>

namespace terp {

struct StepModel;
struct Workspace;

class KeptSoil {
 public:
  KeptSoil();
  ~KeptSoil();

  /// After find_forces of this state. The points may not go to other cells until it is put back.
  void keep(const StepModel& model, const StepState& state, const Workspace& work);
  void put_back(StepState& state, Workspace& work) const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace terp
