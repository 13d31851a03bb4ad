// A yield stress that is not sigma'_v of the first stage plus one POP is written on a grid, column by column. A case
// interpolates between the places of its grid, so values beyond a layer continue those within it. Near its boundaries a
// layer is not asked for, as cleaning may have moved these over soil of another one.

#include "import/dstability/preload.hpp"

#include "import/dstability/section_layout.hpp"
#include "import/dstability/reported_texts.hpp"
#include "model/bodies/body_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real same_pop = 100.0;    // [Pa] by which the POP of a layer may vary and still be one number
constexpr Real least_yield = 1e3;   // [Pa]
constexpr Real least_rest = 100.0;  // [Pa] of a yield stress without its POP
constexpr Real moved = 0.03;        // [m] within which cleaning may have moved a boundary: the file is not asked there
constexpr Real steepest = 30e3;     // [Pa/m] that a yield stress grows by with depth

struct Interval {
  Real low, high;
};

/// Where the vertical line at x lies in a region, from the bottom up.
std::vector<Interval> intervals_at(const CleanRegion& region, Real x)
{
  const std::vector<Side> sides = outline_sides({}, BodyOutline{region.polygon, {1, 1}, region.holes});
  const std::vector<Real> heights = crossings_of_vertical(sides, x);
  std::vector<Interval> found;
  for (std::size_t k = 0; k + 1 < heights.size(); k += 2) found.push_back({heights[k], heights[k + 1]});
  return found;
}

/// The same without what cleaning may have moved.
std::vector<Interval> inner_intervals(const CleanRegion& region, Real x)
{
  std::vector<Interval> found = intervals_at(region, x);
  for (Interval& part : found) {
    const Real margin = std::min(moved, 0.25 * (part.high - part.low));
    part = {part.low + margin, part.high - margin};
  }
  return found;
}

/// The yield stress along a vertical line in pieces of layers, from the file within them and straight on beyond.
class YieldLine {
 public:
  YieldLine(const StixSection& section, const std::vector<LayerPiece>& pieces, Real x) : column_(section.column(x))
  {
    for (const LayerPiece& piece : pieces)
      std::ranges::copy(inner_intervals(*piece.region, x), std::back_inserter(parts_));
  }

  bool empty() const { return parts_.empty(); }

  Real at(Real z) const
  {
    const auto away = [z](const Interval& part) { return std::max({part.low - z, z - part.high, 0.0}); };
    const Interval& part = *std::ranges::min_element(parts_, {}, away);
    if (away(part) == 0.0) return of_file(z);
    const Real edge = z > part.high ? part.high : part.low, length = std::min(part.high - part.low, 0.5);
    const Real inside = of_file(z > part.high ? edge - length : edge + length), at_edge = of_file(edge);
    const Real slope = length > 0.0 ? std::clamp((at_edge - inside) / length, -steepest, steepest) : 0.0;
    return std::max(at_edge + slope * away(part), least_yield);
  }

 private:
  Real of_file(Real z) const
  {
    const auto place = column_.at(std::min(z, column_.ground()));
    return place ? std::max(place->yield_stress, least_yield) : least_yield;
  }

  StixColumn column_;
  std::vector<Interval> parts_;
};

/// The x next to a given one at which a vertical line goes through a piece.
Real nearest_in(const std::vector<LayerPiece>& pieces, Real x)
{
  Real nearest = x, distance = 1e30;
  for (const LayerPiece& piece : pieces) {
    const BoundingBox box = box_around(piece.region->polygon);
    const Real inside = std::min(1e-6, 0.25 * (box.high[0] - box.low[0]));
    const Real there = std::clamp(x, box.low[0] + inside, box.high[0] - inside);
    if (std::abs(there - x) < distance) distance = std::abs(there - x), nearest = there;
  }
  return nearest;
}

struct GridValues {
  Vec<2> low;
  Real dx, dz;
  int nx, nz;                ///< rectangles
  std::vector<Real> values;  ///< z within x

  Real at(Vec<2> x) const
  {
    const Real s = (x[0] - low[0]) / dx, t = (x[1] - low[1]) / dz;
    const int i = std::clamp(static_cast<int>(s), 0, nx - 1), j = std::clamp(static_cast<int>(t), 0, nz - 1);
    const auto value = [&](int a, int b) { return values[static_cast<std::size_t>(a) * (nz + 1) + b]; };
    return std::lerp(
        std::lerp(value(i, j), value(i + 1, j), s - i), std::lerp(value(i, j + 1), value(i + 1, j + 1), s - i), t - j);
  }
};

/// The largest difference between a grid and the yield stress of the file in a piece of a layer [Pa].
Real deviation_in(const LayerPiece& piece, const GridValues& grid, const StixSection& section)
{
  const BoundingBox box = box_around(piece.region->polygon);
  Real most = 0.0;
  for (Real x = box.low[0] + 0.35 * grid.dx; x < box.high[0]; x += 0.7 * grid.dx) {
    const StixColumn column = section.column(x);
    for (const auto& [low, high] : inner_intervals(*piece.region, x)) {
      const int n = std::max(1, static_cast<int>(std::ceil((high - low) / (0.7 * grid.dz))));
      for (int k = 0; k <= n; ++k) {
        const Real z = std::lerp(low, high, static_cast<Real>(k) / n);
        if (const auto there = column.at(z); there && there->layer == piece.layer)
          most = std::max(most, std::abs(grid.at({x, z}) - std::max(there->yield_stress, least_yield)));
      }
    }
  }
  return most;
}

}  // namespace

bool same_outlines_until(const StixScenario& scenario, std::size_t stage)
{
  const StixStage& last = scenario.stages[stage];
  const auto is_same = [](const StixLayer& a, const StixLayer& b) {
    return a.outline == b.outline && a.soil == b.soil;
  };
  return std::ranges::all_of(scenario.stages.begin(), scenario.stages.begin() + static_cast<std::ptrdiff_t>(stage),
      [&](const StixStage& before) {
        return before.excavations == last.excavations && std::ranges::equal(before.layers, last.layers, is_same);
      });
}

bool same_ground_until(const StixScenario& scenario, std::size_t stage)
{
  const auto before = scenario.stages.begin();
  return same_outlines_until(scenario, stage) &&
         std::ranges::all_of(before, before + static_cast<std::ptrdiff_t>(stage),
             [](const StixStage& earlier) { return earlier.loads.empty(); });
}

std::optional<Real> constant_pop(const StixSection& now, const StixSection& first, const LayerPiece& piece, Real cell)
{
  Real low = 1e30, high = -1e30;
  for (const auto& [x, z] : places_in(*piece.region, cell)) {
    const auto place = now.at({x, z});
    const auto before = first.at({x, z});
    if (!place || !before || place->load_stress > 0.0 || place->layer != piece.layer) continue;
    low = std::min(low, place->yield_stress - before->effective_stress);
    high = std::max(high, place->yield_stress - before->effective_stress);
  }
  if (low > high || !(high - low < same_pop) || low < 0.0) return std::nullopt;
  return std::round(0.5 * (low + high));
}

std::string pop_history(const StixSection& now, const LayerPiece& piece, Real cell)
{
  std::vector<Real> low, high;
  for (const auto& [x, z] : places_in(*piece.region, 2.0 * cell)) {
    const StixColumn column = now.column(x);
    if (const auto place = column.at(z); !place || place->layer != piece.layer) continue;
    const std::vector<Real> pops = column.pops(z);
    if (low.empty()) low = high = pops;
    for (std::size_t k = 0; k < pops.size(); ++k)
      low[k] = std::min(low[k], pops[k]), high[k] = std::max(high[k], pops[k]);
  }
  std::string text;
  for (std::size_t k = 0; k < low.size(); ++k) {
    if (!(high[k] - low[k] < same_pop)) return fmt::format("layer {}", piece.layer);
    text += fmt::format("{:.0f} ", 0.5 * (low[k] + high[k]) / same_pop);
  }
  return text.empty() ? fmt::format("layer {}", piece.layer) : text;
}

YieldGrid yield_grid(const StixSection& now, const std::vector<LayerPiece>& pieces, Real cell, Real less)
{
  BoundingBox box = box_around(pieces.front().region->polygon);
  for (const LayerPiece& piece : pieces)
    for (const BoundingBox more = box_around(piece.region->polygon); const int d : {0, 1}) {
      box.low[d] = std::min(box.low[d], more.low[d]);
      box.high[d] = std::max(box.high[d], more.high[d]);
    }
  GridValues grid{box.low, cell, 0.5 * cell, 0, 0, {}};
  grid.nx = std::max(1, static_cast<int>(std::ceil((box.high[0] - box.low[0]) / grid.dx)));
  grid.nz = std::max(1, static_cast<int>(std::ceil((box.high[1] - box.low[1]) / grid.dz)));
  YieldGrid made{"x,y,value\n"};
  for (int i = 0; i <= grid.nx; ++i) {
    const Real x = box.low[0] + i * grid.dx;
    const YieldLine line(now, pieces, nearest_in(pieces, x));
    for (int j = 0; j <= grid.nz; ++j) {
      const Real z = box.low[1] + j * grid.dz;
      grid.values.push_back(line.empty() ? least_yield : line.at(z));
      const Real written = std::max(grid.values.back() - less, less > 0.0 ? least_rest : 0.0);
      made.csv += fmt::format("{},{},{:.1f}\n", number_text(x), number_text(z), written);
    }
  }
  for (const LayerPiece& piece : pieces) made.deviation = std::max(made.deviation, deviation_in(piece, grid, now));
  return made;
}

Sentence sentence_on(const YieldGrid& grid, const std::string& soil)
{
  return filled<reported_texts::yield_grid>(soil, grid.deviation / 1e3);
}

}  // namespace terp
