// Both slopes are found by the same functions: columns are counted from the side that the slope faces. The crest is the
// ground that lies within a twentieth of the relief below the highest ground. Where a plateau falls gently from it, the
// slope begins at the edge of that plateau, found on the upper hull of the surface. The toe is found twice: a plateau
// is sought up to the first one, and changes the height by which the toe is defined.

#include "model/ground/section.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

struct HullLine {
  Index from, to;  ///< columns
  Real fall;       ///< height that is lost over its length [-]
};

/// The lines above the surface from a column outwards to another one, each steeper than the one before.
std::vector<HullLine> upper_hull(const Section& section, Facing facing, Index from, Index to)
{
  const Index step = facing == Facing::right ? 1 : -1;
  const auto fall = [&](Index a, Index b) {
    return (section.heights[a] - section.heights[b]) / (section.columns.width * std::abs(b - a));
  };
  std::vector<HullLine> lines;
  for (Index k = from + step; k != to + step; k += step) {
    if (!std::isfinite(section.heights[k])) continue;
    Index start = lines.empty() ? from : lines.back().to;
    while (!lines.empty() && fall(start, k) <= lines.back().fall) start = lines.back().from, lines.pop_back();
    lines.push_back({start, k, fall(start, k)});
  }
  return lines;
}

/// How far the surface lies below a line of its hull [m].
Real depth_below(const Section& section, const HullLine& line)
{
  Real depth = 0.0;
  const Index step = line.to > line.from ? 1 : -1;
  for (Index k = line.from; k != line.to; k += step)
    depth = std::max(depth,
        section.heights[line.from] - line.fall * section.columns.width * std::abs(k - line.from) - section.heights[k]);
  return depth;
}

/// The outer edge of the plateau that falls gently from the crest, as a column; the outer column of the crest if there
/// is none. A plateau lies near its hull, which falls by less than a quarter of what the ground beyond it does, and it
/// is longer than that is high.
Index edge_of_plateau(const Section& section, const Slope& slope)
{
  constexpr Real gentle = 0.25;
  constexpr Index shortest = 4;  // columns; less may be the steps of points
  const Facing facing = slope.facing;
  const Real width = section.columns.width, low = foot(section, facing);
  const auto columns_to_toe = static_cast<Index>(std::llround((slope.toe - section.columns.left) / width));
  const Index toe = facing == Facing::right ? columns_to_toe - 1 : columns_to_toe;
  const Index crest = facing == Facing::right ? slope.last - 1 : slope.first;
  if (outwards(facing) * (toe - crest) < shortest) return crest;
  Index edge = crest;
  for (const HullLine& line : upper_hull(section, facing, crest, toe)) {
    const Real height = section.heights[line.to] - low, beyond = width * (std::abs(toe - line.to) + 1);
    if (depth_below(section, line) > std::max(width, level * height)) break;
    const Index n = std::abs(line.to - crest);
    const bool is_gentle = line.fall <= gentle * height / beyond;  // and so are the lines before
    if (is_gentle && n >= shortest && width * n >= height) edge = line.to;
  }
  return edge;
}

void look_beyond_plateau(const Section& section, Slope& slope)
{
  const Index edge = edge_of_plateau(section, slope);
  const bool right = slope.facing == Facing::right;
  if (edge == (right ? slope.last - 1 : slope.first)) return;
  (right ? slope.last : slope.first) = right ? edge + 1 : edge;
  slope.crest = outer_edge(section, slope.facing, edge);
  slope.height = slope.relief = section.heights[edge] - foot(section, slope.facing);
}

/// Where the surface has come down to a twentieth of the slope's height over its foot; with a free toe the end of the
/// soil [m].
Real find_toe(const Section& section, const Slope& slope)
{
  const Real low = foot(section, slope.facing) + level * slope.height;
  const auto in_slope = [&](Real h) { return slope.free_toe ? std::isfinite(h) : h > low; };
  const Index k = count_from_side(section, slope.facing, in_slope);
  return k < section.columns.n ? outer_edge(section, slope.facing, from_side(section, slope.facing, k)) : 0.0;
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
  slope.toe = find_toe(section, slope);
  slope.relief = relief(section);
  look_beyond_plateau(section, slope);
  slope.toe = find_toe(section, slope);
  return slope;
}

}  // namespace

Columns columns_between(Real left, Real right, Real width)
{
  return {left, width, static_cast<Index>(std::ceil((right - left) / width - 1e-9))};
}

Section look_at_section(const Mesh<2>& mesh, const PointBlocks<2>& points, Columns columns, Ground ground)
{
  return {columns, surface_heights(mesh, points, columns, ground), lowest(points, ground)};
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
