// An end misses a line only where no other line is within the snap distance: else it has met what it was drawn to.

#include "import/drawing/line_gaps.hpp"

#include "math/plane.hpp"
#include "model/bodies/polygon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real nearly_closed = 0.05;  // part of its length by which an outline may be open by mistake
constexpr std::size_t most_named = 3;

struct Gap {
  Vec<2> at;
  Real size;
  const std::string* layer;
};

/// From an end to the nearest other line; infinite where none is near.
Real gap_around(
    const std::vector<DxfLine>& lines, const std::vector<BoundingBox>& boxes, const DxfLine& own, Vec<2> end)
{
  Real least = INFINITY;
  const BoundingBox here{end, end};
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (&lines[k] != &own && overlap(boxes[k], here)) least = std::min(least, gap_to(lines[k], end));
  return least;
}

Real length_of(const DxfLine& line)
{
  Real sum = 0.0;
  for (std::size_t k = 0; k + 1 < line.places.size(); ++k) sum += distance(line.places[k], line.places[k + 1]);
  return sum;
}

}  // namespace

std::size_t n_sides(const DxfLine& line) { return line.places.size() - (line.closed ? 0 : 1); }

Real gap_to(const DxfLine& line, Vec<2> x)
{
  const auto square_to = [&](Vec<2> place) { return dot(between(place, x), between(place, x)); };
  Real least = square_to(line.places[0]);
  for (std::size_t k = 0; k < n_sides(line); ++k) {
    const Vec<2> a = line.places[k], b = line.places[(k + 1) % line.places.size()], side = between(a, b);
    const Real square = dot(side, side);
    const Real t = square > 0.0 ? std::clamp(dot(between(a, x), side) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, square_to(between(a, b, t)));
  }
  return std::sqrt(least);
}

BoundingBox wider(BoundingBox box, Real by)
{
  for (int d = 0; d < 2; ++d) box.low[d] -= by, box.high[d] += by;
  return box;
}

bool is_rectangle(const DxfLine& line)
{
  if (!line.closed || line.places.size() != 4) return false;
  const BoundingBox box = box_around(line.places);
  const Real area = (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]);
  return std::abs(std::abs(signed_area(line.places)) - area) <= 1e-3 * area;
}

bool is_same_outline(const DxfLine& a, const DxfLine& b, Real snap)
{
  const BoundingBox of_a = box_around(a.places), of_b = box_around(b.places);
  for (int d = 0; d < 2; ++d)
    if (std::abs(of_a.low[d] - of_b.low[d]) > snap || std::abs(of_a.high[d] - of_b.high[d]) > snap) return false;
  const auto lies_on = [&](const DxfLine& line, const DxfLine& other) {
    return std::ranges::all_of(line.places, [&](Vec<2> x) { return gap_to(other, x) <= snap; });
  };
  return lies_on(a, b) && lies_on(b, a);
}

std::string doubt_of_gaps(const std::vector<DxfLine>& lines, Real snap)
{
  std::vector<BoundingBox> boxes;
  for (const DxfLine& line : lines) boxes.push_back(wider(box_around(line.places), near_miss));
  std::vector<Gap> gaps;
  for (const DxfLine& line : lines) {
    const auto add_miss = [&](Vec<2> x) {
      if (const Real gap = gap_around(lines, boxes, line, x); gap > snap && gap < near_miss)
        gaps.push_back({x, gap, &line.layer});
    };
    if (line.closed) {
      for (const Vec<2>& x : line.places) add_miss(x);
      continue;
    }
    const Vec<2> first = line.places.front(), last = line.places.back();
    const Real gap = distance(first, last);
    const bool is_outline = line.places.size() >= 4 && gap > snap && gap < nearly_closed * length_of(line);
    if (is_outline && (gap < near_miss || gap_around(lines, boxes, line, last) > snap)) {
      gaps.push_back({last, gap, &line.layer});
      continue;
    }
    add_miss(first), add_miss(last);
  }
  if (gaps.empty()) return "";
  std::vector<std::string> named;
  for (std::size_t k = 0; k < std::min(gaps.size(), most_named); ++k)
    named.push_back(fmt::format(
        "by {:.3f} m at {:.3f}, {:.3f} m ({})", gaps[k].size, gaps[k].at[0], gaps[k].at[1], *gaps[k].layer));
  if (gaps.size() > most_named) named.push_back(fmt::format("and {} more", gaps.size() - most_named));
  return fmt::format("{} {}: {}. Let them meet within {:g} m.", gaps.size(),
      gaps.size() == 1 ? "end of a line misses another" : "ends of lines miss others", fmt::join(named, ", "), snap);
}

}  // namespace terp
