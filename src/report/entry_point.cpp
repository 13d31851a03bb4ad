#include "report/entry_point.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real crest_share = 0.05;  // of the height of the slope below the highest ground still counts as crest

/// Height of the ground at x; none beyond its ends.
std::optional<Real> height_at(std::span<const float> ground, Real x)
{
  for (std::size_t k = 2; k + 1 < ground.size(); k += 2) {
    const Real a = ground[k - 2], b = ground[k];
    if (x >= a && x <= b) return std::lerp(Real{ground[k - 1]}, Real{ground[k + 1]}, b > a ? (x - a) / (b - a) : 0.0);
  }
  return std::nullopt;
}

}  // namespace

std::optional<EntryPoint> entry_point(const SlideSummary& slide, std::span<const float> ground)
{
  const auto& line = slide.slip.line;
  if (line.empty() || ground.size() < 4) return std::nullopt;
  const bool to_the_right = slide.slide.facing == Facing::right;
  const Real x = to_the_right ? line.front()[0] : line.back()[0];
  const std::optional<Real> y = height_at(ground, x);
  if (!y) return std::nullopt;
  std::size_t top = 1;  // number of the height of the highest ground
  for (std::size_t k = 1; k < ground.size(); k += 2)
    if (ground[k] > ground[top]) top = k;
  const Real foot = to_the_right ? ground.back() : ground[1], height = ground[top] - foot;
  const Real lowest_crest = ground[top] - crest_share * height;
  std::size_t low = top, high = top;  // ends of the crest
  while (low >= 3 && ground[low - 2] >= lowest_crest) low -= 2;
  while (high + 2 < ground.size() && ground[high + 2] >= lowest_crest) high += 2;
  const Real left = ground[low - 1], right = ground[high - 1];
  if (x >= left && x <= right) return EntryPoint{x, *y, "crest"};
  if (to_the_right ? x < left : x > right) return EntryPoint{x, *y, "beyond_crest"};
  return EntryPoint{x, *y, *y - foot >= 0.5 * height ? "upper_half" : "lower_half"};
}

}  // namespace terp
