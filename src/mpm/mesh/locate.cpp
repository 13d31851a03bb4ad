// A point moves little in a step, so a walk from its old cell over the sides that it crossed usually ends after one or
// two cells. The walk may fail at re-entrant corners and across gaps; then all cells near the position are tested.
// Cells are half-open, so exactly one owns a position. Where round-off makes both neighbours deny it, the first that
// accepts it within the tolerance takes it.
#include "mpm/mesh/locate.hpp"

#include <algorithm>

namespace terp {
namespace {

/// A result of the inverse map counts if it maps back to the position within this fraction of the cell's altitude: far
/// above the round-off of coordinates, far below any cell.
constexpr Real arrival_tolerance = 1e-9;

/// Coordinates that say beyond which straight side a position lies, where the inverse map has no result: 1 + distance
/// over the cell's altitude across that side, inside [-1, 1] otherwise.
Vec<2> beyond_sides(const Mesh<2>& mesh, Index cell, Vec<2> x, Vec<2> guess)
{
  const auto corners = mesh.corners(cell);
  Vec<2> local{};
  for (int d = 0; d < 2; ++d) local[d] = std::isfinite(guess[d]) ? std::clamp(guess[d], -1.0, 1.0) : 0.0;
  std::array<Real, 2> farthest{0.0, 0.0};
  for (const Quad4::Side& side : Quad4::sides) {
    const Vec<2>&a = corners[side.corners[0]], &b = corners[side.corners[1]];
    const Vec<2> along{b[0] - a[0], b[1] - a[1]};
    const Real distance = ((x[0] - a[0]) * along[1] - (x[1] - a[1]) * along[0]) / std::hypot(along[0], along[1]);
    const int d = side.direction;
    if (distance <= farthest[d]) continue;
    farthest[d] = distance;
    local[d] = side.place * (1.0 + distance / mesh.geometry(cell).altitude);
  }
  return local;
}

/// Far from a twisted cell the inverse map may give any result, even in [-1, 1]: it counts only if it maps back to x.
Vec<2> local_in(const Mesh<2>& mesh, Index cell, Vec<2> x)
{
  const CellGeometry<Quad4>& geometry = mesh.geometry(cell);
  const Vec<2> offset{x[0] - mesh.centres[cell][0], x[1] - mesh.centres[cell][1]};
  const Vec<2> local = Quad4::local_coordinates(geometry.map, offset);
  if (geometry.map.affine || !std::isfinite(x[0] + x[1])) return local;
  const Vec<2> back = place_in_cell(mesh, cell, local);
  const bool arrived = std::hypot(back[0] - x[0], back[1] - x[1]) <= arrival_tolerance * geometry.altitude;
  return arrived ? local : beyond_sides(mesh, cell, x, local);
}

bool owns(Vec<2> l)
{
  return std::all_of(l.begin(), l.end(), [](Real at) { return at >= -1.0 && at < 1.0; });
}

bool accepts(Vec<2> l)
{
  constexpr Real limit = 1.0 + location_tolerance;
  return std::all_of(l.begin(), l.end(), [](Real at) { return std::abs(at) <= limit; });
}

/// Sides beyond which the position lies, the farthest first; at most two.
int crossed_sides(Vec<2> l, std::array<int, 2>& sides)
{
  int n = 0;
  for (int d = 0; d < Quad4::dim; ++d)
    if (l[d] < -1.0 || l[d] >= 1.0) sides[n++] = Quad4::side_at(d, !(l[d] < 0.0));
  if (n == 2 && std::abs(l[1]) > std::abs(l[0])) std::swap(sides[0], sides[1]);
  return n;
}

/// The walk. Ends in the owner, or in a cell whose crossed sides all lie on the mesh's boundary, or gives up.
Location walk(const Mesh<2>& mesh, Vec<2> x, Index cell)
{
  Index previous = outside;
  Location at{cell, local_in(mesh, cell, x), false};
  for (Index step = 0; step < 4 + 2 * mesh.n_cells(); ++step) {
    if (owns(at.local)) return {at.cell, at.local, true};
    std::array<int, 2> sides{};
    const int n = crossed_sides(at.local, sides);
    Index next = outside;
    for (int k = 0; k < n && next == outside; ++k) next = mesh.neighbours[at.cell][sides[k]];
    const bool back = next == previous && previous != outside;  // on a side that both cells deny by round-off
    if (next == outside || back) return {at.cell, at.local, accepts(at.local)};
    previous = at.cell;
    at = {next, local_in(mesh, next, x), false};
  }
  return at;
}

/// Of the cells near a position its owner, else the first that accepts it, else cell -1.
Location search(const Mesh<2>& mesh, Vec<2> x)
{
  Location found{outside, {0.0, 0.0}, false};
  for (const Index e : boxes_near(mesh.cell_grid, x)) {
    const Vec<2> local = local_in(mesh, e, x);
    if (owns(local)) return {e, local, true};
    if (!found.inside && accepts(local)) found = {e, local, true};
  }
  return found;
}

}  // namespace

Location locate(const Mesh<2>& mesh, Vec<2> x, Index first_guess)
{
  const Location walked = walk(mesh, x, first_guess);
  if (walked.inside || !std::isfinite(x[0] + x[1])) return walked;
  const Location found = search(mesh, x);
  return found.inside ? found : walked;
}

Location locate(const Mesh<2>& mesh, Vec<2> x)
{
  const Location found = search(mesh, x);
  if (found.inside) return found;
  const auto near = boxes_near(mesh.cell_grid, x);
  return walk(mesh, x, near.empty() ? 0 : near.front());
}

Vec<2> place_in_cell(const Mesh<2>& mesh, Index cell, Vec<2> local)
{
  const auto offset = Quad4::offset_from_centre(mesh.geometry(cell).map, local);
  return {mesh.centres[cell][0] + offset[0], mesh.centres[cell][1] + offset[1]};
}

Vec<2> clamp_to_cell(Vec<2> local) { return {std::clamp(local[0], -1.0, 1.0), std::clamp(local[1], -1.0, 1.0)}; }

}  // namespace terp
