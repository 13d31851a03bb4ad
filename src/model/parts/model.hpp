// What never changes during a run, and what the models of its stages are made from.
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

/// What lay above the points of a body when it came: parameters that vary follow from that. Nothing where none varies.
struct Grounds {
  std::shared_ptr<const Overburden> first = nullptr;                     ///< at t = 0
  std::map<StageNumber, std::shared_ptr<const Overburden>> placed = {};  ///< in each stage that places bodies

  const Overburden* of(const BodyCase& body) const
  {
    return body.placed == 0 || placed.empty() ? first.get() : placed.at(body.placed).get();
  }
};

/// The soils of a stage, before there is a model of it.
struct Soils {
  Case description;  ///< as it is solved: strengths divided, means of fields as the values of parameters
  std::vector<SoilMaterial> materials;
  RowTable rows;  ///< of the laws
};

/// What all stages of a run are made from; each part from those above it.
struct Parts {
  std::shared_ptr<const Case> whole;  ///< without the changes of any stage
  SharedMesh mesh;
  std::vector<Index> used;  ///< numbers of the materials that points may have in any stage
  Grounds grounds;
  std::vector<Soils> soils;    ///< by stage; a run without stages has one
  Real dt = 0.0;               ///< [s]
  std::int64_t n_steps = 0;    ///< at most
  Real largest_density = 0.0;  ///< [kg/m^3]
};

/// A model with what it was made from.
struct Model : StepModel {
  std::shared_ptr<const Parts> parts;
  Case description;                                    ///< as the user gave it; of a stage with its changes
  std::vector<std::int64_t> history_ids;               ///< ids of the named points, in the order of the case
  std::vector<BodyShare> bodies;                       ///< in the order of the case; filled with the first state
  std::shared_ptr<const NodalWater> nodal_water = {};  ///< that `water` is
  FloodLevel flood_level = {};                         ///< of the whole run
  std::vector<const FollowerType*> followers = {};     ///< what is measured while the run goes on; may be none

  /// Without the changes of any stage.
  const Case& whole() const { return description.stages.empty() ? description : *parts->whole; }
  /// At t = 0; nullptr: no parameter varies.
  const Overburden* ground() const { return parts->grounds.first.get(); }
};

/// What is drawn of a stage: of a model, or before there is one.
struct StageSoil {
  const Case& description;
  const SharedMesh& mesh;
  const std::vector<SoilMaterial>& materials;
  const Grounds& grounds;

  StageSoil(const Model& model)
      : description(model.description), mesh(model.mesh), materials(model.materials), grounds(model.parts->grounds)
  {
  }
  StageSoil(const Parts& parts, const Soils& soils)
      : description(soils.description), mesh(parts.mesh), materials(soils.materials), grounds(parts.grounds)
  {
  }
};

}  // namespace terp
