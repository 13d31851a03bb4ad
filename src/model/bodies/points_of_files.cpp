// Points in memory have no line numbers, so files are read again where a message needs one. The checks go from the
// clearest message to the least clear: a point in a drawn body, two at one place, cells too full. Distances are
// relative to the size of a point. Places are compared within a cell: pairs across a side are not found.

#include "model/bodies/points_of_files.hpp"

#include "math/errors.hpp"
#include "mpm/mesh/locate.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/bodies/overfull.hpp"
#include "model/bodies/points_csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <tuple>

namespace terp {
namespace {

constexpr Real one_place = 1e-3;  // of the size of a point: points that share their soil lie about that size apart
constexpr Real inside = 1e-6;

std::string points_key(std::size_t body) { return fmt::format("body[{}].points", body); }

/// Of a square of its volume [m].
Real size_of(Real volume) { return std::sqrt(volume); }

/// Only for messages: reads the files again.
struct PointOfFile {
  std::size_t body = 0;
  std::string path;
  CsvPoint point{};

  std::string line() const { return fmt::format("{}:{}", path, point.line); }
};

template <class F>
void for_each_point_of_files(const StageSoil& soil, F&& f)
{
  for (std::size_t b = 0; b < soil.description.bodies.size(); ++b) {
    const std::string& name = soil.description.bodies[b].points_file;
    if (name.empty()) continue;
    const std::string path = path_of(soil.description.folder, name);
    for (const CsvPoint& p : read_points_csv(path)) f(PointOfFile{b, path, p});
  }
}

/// The largest in some cells, ascending.
std::optional<PointOfFile> largest_of_files(const StageSoil& soil, const std::vector<Index>& cells)
{
  std::optional<PointOfFile> found;
  for_each_point_of_files(soil, [&](const PointOfFile& p) {
    if (std::ranges::binary_search(cells, locate(*soil.mesh, p.point.x, 0).cell) &&
        (!found || p.point.volume > found->point.volume))
      found = p;
  });
  return found;
}

CellContents contents_of_cells(const Mesh<2>& mesh, const PointBatches& points)
{
  CellContents contents{std::vector<Real>(mesh.cells.size(), 0.0), std::vector<Real>(mesh.cells.size(), 0.0)};
  for (const auto& batch : points)
    for (const NewPoint& p : batch) {
      contents.volume[p.key.cell] += p.volume;
      contents.largest[p.key.cell] = std::max(contents.largest[p.key.cell], p.volume);
    }
  return contents;
}

/// Bodies that are drawn share their cells; points of files lie where they lie, over each other and over drawn bodies
/// too.
void check_room_for_points(const StageSoil& soil, const PointBatches& points)
{
  const auto overfull = find_overfull(*soil.mesh, contents_of_cells(*soil.mesh, points));
  if (!overfull) return;
  const auto at = largest_of_files(soil, overfull->around);
  if (!at) return;  // no cell of theirs
  const std::string where = fmt::format("{}: the point of {:.4g} m^2 at {} m lies in cell {}", at->line(),
      at->point.volume, place_text(at->point.x), overfull->cell);
  const std::string too_much =
      overfull->by_one_point
          ? fmt::format("{}, where cells have {:.4g} m^2. Allowed: {:.4g} m^2.", where, overfull->area, overfull->limit)
          : fmt::format(
                "{} or beside it. All points there hold {:.4g} m^2,\n"
                "these {} cells have {:.4g} m^2. Allowed, as points at the edge reach beyond: {:.4g} m^2.",
                where, overfull->volume, overfull->around.size(), overfull->area, overfull->limit);
  throw InputError(Problem{points_key(at->body), "the points hold more volume than there is room",
      too_much +
          "\nVolumes are in m^2 (per metre of thickness); no point may be there twice, nor in a body that is drawn.",
      "body", false, {"mesh"}});
}

struct SamePlace {
  const NewPoint* point = nullptr;
  std::int64_t n_more = -1;
};

SamePlace find_same_place(const PointBatches& points)
{
  std::vector<const NewPoint*> sorted;
  for (const auto& batch : points)
    for (const NewPoint& p : batch) sorted.push_back(&p);
  std::sort(sorted.begin(), sorted.end(), [](const NewPoint* a, const NewPoint* b) {
    return std::tie(a->key.cell, a->x[0], a->x[1]) < std::tie(b->key.cell, b->x[0], b->x[1]);
  });
  SamePlace found;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const NewPoint& a = *sorted[k];
    const Real near = one_place * size_of(a.volume);
    for (std::size_t j = k + 1;
         j < sorted.size() && sorted[j]->key.cell == a.key.cell && sorted[j]->x[0] - a.x[0] <= near; ++j) {
      const NewPoint& b = *sorted[j];
      if (std::hypot(b.x[0] - a.x[0], b.x[1] - a.x[1]) > std::min(near, one_place * size_of(b.volume))) continue;
      if (++found.n_more == 0) found.point = &a;
      break;
    }
  }
  return found;
}

void check_places(const StageSoil& soil, const PointBatches& points)
{
  const SamePlace found = find_same_place(points);
  if (found.point == nullptr) return;
  std::vector<PointOfFile> at;
  for_each_point_of_files(soil, [&](const PointOfFile& p) {
    if (std::hypot(p.point.x[0] - found.point->x[0], p.point.x[1] - found.point->x[1]) <=
        one_place * size_of(found.point->volume))
      at.push_back(p);
  });
  const std::string other = at.size() > 1 ? at[1].line() : "a body that is drawn";
  throw InputError(Problem{points_key(at.front().body), "two points lie at one place",
      fmt::format(
          "{} and {}: {} m{}.\nEach point is soil of its own, and no soil may be there twice: leave one of them out.",
          at.front().line(), other, place_text(found.point->x),
          found.n_more > 0 ? fmt::format(", and {} more such places", found.n_more) : ""),
      "body"});
}

/// True if all of a point lies in a body, as a square of its volume along the side next to it.
bool lies_wholly_in(const BodyOutline& body, std::span<const Side> sides, const NewPoint& p)
{
  if (!(body.cells.empty() ? covers(body, p.x) : std::binary_search(body.cells.begin(), body.cells.end(), p.key.cell)))
    return false;
  const Real depth = (0.5 - inside) * size_of(p.volume);
  return std::ranges::all_of(sides, [&](const Side& side) { return distance_to_line(side.a, side.b, p.x) >= depth; });
}

/// A point that reaches over the side of a body may be a coarse neighbour; one within it is soil that is there twice.
void check_drawn_bodies(const StageSoil& soil, const std::vector<BodyOutline>& outlines, const PointBatches& points)
{
  std::vector<std::vector<Side>> sides;
  for (const BodyOutline& outline : outlines) sides.push_back(outline_sides(*soil.mesh, outline));
  for (const auto& batch : points)
    for (const NewPoint& p : batch) {
      if (soil.description.bodies[p.body].points_file.empty()) continue;
      for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (!lies_wholly_in(outlines[k], sides[k], p)) continue;
        std::string line;
        for_each_point_of_files(soil, [&](const PointOfFile& other) {
          if (line.empty() && static_cast<Index>(other.body) == p.body && other.point.x == p.x) line = other.line();
        });
        throw InputError(Problem{points_key(p.body), "a point lies in a body that is drawn",
            fmt::format("{}: the point of {:.4g} m^2 at {} m lies within body[{}].\nNo soil may be there twice: leave "
                        "the point out, or draw that body "
                        "without its place (`holes`).",
                line, p.volume, place_text(p.x), k),
            "body"});
      }
    }
}

bool has_file_of_points(const Case& c)
{
  return std::ranges::any_of(c.bodies, [](const BodyCase& body) { return !body.points_file.empty(); });
}

}  // namespace

void check_points_of_files(const StageSoil& soil, const std::vector<BodyOutline>& outlines, const PointBatches& points)
{
  if (!has_file_of_points(soil.description)) return;
  check_drawn_bodies(soil, outlines, points);
  check_places(soil, points);
  check_room_for_points(soil, points);
}

}  // namespace terp
