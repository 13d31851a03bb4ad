// The rule (decision 0026). A cell is parted into n x n by its local coordinates; the sides of a part are straight.
//
//   whole part    a point in the middle of its local coordinates, with the volume of the part
//   cut part      what a body keeps of it, less its holes and all later bodies, is cut out exactly
//                 each piece is a point at its centroid with its area
//   small piece   less than a fifth of its part: goes to the nearest piece of its body
//                 in the same or an adjoining part of the cell, or else in a cell across a side, or else across a
//                 corner
//
// Where a small piece goes, volumes add up and the common centroid is kept. The straight line between the two must lie
// in the body, and the centroid in the cell. If there is no such neighbour, the small piece is a point of its own.
//
// So the volume of each body is right to round-off, no point is out of proportion to its neighbours, and a sloping
// surface is a row of points along the slope.

#include "model/bodies/seed.hpp"

#include "mpm/mesh/locate.hpp"
#include "model/bodies/cut_cell.hpp"
#include "model/bodies/drawing.hpp"
#include "model/bodies/overfull.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

void seed_whole_cell(const Drawing& drawing, Index cell, Index body, std::vector<Seed>& seeds)
{
  const Lattice lattice{drawing.mesh.geometry(cell), drawing.bodies[body].points_per_cell};
  for (Index row = 0; row < lattice.n[1]; ++row)
    for (Index column = 0; column < lattice.n[0]; ++column) {
      const Vec<2> local = middle_of_part(lattice, {column, row});
      seeds.push_back(
          {place_in_cell(drawing.mesh, cell, local), local, cell, body, volume_of_part(lattice, {column, row})});
    }
}

/// small: numbers of the seeds that are too small and found no neighbour in their cell.
void seed_cut_cell(const Drawing& drawing, const Overlay& overlay, Index cell, std::vector<Seed>& seeds,
    std::vector<std::size_t>& small)
{
  const CellGeometry<Quad4>& geometry = drawing.mesh.geometry(cell);
  const Vec<2> centre = drawing.mesh.centres[cell];
  const auto add_body = [&](Index body) {
    const Lattice lattice{geometry, drawing.bodies[body].points_per_cell};
    for (const Piece& piece : cut_cell(lattice, overlay, body)) {
      const Vec<2> middle = middle_of_part(lattice, piece.part);
      const Vec<2> local = piece.is_whole ? middle : clamp_to_cell(Quad4::local_coordinates(geometry.map, piece.x));
      if (piece.stays_alone) small.push_back(seeds.size());
      seeds.push_back({{centre[0] + piece.x[0], centre[1] + piece.x[1]}, local, cell, body, piece.volume});
    }
  };
  if (overlay.ground >= 0) add_body(overlay.ground);
  for (const Ring& ring : overlay.rings)
    if (!ring.is_hole) add_body(ring.body);
}

Vec<2> common_centroid(const Seed& a, const Seed& b)
{
  const Real t = b.volume / (a.volume + b.volume);
  return {a.x[0] + t * (b.x[0] - a.x[0]), a.x[1] + t * (b.x[1] - a.x[1])};
}

/// True if a seed and a small one may become one: the small one is in sight, and their centroid lies in the cell of the
/// first.
bool may_take(const Drawing& drawing, const Overlay& overlay, const Seed& taker, const Seed& small)
{
  const Vec<2> x = common_centroid(taker, small), centre = drawing.mesh.centres[taker.cell];
  const auto relative = [&](const Seed& seed) { return Vec<2>{seed.x[0] - centre[0], seed.x[1] - centre[1]}; };
  const Vec<2> offset{x[0] - centre[0], x[1] - centre[1]};
  const Vec<2> local = Quad4::local_coordinates(drawing.mesh.geometry(taker.cell).map, offset);
  return std::abs(local[0]) < 1.0 && std::abs(local[1]) < 1.0 &&
         stays_in_body(overlay, taker.body, relative(taker), relative(small));
}

/// The nearest seed of the same body in some cells that may take the small one, or null.
Seed* find_taker(const Drawing& drawing, std::span<const Index> cells, std::vector<Seed>& seeds, const Seed& small)
{
  Seed* best = nullptr;
  Real least = std::numeric_limits<Real>::infinity();
  for (const Index cell : cells) {
    if (cell == outside || cell == small.cell) continue;
    const Overlay overlay = draw_cell(drawing, cell);
    auto seed = std::partition_point(seeds.begin(), seeds.end(), [&](const Seed& s) { return s.cell < cell; });
    for (; seed != seeds.end() && seed->cell == cell; ++seed) {
      const Real distance = std::hypot(seed->x[0] - small.x[0], seed->x[1] - small.x[1]);
      if (seed->body != small.body || seed->volume == 0.0 || distance >= least ||
          !may_take(drawing, overlay, *seed, small))
        continue;
      best = &*seed;
      least = distance;
    }
  }
  return best;
}

void merge_across_sides(const Drawing& drawing, const std::vector<std::size_t>& small, std::vector<Seed>& seeds)
{
  for (const std::size_t k : small) {
    const Index cell = seeds[k].cell;
    Seed* taker = find_taker(drawing, drawing.mesh.neighbours[cell], seeds, seeds[k]);
    if (taker == nullptr) taker = find_taker(drawing, cells_around(drawing.mesh, cell), seeds, seeds[k]);
    if (taker == nullptr) continue;
    const Vec<2> centre = drawing.mesh.centres[taker->cell];
    taker->x = common_centroid(*taker, seeds[k]);
    const Vec<2> offset{taker->x[0] - centre[0], taker->x[1] - centre[1]};
    taker->local = Quad4::local_coordinates(drawing.mesh.geometry(taker->cell).map, offset);
    taker->volume += seeds[k].volume;
    seeds[k].volume = 0.0;
  }
  std::erase_if(seeds, [](const Seed& seed) { return seed.volume == 0.0; });
}

}  // namespace

std::vector<Seed> seed_points(const Mesh<2>& mesh, std::span<const BodyOutline> bodies)
{
  const Drawing drawing = make_drawing(mesh, bodies);
  std::vector<Seed> seeds;
  std::vector<std::size_t> small;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Overlay overlay = draw_cell(drawing, cell);
    if (!overlay.rings.empty())
      seed_cut_cell(drawing, overlay, cell, seeds, small);
    else if (overlay.ground >= 0)
      seed_whole_cell(drawing, cell, overlay.ground, seeds);
  }
  merge_across_sides(drawing, small, seeds);
  return seeds;
}

}  // namespace terp
