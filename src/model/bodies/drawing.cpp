#include "model/bodies/drawing.hpp"

#include <algorithm>

namespace terp {
namespace {

bool touches(const Polygon& polygon, const BoundingBox& box)
{
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (crosses(box, polygon[k], polygon[(k + 1) % polygon.size()])) return true;
  return false;
}

/// The part of a polygon around a cell, relative to the cell's centre.
Ring make_ring(const Polygon& polygon, const BoundingBox& around, Vec<2> centre, Index body, bool is_hole)
{
  const auto shifted = [&](Vec<2> x) { return Vec<2>{x[0] - centre[0], x[1] - centre[1]}; };
  Polygon corners(polygon.size());
  std::transform(polygon.begin(), polygon.end(), corners.begin(), shifted);
  return {clip_to_box(corners, {shifted(around.low), shifted(around.high)}), body, is_hole};
}

void draw_polygon(const BodyOutline& outline, Index body, const BoundingBox& box, Vec<2> centre, Overlay& overlay)
{
  const auto touches_cell = [&](const Polygon& polygon) { return touches(polygon, box); };
  if (!touches(outline.polygon, box) && std::ranges::none_of(outline.holes, touches_cell)) {
    if (covers(outline, centre)) overlay = {body, {}};
    return;
  }
  const BoundingBox around = widened(box, 1.0);  // rings are closed along the box: beyond the cells across the sides
  overlay.rings.push_back(make_ring(outline.polygon, around, centre, body, false));
  for (const Polygon& hole : outline.holes) overlay.rings.push_back(make_ring(hole, around, centre, body, true));
}

}  // namespace

Drawing make_drawing(const Mesh<2>& mesh, std::span<const BodyOutline> bodies)
{
  Drawing drawing{mesh, bodies, std::vector<BoundingBox>(bodies.size()), std::vector<std::vector<char>>(bodies.size())};
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (!bodies[body].polygon.empty()) drawing.boxes[body] = box_around(bodies[body].polygon);
    if (!bodies[body].cells.empty()) drawing.in_region[body].resize(mesh.n_cells());
    for (const Index cell : bodies[body].cells) drawing.in_region[body][cell] = 1;
  }
  return drawing;
}

Overlay draw_cell(const Drawing& drawing, Index cell)
{
  const BoundingBox box = box_around(drawing.mesh.corners(cell));
  Overlay overlay;
  for (std::size_t k = 0; k < drawing.bodies.size(); ++k) {
    const auto body = static_cast<Index>(k);
    if (!drawing.in_region[k].empty()) {
      if (drawing.in_region[k][cell]) overlay = {body, {}};
    } else if (!drawing.bodies[k].polygon.empty() && overlap(box, drawing.boxes[k])) {
      draw_polygon(drawing.bodies[k], body, box, drawing.mesh.centres[cell], overlay);
    }
  }
  return overlay;
}

}  // namespace terp
