// What a step reads, and no step changes.
// Not for: the case that it was made from (model.hpp).
#pragma once

#include "mpm/features/conditions.hpp"
#include "mpm/features/footing.hpp"
#include "mpm/features/load.hpp"
#include "mpm/kernels/damping.hpp"
#include "mpm/points/move.hpp"
#include "mpm/schemes/scheme.hpp"
#include "mpm/step/stage.hpp"
#include "mpm/step/step_water.hpp"

namespace terp {

struct NodeDiffusion;
struct StepModel;
struct StepState;
struct Workspace;

/// One step (kernels.hpp).
using StepFunction = void (*)(const StepModel&, StepState&, Workspace&);

struct StepModel {
  SharedMesh mesh;  ///< one for all runs of a study
  std::vector<SoilMaterial> materials;
  MethodOptions method;
  Boundary boundary;
  OpenSides open_sides;  ///< sides that soil may leave by, shape [n_cells]
  std::vector<Footing> footings;
  std::vector<Load> loads;
  BodyForce body_force;             ///< beside gravity; empty: none
  Vec<2> gravity{0.0, 0.0};         ///< [m/s^2]
  Vec<2> gravity_before{0.0, 0.0};  ///< from which the ramp of the stage starts [m/s^2]
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
  std::shared_ptr<const NodeDiffusion> diffusion = {};  ///< of nonlocal softening; nullptr: without
  int inverse_extent = -1;                              ///< row of the points, with shares that overlap
  int slip_row = -1;  ///< of the points: plastic work of the last step, where soils slip in cut cells; -1: they do not
  /// Row of the points: whose weight is held (placed_bodies.hpp); -1: no stage places or removes bodies.
  int held_row = -1;
  bool places_bodies = false, removes_bodies = false;  ///< in the stage
  std::shared_ptr<const StepWater> water = {};         ///< pore pressure on the nodes; nullptr: no water
  int threads = 1;

  Real time_of(std::int64_t step_number) const { return first_time + static_cast<Real>(step_number - first_step) * dt; }
  Vec<2> gravity_at(Real time) const
  {
    const Real share = ramp.share_at(time);
    if (!(share < 1.0)) return gravity;
    return {gravity_before[0] + share * (gravity[0] - gravity_before[0]),
        gravity_before[1] + share * (gravity[1] - gravity_before[1])};
  }
  Real pressure_of(const Load& load, Real time) const { return load.pressure_at(time, ramp.share_at(time)); }
  bool spreads_softening() const { return diffusion != nullptr; }
  bool slips_in_cut_cells() const { return slip_row >= 0; }
  /// Of schemes that integrate at Gauss points.
  bool hands_back_transposed() const
  {
    return method.strain_shares == StrainShares::transposed && looks_at(*scheme, "strain_shares");
  }
  bool takes_volume_change_of_soil() const
  {
    return method.volume_change == VolumeChange::soil && looks_at(*scheme, "volume_change");
  }
  bool balances_pressure() const { return method.pressure == Pressure::balanced && looks_at(*scheme, "pressure"); }
  /// Whether forces from outside beside gravity and water may act: loads, bodies that come or go, forces.body.
  bool has_loads() const { return !loads.empty() || held_row >= 0 || body_force; }
  bool has_excess_pressure() const
  {
    return std::ranges::any_of(materials, [](const SoilMaterial& m) { return m.excess_row >= 0; });
  }
};

}  // namespace terp
