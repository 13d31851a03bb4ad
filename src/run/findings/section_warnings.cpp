// Bodies are compared by their outlines: from places along each outline a ray goes straight outward and meets the next
// body or a held side of the mesh. Less than half a cell between them is a gap that was hardly drawn on purpose. A long
// side that lies on another outline with one end only makes a wedge, which is reported where nothing else carries the
// body: caverns and overhangs have such a carrier. The area that is drawn is that of all outlines together, cut into
// trapezoids as for the seeding (model/bodies/overlay.hpp).

#include "math/plane.hpp"
#include "run/findings/setup_warnings.hpp"

#include "mpm/features/conditions.hpp"
#include "mpm/mesh/locate.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/bodies/overlay.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/loads/side_shape.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr Real touching = 1e-6;     // of a cell: round-off of coordinates
constexpr Real gap_in_cells = 0.5;  // less is no room that was left on purpose
constexpr int most_samples = 2000;  // of the outline of one body
constexpr Real least_rise = 0.05;   // of a wedge, in cells: chords of one curve differ by less
constexpr Real some_share = 0.1;    // of gravity across a side: steeper sides carry nothing
constexpr Real lost_share = 2e-3;   // of the drawn area; curved outlines on straight cells lose less
constexpr std::size_t most_corners = 2000;

Vec<2> plus(Vec<2> a, Real t, Vec<2> d) { return {a[0] + t * d[0], a[1] + t * d[1]}; }

struct Obstacle {
  std::string name;  ///< "body 1", "the side `bottom`"
  std::vector<Side> sides;
  bool moves = false;            ///< a side with a velocity: soil may be meant to meet it later
  bool holds_along = false;      ///< a side that resists motion along itself
  Across across = Across::free;  ///< of a side
};

/// True if a side of the mesh can carry soil along itself: it is fixed, or a contact with a strength.
bool resists_along(const SideCondition& side)
{
  const Along along = side.slip ? Along::free : info_of(side.kind).action.along;
  return along == Along::prescribed || (along == Along::resisted && (side.adhesion > 0.0 || side.friction > 0.0));
}

/// Distance from x along d (of length 1) to a line, if it is met.
std::optional<Real> meet(Vec<2> x, Vec<2> d, const Side& line)
{
  const Vec<2> along = between(line.a, line.b), to = between(x, line.a);
  const Real det = cross(d, along);
  if (det == 0.0) return std::nullopt;
  const Real t = cross(to, along) / det, s = cross(to, d) / det;
  if (t < 0.0 || s < 0.0 || s > 1.0) return std::nullopt;
  return t;
}

bool encloses(const std::vector<Side>& sides, Vec<2> x)
{
  return std::ranges::count_if(crossings_of_vertical(sides, x[0]), [&](Real y) { return y > x[1]; }) % 2 == 1;
}

/// "body `berm`", or without a name "body 3 (`clay`)": numbers alone say little of layers.
std::string name_of(const BodyCase& body, std::size_t number)
{
  return body.name.empty() ? fmt::format("{} (`{}`)", called(body, number), body.material) : called(body, number);
}

class SectionCheck {
 public:
  explicit SectionCheck(const Model& model) : model_(model), cell_(typical_cell_size(*model.mesh))
  {
    const auto outlines = outlines_of(model);
    n_bodies_ = outlines.size();
    for (std::size_t b = 0; b < n_bodies_; ++b)
      obstacles_.push_back({name_of(model.description.bodies[b], b), outline_sides(*model.mesh, outlines[b])});
    for (const SideCondition& side : model.description.sides) {
      if (info_of(side.kind).action == SideAction{}) continue;
      Obstacle held{fmt::format("the side `{}`", side.side), {}, is_driven(side), resists_along(side),
          info_of(side.kind).action.across};
      for (const CellSide& edge : find_side(*model.mesh, side.side).edges)
        held.sides.push_back(edge_of(*model.mesh, edge));
      obstacles_.push_back(std::move(held));
    }
    const Real g = length(model.gravity);
    if (g > 0.0) down_ = {model.gravity[0] / g, model.gravity[1] / g};
    near_ = meets_ = Touches(n_bodies_, std::vector<bool>(n_bodies_, false));
    near_side_ = meets_side_ = std::vector<bool>(n_bodies_, false);
    beside_side_.resize(n_bodies_);
  }

  void check(Problems& warnings)
  {
    for (std::size_t b = 0; b < n_bodies_; ++b) look_around(b, warnings);
    const auto comes_as_points = [](const BodyCase& body) { return !body.points_file.empty(); };
    if (std::ranges::any_of(model_.description.bodies, comes_as_points) || n_bodies_ == obstacles_.size() ||
        down_ == Vec<2>{})
      return;
    find_wedges(warnings);
    find_hanging(warnings);
  }

 private:
  using Touches = std::vector<std::vector<bool>>;

  struct Beside {
    int n = 0;
    Real least = INFINITY, most = 0.0;
    Vec<2> at{};
    Vec<2> widest{};  ///< where it is `most`
  };

  struct Wedge {
    std::size_t body, other;
    Beside gap;
  };

  void look_around(std::size_t body, Problems& warnings)
  {
    const std::vector<Side>& sides = obstacles_[body].sides;
    const int per_side = std::clamp(most_samples / static_cast<int>(sides.size() + 1), 1, 64);
    const auto stride = std::max<std::size_t>(1, sides.size() / most_samples);
    for (std::size_t k = 0; k < sides.size(); k += stride) {
      std::vector<Beside> beside(obstacles_.size());
      const Real l = length(between(sides[k].a, sides[k].b));
      if (l == 0.0) continue;
      for (int i = 0; i < per_side; ++i) sample(body, sides[k], (i + 0.5) / per_side, beside);
      for (std::size_t other = 0; other < beside.size(); ++other) {
        if (is_gap(beside[other], l, per_side)) report_gap(body, other, beside[other], warnings);
        if (is_wedge(body, sides[k], beside[other], per_side)) wedges_.push_back({body, other, beside[other]});
      }
    }
  }

  /// A gap is as wide at one end as at the other; a wedge between two outlines that meet is not.
  bool is_gap(const Beside& beside, Real side, int per_side) const
  {
    const Real along = side * beside.n / per_side;
    return beside.n > 0 && beside.least > 0.3 * beside.most && (along > 2.0 * cell_ || 2 * beside.n >= per_side);
  }

  /// A lower side that is near another outline over more than two cells, and meets it at one end only.
  bool is_wedge(std::size_t body, const Side& side, const Beside& gap, int per_side) const
  {
    const Vec<2> middle = plus(side.a, 0.5, between(side.a, side.b)), out = outward(body, side, middle);
    const Real l = length(between(side.a, side.b));
    return gap.n > 0 && dot(out, down_) > 0.5 && l * gap.n > 2.0 * cell_ * per_side && gap.least <= 0.3 * gap.most &&
           gap.most > least_rise * cell_;
  }

  /// Of a side of a body at x, of length 1.
  Vec<2> outward(std::size_t body, const Side& side, Vec<2> x) const
  {
    const Vec<2> along = between(side.a, side.b);
    const Real l = length(along);
    const Vec<2> out{along[1] / l, -along[0] / l};
    return encloses(obstacles_[body].sides, plus(x, touching * cell_, out)) ? Vec<2>{-out[0], -out[1]} : out;
  }

  /// True if a side of the mesh that a body meets in the direction `out` holds it against gravity.
  bool holds(const Obstacle& side, const Side& line, Vec<2> out) const
  {
    const Vec<2> along = between(line.a, line.b);
    const Real across = std::abs(cross(along, down_)) / length(along);
    if (side.across == Across::opens && dot(out, down_) < some_share) return false;
    return side.holds_along || across > some_share;
  }

  void sample(std::size_t body, const Side& side, Real share, std::vector<Beside>& beside)
  {
    const Vec<2> x = plus(side.a, share, between(side.a, side.b)), out = outward(body, side, x);
    const Real near = touching * cell_;
    std::size_t nearest = obstacles_.size();
    const Side* nearest_line = nullptr;
    Real distance = INFINITY;
    for (std::size_t k = 0; k < obstacles_.size(); ++k) {
      if (k == body) continue;
      if (k < n_bodies_ && encloses(obstacles_[k].sides, plus(x, near, out))) {
        near_[body][k] = meets_[body][k] = true;
        return;
      }
      const Real before = k < n_bodies_ ? 0.0 : near;  // a side comes before a body that ends at it, too
      for (const Side& line : obstacles_[k].sides)
        if (const auto t = meet(plus(x, -near, out), out, line); t && *t < distance + before)
          distance = *t, nearest = k, nearest_line = &line;
    }
    if (!(distance < gap_in_cells * cell_)) return;
    const bool meets = distance <= 3.0 * near;
    if (nearest < n_bodies_) {
      near_[body][nearest] = true;
      meets_[body][nearest] = meets_[body][nearest] || meets;
    } else if (holds(obstacles_[nearest], *nearest_line, out)) {
      near_side_[body] = true;
      meets_side_[body] = meets_side_[body] || meets || obstacles_[nearest].moves;
    } else {
      beside_side_[body] = nearest;
    }
    if (meets || obstacles_[nearest].moves) return;
    Beside& gap = beside[nearest];
    ++gap.n;
    gap.least = std::min(gap.least, distance);
    if (distance > gap.most) gap.most = distance, gap.widest = x;
    gap.at = x;
  }

  bool is_news(std::size_t body, std::size_t other)
  {
    return reported_.insert({std::min(body, other), std::max(body, other)}).second;
  }

  void report_gap(std::size_t body, std::size_t other, const Beside& gap, Problems& warnings)
  {
    if (!is_news(body, other)) return;
    warnings.push_back({fmt::format("body[{}]", body),
        fmt::format("a gap between {} and {}", obstacles_[body].name, obstacles_[other].name),
        fmt::format(
            "It is {:.3g} m wide at {} m, less than a cell of {:.3g} m. Soil on both sides of it acts on the same "
            "nodes,\nand falls by the gap. Draw the two along one line.",
            gap.least, place_text(gap.at), cell_),
        "body", false, keys_of_outline(body)});
  }

  /// Which bodies a chain of bodies joins to a side that holds them.
  std::vector<bool> held_by(const Touches& touches, std::vector<bool> held) const
  {
    for (std::size_t round = 0; round < n_bodies_; ++round)
      for (std::size_t b = 0; b < n_bodies_; ++b)
        for (std::size_t k = 0; k < n_bodies_; ++k) held[b] = held[b] || ((touches[b][k] || touches[k][b]) && held[k]);
    return held;
  }

  bool is_thrown(std::size_t body) const
  {
    const BodyCase& values = model_.description.bodies[body];
    return values.velocity_at || values.velocity != Vec<2>{0.0, 0.0};
  }

  void find_wedges(Problems& warnings)
  {
    const std::vector<bool> held = held_by(meets_, meets_side_);
    for (const auto& [body, other, gap] : wedges_) {
      if (held[body] || is_thrown(body) || !is_news(body, other)) continue;
      warnings.push_back({fmt::format("body[{}]", body),
          fmt::format("a gap like a wedge between {} and {}", obstacles_[body].name, obstacles_[other].name),
          fmt::format(
              "It opens to more than {:.3g} m at {} m. {} lies on {} with one end only, and nothing else carries "
              "it: it turns and falls.\nDraw the two along one line.",
              gap.most, place_text(gap.widest), obstacles_[body].name, obstacles_[other].name),
          "body", false, keys_of_outline(body)});
    }
  }

  /// Bodies that no chain of bodies joins to a side that holds them: each chain is reported once.
  void find_hanging(Problems& warnings) const
  {
    const std::vector<bool> held = held_by(near_, near_side_);
    std::vector<bool> reported(n_bodies_, false);
    for (std::size_t b = 0; b < n_bodies_; ++b) {
      if (held[b] || reported[b] || is_thrown(b) || model_.bodies[b].n_points == 0) continue;
      std::vector<bool> first(n_bodies_, false);
      first[b] = true;
      const std::vector<bool> chain = held_by(near_, first);
      std::string names = obstacles_[b].name;
      bool thrown = false;
      for (std::size_t k = 0; k < n_bodies_; ++k) {
        if (!chain[k]) continue;
        reported[k] = true;
        thrown = thrown || is_thrown(k);
        if (k != b) names += " and " + obstacles_[k].name;
      }
      if (thrown) continue;
      const bool alone = std::ranges::count(chain, true) == 1;
      warnings.push_back({fmt::format("body[{}]", b), fmt::format("{} hang{} in the air", names, alone ? "s" : ""),
          fmt::format("{} no {}side that holds against gravity{}. {}", alone ? "It touches" : "They touch",
              alone ? "other body and no " : "", beside_text(chain), fall_of(chain)),
          "body", false, keys_of_outline(b)});
    }
  }

  /// Sides that a chain of bodies touches without being held by them.
  std::string beside_text(const std::vector<bool>& chain) const
  {
    for (std::size_t b = 0; b < n_bodies_; ++b)
      if (chain[b] && beside_side_[b])
        return fmt::format(" ({} does not: soil slides along it)", obstacles_[*beside_side_[b]].name);
    return "";
  }

  /// How deep a chain of bodies falls, from its own outlines along gravity.
  std::string fall_of(const std::vector<bool>& chain) const
  {
    Real fall = INFINITY;
    for (std::size_t body = 0; body < n_bodies_; ++body)
      for (std::size_t s = 0; chain[body] && s < obstacles_[body].sides.size(); ++s) {
        const Side& side = obstacles_[body].sides[s];
        for (std::size_t k = 0; k < obstacles_.size(); ++k)
          for (const Side& line : obstacles_[k].sides)
            if (const auto t = meet(plus(side.a, 0.5, between(side.a, side.b)), down_, line);
                t && (k >= n_bodies_ || !chain[k]))
              fall = std::min(fall, *t);
      }
    const char* drawn = std::ranges::count(chain, true) == 1 ? "It falls" : "They fall";
    return std::isfinite(fall) ? fmt::format(
                                     "{} by {:.3g} m. Draw it down to what carries it.\nSoil that lands comes "
                                     "to rest up to a cell above the ground "
                                     "(docs/limits.md#8-sides-contact-and-footings).",
                                     drawn, fall)
                               : "Nothing below carries it. Give the side below it a condition in [boundary].";
  }

  const Model& model_;
  Real cell_;
  std::size_t n_bodies_ = 0;
  std::vector<Obstacle> obstacles_;           ///< bodies, then held sides
  Vec<2> down_{};                             ///< of length 1; zero without gravity
  Touches near_, meets_;                      ///< which bodies a body is near to, by less than half a cell; and touches
  std::vector<bool> near_side_, meets_side_;  ///< the same of any side that holds against gravity
  std::vector<std::optional<std::size_t>> beside_side_;  ///< a side that each body is near to, which does not hold it
  std::vector<Wedge> wedges_;
  std::set<std::pair<std::size_t, std::size_t>> reported_;
};

/// The built-in names say where a side lies; edges of a polygon may be counted from 1 or run clockwise.
void find_misplaced_sides(const Model& model, Problems& warnings)
{
  struct Named {
    const char* name;
    Vec<2> normal;
    const char* place;
  };
  constexpr Named known[] = {{"left", {-1.0, 0.0}, "to the left"}, {"right", {1.0, 0.0}, "to the right"},
      {"bottom", {0.0, -1.0}, "downward"}, {"top", {0.0, 1.0}, "upward"}};
  const auto facing = [](Vec<2> n, const Named& side) { return n[0] * side.normal[0] + n[1] * side.normal[1]; };
  constexpr Real faces = 0.25;  // cosine: a slope of 1:4 may be the left side
  for (const NamedSide& side : model.mesh->sides)
    for (const Named& named : known) {
      const SideShape shape = shape_of_side(*model.mesh, side);
      if (side.name != named.name || shape.length == 0.0 || facing(shape.normal, named) >= faces) continue;
      const Named* looks = std::ranges::max_element(
          known, [&](const Named& a, const Named& b) { return facing(shape.normal, a) < facing(shape.normal, b); });
      const MeshKind kind = model.description.mesh.kind;
      const bool polygon = kind == MeshKind::polygon, file = kind == MeshKind::file;
      const std::string key = polygon ? fmt::format("mesh.edges.\"{}\"", side.name) : file ? "mesh.file" : "mesh.sides";
      warnings.push_back({key, fmt::format("the side `{}` does not face {}", side.name, named.place),
          fmt::format("It faces {}, {:.4g} m long. {}", looks->place, shape.length,
              polygon ? "Edge k runs from corner k of the polygon to corner k + 1, counted from 0.\n"
                        "`terp check CASE --picture section.svg` draws it."
              : file  ? "Look at the physical group of that name in the mesh file, or give the side another name."
                      : "Look at the order of the four lines of the grid."),
          polygon ? "mesh.edges" : "mesh", false, {"mesh.polygon", "mesh"}});
    }
}

/// Area of all drawn polygons together, where they overlap once [m^2]; none if that is not so easily said.
std::optional<Real> drawn_area(const Model& model)
{
  Overlay overlay;
  Vec<2> low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  std::size_t n_corners = 0;
  const auto outlines = outlines_of(model);
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    if (outlines[b].polygon.empty()) return std::nullopt;
    overlay.rings.push_back({outlines[b].polygon, static_cast<Index>(b), false});
    for (const Polygon& hole : outlines[b].holes) overlay.rings.push_back({hole, static_cast<Index>(b), true});
    for (const Vec<2>& x : outlines[b].polygon)
      for (int d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  }
  const Vec<2> middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
  const Vec<2> half{0.51 * (high[0] - low[0]), 0.51 * (high[1] - low[1])};
  for (Ring& ring : overlay.rings) {
    n_corners += ring.corners.size();
    for (Vec<2>& x : ring.corners) x = between(middle, x);
  }
  if (n_corners > most_corners) return std::nullopt;
  Real area = 0.0;
  for (const Part& part :
      share_out(overlay, {Vec<2>{-half[0], -half[1]}, {half[0], -half[1]}, {half[0], half[1]}, {-half[0], half[1]}}))
    area += part.area;
  return area;
}

/// A place where a body reaches over the boundary of the mesh.
std::string place_of_loss(const Model& model)
{
  const auto outlines = outlines_of(model);
  for (Index e = 0; e < model.mesh->n_cells(); ++e)
    for (int s = 0; s < 4; ++s) {
      if (model.mesh->neighbours[e][s] != outside) continue;
      const Side edge = edge_of(*model.mesh, {e, s});
      const Vec<2> along = between(edge.a, edge.b), middle = plus(edge.a, 0.5, along);
      const Vec<2> beyond = plus(middle, 0.05, Vec<2>{along[1], -along[0]});
      if (std::ranges::any_of(outlines, [&](const BodyOutline& body) { return covers(body, beyond); }))
        return fmt::format(" It reaches over the boundary of the mesh at {} m.", place_text(middle));
    }
  return "";
}

void find_lost_soil(const Model& model, Problems& warnings)
{
  const auto drawn = drawn_area(model);
  Real seeded = 0.0;
  for (const BodyShare& body : model.bodies) seeded += body.area;
  if (!drawn || !(*drawn - seeded > lost_share * *drawn)) return;
  warnings.push_back({"body", "a part of the soil lies outside of the mesh",
      fmt::format("The bodies are drawn with {:.6g} m^2, their points stand for {:.6g} m^2: {:.2g} % is missing.{}\n"
                  "Look for a cell that is missing from the mesh, or make the outline of body and mesh the same.",
          *drawn, seeded, 100.0 * (*drawn - seeded) / *drawn, place_of_loss(model)),
      "mesh", false, {"mesh"}});
}

/// A hole in the mesh that no side names, no larger than a few cells: cells that were forgotten.
void find_holes(const Model& model, Problems& warnings)
{
  constexpr Real few_cells = 4.5;
  const Mesh<2>& mesh = *model.mesh;
  std::vector<Index> next(mesh.nodes.size(), -1);
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < 4; ++s)
      if (mesh.neighbours[e][s] == outside) next[mesh.cells[e][s]] = mesh.cells[e][(s + 1) % 4];
  for (const NamedSide& side : mesh.sides)
    for (const CellSide& edge : side.edges) next[mesh.cells[edge.cell][edge.side]] = -1;
  const Real cell = typical_cell_size(mesh);
  for (Index start = 0; start < mesh.n_nodes(); ++start) {
    Polygon hole;
    Index i = start;
    while (next[i] >= 0) hole.push_back(mesh.nodes[i]), i = std::exchange(next[i], -1);
    if (hole.empty() || i != start) continue;
    const Real area = -signed_area(hole);
    if (!(area > 0.0) || area > few_cells * cell * cell) continue;
    warnings.push_back({"mesh", "the mesh has a hole",
        fmt::format("At {} m {:.3g} m^2 are missing, about {:.0f} cell{}. Soil cannot enter it, and no side names it.\n"
                    "Add the cell, or name the boundary of the hole.",
            place_text(hole.front()), area, std::max(1.0, area / (cell * cell)), area > 1.5 * cell * cell ? "s" : ""),
        "mesh", false, {"mesh.file"}});
  }
}

void find_tiny_soil(const Model& model, Problems& warnings)
{
  Polygon corners;
  for (const BodyOutline& outline : outlines_of(model))
    corners.insert(corners.end(), outline.polygon.begin(), outline.polygon.end());
  if (corners.empty()) return;
  const BoundingBox box = box_around(corners);
  const Vec<2> soil = between(box.low, box.high);
  const Real cell = typical_cell_size(*model.mesh);
  if (!(std::max(soil[0], soil[1]) < 0.999 * cell) || model.mesh->n_cells() == 1) return;  // one cell: a test of a law
  warnings.push_back({"body", "all bodies together are smaller than a cell",
      fmt::format(
          "They measure {:.3g} m by {:.3g} m, a cell {:.3g} m. Lengths of mesh and bodies are in metres: a mesh in "
          "mm is 1000 times too large.",
          soil[0], soil[1], cell),
      "mesh", false, {"mesh"}});
}

}  // namespace

void find_odd_places(const Model& model, Problems& warnings)
{
  find_misplaced_sides(model, warnings);
  find_tiny_soil(model, warnings);
  find_lost_soil(model, warnings);
  find_holes(model, warnings);
  SectionCheck(model).check(warnings);
}

}  // namespace terp
