// What a step reads, and no step changes.
// Not for: the case that it was made from (model.hpp).
#pragma once

#include "mpm/features/slots.hpp"
#include "mpm/kernels/damping.hpp"
#include "mpm/mesh/mesh.hpp"
#include "mpm/points/soil_material.hpp"
#include "mpm/schemes/scheme.hpp"
#include "mpm/step/stage.hpp"

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;

/// One step (kernels.hpp).
using StepFunction = void (*)(const StepModel&, StepState&, Workspace&);

struct StepModel {
  SharedMesh mesh;  ///< one for all runs of a study
  std::vector<SoilMaterial> materials;
  MethodOptions method;
  Vec<2> gravity{0.0, 0.0};         ///< [m/s^2]
  Vec<2> gravity_before{0.0, 0.0};  ///< from which the ramp of the stage starts [m/s^2]
  Real at_strength_before = 1.0;    ///< at which strengths are at its start, over that of the laws [-]
  Damping damping;
  const Scheme* scheme = nullptr;
  StepFunction step = nullptr;                           ///< of the same copy of the kernels as the laws and the scheme
  StepFunction find_forces = nullptr, strain = nullptr;  ///< halves of a step without motion (kernels.hpp)
  Real dt = 0.0;                                         ///< [s]; end time over a whole number of steps
  std::int64_t n_steps = 0;                              ///< at most, of all stages
  std::int64_t first_step = 0;  ///< step of first_time: not 0 where the run began in another time step
  Real first_time = 0.0;        ///< [s]
  Stage stage;                  ///< that the model is of
  Ramp ramp;                    ///< from the values of the stage before
  Real largest_density = 0.0;   ///< [kg/m^3], for the small-mass limit
  RowTable rows;                ///< what a point carries
  int threads = 1;
  ModelSlots with = {};  ///< the features

  Real time_of(std::int64_t step_number) const { return first_time + static_cast<Real>(step_number - first_step) * dt; }
  Vec<2> gravity_at(Real time) const
  {
    const Real share = ramp.share_at(time);
    if (!(share < 1.0)) return gravity;
    return {gravity_before[0] + share * (gravity[0] - gravity_before[0]),
        gravity_before[1] + share * (gravity[1] - gravity_before[1])};
  }
  /// Strengths go from those before to those of the laws linearly: 1 / at = (1 - share) / before + share.
  Real at_strength(Real time) const
  {
    const Real share = at_strength_before == 1.0 ? 1.0 : ramp.share_at(time);
    return share < 1.0 ? at_strength_before / (1.0 + share * (at_strength_before - 1.0)) : 1.0;
  }
};

}  // namespace terp
