// What never changes during a run.
#pragma once

#include "model/bodies/seed.hpp"
#include "model/case/case.hpp"
#include "model/ground/flood_level.hpp"
#include "mpm/step/step_model.hpp"

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

class NodalWater;
struct FollowerType;

/// A model with what it was made from.
struct Model : StepModel {
  Case description;                               ///< as the user gave it; of a stage with its changes
  std::shared_ptr<const Case> whole = nullptr;    ///< without the changes of any stage; none: the run has no stages
  std::vector<std::int64_t> history_ids;          ///< ids of the named points, in the order of the case
  std::vector<BodyShare> bodies;                  ///< in the order of the case; filled with the first state
  std::shared_ptr<const Overburden> ground = {};  ///< of the run at t = 0, where a parameter varies; nullptr: none
  /// The same in each stage that places bodies, by its number; empty: parameters do not vary, or no stage does.
  std::map<StageNumber, std::shared_ptr<const Overburden>> later_ground = {};
  std::shared_ptr<const NodalWater> nodal_water = {};  ///< that `water` is
  FloodLevel flood_level = {};                         ///< of the whole run
  std::vector<const FollowerType*> followers = {};     ///< what is measured while the run goes on; may be none

  /// What lay above the points of a body when it came: parameters that vary follow from that.
  const Overburden* ground_with(Index body) const
  {
    const StageNumber stage = later_ground.empty() ? 0 : description.bodies[static_cast<std::size_t>(body)].placed;
    return stage == 0 ? ground.get() : later_ground.at(stage).get();
  }
};

}  // namespace terp
