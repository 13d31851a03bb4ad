// The vertical line is cut at all crossings of all outlines; between two neighbouring ones one look at the middle
// decides. Excavations only lower the top of what is found.

#include "import/dstability/ground_column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace terp {
namespace {

/// Elevations at which an outline crosses the vertical line, ascending. An edge belongs to its left end and not to its
/// right one, so that a corner counts once; at the right end of the section the other way round.
std::vector<Real> crossings(const StixLine& outline, Real x, bool at_right_end)
{
  std::vector<Real> levels;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec<2> a = outline[k], b = outline[k + 1 < outline.size() ? k + 1 : 0];
    const Real left = std::min(a[0], b[0]), right = std::max(a[0], b[0]);
    const bool spans = at_right_end ? left < x && x <= right : left <= x && x < right;
    if (spans) levels.push_back(a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])));
  }
  std::ranges::sort(levels);
  return levels;
}

struct Crossed {
  std::size_t layer;
  Real area;
  std::vector<Real> levels;

  bool contains(Real z) const
  {
    return std::ranges::count_if(levels, [z](Real level) { return level < z; }) % 2 == 1;
  }
};

/// Where the excavations leave ground at most [m].
Real dug_to(const std::vector<StixLine>& excavations, Real x)
{
  Real lowest = std::numeric_limits<Real>::infinity();
  for (const StixLine& line : excavations)
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Vec<2> a = line[k], b = line[k + 1];
      if (x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
      const Real z = a[0] == b[0] ? std::min(a[1], b[1]) : a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0]));
      lowest = std::min(lowest, z);
    }
  return lowest;
}

}  // namespace

BoundingBox box_around(const std::vector<StixLayer>& layers)
{
  constexpr Real far = std::numeric_limits<Real>::infinity();
  BoundingBox box{{far, far}, {-far, -far}};
  for (const StixLayer& layer : layers)
    for (const Vec<2>& x : layer.outline)
      for (std::size_t d = 0; d < 2; ++d)
        box.low[d] = std::min(box.low[d], x[d]), box.high[d] = std::max(box.high[d], x[d]);
  return box;
}

std::vector<SoilBand> soil_bands(const StixStage& stage, Real x)
{
  const auto [low, high] = box_around(stage.layers);
  const Real inside = std::clamp(x, low[0], std::max(low[0], high[0]));
  std::vector<Crossed> crossed;
  std::vector<Real> levels;
  for (std::size_t k = 0; k < stage.layers.size(); ++k) {
    const StixLine& outline = stage.layers[k].outline;
    std::vector<Real> at = crossings(outline, inside, inside >= high[0]);
    if (at.empty()) continue;
    levels.insert(levels.end(), at.begin(), at.end());
    crossed.push_back({k, std::abs(signed_area(outline)), std::move(at)});
  }
  std::ranges::sort(levels, std::ranges::greater{});
  std::ranges::sort(crossed, {}, &Crossed::area);
  const Real limit = dug_to(stage.excavations, inside);
  std::vector<SoilBand> bands;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const Real top = std::min(levels[k], limit), bottom = levels[k + 1];
    if (!(top > bottom)) continue;
    const Real middle = std::midpoint(levels[k], bottom);
    const auto holds = std::ranges::find_if(crossed, [middle](const Crossed& c) { return c.contains(middle); });
    if (holds == crossed.end()) continue;
    if (!bands.empty() && bands.back().layer == holds->layer && bands.back().bottom == top)
      bands.back().bottom = bottom;
    else
      bands.push_back({top, bottom, holds->layer});
  }
  return bands;
}

const SoilBand* band_at(const std::vector<SoilBand>& bands, Real z)
{
  if (bands.empty() || z > bands.front().top) return nullptr;
  const SoilBand* nearest = &bands.front();
  Real distance = std::numeric_limits<Real>::infinity();
  for (const SoilBand& band : bands) {
    const Real away = std::max({band.bottom - z, z - band.top, 0.0});
    if (away < distance) distance = away, nearest = &band;
  }
  return nearest;
}

}  // namespace terp
