// cut_along makes a planar graph of region and line, and asks each face on which side one place of it lies. Faces that
// are thin change sides. Then edges with one side on both sides are left out, and faces are found once more.
// ground_line looks close to the left and the right of each corner, so that upright sides have both their ends.

#include "import/dstability/section_layout.hpp"

#include "math/errors.hpp"
#include "math/interpolate.hpp"
#include "math/plane.hpp"
#include "model/bodies/body_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace terp {
namespace {

/// Area over cell^3 [1/m] of the cells that Terp chooses itself: points times steps go with it. The tutorial of
/// D-Stability on 0.5 m has 21 000; by `terp check` it takes at most four minutes on two cores.
constexpr Real most_work = 25000.0;
constexpr Real most_cells_asked_for = 4e6;  // some 36 million points
constexpr Real least_dike = 0.25;           // of the height of the ground: what is lower is no dike, but a field
constexpr Real round_cells[] = {0.05, 0.1, 0.125, 0.2, 0.25, 0.4, 0.5, 0.8, 1.0, 1.25, 2.0, 2.5, 4.0, 5.0, 10.0};

/// Elevation of the ground at x, excavations cut; very low where there is no soil [m].
Real ground_at(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations, Real x)
{
  Real high = -1e30;
  for (const DrawnRegion& region : drawn) {
    const std::vector<Side> sides = outline_sides({}, BodyOutline{region.polygon, {1, 1}});
    for (const Real y : crossings_of_vertical(sides, x)) high = std::max(high, y);
  }
  for (const DrawnExcavation& pit : excavations) {
    auto line = pit.places;
    std::ranges::sort(line, {}, [](const Vec<2>& at) { return at[0]; });
    if (line.size() > 1 && x > line.front()[0] && x < line.back()[0]) high = std::min(high, interpolate(line, x));
  }
  return high;
}

Real length_of(const Polygon& outline)
{
  Real sum = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) sum += distance(outline[k], outline[(k + 1) % outline.size()]);
  return sum;
}

/// The lowest edge of all regions over an interval without corners: its height at both ends.
struct Bottom {
  Real left = 1e30, right = 1e30;
  int drawn = -1;  ///< none: no soil is there
};

Bottom bottom_between(const std::vector<CleanRegion>& regions, Real left, Real right)
{
  Bottom lowest;
  for (const CleanRegion& region : regions)
    for (std::size_t k = 0; k < region.polygon.size(); ++k) {
      Vec<2> a = region.polygon[k], b = region.polygon[(k + 1) % region.polygon.size()];
      if (a[0] > b[0]) std::swap(a, b);
      if (a[0] > left || b[0] < right) continue;
      const auto at = [&](Real x) { return std::lerp(a[1], b[1], (x - a[0]) / (b[0] - a[0])); };
      if (at(left) + at(right) < lowest.left + lowest.right) lowest = {at(left), at(right), region.drawn};
    }
  return lowest;
}

/// The outline without corners that are there twice, or at which it goes straight on.
Polygon without_straight_corners(Polygon outline)
{
  outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  Polygon kept;
  const std::size_t n = outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<2> a = kept.empty() ? outline[n - 1] : kept.back(), b = outline[k], c = outline[(k + 1) % n];
    if (std::abs(cross(a, b, c)) > 1e-9 * distance(a, c)) kept.push_back(b);
  }
  return kept;
}

/// Place of the crest of a dike on the ground: the highest one between two x; without them, the one that is highest
/// over the lower one of what is lowest to its left and to its right. Level ground and slopes: the highest of all.
Vec<2> crest_of(const std::vector<Vec<2>>& ground, const std::optional<Vec<2>>& between)
{
  const auto higher = [](const Vec<2>& a, const Vec<2>& b) { return a[1] < b[1]; };
  if (between) {
    std::vector<Vec<2>> part;
    std::ranges::copy_if(ground, std::back_inserter(part),
        [&](const Vec<2>& x) { return x[0] >= (*between)[0] && x[0] <= (*between)[1]; });
    if (!part.empty()) return *std::ranges::max_element(part, higher);
  }
  std::vector<Real> lowest_behind(ground.size());
  for (std::size_t k = ground.size(); k-- > 0;)
    lowest_behind[k] = k + 1 < ground.size() ? std::min(ground[k][1], lowest_behind[k + 1]) : ground[k][1];
  const auto [low, high] = std::ranges::minmax_element(ground, higher);
  Vec<2> crest = *high;
  Real most = least_dike * ((*high)[1] - (*low)[1]), lowest = ground.front()[1];
  for (std::size_t k = 0; k < ground.size(); ++k) {
    lowest = std::min(lowest, ground[k][1]);
    if (const Real rise = ground[k][1] - std::max(lowest, lowest_behind[k]); rise > most)
      most = rise, crest = ground[k];
  }
  return crest;
}

Real round_cell(Real wanted, Real area)
{
  Real best = std::end(round_cells)[-1];
  for (const Real cell : round_cells) {
    const bool nearer = std::abs(std::log(cell / wanted)) < std::abs(std::log(best / wanted));
    const auto is_too_much = [&](Real h) { return area / (h * h * h) > most_work; };
    if (!is_too_much(cell) && (nearer || is_too_much(best))) best = cell;
  }
  return best;
}

}  // namespace

BoundingBox box_around(const std::vector<DrawnRegion>& drawn)
{
  BoundingBox all{{1e30, 1e30}, {-1e30, -1e30}};
  for (const DrawnRegion& region : drawn)
    for (const Vec<2>& x : region.polygon)
      for (int d = 0; d < 2; ++d) all.low[d] = std::min(all.low[d], x[d]), all.high[d] = std::max(all.high[d], x[d]);
  return all;
}

std::vector<Vec<2>> ground_line(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    const std::optional<Vec<2>>& more)
{
  const BoundingBox box = box_around(drawn);
  std::set<Real> places;
  const auto insert = [&](Real x) { places.insert(std::clamp(x, box.low[0], box.high[0])); };
  for (const DrawnRegion& region : drawn)
    for (const Vec<2>& x : region.polygon) insert(x[0]);
  for (const DrawnExcavation& pit : excavations)
    for (const Vec<2>& x : pit.places) insert(x[0]);
  if (more)
    for (const Real x : *more) insert(x);
  const Real inside = 1e-6 * (box.high[0] - box.low[0]);
  std::vector<Vec<2>> line;
  for (const Real place : places)
    for (const Real x : {place - inside, place + inside})
      if (const Real y = ground_at(drawn, excavations, x); y > -1e30) line.push_back({x, y});
  return line;
}

SectionLayout layout_of(
    const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations, const LayoutWishes& wishes)
{
  const BoundingBox box = box_around(drawn);
  SectionLayout layout{box.low, box.high};
  Real area = 0.0;
  for (const DrawnRegion& region : drawn) area += std::abs(signed_area(region.polygon));
  const std::vector<Vec<2>> surface = ground_line(drawn, excavations, wishes.crest);
  layout.left = surface.front()[1];
  layout.right = surface.back()[1];
  layout.crest = crest_of(surface, wishes.crest);
  layout.top = std::ranges::max(surface, {}, [](const Vec<2>& x) { return x[1]; })[1];
  const bool is_left = wishes.land == LandEnd::left || (wishes.land == LandEnd::lower && layout.left < layout.right);
  layout.height = layout.crest[1] - (is_left ? layout.left : layout.right);
  const Real thickness = layout.crest[1] - layout.low[1];
  if (layout.height < 0.05 * thickness)  // the land rises behind the dike
    for (const Vec<2>& x : surface)
      if ((x[0] < layout.crest[0]) == is_left) layout.height = std::max(layout.height, layout.crest[1] - x[1]);
  if (layout.height < 0.05 * thickness) layout.height = 0.5 * thickness;
  layout.cell = wishes.cell > 0.0 ? wishes.cell : round_cell(0.1 * layout.height, area);
  if (const Real cells = area / (layout.cell * layout.cell); cells > most_cells_asked_for)
    throw InputError({"", fmt::format("cells of {:g} m are too small for this section", layout.cell),
        fmt::format("The soil would have {:.2g} of them, at most {:.2g}. Give larger ones, from {:.2g} m on, or a part "
                    "of the section: --cell H, --between X,X.",
            cells, most_cells_asked_for, std::sqrt(area / most_cells_asked_for)),
        ""});
  return layout;
}

void check_cell(const SectionLayout& layout, Real asked_for)
{
  const Real most = std::max(0.5 * layout.height, 0.25 * (layout.top - layout.low[1]));
  if (!(asked_for > most)) return;
  throw InputError({"", fmt::format("cells of {:g} m are too large for this section", asked_for),
      fmt::format(
          "Its soil is {:.3g} m thick, and its crest {:.3g} m high. Give at most {:.3g} m with --cell, or leave "
          "it out: some {:.2g} m.",
          layout.top - layout.low[1], layout.height, std::floor(100.0 * most) / 100.0, 0.1 * layout.height),
      ""});
}

std::vector<Vec<2>> places_in(const CleanRegion& region, Real step)
{
  const BoundingBox box = box_around(region.polygon);
  const auto holds = [](Vec<2> place) { return [place](const Polygon& outline) { return contains(outline, place); }; };
  std::vector<Vec<2>> places;
  for (Real x = box.low[0] + 0.5 * step; x < box.high[0]; x += step)
    for (Real z = box.low[1] + 0.5 * step; z < box.high[1]; z += step)
      if (contains(region.polygon, {x, z}) && std::ranges::none_of(region.holes, holds({x, z})))
        places.push_back({x, z});
  if (places.empty()) places.push_back(place_in(region.polygon));
  return places;
}

CleaningOptions cleaning_for(Real cell)
{
  return {.snap = 1e-3, .shortest_edge = std::min(0.05, 0.1 * cell), .tolerance = std::min(0.02, 0.04 * cell)};
}

CaseTableText mesh_table(const SectionLayout& layout)
{
  const Real width = layout.high[0] - layout.low[0];
  const Real cell_x = width / std::max(1.0, std::round(width / layout.cell));
  const Real rows = std::ceil((layout.top - layout.low[1]) / layout.cell) + 2.0;
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

CaseTableText time_table(const std::string& end)
{
  CaseTableText table{"[time]",
      "At rest: soil with 2e-4 of its weight out of balance gains this speed in this time, half a period of soft soil "
      "of some 25 m.",
      {{"rest_speed", "4e-3", "m/s"}, {"rest_time", "2.0", "s"}}};
  if (!end.empty()) table.lines.insert(table.lines.begin(), {{"until", end, ""}, {"at_most", "30.0", "s"}});
  return table;
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
  PlanarGraph graph = join_lines(lines, 1e-8);
  const PlanarFaces faces = find_faces(graph);
  std::vector<int> side(faces.rings.size(), -1);  // of the line, by face; 0 below, 1 above, -1 not of the region
  std::vector<char> is_thin(faces.rings.size(), 0);
  const auto is_of_region = [&](Vec<2> x) {
    const auto in = [&](const Polygon& outline) { return contains(outline, x); };
    return in(region.polygon) && std::ranges::none_of(region.holes, in);
  };
  for (std::size_t k = 1; k < faces.rings.size(); ++k) {
    const Polygon outline = corners_of(graph, faces.rings[k][0]);
    const Vec<2> x = place_in(outline);
    if (!is_of_region(x)) continue;
    side[k] = x[1] > interpolate(cut.places, x[0]) ? 1 : 0;
    is_thin[k] = 2.0 * area_of_face(graph, faces.rings[k]) < thin * length_of(outline);
  }
  // A thin face goes to what it touches across the line, if that is thick.
  std::vector<int> kept = side;
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    for (const auto& [one, other] : {std::pair{faces.left[e], faces.right[e]}, {faces.right[e], faces.left[e]}})
      if (is_thin[one] && !is_thin[other] && side[one] >= 0 && side[other] == 1 - side[one] && kept[one] == side[one]) {
        kept[one] = side[other];
        left_there += area_of_face(graph, faces.rings[one]);
      }
  const auto is_of_side = [&](int wanted) { return std::ranges::find(kept, wanted) != kept.end(); };
  if (!is_of_side(0) || !is_of_side(1)) return {{region, is_of_side(1)}};
  std::vector<GraphEdge> edges;
  std::vector<std::pair<int, int>> sides;  // left and right of the edges that part them
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    if (kept[faces.left[e]] != kept[faces.right[e]]) {
      edges.push_back(graph.edges[e]);
      sides.emplace_back(kept[faces.left[e]], kept[faces.right[e]]);
    }
  graph.edges = std::move(edges);
  const PlanarFaces joined = find_faces(graph);
  std::vector<CutRegion> pieces;
  for (std::size_t k = 1; k < joined.rings.size(); ++k) {
    const auto edge = static_cast<std::size_t>(joined.rings[k][0].edges[0]);
    const int of = joined.left[edge] == static_cast<Index>(k) ? sides[edge].first : sides[edge].second;
    if (of < 0) continue;
    CutRegion piece{{region.drawn, corners_of(graph, joined.rings[k][0]), {}}, of == 1};
    for (std::size_t i = 1; i < joined.rings[k].size(); ++i)
      piece.region.holes.push_back(corners_of(graph, joined.rings[k][i]));
    pieces.push_back(std::move(piece));
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
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
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

std::vector<CleanRegion> base_fill(const SectionLayout& layout, const std::vector<CleanRegion>& regions)
{
  std::set<Real> corners;
  for (const CleanRegion& region : regions)
    for (const Vec<2>& x : region.polygon) corners.insert(x[0]);
  std::vector<CleanRegion> fills;
  Polygon base;               // of the piece that is being made, from left to right
  std::map<int, Real> above;  // width of each drawn region over it
  const auto finish = [&] {
    if (base.empty()) return;
    const auto most = std::ranges::max_element(above, {}, [](const auto& entry) { return entry.second; });
    Polygon outline{{base.front()[0], layout.low[1]}, {base.back()[0], layout.low[1]}};
    outline.insert(outline.end(), base.rbegin(), base.rend());
    fills.push_back({most->first, without_straight_corners(outline), {}});
    base.clear();
    above.clear();
  };
  const auto lies_low = [&](Real z) { return z < layout.low[1] + 1e-6; };
  for (auto left = corners.begin(), right = std::next(left); right != corners.end(); left = right++) {
    const Bottom bottom = bottom_between(regions, *left, *right);
    if (bottom.drawn < 0 || (lies_low(bottom.left) && lies_low(bottom.right))) {
      finish();
      continue;
    }
    if (!base.empty() && lies_low(bottom.left)) finish();
    base.push_back({*left, bottom.left});
    base.push_back({*right, bottom.right});
    above[bottom.drawn] += *right - *left;
    if (lies_low(bottom.right)) finish();
  }
  finish();
  return fills;
}

}  // namespace terp
