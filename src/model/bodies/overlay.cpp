// Level lines are left out: the lines that meet their ends give the heights at which strips begin. From left to right
// through a strip, each line toggles whether the place is in its ring, so a ring may touch itself. A line outside of
// the quadrilateral is moved to its nearest side: there it still toggles its ring, before or behind all soil.
// Trapezoids of one body join with those above that share part of a side; a part stays whole if it holds its centroid.

#include "model/bodies/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace terp {
namespace {

/// Heights closer than this part of the quadrilateral's are one; trapezoids that share less of a side do not touch.
/// Above the round-off of crossings, below anything drawn on purpose.
constexpr Real resolution = 1e-13;

/// A line that is not level; a is its lower end.
struct Line {
  Vec<2> a, b;
  int ring;  ///< -1: a side of the quadrilateral

  /// Never beyond its ends, so that a nearly level line stays where it is.
  Real x_at(Real y) const
  {
    const Real x = a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
    return std::clamp(x, std::min(a[0], b[0]), std::max(a[0], b[0]));
  }
};

/// Ends at the heights low and high of its strip.
struct Cut {
  Real middle, low, high;  ///< x at half the height, at the bottom, at the top
  int ring;
};

struct Trapezoid {
  Index body;
  Real y0, y1, left0, left1, right0, right1;

  Real area() const { return 0.5 * (y1 - y0) * ((right0 - left0) + (right1 - left1)); }

  /// Integrals of x and y over it [m^3].
  Vec<2> moments() const
  {
    const Real h = y1 - y0, w0 = right0 - left0, w1 = right1 - left1;
    const auto sum = [](Real p, Real q) { return p * p + p * q + q * q; };
    return {h / 6.0 * (sum(right0, right1) - sum(left0, left1)), area() * y0 + h * h * (w0 / 6.0 + w1 / 3.0)};
  }

  bool holds(Vec<2> x) const
  {
    if (x[1] < y0 || x[1] > y1) return false;
    const Real t = (x[1] - y0) / (y1 - y0);
    return x[0] >= left0 + t * (left1 - left0) && x[0] <= right0 + t * (right1 - right0);
  }
};

void add_lines(std::span<const Vec<2>> corners, int ring, const BoundingBox& box, std::vector<Line>& lines)
{
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Vec<2> a = corners[k], b = corners[(k + 1) % corners.size()];
    if (a[1] == b[1]) continue;
    if (a[1] > b[1]) std::swap(a, b);
    if (a[1] < box.high[1] && b[1] > box.low[1]) lines.push_back({a, b, ring});
  }
}

/// Where the line from a to b crosses or touches the one from c to e, as a share of the way to b. Parallel to
/// round-off: nowhere, for what lies between them has no area.
std::optional<Real> share_to_crossing(Vec<2> a, Vec<2> b, Vec<2> c, Vec<2> e)
{
  const Vec<2> r{b[0] - a[0], b[1] - a[1]}, s{e[0] - c[0], e[1] - c[1]}, d{c[0] - a[0], c[1] - a[1]};
  const Real det = r[0] * s[1] - r[1] * s[0];
  if (std::abs(det) <= resolution * std::hypot(r[0], r[1]) * std::hypot(s[0], s[1])) return std::nullopt;
  const Real t = (d[0] * s[1] - d[1] * s[0]) / det, u = (d[0] * r[1] - d[1] * r[0]) / det;
  if (t < 0.0 || t > 1.0 || u < 0.0 || u > 1.0) return std::nullopt;
  return t;
}

/// Bounds of the strips, ascending, from the bottom to the top of the box.
std::vector<Real> find_heights(std::vector<Line>& lines, const BoundingBox& box)
{
  std::vector<Real> all;
  for (const Line& line : lines) all.insert(all.end(), {line.a[1], line.b[1]});
  std::vector<const Line*> near;  // only these can cross within the quadrilateral
  for (const Line& line : lines)
    if (crosses(box, line.a, line.b)) near.push_back(&line);
  for (std::size_t k = 0; k < near.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (const auto t = share_to_crossing(near[k]->a, near[k]->b, near[other]->a, near[other]->b))
        all.push_back(near[k]->a[1] + *t * (near[k]->b[1] - near[k]->a[1]));
  std::ranges::sort(all);
  const Real apart = resolution * (box.high[1] - box.low[1]);
  std::vector<Real> heights{box.low[1]};
  for (const Real y : all)
    if (y > heights.back() + apart && y < box.high[1] - apart) heights.push_back(y);
  heights.push_back(box.high[1]);
  return heights;
}

/// Lines through a strip from left to right, between the quadrilateral's own two sides, which come first and last.
std::vector<Cut> cut_strip(const std::vector<Line>& lines, Real y0, Real y1)
{
  const Real y = 0.5 * (y0 + y1);
  std::vector<Cut> cuts;
  std::vector<Cut> sides;
  for (const Line& line : lines)
    if (line.a[1] <= y && line.b[1] > y)
      (line.ring < 0 ? sides : cuts).push_back({line.x_at(y), line.x_at(y0), line.x_at(y1), line.ring});
  if (sides.size() != 2) return {};  // less than round-off of the quadrilateral's height
  if (sides[0].middle > sides[1].middle) std::swap(sides[0], sides[1]);
  for (Cut& cut : cuts) {
    cut.middle = std::clamp(cut.middle, sides[0].middle, sides[1].middle);
    cut.low = std::clamp(cut.low, sides[0].low, std::max(sides[0].low, sides[1].low));
    cut.high = std::clamp(cut.high, sides[0].high, std::max(sides[0].high, sides[1].high));
  }
  std::ranges::stable_sort(cuts, [](const Cut& a, const Cut& b) { return a.middle < b.middle; });
  cuts.insert(cuts.begin(), sides[0]);
  cuts.push_back(sides[1]);
  return cuts;
}

Index top_of(const Overlay& overlay, const std::vector<char>& inside)
{
  Index top = overlay.ground, body = -1;
  bool in_body = false;
  for (std::size_t k = 0; k < overlay.rings.size(); ++k) {
    const Ring& ring = overlay.rings[k];
    if (ring.body != body && in_body) top = body;
    if (ring.body != body) in_body = false;
    body = ring.body;
    in_body = ring.is_hole ? in_body && !inside[k] : inside[k];
  }
  return in_body ? body : top;
}

void share_out_strip(
    const Overlay& overlay, const std::vector<Cut>& cuts, Real y0, Real y1, std::vector<Trapezoid>& trapezoids)
{
  const std::size_t first = trapezoids.size();
  std::vector<char> inside(overlay.rings.size(), 0);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (cuts[k].ring >= 0) inside[cuts[k].ring] ^= 1;
    const Cut &left = cuts[k], &right = cuts[k + 1];
    if (right.middle <= left.middle) continue;
    const Index body = top_of(overlay, inside);
    if (trapezoids.size() > first && trapezoids.back().body == body) {  // a line that parts nothing here
      trapezoids.back().right0 = right.low;
      trapezoids.back().right1 = right.high;
    } else {
      trapezoids.push_back({body, y0, y1, left.low, left.high, right.low, right.high});
    }
  }
}

/// Gives each trapezoid the number of the first one that it hangs together with.
std::vector<std::size_t> connect_trapezoids(const std::vector<Trapezoid>& trapezoids, Real width)
{
  std::vector<std::size_t> group(trapezoids.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t upper = 0; upper < trapezoids.size(); ++upper)
    for (std::size_t lower = 0; lower < upper; ++lower) {
      const Trapezoid &a = trapezoids[lower], &b = trapezoids[upper];
      const Real shared = std::min(a.right1, b.right0) - std::max(a.left1, b.left0);
      if (a.body != b.body || a.y1 != b.y0 || shared <= resolution * width || group[lower] == group[upper]) continue;
      const auto [keep, drop] = std::minmax(group[lower], group[upper]);
      std::ranges::replace(group, std::size_t{drop}, std::size_t{keep});
    }
  return group;
}

/// The trapezoids of one group as one part, or each by itself if the centroid of all lies in none.
void add_parts(const std::vector<Trapezoid>& group, std::vector<Part>& parts)
{
  Real area = 0.0;
  Vec<2> moments{0.0, 0.0};
  for (const Trapezoid& t : group) {
    area += t.area();
    for (int d = 0; d < 2; ++d) moments[d] += t.moments()[d];
  }
  if (area <= 0.0) return;
  const Vec<2> centroid{moments[0] / area, moments[1] / area};
  const bool holds = std::ranges::any_of(group, [&](const Trapezoid& t) { return t.holds(centroid); });
  if (holds || group.size() == 1) {
    parts.push_back({group.front().body, area, centroid});
  } else {
    for (const Trapezoid& t : group) add_parts({t}, parts);
  }
}

}  // namespace

Index top_body(const Overlay& overlay, Vec<2> x)
{
  std::vector<char> inside(overlay.rings.size());
  for (std::size_t k = 0; k < inside.size(); ++k) inside[k] = contains(overlay.rings[k].corners, x);
  return top_of(overlay, inside);
}

bool stays_in_body(const Overlay& overlay, Index body, Vec<2> a, Vec<2> b)
{
  std::vector<Real> shares{0.0, 1.0};
  for (const Ring& ring : overlay.rings)
    for (std::size_t k = 0; k < ring.corners.size(); ++k)
      if (const auto t = share_to_crossing(a, b, ring.corners[k], ring.corners[(k + 1) % ring.corners.size()]))
        shares.push_back(*t);
  std::ranges::sort(shares);
  for (std::size_t k = 1; k < shares.size(); ++k) {
    const Real t = 0.5 * (shares[k - 1] + shares[k]);
    const bool is_way = shares[k] - shares[k - 1] > resolution;
    if (is_way && top_body(overlay, {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}) != body) return false;
  }
  return true;
}

std::vector<Part> share_out(const Overlay& overlay, const std::array<Vec<2>, 4>& corners)
{
  const BoundingBox box = box_around(corners);
  std::vector<Line> lines;
  add_lines(corners, -1, box, lines);
  for (std::size_t k = 0; k < overlay.rings.size(); ++k)
    add_lines(overlay.rings[k].corners, static_cast<int>(k), box, lines);
  const std::vector<Real> heights = find_heights(lines, box);
  std::vector<Trapezoid> trapezoids;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k)
    share_out_strip(overlay, cut_strip(lines, heights[k], heights[k + 1]), heights[k], heights[k + 1], trapezoids);
  std::erase_if(trapezoids, [](const Trapezoid& t) { return t.body < 0; });
  const auto group = connect_trapezoids(trapezoids, box.high[0] - box.low[0]);
  std::vector<Part> parts;
  for (std::size_t first = 0; first < trapezoids.size(); ++first) {
    std::vector<Trapezoid> together;
    for (std::size_t k = first; k < trapezoids.size(); ++k)
      if (group[k] == first) together.push_back(trapezoids[k]);
    if (!together.empty()) add_parts(together, parts);
  }
  return parts;
}

}  // namespace terp
