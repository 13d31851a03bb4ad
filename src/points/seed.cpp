#include "points/seed.hpp"

#include "mesh/locate.hpp"

#include <algorithm>

namespace terp {
namespace {

struct Box {
  Vec<2> low, high;
};

Box box_of(std::span<const Vec<2>> points)
{
  Box box{points[0], points[0]};
  for (const auto& x : points)
    for (int d = 0; d < 2; ++d) {
      box.low[d] = std::min(box.low[d], x[d]);
      box.high[d] = std::max(box.high[d], x[d]);
    }
  return box;
}

bool overlap(const Box& a, const Box& b)
{
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1];
}

Real det_jacobian(const CellGeometry<2>& cell, Vec<2> at)
{
  const auto j = jacobian(cell, at[0], at[1]);
  return j[0][0] * j[1][1] - j[0][1] * j[1][0];
}

/// True where no body drawn later covers the place.
bool on_top(std::span<const BodyOutline> bodies, std::size_t body, Vec<2> x)
{
  if (!contains(bodies[body].polygon, x)) return false;
  for (std::size_t later = body + 1; later < bodies.size(); ++later)
    if (contains(bodies[later].polygon, x)) return false;
  return true;
}

void seed_cell(const Mesh<2>& mesh, std::span<const BodyOutline> bodies, Index cell, Index body, std::vector<Seed>& seeds)
{
  const auto [nx, ny] = bodies[body].points_per_cell;
  const Real part = 4.0 / (static_cast<Real>(nx) * ny);  // of the reference square's area
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Vec<2> local{(2.0 * i + 1.0) / nx - 1.0, (2.0 * j + 1.0) / ny - 1.0};
      const Vec<2> x = place_in_cell(mesh, cell, local);
      if (on_top(bodies, body, x)) seeds.push_back({x, local, cell, body, part * det_jacobian(mesh.geometry(cell), local)});
    }
}

}  // namespace

std::vector<Seed> seed_points(const Mesh<2>& mesh, std::span<const BodyOutline> bodies)
{
  std::vector<Box> boxes;
  for (const auto& body : bodies) boxes.push_back(box_of(body.polygon));
  std::vector<Seed> seeds;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const auto corners = mesh.corners(cell);
    const Box here = box_of(corners);
    for (std::size_t body = 0; body < bodies.size(); ++body)
      if (overlap(here, boxes[body])) seed_cell(mesh, bodies, cell, static_cast<Index>(body), seeds);
  }
  return seeds;
}

}  // namespace terp
