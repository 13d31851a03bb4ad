// Sides of outlines and of the mesh are parted wherever they meet others; a piece with soil on one side alone is
// surface. Where a side of an outline lies along one of the mesh, that of the mesh counts.

#include "model/seepage/flow_surface.hpp"

#include "math/plane.hpp"
#include "mpm/mesh/locate.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace terp {
namespace {

constexpr Real beside = 5e-3;      // of a cell: distance at which a side is looked at; a thinner gap is none
constexpr Real touches = 1e-7;     // of a cell: sides this near meet
constexpr Real base_faces = -0.5;  // upward part of the normal below which a side may be the base
constexpr Real inwards = 1e-7;
constexpr Real least_piece = 1e-9;  // of an edge

class SoilOutlines {
 public:
  SoilOutlines(const Mesh<2>& mesh, std::span<const BodyOutline> bodies) : mesh_(mesh)
  {
    for (const BodyOutline& body : bodies) sides_.push_back(outline_sides(mesh, body));
    for (const std::vector<Side>& of_body : sides_) all_.insert(all_.end(), of_body.begin(), of_body.end());
  }

  const std::vector<Side>& all() const { return all_; }

  /// Within the mesh.
  bool is_soil(Vec<2> x) const
  {
    return locate(mesh_, x).inside &&
           std::ranges::any_of(sides_, [&](const std::vector<Side>& sides) { return encloses(sides, x); });
  }

  /// Whether soil lies right above a place, or right below.
  bool has_soil(Vec<2> x, bool above) const
  {
    for (const std::vector<Side>& sides : sides_)
      for (const Real y : crossings_of_vertical(sides, x[0]))
        if (above ? y > x[1] : y < x[1]) return true;
    return false;
  }

 private:
  const Mesh<2>& mesh_;
  std::vector<std::vector<Side>> sides_;  // by body
  std::vector<Side> all_;
};

/// Shares of the way from a to b at which other sides meet it, with 0 and 1.
std::vector<Real> meetings(Vec<2> a, Vec<2> b, std::span<const Side> sides, Real tolerance)
{
  std::vector<Real> shares{0.0, 1.0};
  const Vec<2> way = between(a, b);
  const Real square = dot(way, way);
  const auto enter = [&](Vec<2> x) {
    if (distance_to_line(a, b, x) > tolerance) return;
    const Real t = dot(between(a, x), way) / square;
    if (t > 0.0 && t < 1.0) shares.push_back(t);
  };
  for (const Side& side : sides) {
    enter(side.a);
    enter(side.b);
    if (Vec<2> x; lines_cross(a, b, side.a, side.b, x)) shares.push_back(dot(between(a, x), way) / square);
  }
  std::ranges::sort(shares);
  return shares;
}

std::vector<Side> sides_of_mesh(const Mesh<2>& mesh)
{
  std::vector<Side> sides;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int s = 0; s < Quad4::n_sides; ++s)
      if (mesh.neighbours[cell][s] == outside) {
        const auto corners = mesh.corners(cell);
        sides.push_back({corners[Quad4::sides[s].corners[0]], corners[Quad4::sides[s].corners[1]]});
      }
  return sides;
}

}  // namespace

SoilEdge part_of(const SoilEdge& edge, Real s, Real t)
{
  return {between(edge.a, edge.b, s), between(edge.a, edge.b, t), edge.normal, edge.kind, edge.is_open};
}

std::vector<SoilEdge> surface_of(const Mesh<2>& mesh, std::span<const BodyOutline> bodies, std::span<const Side> walls)
{
  const SoilOutlines soil(mesh, bodies);
  const std::vector<Side> of_mesh = sides_of_mesh(mesh);
  const Real tolerance = touches * mesh.smallest_altitude, step = beside * mesh.smallest_altitude;
  std::vector<Side> parting = soil.all();
  parting.insert(parting.end(), walls.begin(), walls.end());
  std::vector<SoilEdge> edges;
  std::set<std::array<long long, 2>> known;  // by their middles
  const auto enter = [&](const Side& side, bool is_of_mesh) {
    const Real whole = distance(side.a, side.b);
    if (whole < tolerance) return;
    const std::vector<Real> shares = meetings(side.a, side.b, parting, step);
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
      if ((shares[k + 1] - shares[k]) * whole < step) continue;
      const Vec<2> a = between(side.a, side.b, shares[k]), b = between(side.a, side.b, shares[k + 1]),
                   middle = between(a, b, 0.5), way = between(a, b);
      Vec<2> normal{way[1] / length(way), -way[0] / length(way)};
      const auto at = [&](Real by) { return Vec<2>{middle[0] + by * normal[0], middle[1] + by * normal[1]}; };
      const bool right = soil.is_soil(at(step)), left = soil.is_soil(at(-step));
      if (right == left) continue;
      if (right) normal = {-normal[0], -normal[1]};
      if (!is_of_mesh && !locate(mesh, at(right ? -step : step)).inside) continue;
      const std::array key{std::llround(middle[0] / (10.0 * tolerance)), std::llround(middle[1] / (10.0 * tolerance))};
      if (!known.insert(key).second) continue;
      edges.push_back({a, b, normal, EdgeKind::ground, !is_of_mesh});
    }
  };
  for (const Side& side : of_mesh) enter(side, true);
  for (const Side& side : soil.all()) enter(side, false);
  if (edges.empty()) return edges;
  Real left = edges[0].a[0], right = left;
  for (const SoilEdge& edge : edges)
    for (const Vec<2>& x : {edge.a, edge.b}) left = std::min(left, x[0]), right = std::max(right, x[0]);
  for (SoilEdge& edge : edges) {
    const Vec<2> middle = between(edge.a, edge.b, 0.5),
                 out{middle[0] + step * edge.normal[0], middle[1] + step * edge.normal[1]};
    if (std::max(edge.a[0], edge.b[0]) < left + step)
      edge.kind = EdgeKind::left;
    else if (std::min(edge.a[0], edge.b[0]) > right - step)
      edge.kind = EdgeKind::right;
    else if (edge.normal[1] < base_faces && soil.has_soil(out, true) && !soil.has_soil(out, false))
      edge.kind = EdgeKind::base, edge.is_open = false;
    else
      edge.is_open = true;
  }
  return edges;
}

void add_places(const Mesh<2>& mesh, const SoilEdge& edge, const EdgeCondition& of, std::vector<SurfacePlace>& places)
{
  const Real whole = distance(edge.a, edge.b);
  if (!(whole > 0.0)) return;
  const Real shift = inwards * mesh.smallest_altitude;
  const Vec<2> a{edge.a[0] - shift * edge.normal[0], edge.a[1] - shift * edge.normal[1]},
      b{edge.b[0] - shift * edge.normal[0], edge.b[1] - shift * edge.normal[1]};
  const BoundingBox box = box_around(std::array{a, b});
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const auto corners = mesh.corners(cell);
    const BoundingBox around = box_around(corners);
    if (around.low[0] > box.high[0] || around.high[0] < box.low[0] || around.low[1] > box.high[1] ||
        around.high[1] < box.low[1])
      continue;
    Real s = 0.0, t = 1.0;
    for (int side = 0; side < Quad4::n_sides && s < t; ++side) {
      const Vec<2>&p = corners[side], &q = corners[(side + 1) % Quad4::n_sides];
      const Real at_a = cross(p, q, a), at_b = cross(p, q, b);
      if (at_a < 0.0 && at_b < 0.0)
        t = -1.0;
      else if (at_a < 0.0)
        s = std::max(s, at_a / (at_a - at_b));
      else if (at_b < 0.0)
        t = std::min(t, at_a / (at_a - at_b));
    }
    if (t - s < least_piece) continue;
    for (const Real gauss : {-Quad4::gauss_abscissa, Quad4::gauss_abscissa}) {
      const Vec<2> x = between(a, b, s + 0.5 * (1.0 + gauss) * (t - s));
      const Real head = of.condition == FlowCondition::seep ? x[1] : of.head;
      places.push_back(
          {cell, x, edge.normal, 0.5 * (t - s) * whole, of.condition, head, of.leakage_length, of.part, {}, {}, 0.0});
    }
  }
}

}  // namespace terp
