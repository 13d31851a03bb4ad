// With one open line closed polylines no longer are regions, they only give names. Face 0 is the outside of all lines.
// Regions are ordered by their tops before those without a name are numbered, so that numbers run downwards.

#include "import/drawing/dxf_regions.hpp"

#include "import/drawing/tidy_lines.hpp"

#include "math/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace terp {
namespace {

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

}  // namespace

DxfRegions regions_of(const DxfDrawing& whole, Real snap)
{
  const TidyLines drawing = tidy_lines(whole.lines, snap);
  DxfRegions found{{}, drawing.notes, drawing.doubts};
  if (drawing.lines.empty())
    throw InputError({"", "no line of the drawing bounds soil", "Draw outlines of the soils.", ""});
  const auto is_open = [](const DxfLine& line) { return !line.closed; };
  if (std::ranges::none_of(drawing.lines, is_open)) {
    for (const DxfLine& line : drawing.lines) found.regions.push_back({line.layer, line.places});
    return found;
  }
  std::vector<DrawnLine> lines;
  for (const DxfLine& line : drawing.lines) {
    lines.push_back({line.places, false, static_cast<int>(lines.size())});
    if (line.closed) lines.back().places.push_back(line.places.front());
  }
  const PlanarGraph graph = join_lines(lines, snap);
  const PlanarFaces faces = find_faces(graph);
  if (faces.rings.size() < 2)
    throw InputError({"", "the lines of the drawing enclose nothing",
        fmt::format("Each layer needs an outline, or lines around it whose ends meet within {:g} m.", snap), ""});
  for (std::size_t k = 1; k < faces.rings.size(); ++k) {
    Polygon outline = corners_of(graph, faces.rings[k][0]);
    found.regions.push_back({name_of(drawing, graph, faces.rings[k][0], outline), outline});
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
  return found;
}

}  // namespace terp
