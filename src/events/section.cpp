#include "events/section.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace terp {
namespace {

constexpr Real level = 0.05;  // of the height: what lies within this of the highest surface belongs to the crest [-]
constexpr Index fewest_columns = 2;  // beside the crest, for a slope: the last column may be narrow and empty

/// Height of the highest surface [m].
Real highest(const Section& section)
{
  Real y = section.base;
  for (const Real h : section.heights)
    if (std::isfinite(h)) y = std::max(y, h);
  return y;
}

/// The column at distance k from the side that a slope faces.
Index from_side(const Section& section, Facing facing, Index k)
{
  return facing == Facing::right ? section.columns.n - 1 - k : k;
}

/// The edge of a column that is nearer to the side, or farther from it [m].
Real outer_edge(const Section& section, Facing facing, Index column)
{
  return section.columns.left + section.columns.width * (facing == Facing::right ? column + 1 : column);
}

/// True if at least two columns at the side have no soil.
bool has_free_toe(const Section& section, Facing facing)
{
  for (Index k = 0; k < fewest_columns; ++k)
    if (std::isfinite(section.heights[from_side(section, facing, k)])) return false;
  return true;
}

/// The height of the ground at the side that a slope faces [m].
Real ground_at_side(const Section& section, Facing facing)
{
  for (Index k = 0; k < section.columns.n; ++k)
    if (const Real h = section.heights[from_side(section, facing, k)]; std::isfinite(h)) return h;
  return section.base;
}

/// The level to which the ground comes down on a side: that at the side, or the lowest point where no soil is [m].
Real foot(const Section& section, Facing facing)
{
  return has_free_toe(section, facing) ? section.base : ground_at_side(section, facing);
}

/// How many columns from the side the first is that fits.
template <class F>
Index count_from_side(const Section& section, Facing facing, F&& fits)
{
  Index k = 0;
  while (k < section.columns.n && !fits(section.heights[from_side(section, facing, k)])) ++k;
  return k;
}

/// The slope between the crest and a side; none if the crest reaches the side.
std::optional<Slope> find_slope(const Section& section, Facing facing)
{
  const Real crest_level = highest(section) - level * relief(section);
  const auto in_crest = [&](Real h) { return h >= crest_level; };
  const Index beside = count_from_side(section, facing, in_crest);
  const Index behind = count_from_side(section, facing == Facing::right ? Facing::left : Facing::right, in_crest);
  if (beside < fewest_columns) return std::nullopt;
  Slope slope{.facing = facing};
  const Index n = section.columns.n;
  slope.first = facing == Facing::right ? behind : beside;
  slope.last = n - (facing == Facing::right ? beside : behind);
  slope.free_toe = has_free_toe(section, facing);
  slope.height = highest(section) - foot(section, facing);
  slope.crest = outer_edge(section, facing, facing == Facing::right ? slope.last - 1 : slope.first);
  const Real low = highest(section) - (1.0 - level) * slope.height;
  const auto in_slope = [&](Real h) { return slope.free_toe ? std::isfinite(h) : h > low; };
  if (const Index k = count_from_side(section, facing, in_slope); k < n)
    slope.toe = outer_edge(section, facing, from_side(section, facing, k));
  return slope;
}

}  // namespace

Columns columns_between(Real left, Real right, Real width)
{
  return {left, width, static_cast<Index>(std::ceil((right - left) / width - 1e-9))};
}

Section look_at_section(const Mesh<2>& mesh, const PointBlocks<2>& points, Columns columns)
{
  return {columns, surface_heights(mesh, points, columns), lowest(points)};
}

Real relief(const Section& section)
{
  return highest(section) - std::min(foot(section, Facing::right), foot(section, Facing::left));
}

bool is_flat(const Section& section) { return !(relief(section) >= section.columns.width); }

std::vector<Slope> find_slopes(const Section& section)
{
  std::vector<Slope> slopes;
  if (section.columns.n < fewest_columns || is_flat(section)) return slopes;
  for (const Facing facing : {Facing::right, Facing::left})
    if (const auto slope = find_slope(section, facing)) slopes.push_back(*slope);
  return slopes;
}

Real moved_distance(const Section& section)
{
  return level * (is_flat(section) ? highest(section) - section.base : relief(section));
}

}  // namespace terp
