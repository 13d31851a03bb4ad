#include "schemes/cut_cells.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

using Rows = PointRows<2>;

constexpr Real window = 1.5;        // radius of the points that tell the direction, in sizes of the cell
constexpr Real least_clear = 0.25;  // share of the variance of "is soil a" that a plane explains; a border: 0.45 to 0.7
constexpr int most_soils = 8;       // in a cell; with more there is no slip

/// Sums over points, with the weight Omega_p (1 - r^2/R^2): of 1, x, y, x^2, xy, y^2, from the centre of a cell.
struct Moments {
  std::array<Real, 6> of{};

  void add(const PointBlock<2>& block, Vec<2> centre, Real radius)
  {
    std::array<Pack, 6> sums = zero_packs<6>();
    const Pack shrink(1.0 / (radius * radius));
    for (Index p = 0; p < block.n; p += pack_width) {
      const Pack x = Pack::load(block.row(Rows::x) + p) - Pack(centre[0]);
      const Pack y = Pack::load(block.row(Rows::x + 1) + p) - Pack(centre[1]);
      const Pack part = max(Pack(1.0) - (x * x + y * y) * shrink, Pack(0.0));
      const Mask in_use = lane_numbers() < Pack(static_cast<Real>(block.n - p));
      const Pack w = select(in_use, part * Pack::load(block.row(Rows::volume) + p), Pack(0.0));
      sums[0] += w;
      sums[1] += w * x;
      sums[2] += w * y;
      sums[3] += w * x * x;
      sums[4] += w * x * y;
      sums[5] += w * y * y;
    }
    for (std::size_t k = 0; k < of.size(); ++k) of[k] += sum(sums[k]);
  }
};

/// Calls f(block) for the blocks of a cell and of those that share a node with it.
template <class F>
void for_each_block_around(const Mesh<2>& mesh, const PointBlocks<2>& points, Index cell, F&& f)
{
  std::array<Index, 32> seen;
  std::size_t n = 0;
  for (const Index node : mesh.cells[cell])
    for (Index k = mesh.first_cell_of_node[node]; k < mesh.first_cell_of_node[node + 1]; ++k) {
      const auto other = static_cast<Index>(mesh.cells_of_node[k].cell);
      if (n == seen.size() || std::find(seen.begin(), seen.begin() + n, other) != seen.begin() + n) continue;
      seen[n++] = other;
      for_each_block(points, other, [&](const PointBlock<2>& block, Index) { f(block); });
    }
}

/// The soil of one material in a cell.
struct Soil {
  Index material;
  Real weight = 0.0;
  SymTensor<Real, 2> sigma = {};  ///< sum, times weight
  Real G = 0.0;                   ///< the largest of its points [Pa]

  Real tau(const BlockSlip& unit) const
  {
    return (unit.normal * (sigma[0] - sigma[1]) + 2.0 * unit.shear * sigma[3]) / weight;
  }
};

struct Soils {
  std::array<Soil, most_soils> of;
  int n = 0;

  std::span<Soil> all() { return {of.data(), static_cast<std::size_t>(n)}; }
};

bool has_several_soils(const PointBlocks<2>& points, Index cell)
{
  const Index first = points.first_block(cell);
  for (Index b = points.block(first).next; b >= 0; b = points.block(b).next)
    if (points.block(b).material != points.block(first).material) return true;
  return false;
}

/// False: one of them has no shear stiffness, or there are too many.
bool list_soils(const SchemeContext& context, const CellGroup<Quad4>& group, Index cell, Soils& soils)
{
  bool known = true;
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index b) {
    if (!known) return;
    if (soils.n == 0 || soils.of[soils.n - 1].material != block.material) {
      known = soils.n < most_soils;
      if (!known) return;
      soils.of[soils.n++] = {.material = block.material};
    }
    Soil& soil = soils.of[soils.n - 1];
    const BlockSlip& slip = group.slips[b];
    soil.weight += slip.weight;
    for (int k = 0; k < n_sym<2>; ++k) soil.sigma[k] += slip.weight * slip.sigma[k];
    const SoilMaterial& material = context.materials[block.material];
    for (Index p = 0; p < block.n; ++p)
      soil.G = std::max(soil.G, material.law->moduli_at(material.view(block, p), stress_at(block, p)).shear);
    known = soil.G > 0.0 && soil.weight > 0.0;
  });
  return known;
}

/// Puts the two soils with most volume first.
void sort_by_volume(Soils& soils)
{
  std::ranges::stable_sort(soils.all(), [](const Soil& a, const Soil& b) { return a.weight > b.weight; });
}

/// Area of the part of a polygon above d, with the heights of its corners.
Real area_above(const std::array<Vec<2>, 4>& x, const std::array<Real, 4>& height, Real d)
{
  std::array<Vec<2>, 8> part;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    if (height[i] > d) part[n++] = x[i];
    if ((height[i] > d) == (height[j] > d)) continue;
    const Real f = (d - height[i]) / (height[j] - height[i]);
    part[n++] = {x[i][0] + f * (x[j][0] - x[i][0]), x[i][1] + f * (x[j][1] - x[i][1])};
  }
  Real twice = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec<2>&a = part[i], &b = part[(i + 1) % n];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

/// Where a quadratic function that falls from f0 at 0 over f_half to f1 at 1 is zero.
Real zero_of(Real f0, Real f_half, Real f1)
{
  const Real curve = 2.0 * (f0 - 2.0 * f_half + f1), slope = f1 - f0 - curve;
  const Real root = std::sqrt(std::max(slope * slope - 4.0 * curve * f0, 0.0)) - slope;
  return root > 0.0 ? std::clamp(2.0 * f0 / root, 0.0, 1.0) : 0.5;
}

/// Of two soils with n towards a: their border, and the slip of the one with the lower shear stress, the new soil a.
Kink kink_between(const CellGroup<Quad4>& group, int c, Vec<2> n, const Soil& a, const Soil& b, const BlockSlip& unit)
{
  const Real tau_a = a.tau(unit), tau_b = b.tau(unit);
  if (std::abs(tau_b) < std::abs(tau_a)) return kink_between(group, c, {-n[0], -n[1]}, b, a, unit);
  Kink kink{.along = {n[1], -n[0]}, .share = a.weight / (a.weight + b.weight), .slipped = (tau_b - tau_a) / a.G};
  kink.above = above_border(group.mesh, group.cells[c], n, kink.share);
  const auto& force = group.corners[c].internal_force;
  for (std::size_t i = 0; i < 4; ++i)
    kink.force += kink.above[i] * (kink.along[0] * force[0][i] + kink.along[1] * force[1][i]);
  return kink;
}

void find_slips_of_cell(const SchemeContext& context, const CellGroup<Quad4>& group, int c)
{
  const Index cell = group.cells[c];
  Soils soils;
  if (!list_soils(context, group, cell, soils)) return;
  sort_by_volume(soils);
  const Soil &a = soils.of[0], &b = soils.of[1];
  const Vec<2> n = across_border(group.mesh, group.points, cell, {a.material, b.material});
  const BlockSlip unit{.normal = n[0] * n[1], .shear = 0.5 * (n[1] * n[1] - n[0] * n[0])};
  if (!unit.acts()) return;
  Real volume = 0.0, yielding = 0.0, held = 0.0;
  for (const Soil& soil : soils.all()) {
    volume += soil.weight;
    yielding += soil.weight / soil.G;
    held += soil.weight * soil.tau(unit) / soil.G;
  }
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index b) {
    const Soil& soil = *std::ranges::find(soils.all(), block.material, &Soil::material);
    BlockSlip& slip = group.slips[b];
    slip.normal = unit.normal;
    slip.shear = unit.shear;
    slip.held = (held / yielding - soil.tau(unit)) / soil.G;
    slip.rate = volume / (soil.G * yielding) - 1.0;
  });
  group.slips[group.points.first_block(cell)].kink = kink_between(group, c, n, a, b, unit);
}

}  // namespace

Vec<2> across_border(const Mesh<2>& mesh, const PointBlocks<2>& points, Index cell, std::array<Index, 2> materials)
{
  const Vec<2> centre = mesh.centres[cell];
  const Real radius = window * std::sqrt(mesh.geometry(cell).volume);
  std::array<Moments, 2> soil;
  for_each_block_around(mesh, points, cell, [&](const PointBlock<2>& block) {
    for (int k = 0; k < 2; ++k)
      if (block.material == materials[k]) soil[k].add(block, centre, radius);
  });
  std::array<Real, 6> all;
  for (int k = 0; k < 6; ++k) all[k] = soil[0].of[k] + soil[1].of[k];
  const Real whole = all[0], share = soil[0].of[0] / whole, x = all[1] / whole, y = all[2] / whole;
  const Real xx = all[3] / whole - x * x, xy = all[4] / whole - x * y, yy = all[5] / whole - y * y;
  const Real of_x = soil[0].of[1] / whole - share * x, of_y = soil[0].of[2] / whole - share * y;
  const Real slope_x = yy * of_x - xy * of_y, slope_y = xx * of_y - xy * of_x;  // of the plane, times the determinant
  const Real determinant = xx * yy - xy * xy, length = std::sqrt(slope_x * slope_x + slope_y * slope_y);
  const bool is_clear = slope_x * of_x + slope_y * of_y >= least_clear * share * (1.0 - share) * determinant;
  if (!is_clear || !(determinant > 0.0) || !(length > 0.0)) return {0.0, 0.0};
  return {slope_x / length, slope_y / length};
}

std::array<Real, 4> above_border(const Mesh<2>& mesh, Index cell, Vec<2> n, Real share)
{
  std::array<Vec<2>, 4> x;
  std::array<Real, 4> height, sorted, area;
  for (std::size_t i = 0; i < 4; ++i) {
    for (int d = 0; d < 2; ++d) x[i][d] = mesh.nodes[mesh.cells[cell][i]][d] - mesh.centres[cell][d];
    height[i] = n[0] * x[i][0] + n[1] * x[i][1];
  }
  sorted = height;
  std::ranges::sort(sorted);
  // Between the heights of two corners the area falls as a quadratic function.
  const Real whole = area_above(x, height, sorted[0] - 1.0), wanted = share * whole;
  for (std::size_t k = 1; k < 3; ++k) area[k] = area_above(x, height, sorted[k]) - wanted;
  area[0] = whole - wanted;
  area[3] = -wanted;
  const std::size_t k = area[1] < 0.0 ? 0 : area[2] < 0.0 ? 1 : 2;
  const Real half = area_above(x, height, 0.5 * (sorted[k] + sorted[k + 1])) - wanted;
  const Real border = sorted[k] + zero_of(area[k], half, area[k + 1]) * (sorted[k + 1] - sorted[k]);
  for (Real& value : height) value = std::max(value - border, 0.0);
  return height;
}

void find_slips(const SchemeContext& context, const CellGroup<Quad4>& group)
{
  for (int c = 0; c < group.n(); ++c)
    if (has_several_soils(group.points, group.cells[c])) find_slips_of_cell(context, group, c);
}

}  // namespace terp
