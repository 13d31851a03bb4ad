#include "dstability/section_layout.hpp"

#include "base/errors.hpp"
#include "base/interpolate.hpp"
#include "points/body_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace terp {
namespace {

constexpr Real most_cells = 60000.0;
constexpr Real round_cells[] = {0.05, 0.1, 0.125, 0.2, 0.25, 0.4, 0.5, 0.8, 1.0, 1.25, 2.0, 2.5, 4.0, 5.0, 10.0};

/// Highest and lowest soil of a region at x.
void stretch(const std::vector<Polygon>& outlines, Real x, Real& low, Real& high)
{
  for (const Polygon& p : outlines)
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Vec<2>&a = p[k], &b = p[(k + 1) % p.size()];
      if ((a[0] > x) == (b[0] > x)) continue;
      const Real y = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
      low = std::min(low, y);
      high = std::max(high, y);
    }
}

Real round_cell(Real wanted, Real area)
{
  Real best = std::end(round_cells)[-1];
  for (const Real cell : round_cells) {
    const bool nearer = std::abs(std::log(cell / wanted)) < std::abs(std::log(best / wanted));
    if (area / (cell * cell) <= most_cells && (nearer || area / (best * best) > most_cells)) best = cell;
  }
  return best;
}

}  // namespace

SectionLayout layout_of(
    const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations, Real cell, LandEnd land)
{
  const Real far = 1e30;
  SectionLayout layout{{far, far}, {-far, -far}};
  std::vector<Polygon> outlines;
  std::set<Real> places;
  Real area = 0.0;
  for (const DrawnRegion& region : drawn) {
    outlines.push_back(region.polygon);
    area += std::abs(signed_area(region.polygon));
    for (const Vec<2>& x : region.polygon) {
      places.insert(x[0]);
      for (int d = 0; d < 2; ++d) {
        layout.low[d] = std::min(layout.low[d], x[d]);
        layout.high[d] = std::max(layout.high[d], x[d]);
      }
    }
  }
  const auto ground = [&](Real x) {
    Real low = far, high = -far;
    stretch(outlines, x, low, high);
    for (const DrawnExcavation& pit : excavations) {
      auto line = pit.places;
      std::ranges::sort(line, {}, [](const Vec<2>& at) { return at[0]; });
      if (line.size() > 1 && x > line.front()[0] && x < line.back()[0]) high = std::min(high, interpolate(line, x));
    }
    return high;
  };
  const Real width = layout.high[0] - layout.low[0], inside = 1e-6 * width;
  layout.left = ground(layout.low[0] + inside);
  layout.right = ground(layout.high[0] - inside);
  layout.crest = {layout.low[0], -far};
  for (const Real x : places)
    for (const Real at : {x - inside, x + inside})
      if (const Real y = ground(at); y > layout.crest[1]) layout.crest = {at, y};
  const Real foot = land == LandEnd::left    ? layout.left
                    : land == LandEnd::right ? layout.right
                                             : std::min(layout.left, layout.right);
  layout.height = layout.crest[1] - foot;
  const Real thickness = layout.crest[1] - layout.low[1];
  if (layout.height < 0.05 * thickness) layout.height = 0.5 * thickness;
  layout.cell = cell > 0.0 ? cell : round_cell(0.1 * layout.height, area);
  return layout;
}

std::vector<DrawnRegion> part_between(const std::vector<DrawnRegion>& drawn, Vec<2> between)
{
  std::vector<DrawnRegion> part;
  for (const DrawnRegion& region : drawn) {
    Polygon polygon = clip_to_box(region.polygon, {{between[0], -1e9}, {between[1], 1e9}});
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    part.push_back({region.name, std::move(polygon)});
  }
  const auto is_empty = [](const DrawnRegion& r) { return std::abs(signed_area(r.polygon)) < 1e-6; };
  if (std::ranges::all_of(part, is_empty))
    throw InputError({"", "there is no soil between these x",
        fmt::format("Got --between {:g},{:g}. terp import FILE lists where the section is.", between[0], between[1]),
        ""});
  return part;
}

CleaningOptions cleaning_for(Real cell)
{
  return {.snap = 1e-3, .shortest_edge = std::min(0.05, 0.1 * cell), .tolerance = std::min(0.02, 0.04 * cell)};
}

CaseTableText mesh_table(const SectionLayout& layout)
{
  const Real width = layout.high[0] - layout.low[0];
  const Real cell_x = width / std::max(1.0, std::round(width / layout.cell));
  const Real rows = std::ceil((layout.crest[1] - layout.low[1]) / layout.cell) + 2.0;
  return {"[mesh]",
      fmt::format("Cells of about a tenth of the height of the dike ({:.2f} m), whole ones from limit to limit. Those "
                  "above the ground cost nothing.",
          layout.height),
      {{"origin", fmt::format("[{}, {}]", number_text(layout.low[0]), number_text(layout.low[1])), "m"},
          {"size", fmt::format("[{}, {}]", number_text(width), number_text(rows * layout.cell)), "m"},
          {"cell",
              std::abs(cell_x - layout.cell) < 1e-9 ? number_text(layout.cell)
                                                    : fmt::format("[{:.12g}, {}]", cell_x, number_text(layout.cell)),
              "m"}}};
}

std::vector<CaseTableText> common_tables(const SectionLayout& layout)
{
  return {{"[boundary]", "", {{"left", "\"roller\"", ""}, {"right", "\"roller\"", ""}, {"bottom", "\"fixed\"", ""}}},
      {"[forces]", "As docs/dike.md has it for dikes: little damping, of the mean out-of-balance force.",
          {{"gravity", "[0.0, -9.81]", ""}, {"damping", "{ local = 0.05, averaging_time = 0.2 }", ""}}},
      {"[method]", "", {{"relaxation_time", "0.05", "s"}}},
      {"[initial]", "", {{"stress", "\"equilibrium\"", "from k0 of each soil"}, {"k0", "0.5", ""}}},
      {"[output]", "", {}}, {"[output.fields]", "", {{"every", "1.0", "s"}}},
      {"[output.ledger]", "", {{"every", "0.1", "s"}}},
      {"[output.history]", "",
          {{"every", "0.1", "s"},
              {"points", fmt::format("{{ crest = [{:.2f}, {:.2f}] }}", layout.crest[0], layout.crest[1] - 0.3), ""}}}};
}

std::vector<CutRegion> cut_along(
    const CleanRegion& region, const std::vector<Vec<2>>& line, Real thin, Real& left_there)
{
  const BoundingBox box = box_around(region.polygon);
  DrawnLine cut{line, false, 1};
  cut.places.insert(cut.places.begin(), {std::min(box.low[0], line.front()[0]) - 1.0, line.front()[1]});
  cut.places.push_back({std::max(box.high[0], line.back()[0]) + 1.0, line.back()[1]});
  std::vector<DrawnLine> lines{{region.polygon, true, 0}, cut};
  for (const Polygon& hole : region.holes) lines.push_back({hole, true, 0});
  const PlanarGraph graph = join_lines(lines, 1e-8);
  const PlanarFaces faces = find_faces(graph);
  std::vector<CutRegion> pieces;
  Real thick[2] = {0.0, 0.0}, slivers[2] = {0.0, 0.0};
  for (std::size_t k = 1; k < faces.rings.size(); ++k) {
    CleanRegion piece{region.drawn, corners_of(graph, faces.rings[k][0]), {}};
    const Vec<2> x = place_in(piece.polygon);
    const auto in = [&](const Polygon& outline) { return contains(outline, x); };
    if (!in(region.polygon) || std::ranges::any_of(region.holes, in)) continue;
    Real length = 0.0;
    for (std::size_t i = 0; i < piece.polygon.size(); ++i) {
      const Vec<2> a = piece.polygon[i], b = piece.polygon[(i + 1) % piece.polygon.size()];
      length += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    for (std::size_t i = 1; i < faces.rings[k].size(); ++i) piece.holes.push_back(corners_of(graph, faces.rings[k][i]));
    const bool above = x[1] > interpolate(cut.places, x[0]);
    const Real area = area_of_face(graph, faces.rings[k]);
    (2.0 * area < thin * length ? slivers : thick)[above] += area;
    pieces.push_back({std::move(piece), above});
  }
  for (const bool side : {false, true})
    if (thick[side] == 0.0 && thick[!side] > 0.0) {
      left_there += slivers[side];
      return {{region, !side}};
    }
  return pieces;
}

void put_on_top(BodyOrder& order)
{
  const std::size_t n = order.regions.size();
  for (std::size_t k = 0; k < n; ++k) {
    auto& holes = order.regions[k].holes;
    std::erase_if(holes, [&](Polygon hole) {
      std::ranges::reverse(hole);
      Real filled = 0.0;
      for (const CleanRegion& other : order.regions)
        if (&other != &order.regions[k] && contains(hole, place_in(other.polygon)))
          filled += area(BodyOutline{other.polygon, {1, 1}, other.holes});
      return filled > (1.0 - 1e-6) * signed_area(hole);
    });
  }
  std::vector<std::size_t> by_size(n);
  for (std::size_t k = 0; k < n; ++k) by_size[k] = k;
  // Only a region inside another one must come after it; the order is else that of the file.
  std::vector<int> depth(n, 0);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t other = 0; other < n; ++other)
      if (k != other && contains(order.regions[other].polygon, place_in(order.regions[k].polygon)) &&
          signed_area(order.regions[other].polygon) > signed_area(order.regions[k].polygon))
        ++depth[k];
  std::ranges::stable_sort(by_size, {}, [&](std::size_t k) { return depth[k]; });
  BodyOrder sorted;
  for (const std::size_t k : by_size) {
    order.bodies[k].polygon = order.regions[k].polygon;
    order.bodies[k].holes = order.regions[k].holes;
    sorted.bodies.push_back(std::move(order.bodies[k]));
    sorted.regions.push_back(std::move(order.regions[k]));
  }
  order = std::move(sorted);
}

BaseFill base_fill(const SectionLayout& layout, const std::vector<CleanRegion>& regions)
{
  std::set<Real> corners;
  for (const CleanRegion& region : regions)
    for (const Vec<2>& x : region.polygon) corners.insert(x[0]);
  BaseFill fill;
  std::map<int, Real> above;
  Real highest = layout.low[1], before = layout.low[0];
  for (const Real x : corners) {
    Real lows[2] = {1e30, 1e30};  // at both ends of the interval
    int drawn = -1;
    for (const CleanRegion& region : regions)
      for (const int end : {0, 1}) {
        Real low = 1e30, high = -1e30;
        stretch({region.polygon}, before + (end == 0 ? 1e-9 : 1.0 - 1e-9) * (x - before), low, high);
        if (low < lows[end]) lows[end] = low, drawn = region.drawn;
      }
    const Real lowest = std::max(lows[0], lows[1]);
    if (drawn >= 0 && lowest < 1e30 && lowest > layout.low[1] + 1e-6) {
      fill.area += (0.5 * (lows[0] + lows[1]) - layout.low[1]) * (x - before);
      above[drawn] += x - before;
      highest = std::max(highest, lowest);
    }
    before = x;
  }
  if (fill.area <= 1e-9) return {};
  const auto most = std::ranges::max_element(above, {}, [](const auto& entry) { return entry.second; });
  fill.drawn = most->first;
  // As high as the highest place of the base: what it would cover of the section lies on top of it.
  fill.box = {layout.low, {layout.high[0], layout.low[1]}, {layout.high[0], highest}, {layout.low[0], highest}};
  return fill;
}

}  // namespace terp
