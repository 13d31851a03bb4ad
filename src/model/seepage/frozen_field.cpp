#include "model/seepage/frozen_field.hpp"

#include "math/plane.hpp"
#include "model/seepage/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

// Share of wet soil at a node, interpolated, from which on a place is wet. Not 0.5 to the bit, which nodes on a level
// table have: their surface would be that of a cell without soil.
constexpr Real is_filled = 0.5 + 1e-6;
constexpr Real near_ground = 0.75;  // of a cell: a surface of wet soil less deep is that of the ground

/// Share of the space about each node that wet soil fills.
std::vector<Real> shares_at_nodes(const Mesh<2>& mesh, std::span<const WetPoint> points)
{
  std::vector<Real> share(mesh.nodes.size(), 0.0), space(mesh.nodes.size(), 0.0);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int g = 0; g < Quad4::n_gauss; ++g) {
      const auto shape = Quad4::shape_functions(Quad4::gauss_place(g));
      for (int i = 0; i < 4; ++i) space[mesh.cells[cell][i]] += shape[i] * mesh.geometry(cell).gauss_volume[g];
    }
  for (const WetPoint& point : points) {
    const Vec<2>& centre = mesh.centres[point.cell];
    const auto local = Quad4::local_coordinates(
        mesh.geometry(point.cell).map, std::array{point.x[0] - centre[0], point.x[1] - centre[1]});
    const auto shape = Quad4::shape_functions(local);
    for (int i = 0; i < 4; ++i) share[mesh.cells[point.cell][i]] += shape[i] * point.volume;
  }
  for (std::size_t i = 0; i < share.size(); ++i) share[i] /= space[i];
  return share;
}

/// In series in every direction; cells without points have that of all.
std::vector<Permeability> permeabilities(const Mesh<2>& mesh, std::span<const WetPoint> points)
{
  struct Sum {
    Real volume = 0.0, horizontal = 0.0, vertical = 0.0;

    void enter(const WetPoint& p)
    {
      volume += p.volume;
      horizontal += p.volume / p.k.horizontal;
      vertical += p.volume / p.k.vertical;
    }
    Permeability mean() const { return {volume / horizontal, volume / vertical}; }
  };
  std::vector<Sum> sums(mesh.cells.size());
  Sum all;
  for (const WetPoint& point : points) {
    if (!(point.volume > 0.0)) continue;
    sums[point.cell].enter(point);
    all.enter(point);
  }
  std::vector<Permeability> k;
  for (const Sum& sum : sums) k.push_back(sum.volume > 0.0 ? sum.mean() : all.mean());
  return k;
}

class WetDomain {
 public:
  WetDomain(const Mesh<2>& mesh, const AboveSoil& above, FlowSoil& soil) : mesh_(mesh), above_(above), soil_(soil) {}

  void add_cell(Index cell, const std::vector<Real>& share, const Permeability& k)
  {
    std::array<Real, 4> over;
    int n_over = 0;
    for (int i = 0; i < 4; ++i) {
      over[i] = share[mesh_.cells[cell][i]] - is_filled;
      n_over += over[i] >= 0.0;
    }
    if (n_over == 0) return;
    if (n_over == 4) return add_gauss_places(mesh_, cell, {cell, {}, 0.0, k}, soil_);
    const auto corners = mesh_.corners(cell);
    std::vector<Vec<2>> ring;
    std::vector<std::pair<bool, Vec<2>>> crossings;  // true: the way round the cell leaves the wet soil
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      if (over[i] >= 0.0) ring.push_back(corners[i]);
      if ((over[i] >= 0.0) == (over[j] >= 0.0)) continue;
      const Vec<2> x = between(corners[i], corners[j], over[i] / (over[i] - over[j]));
      ring.push_back(x);
      crossings.emplace_back(over[i] >= 0.0, x);
    }
    if (!add_ring(cell, ring, k)) return;
    for (std::size_t c = 0; c < crossings.size(); ++c)
      if (crossings[c].first) add_surface(cell, crossings[c].second, crossings[(c + 1) % crossings.size()].second);
  }

 private:
  /// Triangles with three places each; false: next to nothing.
  bool add_ring(Index cell, const std::vector<Vec<2>>& ring, const Permeability& k)
  {
    Real area = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += 0.5 * cross(ring[0], ring[i], ring[i + 1]);
    if (area < 1e-8 * mesh_.geometry(cell).volume) return false;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const std::array<Vec<2>, 3> t{ring[0], ring[i], ring[i + 1]};
      const Real of_triangle = 0.5 * cross(t[0], t[1], t[2]);
      if (!(of_triangle > 0.0)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        Vec<2> x{};
        for (int d = 0; d < 2; ++d) x[d] = (4.0 * t[c][d] + t[(c + 1) % 3][d] + t[(c + 2) % 3][d]) / 6.0;
        soil_.places.push_back({cell, x, of_triangle / 3.0, k});
      }
    }
    return true;
  }

  void add_surface(Index cell, Vec<2> a, Vec<2> b)
  {
    const Real whole = distance(a, b);
    if (!(whole > 1e-9 * mesh_.smallest_altitude)) return;
    const Vec<2> way = between(a, b), normal{way[1] / whole, -way[0] / whole};
    const Real size = std::sqrt(mesh_.geometry(cell).volume);
    for (const Real gauss : {-Quad4::gauss_abscissa, Quad4::gauss_abscissa}) {
      const Vec<2> x = between(a, b, 0.5 * (1.0 + gauss));
      const Real level = above_.free_water(x[0]);
      const bool is_inside = x[1] < above_.ground(x[0]) - near_ground * size;
      const bool is_fed = level > x[1] && !is_inside;
      soil_.surface.push_back({cell, x, normal, 0.5 * whole,
          is_fed || is_inside ? FlowCondition::head : FlowCondition::seep, is_fed ? level : x[1], 0.0, 0, {}, {}, 0.0});
    }
  }

  const Mesh<2>& mesh_;
  const AboveSoil& above_;
  FlowSoil& soil_;
};

}  // namespace

std::vector<Real> frozen_heads(
    const Mesh<2>& mesh, std::span<const WetPoint> points, const AboveSoil& above, std::vector<SurfacePlace> sides)
{
  const std::vector<Real> share = shares_at_nodes(mesh, points);
  const std::vector<Permeability> k = permeabilities(mesh, points);
  FlowSoil soil;
  soil.surface = std::move(sides);
  for (SurfacePlace& place : soil.surface) place.part = 0;
  WetDomain domain(mesh, above, soil);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) domain.add_cell(cell, share, k[cell]);
  complete_flow_soil(mesh, soil);
  FlowOptions options;
  options.is_saturated = true;
  options.most_iterations = 30;
  FlowResult flow = find_flow(mesh, soil, 1, options);
  for (std::size_t i = 0; i < flow.heads.size(); ++i)
    if (!flow.has_flow[i]) flow.heads[i] = std::numeric_limits<Real>::quiet_NaN();
  return flow.heads;
}

}  // namespace terp
