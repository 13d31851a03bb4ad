// The first material points of a case: seeded bodies and points from files.
#pragma once

#include "model/bodies/seed.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

#include <functional>

namespace terp {

/// A material point at t = 0.
struct NewPoint {
  Vec<2> x;      ///< [m]
  Vec<2> local;  ///< xi, eta in its cell
  Vec<2> v;      ///< [m/s]
  Real volume;   ///< [m^2]
  BlockKey key;  ///< of the block that it goes to
  Index body;    ///< number of its [[body]] in the case
};

/// Points in batches that can be dropped one by one.
using PointBatches = std::vector<std::vector<NewPoint>>;

/// All points, in the order of their ids, also of bodies that are not there in the stage of the model: first those of
/// the start, then those of each stage that places some. Throws InputError.
PointBatches make_points(const StageSoil& soil);

/// Body and place of each point as it is seeded, by id, the same in all stages. Displacement may be counted from later
/// places.
struct Seeds {
  std::vector<Index> bodies;
  std::vector<Real> places;  ///< [m], shape [n, 2]

  bool operator==(const Seeds&) const = default;
};

Seeds seeds_of(const PointBatches& points);

/// How points, area and mass are shared among the bodies.
std::vector<BodyShare> shares_of_bodies(const Model& model, const PointBatches& points);

/// By number of the body; empty for those that come as points.
std::vector<BodyOutline> outlines_of(const Case& c, const Mesh<2>& mesh);
inline std::vector<BodyOutline> outlines_of(const StageSoil& soil) { return outlines_of(soil.description, *soil.mesh); }

/// Keys that say where a body and where the mesh is: for problems of the one in the other.
std::vector<std::string> keys_of_outline(std::size_t body);

/// Number of a material by the name that bodies use; of a soil in two parts that of a zone, of Zone::all the first.
/// Throws InputError.
Index material_number(const StageSoil& soil, const std::string& name, Zone zone = Zone::all);

/// Adds the points of the bodies for which `wanted` is true; ids count all points. Each batch is dropped when it is in:
/// points and blocks together would be the most that a run ever holds.
void add_points(
    const Model& model, PointBatches points, const std::function<bool(const BodyCase&)>& wanted, StepState& state);

}  // namespace terp
