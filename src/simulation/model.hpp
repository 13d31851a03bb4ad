// What never changes during a run.
#pragma once

#include "boundary/conditions.hpp"
#include "boundary/footing.hpp"
#include "boundary/load.hpp"
#include "forces/damping.hpp"
#include "points/move.hpp"
#include "points/seed.hpp"
#include "schemes/scheme.hpp"
#include "simulation/case.hpp"
#include "simulation/flood_level.hpp"
#include "simulation/follower.hpp"
#include "simulation/stage.hpp"
#include "transfer/node_diffusion.hpp"

#include <map>

namespace terp {

/// What came of a body at t = 0.
struct BodyShare {
  std::string material;  ///< name; of a file of points the names of all, "sand + clay"
  std::int64_t n_points = 0;
  Real area = 0.0;          ///< of its points [m^2]
  Real mass = 0.0;          ///< [kg per m]
  Real fullest_cell = 1.0;  ///< of a file of points: largest share of a cell's area that its points fill [-]
};

struct Model;
struct State;
struct Workspace;
class NodalWater;

/// One step (step.hpp).
using StepFunction = void (*)(const Model&, State&, Workspace&);

struct Model {
  Case description;                             ///< as the user gave it; of a stage with its changes
  std::shared_ptr<const Case> whole = nullptr;  ///< without the changes of any stage; none: the run has no stages
  SharedMesh mesh;                              ///< one for all runs of a study
  std::vector<SoilMaterial> materials;
  MethodOptions method;
  Boundary boundary;
  OpenSides open_sides;  ///< sides that soil may leave by, shape [n_cells]
  std::vector<Footing> footings;
  std::vector<Load> loads;
  Vec<2> gravity{0.0, 0.0};         ///< [m/s^2]
  Vec<2> gravity_before{0.0, 0.0};  ///< from which the ramp of the stage starts [m/s^2]
  Damping damping;
  const Scheme* scheme = nullptr;
  StepFunction step = nullptr;            ///< of the same copy of the kernels as the laws and the scheme
  Real dt = 0.0;                          ///< [s]; end time over a whole number of steps
  std::int64_t n_steps = 0;               ///< at most, of all stages
  std::int64_t first_step = 0;            ///< step of first_time: not 0 where the run began in another time step
  Real first_time = 0.0;                  ///< [s]
  Stage stage;                            ///< that the model is of
  Ramp ramp;                              ///< from the values of the stage before
  Real largest_density = 0.0;             ///< [kg/m^3], for the small-mass limit
  std::vector<std::int64_t> history_ids;  ///< ids of the named points, in the order of the case
  std::vector<BodyShare> bodies;          ///< in the order of the case; filled with the first state
  RowTable rows;                          ///< what a point carries
  NodeDiffusion diffusion;                ///< of nonlocal softening; empty without
  int inverse_extent = -1;                ///< row of the points, with shares that overlap
  int slip_row = -1;  ///< of the points: plastic work of the last step, where soils slip in cut cells; -1: they do not
  std::shared_ptr<const Overburden> ground = {};  ///< of the run at t = 0, where a parameter varies; nullptr: none
  /// The same in each stage that places bodies, by its number; empty: parameters do not vary, or no stage does.
  std::map<StageNumber, std::shared_ptr<const Overburden>> later_ground = {};
  /// Row of the points: whose weight is held (placed_bodies.hpp); -1: no stage places or removes bodies.
  int held_row = -1;
  std::shared_ptr<const NodalWater> water = {};  ///< pore pressure on the nodes; nullptr: no water
  FloodLevel flood_level = {};                   ///< of the whole run
  int threads = 1;
  FollowerTypes followers = {};  ///< what is measured while the run goes on; may be none

  /// What lay above the points of a body when it came: parameters that vary follow from that.
  const Overburden* ground_with(Index body) const
  {
    const StageNumber stage = later_ground.empty() ? 0 : description.bodies[static_cast<std::size_t>(body)].placed;
    return stage == 0 ? ground.get() : later_ground.at(stage).get();
  }
  Real time_of(std::int64_t step_number) const { return first_time + static_cast<Real>(step_number - first_step) * dt; }
  Vec<2> gravity_at(Real time) const
  {
    const Real share = ramp.share_at(time);
    if (!(share < 1.0)) return gravity;
    return {gravity_before[0] + share * (gravity[0] - gravity_before[0]),
        gravity_before[1] + share * (gravity[1] - gravity_before[1])};
  }
  Real pressure_of(const Load& load, Real time) const { return load.pressure_at(time, ramp.share_at(time)); }
  bool spreads_softening() const { return diffusion.n_substeps > 0; }
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
  bool has_loads() const { return !loads.empty() || held_row >= 0 || description.forces.body.at; }
  bool has_excess_pressure() const
  {
    return std::ranges::any_of(materials, [](const SoilMaterial& m) { return m.excess_row >= 0; });
  }
};

}  // namespace terp
