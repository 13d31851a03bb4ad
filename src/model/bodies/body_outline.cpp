// First each closed line by itself; only if all are sound, holes against the polygon, then against each other. Lines
// cross if each has its ends on both sides of the other, farther from it than round-off: outlines may touch. A hole
// that leaves the polygon through a corner crosses no side. So the corners of holes are tested, too.

#include "model/bodies/body_outline.hpp"

#include "math/plane.hpp"
#include "model/meshes/mesh_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace terp {
namespace {

/// Area over the square of the longest extent, below which a polygon is a line: above the round-off of its area.
constexpr Real no_area = 1e-12;

Side side_of(const Polygon& polygon, std::size_t k) { return {polygon[k], polygon[(k + 1) % polygon.size()]}; }

std::string side_text(const Side& side)
{
  return fmt::format("from {} to {} m", place_text(side.a), place_text(side.b));
}

/// Where two sides cross in their interiors; sides that only touch do not.
std::optional<Vec<2>> crossing(const Side& one, const Side& two)
{
  for (int d = 0; d < 2; ++d)
    if (std::max(one.a[d], one.b[d]) < std::min(two.a[d], two.b[d]) ||
        std::max(two.a[d], two.b[d]) < std::min(one.a[d], one.b[d]))
      return std::nullopt;
  const Real a = cross(two.a, two.b, one.a), b = cross(two.a, two.b, one.b);
  const Real c = cross(one.a, one.b, two.a), d = cross(one.a, one.b, two.b);
  if (!(a * b < 0.0 && c * d < 0.0)) return std::nullopt;
  const Real touch = no_area * (distance(one.a, one.b) * distance(two.a, two.b));
  if (std::min(std::abs(a), std::abs(b)) <= touch || std::min(std::abs(c), std::abs(d)) <= touch) return std::nullopt;
  return between(one.a, one.b, a / (a - b));
}

Polygon without_repeated_corners(const Polygon& polygon)
{
  Polygon kept;
  for (const auto& x : polygon)
    if (kept.empty() || x != kept.back()) kept.push_back(x);
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

std::optional<std::string> self_crossing(const Polygon& polygon)
{
  for (std::size_t k = 0; k < polygon.size(); ++k)
    for (std::size_t other = k + 1; other < polygon.size(); ++other)
      if (const auto x = crossing(side_of(polygon, k), side_of(polygon, other)))
        return fmt::format("its side {} crosses its side {} at {} m", side_text(side_of(polygon, k)),
            side_text(side_of(polygon, other)), place_text(*x));
  return std::nullopt;
}

std::optional<Vec<2>> first_crossing(const Polygon& one, const Polygon& two)
{
  for (std::size_t k = 0; k < one.size(); ++k)
    for (std::size_t other = 0; other < two.size(); ++other)
      if (const auto x = crossing(side_of(one, k), side_of(two, other))) return x;
  return std::nullopt;
}

bool on_outline(const Polygon& polygon, Vec<2> x)
{
  const BoundingBox box = box_around(polygon);
  const Real touch = no_area * distance(box.low, box.high);
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (distance_to_line(polygon[k], polygon[(k + 1) % polygon.size()], x) <= touch) return true;
  return false;
}

/// Checks one closed line by itself; true if it is sound.
bool check_ring(const Polygon& polygon, const std::string& name, std::vector<std::string>& found)
{
  const std::size_t before = found.size();
  for (const auto& x : polygon)
    if (!std::isfinite(x[0] + x[1]))
      found.push_back(fmt::format("{} has a corner that is not a number: {}", name, place_text(x)));
  if (found.size() > before) return false;
  const Polygon corners = without_repeated_corners(polygon);
  if (corners.size() < 3) {
    found.push_back(fmt::format("{} has {} different corner{}{}; it needs at least 3", name, corners.size(),
        corners.size() == 1 ? "" : "s", corners.empty() ? "" : " from " + place_text(corners.front()) + " m"));
    return false;
  }
  if (const auto text = self_crossing(corners)) {
    found.push_back(fmt::format("{} crosses itself: {}", name, *text));
    return false;
  }
  const BoundingBox box = box_around(corners);
  const Real extent = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  if (std::abs(signed_area(corners)) > no_area * extent * extent) return true;
  found.push_back(fmt::format("{} has no area: all its corners lie on a line in the box from {} to {} m", name,
      place_text(box.low), place_text(box.high)));
  return false;
}

std::string hole_name(std::size_t k) { return fmt::format("hole {}", k + 1); }

void check_hole_in_polygon(
    const Polygon& polygon, const Polygon& hole, const std::string& name, std::vector<std::string>& found)
{
  for (const auto& x : hole)
    if (!contains(polygon, x) && !on_outline(polygon, x)) {
      found.push_back(fmt::format("{} lies outside its body: its corner {} m", name, place_text(x)));
      return;
    }
  if (const auto x = first_crossing(hole, polygon))
    found.push_back(fmt::format("{} lies outside its body: it crosses the polygon at {} m", name, place_text(*x)));
}

void check_holes_apart(const BodyOutline& body, std::size_t one, std::size_t two, std::vector<std::string>& found)
{
  const Polygon &a = body.holes[one], &b = body.holes[two];
  const auto within = [](const Polygon& inner, const Polygon& outer) {
    return std::ranges::all_of(inner, [&](Vec<2> x) { return contains(outer, x) || on_outline(outer, x); });
  };
  if (const auto x = first_crossing(a, b))
    found.push_back(fmt::format("{} and {} cross at {} m", hole_name(one), hole_name(two), place_text(*x)));
  else if (within(a, b) || within(b, a))
    found.push_back(fmt::format(
        "{} and {} lie in each other at {} m", hole_name(one), hole_name(two), place_text(within(a, b) ? a[0] : b[0])));
}

}  // namespace

bool covers(const BodyOutline& body, Vec<2> x)
{
  const auto in_hole = [&](const Polygon& hole) { return contains(hole, x); };
  return contains(body.polygon, x) && std::ranges::none_of(body.holes, in_hole);
}

std::vector<Side> outline_sides(const Mesh<2>& mesh, const BodyOutline& body)
{
  std::vector<Side> sides;
  const auto add = [&](const Polygon& polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k) sides.push_back(side_of(polygon, k));
  };
  add(body.polygon);
  for (const Polygon& hole : body.holes) add(hole);
  std::vector<char> is_in(body.cells.empty() ? 0 : mesh.cells.size(), 0);
  for (const Index cell : body.cells) is_in[cell] = 1;
  for (const Index cell : body.cells)
    for (int k = 0; k < 4; ++k) {
      const Index other = mesh.neighbours[cell][k];
      if (other == outside || !is_in[other])
        sides.push_back({mesh.nodes[mesh.cells[cell][k]], mesh.nodes[mesh.cells[cell][(k + 1) % 4]]});
    }
  return sides;
}

std::vector<Real> crossings_of_vertical(std::span<const Side> sides, Real x)
{
  std::vector<Real> heights;
  for (const Side& side : sides)
    if ((side.a[0] > x) != (side.b[0] > x)) heights.push_back(height_at(side, x));
  std::ranges::sort(heights);
  return heights;
}

bool encloses(std::span<const Side> sides, Vec<2> x)
{
  return std::ranges::count_if(crossings_of_vertical(sides, x[0]), [&](Real y) { return y > x[1]; }) % 2 == 1;
}

Real area(const BodyOutline& body)
{
  Real sum = std::abs(signed_area(body.polygon));
  for (const Polygon& hole : body.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

std::vector<std::string> check_outline(const BodyOutline& body)
{
  std::vector<std::string> found;
  if (!body.cells.empty()) {
    if (!body.polygon.empty() || !body.holes.empty())
      found.push_back("a body of whole cells has no polygon and no holes");
    return found;
  }
  bool sound = check_ring(body.polygon, "the polygon", found);
  for (std::size_t k = 0; k < body.holes.size(); ++k) sound = check_ring(body.holes[k], hole_name(k), found) && sound;
  if (!sound) return found;
  for (std::size_t k = 0; k < body.holes.size(); ++k) {
    check_hole_in_polygon(body.polygon, body.holes[k], hole_name(k), found);
    for (std::size_t other = 0; other < k; ++other) check_holes_apart(body, other, k, found);
  }
  return found;
}

}  // namespace terp
