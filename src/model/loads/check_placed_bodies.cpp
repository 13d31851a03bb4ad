#include "model/loads/check_placed_bodies.hpp"

#include "math/errors.hpp"
#include "model/meshes/mesh_error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {
namespace {

/// The points of a body that are to come where another one is drawn.
struct Overlap {
  Index n = 0;
  Vec<2> first{0.0, 0.0};  ///< [m]
};

/// By the bodies that are drawn.
std::vector<Overlap> overlaps_of(
    const Model& model, const PointBatches& points, std::size_t body, const std::vector<BodyOutline>& outlines)
{
  const std::vector<BodyCase>& bodies = model.description.bodies;
  std::vector<Overlap> overlaps(bodies.size());
  for (std::size_t other = 0; other < bodies.size(); ++other) {
    if (bodies[other].placed >= bodies[body].placed || bodies[other].removed < bodies[body].placed) continue;
    const std::vector<Side> sides = outline_sides(*model.mesh, outlines[other]);
    for (const auto& batch : points)
      for (const NewPoint& p : batch)
        if (static_cast<std::size_t>(p.body) == body && encloses(sides, p.x))
          if (overlaps[other].n++ == 0) overlaps[other].first = p.x;
  }
  return overlaps;
}

}  // namespace

int add_held_row(RowTable& rows)
{
  return rows.add({.name = "held",
      .unit = "-",
      .meaning = "1: of a body that the stage places, -1: of one that it digs away, 0: of any other",
      .owner = "stage"});
}

void check_placed_bodies(const Model& model, const PointBatches& points)
{
  const std::vector<BodyCase>& bodies = model.description.bodies;
  if (!model.with.bodies) return;
  const std::vector<BodyOutline> outlines = outlines_of(model);
  std::vector<Problem> problems;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].placed == 0) continue;
    const std::vector<Overlap> overlaps = overlaps_of(model, points, b, outlines);
    for (std::size_t other = 0; other < bodies.size(); ++other)
      if (overlaps[other].n > 0)
        problems.push_back({fmt::format("body[{}]", b),
            fmt::format("{} is placed where {} is", called(bodies[b], b), called(bodies[other], other)),
            fmt::format(
                "{} of its points lie in it, the first at {} m. Draw it beside the other, or let an earlier stage "
                "remove that.",
                overlaps[other].n, place_text(overlaps[other].first)),
            "stage.place", false, keys_of_outline(b)});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace terp
