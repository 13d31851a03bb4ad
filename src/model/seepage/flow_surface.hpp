// The surface of the soil, by what stands on it: free water, air, the ends of the section, the base.
// Not for: what the conditions are (computed_water.hpp).
#pragma once

#include "model/bodies/body_outline.hpp"
#include "model/seepage/flow_soil.hpp"

#include <functional>
#include <span>
#include <vector>

namespace terp {

enum class EdgeKind { ground, left, right, base };

/// A straight piece of the surface of the soil.
struct SoilEdge {
  Vec<2> a, b;    ///< [m]
  Vec<2> normal;  ///< outwards
  EdgeKind kind;
  bool is_open;  ///< to air or free water: the ground, and an end of the soil that is not the end of the mesh
};

/// The surface of all outlines together, within the mesh. Left and right: at the ends of the soil; base: below it is
/// nothing, and soil above; ground: all else. No piece goes across a wall.
std::vector<SoilEdge> surface_of(
    const Mesh<2>& mesh, std::span<const BodyOutline> bodies, std::span<const Side> walls = {});

/// The piece of an edge from the share s to the share t of its way.
SoilEdge part_of(const SoilEdge& edge, Real s, Real t);

/// What holds on an edge. head: of a seepage face none.
struct EdgeCondition {
  FlowCondition condition = FlowCondition::seep;
  Real head = 0.0;            ///< [m]
  Real leakage_length = 0.0;  ///< [m]
  Index part = 0;
};

/// Adds the places of an edge in the cells that it runs through. An edge along cells belongs to that of the soil.
void add_places(const Mesh<2>& mesh, const SoilEdge& edge, const EdgeCondition& of, std::vector<SurfacePlace>& places);

}  // namespace terp
