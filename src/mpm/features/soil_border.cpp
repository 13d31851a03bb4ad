// A plane is fitted by least squares to "is this soil a" over the points within 1.5 cells. Their weights fall to zero
// at the rim, so that the border does not jump as points come and go. If the plane explains too little, one soil may
// lie as a band in the other: the one whose points are spread least in one direction. How thick it is follows from its
// share of the area, not from its points. The area above a line is quadratic between the heights of two corners, so the
// line that cuts off a share is found exactly.

#include "mpm/features/soil_border.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real window = 1.5;        // radius of the points that tell the direction, in sizes of the cell
constexpr Real least_clear = 0.25;  // share of the variance of "is soil a" that a plane explains; a border: 0.45 to 0.7
constexpr Real most_round = 0.25;   // least over largest variance of the points of a band; a layer of R/2: 0.1
constexpr Real least_long =
    0.05;  // largest variance of the points of a band over R^2; a thin layer: 0.2, its end: 0.06

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

/// Means, variances and the direction of the least variance of points.
struct Spread {
  Vec<2> mean{0.0, 0.0}, least{0.0, 0.0};
  Real round = 1.0;    ///< least over largest variance; 1: no direction
  Real largest = 0.0;  ///< variance [m^2]

  explicit Spread(const Moments& of)
  {
    const auto& [w, x, y, xx, xy, yy] = of.of;
    if (!(w > 0.0)) return;
    mean = {x / w, y / w};
    const Real c = xy / w - mean[0] * mean[1];
    const Real d = 0.5 * ((xx - yy) / w - mean[0] * mean[0] + mean[1] * mean[1]);
    const Real middle = 0.5 * ((xx + yy) / w - mean[0] * mean[0] - mean[1] * mean[1]), root = std::sqrt(d * d + c * c);
    if (!(middle > 0.0)) return;
    const Vec<2> along = d > 0.0 ? Vec<2>{d + root, c} : Vec<2>{c, root - d};
    const Real length = std::sqrt(along[0] * along[0] + along[1] * along[1]);
    if (!(length > 0.0)) return;
    least = {-along[1] / length, along[0] / length};
    largest = middle + root;
    round = (middle - root) / largest;
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

struct Corners {
  std::array<Vec<2>, 4> x;     ///< from the centre of the cell [m]
  std::array<Real, 4> height;  ///< along n

  Corners(const Mesh<2>& mesh, Index cell, Vec<2> n)
  {
    for (std::size_t i = 0; i < 4; ++i) {
      for (int d = 0; d < 2; ++d) x[i][d] = mesh.nodes[mesh.cells[cell][i]][d] - mesh.centres[cell][d];
      height[i] = n[0] * x[i][0] + n[1] * x[i][1];
    }
  }

  Real lowest() const { return std::ranges::min(height); }
  Real area() const { return area_above(x, height, lowest() - 1.0); }
};

}  // namespace

Border find_border(const Mesh<2>& mesh, const PointBlocks<2>& points, Index cell, std::array<Index, 2> materials)
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
  if (is_clear && determinant > 0.0 && length > 0.0) return {.across = {slope_x / length, slope_y / length}};
  const std::array<Spread, 2> spread{Spread(soil[0]), Spread(soil[1])};
  const int band = spread[0].round <= spread[1].round ? 0 : 1;
  const auto& [mean, least, round, largest] = spread[band];
  if (!(round < most_round) || !(largest > least_long * radius * radius)) return {};
  return {least, band, mean[0] * least[0] + mean[1] * least[1]};
}

std::array<Real, 4> above_border(const Mesh<2>& mesh, Index cell, Vec<2> n, Real share)
{
  Corners corners(mesh, cell, n);
  auto& [x, height] = corners;
  std::array<Real, 4> sorted = height, area;
  std::ranges::sort(sorted);
  // Between the heights of two corners the area falls as a quadratic function.
  const Real whole = corners.area(), wanted = share * whole;
  for (std::size_t k = 1; k < 3; ++k) area[k] = area_above(x, height, sorted[k]) - wanted;
  area[0] = whole - wanted;
  area[3] = -wanted;
  const std::size_t k = area[1] < 0.0 ? 0 : area[2] < 0.0 ? 1 : 2;
  const Real half = area_above(x, height, 0.5 * (sorted[k] + sorted[k + 1])) - wanted;
  const Real border = sorted[k] + zero_of(area[k], half, area[k + 1]) * (sorted[k + 1] - sorted[k]);
  for (Real& value : height) value = std::max(value - border, 0.0);
  return height;
}

std::array<Real, 4> within_soil(const Mesh<2>& mesh, Index cell, const Border& border, Real share)
{
  const Vec<2> n = border.across;
  if (border.band < 0) return above_border(mesh, cell, n, share);
  const Corners corners(mesh, cell, n);
  const Real thickness = border.band == 0 ? share : 1.0 - share;  // of the band, as its share of the area
  const Real above_middle = area_above(corners.x, corners.height, border.height) / corners.area();
  const Real above = std::clamp(above_middle - 0.5 * thickness, 0.0, 1.0 - thickness);
  const auto low = above_border(mesh, cell, n, above + thickness), high = above_border(mesh, cell, n, above);
  std::array<Real, 4> within;
  for (std::size_t i = 0; i < 4; ++i) {
    within[i] = low[i] - high[i];
    if (border.band == 1) within[i] = corners.height[i] - corners.lowest() - within[i];
  }
  return within;
}

}  // namespace terp
