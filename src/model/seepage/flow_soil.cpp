// A cell of one soil has the four places of Gauss. A cell that outlines cut has those of a lattice of 3 x 3 parts, each
// cut exactly. The empty part of a cut cell has a thousandth of the permeability of its soil, so that nodes with next
// to no soil are held.

#include "model/seepage/flow_soil.hpp"

#include "math/plane.hpp"
#include "model/bodies/cut_cell.hpp"
#include "model/bodies/drawing.hpp"
#include "mpm/mesh/locate.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real of_empty_part = 1e-3;  // permeability of the empty part of a cell over that of its soil
constexpr Real mixes_from = 10.0;     // ratio of permeabilities in a cell from which on they are one
constexpr Real least_part = 1e-10;    // of a cell that counts as soil
constexpr std::array<Index, 2> parts_of_cell{3, 3};

void set_shape(
    const Mesh<2>& mesh, Index cell, Vec<2> local, Quad4::PerCorner<Real>& shape, Quad4::PerCorner<Vec<2>>& gradient)
{
  const Quad4::Map& map = mesh.geometry(cell).map;
  shape = Quad4::shape_functions(local);
  const auto j = Quad4::jacobian(map, local);
  const Real det = Quad4::determinant(j);
  const auto derivatives = Quad4::shape_derivatives(local);
  for (int i = 0; i < Quad4::n_corners; ++i) {
    const auto scaled = Quad4::scaled_gradient(j, derivatives[i]);
    gradient[i] = {scaled[0] / det, scaled[1] / det};
  }
}

Vec<2> local_of(const Mesh<2>& mesh, Index cell, Vec<2> x)
{
  const Vec<2>& centre = mesh.centres[cell];
  return Quad4::local_coordinates(mesh.geometry(cell).map, Vec<2>{x[0] - centre[0], x[1] - centre[1]});
}

void add_fine_places(const Mesh<2>& mesh, Index cell, const FlowPlace& like, FlowSoil& soil)
{
  constexpr std::array at{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  constexpr std::array weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  const Quad4::Map& map = mesh.geometry(cell).map;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      FlowPlace place = like;
      place.x = place_in_cell(mesh, cell, {at[i], at[j]});
      place.weight = weight[i] * weight[j] * Quad4::determinant(Quad4::jacobian(map, Vec<2>{at[i], at[j]}));
      soil.places.push_back(place);
    }
}

/// The part of a cell that a soil has, of one body or of several.
struct CellShare {
  Permeability k;
  Real area = 0.0;
  Vec<2> moment{0.0, 0.0};
};

/// What bodies have of a cell, part by part.
std::vector<Part> parts_in(const Drawing& drawing, const Overlay& overlay, Index cell)
{
  const Lattice lattice{drawing.mesh.geometry(cell), parts_of_cell};
  const Vec<2> centre = drawing.mesh.centres[cell];
  std::vector<Part> parts;
  for (Index row = 0; row < lattice.n[1]; ++row)
    for (Index column = 0; column < lattice.n[0]; ++column)
      for (Part part : share_out(overlay, corners_of_part(lattice, {column, row}))) {
        if (part.body < 0 || !(part.area > 0.0)) continue;
        for (int d = 0; d < 2; ++d) part.centroid[d] += centre[d];
        parts.push_back(part);
      }
  return parts;
}

std::vector<CellShare> shares_of(std::span<const Part> parts, std::span<const FlowMaterial> materials)
{
  std::vector<CellShare> shares;
  for (const Part& part : parts) {
    auto share = std::ranges::find(shares, materials[part.body].k, &CellShare::k);
    if (share == shares.end()) share = shares.insert(share, CellShare{materials[part.body].k});
    share->area += part.area;
    for (int d = 0; d < 2; ++d) share->moment[d] += part.area * part.centroid[d];
  }
  return shares;
}

Real most_ratio(std::span<const CellShare> shares)
{
  Real least = std::numeric_limits<Real>::infinity(), most = 0.0;
  for (const CellShare& share : shares) {
    least = std::min({least, share.k.horizontal, share.k.vertical});
    most = std::max({most, share.k.horizontal, share.k.vertical});
  }
  return most / least;
}

struct Mixture {
  Permeability k;
  bool is_layered;  ///< of layers whose border runs along the cell: exact, whatever their ratio
};

/// Of soils in a cell: layers in series across their border and side by side along it, where the border runs along the
/// cell; else in series in every direction.
Mixture mixed(const Mesh<2>& mesh, Index cell, std::span<const CellShare> shares)
{
  Real area = 0.0;
  for (const CellShare& share : shares) area += share.area;
  Permeability series, side_by_side;
  for (const CellShare& share : shares) {
    const Real part = share.area / area;
    series.horizontal += part / share.k.horizontal, series.vertical += part / share.k.vertical;
    side_by_side.horizontal += part * share.k.horizontal, side_by_side.vertical += part * share.k.vertical;
  }
  series = {1.0 / series.horizontal, 1.0 / series.vertical};
  if (shares.size() != 2) return {series, false};
  const Quad4::Map& map = mesh.geometry(cell).map;
  const auto middle = [](const CellShare& share) {
    return Vec<2>{share.moment[0] / share.area, share.moment[1] / share.area};
  };
  const Vec<2> a = middle(shares[0]), b = middle(shares[1]), across{b[0] - a[0], b[1] - a[1]};
  const Real length = std::hypot(across[0], across[1]);
  const auto is_square_to = [&](Vec<2> axis) {  // and the axis lies along x or y
    const Real along = std::abs(across[0] * axis[0] + across[1] * axis[1]);
    return along < 1e-6 * length * std::hypot(axis[0], axis[1]) &&
           std::min(std::abs(axis[0]), std::abs(axis[1])) < 1e-6 * std::hypot(axis[0], axis[1]);
  };
  const bool has_border_along = is_square_to(map.axis_xi) || is_square_to(map.axis_eta);
  if (!map.affine || !has_border_along) return {series, false};
  const bool is_level = std::abs(across[1]) > std::abs(across[0]);
  return {is_level ? Permeability{side_by_side.horizontal, series.vertical}
                   : Permeability{series.horizontal, side_by_side.vertical},
      true};
}

void add_cell(const Drawing& drawing, Index cell, std::span<const FlowMaterial> materials, bool is_fine, FlowSoil& soil)
{
  const Overlay overlay = draw_cell(drawing, cell);
  const auto like = [&](Index body) { return FlowPlace{cell, {}, 0.0, materials[body].k, materials[body].storage}; };
  const Mesh<2>& mesh = drawing.mesh;
  const auto add_whole = [&](Index body) {
    is_fine ? add_fine_places(mesh, cell, like(body), soil) : add_gauss_places(mesh, cell, like(body), soil);
  };
  if (overlay.rings.empty()) {
    if (overlay.ground >= 0) add_whole(overlay.ground);
    return;
  }
  const std::vector<Part> parts = parts_in(drawing, overlay, cell);
  const std::vector<CellShare> shares = shares_of(parts, materials);
  const Real area = mesh.geometry(cell).volume;
  Real filled = 0.0;
  for (const CellShare& share : shares) filled += share.area;
  if (filled < least_part * area) return;
  if (shares.size() == 1 && filled > (1.0 - 1e-9) * area) return add_whole(parts[0].body);
  const Mixture mixture = shares.size() > 1 ? mixed(mesh, cell, shares) : Mixture{};
  const bool is_mixed = shares.size() > 1 && (mixture.is_layered || most_ratio(shares) > mixes_from);
  for (const Part& part : parts) {
    FlowPlace place = like(part.body);
    if (is_mixed) place.k = mixture.k;
    place.x = part.centroid;
    place.weight = part.area;
    soil.places.push_back(place);
  }
}

/// Of the soil of a cell.
struct CellSoil {
  Real area = 0.0;
  Permeability k = {};  // times the area
  Real length = 0.0;    // of its surface
};

std::vector<CellSoil> soil_of_cells(const Mesh<2>& mesh, const FlowSoil& soil)
{
  std::vector<CellSoil> cells(mesh.cells.size());
  for (const FlowPlace& place : soil.places) {
    if (!place.is_soil) continue;
    CellSoil& cell = cells[place.cell];
    cell.area += place.weight;
    cell.k.horizontal += place.weight * place.k.horizontal, cell.k.vertical += place.weight * place.k.vertical;
  }
  for (const SurfacePlace& place : soil.surface) cells[place.cell].length += place.weight;
  for (CellSoil& cell : cells)
    if (cell.area > 0.0) cell.k = {cell.k.horizontal / cell.area, cell.k.vertical / cell.area};
  return cells;
}

}  // namespace

void add_gauss_places(const Mesh<2>& mesh, Index cell, const FlowPlace& like, FlowSoil& soil)
{
  for (int g = 0; g < Quad4::n_gauss; ++g) {
    FlowPlace place = like;
    place.x = place_in_cell(mesh, cell, Quad4::gauss_place(g));
    place.weight = mesh.geometry(cell).gauss_volume[g];
    soil.places.push_back(place);
  }
}

FlowSoil make_flow_soil(const Mesh<2>& mesh, std::span<const BodyOutline> bodies,
    std::span<const FlowMaterial> materials, std::vector<SurfacePlace> surface, bool is_fine)
{
  const Drawing drawing = make_drawing(mesh, bodies);
  FlowSoil soil;
  soil.surface = std::move(surface);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) add_cell(drawing, cell, materials, is_fine, soil);
  complete_flow_soil(mesh, soil);
  return soil;
}

void complete_flow_soil(const Mesh<2>& mesh, FlowSoil& soil)
{
  const std::vector<CellSoil> cells = soil_of_cells(mesh, soil);
  for (Index c = 0; c < mesh.n_cells(); ++c) {
    const CellSoil& cell = cells[c];
    const Real empty = 1.0 - cell.area / mesh.geometry(c).volume;
    if (cell.area <= 0.0 || empty < 1e-3) continue;
    const Real share = of_empty_part * empty;
    FlowPlace place{c, {}, 0.0, {share * cell.k.horizontal, share * cell.k.vertical}};
    place.is_soil = false;
    add_gauss_places(mesh, c, place, soil);
  }
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  for (FlowPlace& place : soil.places) {
    set_shape(mesh, place.cell, local_of(mesh, place.cell, place.x), place.shape, place.gradient);
    if (place.is_soil) low = std::min(low, place.x[1]), high = std::max(high, place.x[1]);
  }
  soil.height = soil.places.empty() ? 0.0 : high - low;
  // A surface along the border of cells may have been given to a cell that holds no soil.
  std::erase_if(soil.surface, [&](const SurfacePlace& place) { return !(cells[place.cell].area > 0.0); });
  for (SurfacePlace& place : soil.surface) {
    const CellSoil& cell = cells[place.cell];
    const Real volume = mesh.geometry(place.cell).volume;
    Quad4::PerCorner<Vec<2>> gradient;
    set_shape(mesh, place.cell, local_of(mesh, place.cell, place.x), place.shape, gradient);
    const Vec<2> kn = cell.k.times(place.normal);
    const Real k_n = kn[0] * place.normal[0] + kn[1] * place.normal[1];
    if (place.condition == FlowCondition::leak) {
      place.penalty = k_n / place.leakage_length;
      continue;
    }
    place.penalty = k_n * std::max(1.0 / std::sqrt(volume), cell.length / std::max(cell.area, 1e-12 * volume));
    for (int i = 0; i < Quad4::n_corners; ++i) place.flux[i] = -(gradient[i][0] * kn[0] + gradient[i][1] * kn[1]);
  }
}

std::optional<Real> head_at(const Mesh<2>& mesh, std::span<const Real> heads, Vec<2> x)
{
  const Location at = locate(mesh, x);
  if (!at.inside) return std::nullopt;
  const auto shape = Quad4::shape_functions(std::array{at.local[0], at.local[1]});
  Real head = 0.0;
  for (int i = 0; i < Quad4::n_corners; ++i) head += shape[i] * heads[mesh.cells[at.cell][i]];
  return head;
}

}  // namespace terp
