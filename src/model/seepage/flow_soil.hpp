// Where water flows: places of the soil in the cells of the background mesh, and of the surface of the soil in them.
// Not for: what stands around the soil (flow_surface.hpp), nor the equations (free_surface.hpp).
#pragma once

#include "model/bodies/body_outline.hpp"
#include "model/seepage/permeability.hpp"
#include "mpm/mesh/mesh.hpp"

#include <optional>
#include <span>
#include <vector>

namespace terp {

/// A place of the quadrature of the soil.
struct FlowPlace {
  Index cell;
  Vec<2> x;     ///< [m]
  Real weight;  ///< [m^2]
  Permeability k;
  Storage storage = {};
  bool is_soil = true;  ///< false: the empty part of a cut cell, which carries its nodes
  Quad4::PerCorner<Real> shape = {};
  Quad4::PerCorner<Vec<2>> gradient = {};  ///< [1/m]
};

enum class FlowCondition {
  head,  ///< h = head
  leak,  ///< the layer goes on: q_n = k (h - head)/leakage length
  seep   ///< p <= 0, and water comes out where p = 0
};

/// A place of the quadrature of the surface of the soil where water may pass.
struct SurfacePlace {
  Index cell;
  Vec<2> x, normal;  ///< place [m] and unit normal, outwards
  Real weight;       ///< [m]
  FlowCondition condition;
  Real head;            ///< [m]; of a seepage face the elevation
  Real leakage_length;  ///< of a leak [m]
  Index part;           ///< number of the condition that it belongs to
  Quad4::PerCorner<Real> shape = {};
  Quad4::PerCorner<Real> flux = {};  ///< q_n of unit heads at the corners, saturated [1/s]
  Real penalty = 0.0;                ///< k_n over a length [1/s]
};

struct FlowSoil {
  std::vector<FlowPlace> places;
  std::vector<SurfacePlace> surface;
  Real height = 0.0;  ///< of the soil [m]
};

/// A soil as the flow sees it.
struct FlowMaterial {
  Permeability k;
  Storage storage = {};
};

/// The soil of outlines, the last one on top; materials: by outline. Cells that outlines cut are cut exactly. Soils
/// that share a cell and differ by more than ten have one permeability there: that of layers with a border along the
/// cell, else that of layers in series in every direction. surface: conditions with place, normal, weight and cell.
/// is_fine: whole cells have 4 x 4 places, as what soil stores over a band narrower than a cell needs.
FlowSoil make_flow_soil(const Mesh<2>& mesh, std::span<const BodyOutline> bodies,
    std::span<const FlowMaterial> materials, std::vector<SurfacePlace> surface, bool is_fine = false);

/// The four places of Gauss in a cell; like: the rest of them.
void add_gauss_places(const Mesh<2>& mesh, Index cell, const FlowPlace& like, FlowSoil& soil);

/// What follows from places and permeabilities: shapes, the empty parts of cut cells, fluxes and penalties.
void complete_flow_soil(const Mesh<2>& mesh, FlowSoil& soil);

/// Heads at the nodes, interpolated [m]; none outside the mesh.
std::optional<Real> head_at(const Mesh<2>& mesh, std::span<const Real> heads, Vec<2> x);

}  // namespace terp
