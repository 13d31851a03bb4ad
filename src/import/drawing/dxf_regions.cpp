// With one open line closed polylines no longer are regions, they only give names. Face 0 is the outside of all lines.
// Regions are ordered by their tops before those without a name are numbered, so that numbers run downwards.

#include "import/drawing/dxf_regions.hpp"

#include "import/drawing/tidy_lines.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace terp {
namespace {

constexpr Real thin = 0.05;             // [m]: mean width of a region that nobody drew on purpose
constexpr std::size_t most_thin = 300;  // regions: more are a hatching

/// The layer of the smallest hatch over an outline; empty: none, or all hatches lie on one layer.
std::string name_by_hatch(const std::vector<DxfLine>& hatches, Polygon outline)
{
  const auto same = [&](const DxfLine& hatch) { return hatch.layer == hatches.front().layer; };
  if (std::ranges::all_of(hatches, same)) return "";
  if (signed_area(outline) < 0.0) std::ranges::reverse(outline);
  const Vec<2> inside = place_in(outline);
  const DxfLine* over = nullptr;
  for (const DxfLine& hatch : hatches)
    if (contains(hatch.places, inside) &&
        (over == nullptr || std::abs(signed_area(hatch.places)) < std::abs(signed_area(over->places))))
      over = &hatch;
  return over == nullptr ? "" : over->layer;
}

std::string name_of(const TidyLines& drawing, const PlanarGraph& graph, const FaceRing& ring, const Polygon& outline)
{
  const DxfLine* around = nullptr;
  const Vec<2> inside = place_in(outline);
  for (const DxfLine& line : drawing.lines)
    if (line.closed && contains(line.places, inside) &&
        (around == nullptr || std::abs(signed_area(line.places)) < std::abs(signed_area(around->places))))
      around = &line;
  if (around != nullptr) return around->layer;
  std::optional<std::set<std::string>> layers;  // that each side of the face is drawn on
  for (const Index edge : ring.edges) {
    std::set<std::string> here;
    for (const int owner : graph.edges[edge].owners) here.insert(drawing.lines[owner].layer);
    here.erase("");  // of a side that closes the section
    if (here.empty()) continue;
    if (layers) std::erase_if(here, [&](const std::string& layer) { return !layers->contains(layer); });
    layers = std::move(here);
  }
  return layers && layers->size() == 1 ? *layers->begin() : "";
}

/// Pieces that bound no region; a doubt where they may be borders of soil.
void report_loose(const PlanarGraph& graph, const TidyLines& drawing, DxfRegions& found)
{
  std::set<std::string> layers;
  Real length = 0.0;
  for (const GraphEdge& edge : graph.loose) {
    length += distance(graph.places[edge.a], graph.places[edge.b]);
    for (const int owner : edge.owners)
      if (const std::string& layer = drawing.lines[owner].layer; !layer.empty()) layers.insert(layer);
  }
  const BoundingBox box = box_around(graph.places);
  const bool is_doubt = length > short_piece * (box.high[0] - box.low[0]);
  const Vec<2> end = graph.places[graph.loose.front().a];
  (is_doubt ? found.doubts : found.notes)
      .push_back(fmt::format("Pieces of lines bound no region and were left out, {:.2f} m on {}; the first ends at "
                             "{:.3f}, {:.3f} m.{}",
          length, fmt::join(layers, ", "), end[0], end[1],
          is_doubt ? " A border of soil must end at other lines, or at one x with the others." : ""));
}

/// Regions thinner than any layer: lines that were meant to meet do not.
void report_thin(DxfRegions& found)
{
  std::vector<Vec<2>> at;
  for (const DrawnRegion& region : found.regions) {
    Real around = 0.0;
    const Polygon& x = region.polygon;
    for (std::size_t k = 0; k < x.size(); ++k) around += distance(x[k], x[(k + 1) % x.size()]);
    if (2.0 * std::abs(signed_area(x)) < thin * around) at.push_back(x[0]);
  }
  if (at.size() > most_thin)
    throw InputError({"", fmt::format("the lines enclose {} regions that are thinner than {:g} m", at.size(), thin),
        fmt::format(
            "The first lies at {:.3f}, {:.3f} m. Leave out hatchings: --layers names the layers of the section.{}{}",
            at[0][0], at[0][1], found.doubts.empty() ? "" : "\n  ", fmt::join(found.doubts, "\n  ")),
        ""});
  if (!at.empty())
    found.doubts.push_back(fmt::format(
        "{} regions are thinner than {:g} m, the first at {:.3f}, {:.3f} m: do lines miss each other there?", at.size(),
        thin, at[0][0], at[0][1]));
}

/// All outlines are closed: each is a region.
void take_outlines(const TidyLines& drawing, const DxfDrawing& whole, DxfRegions& found)
{
  std::set<std::string> layers;
  for (const DxfLine& line : drawing.lines) layers.insert(line.layer);
  const bool is_one_soil = layers.size() == 1 && drawing.lines.size() > 1;
  std::size_t n_named = 0;
  for (const DxfLine& line : drawing.lines) {
    const std::string name = is_one_soil ? name_by_hatch(whole.hatches, line.places) : "";
    n_named += !name.empty();
    found.regions.push_back({name.empty() ? line.layer : name, line.places});
  }
  if (n_named > 0) found.notes.push_back(fmt::format("{} outlines have the names of the hatches in them.", n_named));
  if (is_one_soil && n_named == 0 && !whole.layers_are_chosen)
    found.doubts.push_back(
        fmt::format("All {} outlines lie on one layer, {}: they are one soil. Draw each soil on a "
                    "layer of its own.",
            drawing.lines.size(), *layers.begin()));
}

/// No regions where the lines enclose nothing.
DxfRegions regions_of_lines(const DxfDrawing& whole, Real snap)
{
  const TidyLines drawing = tidy_lines(whole, snap);
  const Real reach = snap / edge_reach;  // so that edges, too, go through places within `snap`
  DxfRegions found{{}, drawing.notes, drawing.doubts, reach};
  if (drawing.lines.empty()) return found;
  const auto is_open = [](const DxfLine& line) { return !line.closed; };
  if (std::ranges::none_of(drawing.lines, is_open)) return take_outlines(drawing, whole, found), found;
  std::vector<DrawnLine> lines;
  for (const DxfLine& line : drawing.lines) {
    lines.push_back({line.places, false, static_cast<int>(lines.size())});
    if (line.closed) lines.back().places.push_back(line.places.front());
  }
  const PlanarGraph graph = join_lines(lines, reach);
  const PlanarFaces faces = find_faces(graph);
  if (faces.rings.size() < 2) return found;
  for (std::size_t k = 1; k < faces.rings.size(); ++k) {
    Polygon outline = corners_of(graph, faces.rings[k][0]);
    std::string name = name_of(drawing, graph, faces.rings[k][0], outline);
    if (name.empty()) name = name_by_hatch(whole.hatches, outline);
    found.regions.push_back({std::move(name), std::move(outline)});
  }
  const auto top = [](const DrawnRegion& region) { return box_around(region.polygon).high[1]; };
  std::ranges::stable_sort(found.regions, [&](const auto& a, const auto& b) { return top(a) > top(b); });
  int number = 0;
  for (DrawnRegion& region : found.regions)
    if (++number; region.name.empty()) region.name = fmt::format("region {}", number);
  const auto n_open = std::ranges::count_if(
      drawing.lines, [&](const DxfLine& line) { return is_open(line) && !line.layer.empty(); });  // as drawn
  found.notes.push_back(fmt::format(
      "{} lines are open: the {} regions are what all lines enclose, joined within {:g} m.", n_open, number, snap));
  if (!graph.loose.empty()) report_loose(graph, drawing, found);
  report_thin(found);
  return found;
}

}  // namespace

DxfRegions regions_of(const DxfDrawing& whole, Real snap)
{
  DxfRegions found;
  if (!whole.lines.empty()) found = regions_of_lines(whole, snap);
  DxfDrawing with_hatches = whole;
  std::set<std::string> used, unused;
  for (const DxfLine& hatch : whole.hatches) {
    Polygon outline = hatch.places;
    if (signed_area(outline) < 0.0) std::ranges::reverse(outline);
    const Vec<2> inside = place_in(outline);
    const bool is_water = is_of_water(hatch.layer);
    const bool is_bound =
        std::ranges::any_of(found.regions, [&](const DrawnRegion& region) { return contains(region.polygon, inside); });
    (is_bound || is_water ? unused : used).insert(hatch.layer);
    if (!is_bound && !is_water) with_hatches.lines.push_back(hatch);
  }
  if (!used.empty()) {
    found = regions_of_lines(with_hatches, snap);
    found.doubts.push_back(
        fmt::format("Hatches were read as outlines, where no line bounds soil: {}.", fmt::join(used, ", ")));
  }
  if (!unused.empty()) found.notes.push_back(fmt::format("Hatches that bound no soil: {}.", fmt::join(unused, ", ")));
  if (found.regions.empty())
    throw InputError({"", "the lines of the drawing enclose nothing",
        fmt::format("Each layer needs an outline, or lines around it whose ends meet within {:g} m.", snap), ""});
  return found;
}

}  // namespace terp
