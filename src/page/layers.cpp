// Where no point of its soil is near a place of an outline, another body lies over it: there the line has a gap.

#include "page/layers.hpp"

#include "model/bodies/body_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace terp {
namespace {

constexpr Real reach = 2.0;           // of a point, in spacings: an outline passes its soil nearer than this
constexpr Real most_places = 40'000;  // of all outlines
constexpr int n_columns = 60;         // in which the place of a name is sought
constexpr Real thick = 0.9;           // of the largest thickness is enough for a name
constexpr Real margin = 0.04;         // of the width of a layer that its name keeps from the ends

using Column = std::pair<long, long>;

bool is_of(const PointsAtStart& points, std::size_t p, const std::set<Index>& materials)
{
  return is_soil(points.places, p) && materials.contains(static_cast<Index>(points.materials[p]));
}

/// Points of some materials in squares of `reach` spacings.
class Nearby {
 public:
  Nearby(const PointsAtStart& points, const std::set<Index>& materials) : points_(points), size_(reach * points.spacing)
  {
    for (std::size_t p = 0; p < points.materials.size(); ++p)
      if (is_of(points, p, materials)) squares_[square_of(place(p))].push_back(static_cast<std::uint32_t>(p));
  }

  std::optional<std::uint32_t> nearest(Vec<2> x) const
  {
    std::optional<std::uint32_t> best;
    Real least = size_ * size_;
    const auto [i, j] = square_of(x);
    for (long di = -1; di <= 1; ++di)
      for (long dj = -1; dj <= 1; ++dj) {
        const auto found = squares_.find({i + di, j + dj});
        if (found == squares_.end()) continue;
        for (const std::uint32_t p : found->second) {
          const Vec<2> y = place(p);
          const Real dx = y[0] - x[0], dy = y[1] - x[1], square = dx * dx + dy * dy;
          if (square < least) least = square, best = p;
        }
      }
    return best;
  }

  Vec<2> place(std::size_t p) const { return {points_.places[2 * p], points_.places[2 * p + 1]}; }

 private:
  Column square_of(Vec<2> x) const
  {
    return {std::lround(std::floor(x[0] / size_)), std::lround(std::floor(x[1] / size_))};
  }

  PointsAtStart points_;
  Real size_;
  std::map<Column, std::vector<std::uint32_t>> squares_;
};

void add_gap(AttachedLines& lines)
{
  if (lines.points.empty() || lines.points.back() == AttachedLines::gap) return;
  lines.points.push_back(AttachedLines::gap);
  lines.offsets.insert(lines.offsets.end(), {0.0f, 0.0f});
}

void attach(const Nearby& nearby, Vec<2> x, AttachedLines& lines)
{
  const auto point = nearby.nearest(x);
  if (!point) return add_gap(lines);
  const Vec<2> at = nearby.place(*point);
  lines.points.push_back(*point);
  lines.offsets.insert(lines.offsets.end(), {static_cast<float>(x[0] - at[0]), static_cast<float>(x[1] - at[1])});
}

/// From a to b without b, in steps of at most `step`.
void attach_side(const Nearby& nearby, const Side& side, Real step, AttachedLines& lines)
{
  const int n =
      std::max(1, static_cast<int>(std::ceil(std::hypot(side.b[0] - side.a[0], side.b[1] - side.a[1]) / step)));
  for (int k = 0; k < n; ++k) {
    const Real share = static_cast<Real>(k) / n;
    attach(nearby, {std::lerp(side.a[0], side.b[0], share), std::lerp(side.a[1], side.b[1], share)}, lines);
  }
}

std::vector<std::vector<Vec<2>>> rings_of(const BodyCase& body)
{
  std::vector<std::vector<Vec<2>>> rings = body.holes;
  if (!body.polygon.empty()) rings.push_back(body.polygon);
  return rings;
}

std::vector<Side> sides_of_region(const BodyCase& body, const Mesh<2>& mesh)
{
  for (const NamedRegion& region : mesh.regions)
    if (!body.region.empty() && region.name == body.region)
      return outline_sides(mesh, {.polygon = {}, .points_per_cell = {1, 1}, .holes = {}, .cells = region.cells});
  return {};
}

Real length_of_outlines(const Case& description)
{
  Real length = 0.0;
  for (const BodyCase& body : description.bodies)
    for (const auto& ring : rings_of(body))
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec<2>&a = ring[k], &b = ring[(k + 1) % ring.size()];
        length += std::hypot(b[0] - a[0], b[1] - a[1]);
      }
  return length;
}

void attach_body(const BodyCase& body, const Mesh<2>& mesh, const Nearby& nearby, Real step, AttachedLines& lines)
{
  for (const auto& ring : rings_of(body)) {
    add_gap(lines);
    for (std::size_t k = 0; k < ring.size(); ++k)
      attach_side(nearby, {ring[k], ring[(k + 1) % ring.size()]}, step, lines);
    attach(nearby, ring.front(), lines);
  }
  for (const Side& side : sides_of_region(body, mesh)) {
    add_gap(lines);
    attach_side(nearby, side, step, lines);
    attach(nearby, side.b, lines);
  }
}

AttachedLines middle_of(const PointsAtStart& points, const std::set<Index>& materials, const Nearby& nearby)
{
  Real left = INFINITY, right = -INFINITY;
  for (std::size_t p = 0; p < points.materials.size(); ++p)
    if (is_of(points, p, materials))
      left = std::min(left, points.places[2 * p]), right = std::max(right, points.places[2 * p]);
  if (!(right > left)) return {};
  std::array<std::vector<Real>, n_columns> heights;
  for (std::size_t p = 0; p < points.materials.size(); ++p)
    if (is_of(points, p, materials)) {
      const auto k = static_cast<std::size_t>((points.places[2 * p] - left) / (right - left) * (n_columns - 1));
      heights[k].push_back(points.places[2 * p + 1]);
    }
  std::array<Real, n_columns> thickness{}, middle{};  // of the thickest piece in each column
  for (std::size_t k = 0; k < n_columns; ++k) {
    std::ranges::sort(heights[k]);
    for (std::size_t first = 0, at = 0; at < heights[k].size(); ++at) {
      if (at > 0 && heights[k][at] - heights[k][at - 1] > reach * points.spacing) first = at;
      const Real piece = heights[k][at] - heights[k][first];
      if (piece >= thickness[k]) thickness[k] = piece, middle[k] = 0.5 * (heights[k][at] + heights[k][first]);
    }
  }
  const Real most = *std::ranges::max_element(thickness);
  for (std::size_t k = 0; k < n_columns; ++k) {
    const Real share = (static_cast<Real>(k) + 0.5) / n_columns;
    if (thickness[k] < thick * most || share < margin || share > 1.0 - margin) continue;
    AttachedLines one;
    attach(nearby, {left + share * (right - left), middle[k]}, one);
    if (!one.is_empty()) return one;
  }
  return {};
}

}  // namespace

std::vector<SoilLayer> attach_layers(const Case& description, const Mesh<2>& mesh, const PointsAtStart& points)
{
  const Real step = std::max(points.spacing, length_of_outlines(description) / most_places);
  std::vector<SoilLayer> layers;
  for (const BodyCase& first : description.bodies) {
    if (first.material.empty() || std::ranges::find(layers, first.material, &SoilLayer::soil) != layers.end()) continue;
    std::set<Index> materials;
    for (std::size_t m = 0; m < description.materials.size(); ++m)
      if (description.materials[m].called() == first.material) materials.insert(static_cast<Index>(m));
    const Nearby nearby(points, materials);
    SoilLayer& layer = layers.emplace_back(SoilLayer{first.material, {}, middle_of(points, materials, nearby)});
    for (const BodyCase& body : description.bodies)
      if (body.material == first.material) attach_body(body, mesh, nearby, step, layer.lines);
  }
  return layers;
}

AttachedLines attach_surface(const PointsAtStart& points, Real from, Real to)
{
  std::map<long, std::uint32_t> top;  // by column of one spacing
  for (std::size_t p = 0; p < points.materials.size(); ++p) {
    const Real x = points.places[2 * p];
    if (!(x >= from && x <= to)) continue;  // also where there is no soil
    const auto [entry, fresh] =
        top.try_emplace(std::lround(std::floor(x / points.spacing)), static_cast<std::uint32_t>(p));
    if (!fresh && points.places[2 * p + 1] > points.places[2 * entry->second + 1])
      entry->second = static_cast<std::uint32_t>(p);
  }
  AttachedLines lines;
  for (const auto& [column, point] : top) {
    lines.points.push_back(point);
    lines.offsets.insert(lines.offsets.end(), {0.0f, static_cast<float>(0.5 * points.spacing)});
  }
  return lines;
}

}  // namespace terp
