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
#include "model/meshes/setup_mesh.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/loads/side_shape.hpp"
#include "model/soils/overburden.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <tuple>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr Real touching = 1e-6;     // of a cell: round-off of coordinates
constexpr Real gap_in_cells = 0.5;  // less is no room that was left on purpose
constexpr int most_samples = 2000;  // of the outline of one body
constexpr Real least_rise = 0.05;   // of a wedge, in cells: chords of one curve differ by less
constexpr Real some_share = 0.1;    // of gravity across a side: steeper sides carry nothing

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

/// "body `berm`", or without a name "body 3 (`clay`)": numbers alone say little of layers.
std::string name_of(const BodyCase& body, std::size_t number)
{
  return body.name.empty() ? fmt::format("{} (`{}`)", called(body, number), body.material) : called(body, number);
}

class SectionCheck {
 public:
  /// absent: bodies that are left out, by their numbers.
  explicit SectionCheck(const Model& model, const std::set<std::size_t>& absent = {})
      : model_(model), cell_(typical_cell_size(*model.mesh))
  {
    const auto outlines = outlines_of(model);
    n_bodies_ = outlines.size();
    for (std::size_t b = 0; b < n_bodies_; ++b)
      obstacles_.push_back({name_of(model.description.bodies[b], b),
          absent.contains(b) ? std::vector<Side>{} : outline_sides(*model.mesh, outlines[b])});
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
    for (const Hanging& chain : find_hanging()) report_hanging(chain, warnings);
  }

  struct Hanging {
    std::vector<bool> bodies;
    std::string names;

    bool is_alone() const { return std::ranges::count(bodies, true) == 1; }
  };

  /// The bodies that hang in the air, by their numbers; their names go to `names`.
  std::set<std::size_t> hanging(std::string& names)
  {
    Problems ignored;
    for (std::size_t b = 0; b < n_bodies_; ++b) look_around(b, ignored);
    std::set<std::size_t> found;
    for (const Hanging& chain : find_hanging()) {
      for (std::size_t b = 0; b < n_bodies_; ++b)
        if (chain.bodies[b]) found.insert(b);
      names += (names.empty() ? "" : " and ") + chain.names;
    }
    return found;
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

  /// Bodies that no chain of bodies joins to a side that holds them, each chain once.
  std::vector<Hanging> find_hanging() const
  {
    std::vector<Hanging> chains;
    const std::vector<bool> held = held_by(near_, near_side_);
    std::vector<bool> reported(n_bodies_, false);
    for (std::size_t b = 0; b < n_bodies_; ++b) {
      if (held[b] || reported[b] || is_thrown(b) || obstacles_[b].sides.empty() || model_.bodies[b].n_points == 0)
        continue;
      std::vector<bool> first(n_bodies_, false);
      first[b] = true;
      Hanging chain{held_by(near_, first), obstacles_[b].name};
      bool thrown = false;
      for (std::size_t k = 0; k < n_bodies_; ++k) {
        if (!chain.bodies[k]) continue;
        reported[k] = true;
        thrown = thrown || is_thrown(k);
        if (k != b) chain.names += " and " + obstacles_[k].name;
      }
      if (!thrown) chains.push_back(std::move(chain));
    }
    return chains;
  }

  void report_hanging(const Hanging& chain, Problems& warnings) const
  {
    const auto b = static_cast<std::size_t>(std::ranges::find(chain.bodies, true) - chain.bodies.begin());
    warnings.push_back(
        {fmt::format("body[{}]", b), fmt::format("{} hang{} in the air", chain.names, chain.is_alone() ? "s" : ""),
            fmt::format("{} no {}side that holds against gravity{}. {}", chain.is_alone() ? "It touches" : "They touch",
                chain.is_alone() ? "other body and no " : "", beside_text(chain.bodies), fall_of(chain.bodies)),
            "body", false, keys_of_outline(b)});
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

/// A stage digs away what other bodies stand on.
void find_undermined_soil(const Model& model, Problems& warnings)
{
  const Case& whole = model.whole();
  if (model.gravity == Vec<2>{} || whole.sides.empty()) return;
  std::string ignored;
  std::optional<std::set<std::size_t>> before;
  for (std::size_t k = 0; k < whole.stages.size(); ++k) {
    if (whole.stages[k].remove.empty()) continue;
    if (!before) before = SectionCheck(model).hanging(ignored);
    std::set<std::size_t> absent;
    for (std::size_t b = 0; b < whole.bodies.size(); ++b)
      if (whole.bodies[b].placed > k + 1 || whole.bodies[b].removed <= k + 1) absent.insert(b);
    std::string names;
    const std::set<std::size_t> now = SectionCheck(model, absent).hanging(names);
    if (std::ranges::includes(*before, now)) continue;
    warnings.push_back({fmt::format("stage[{}].remove", k),
        fmt::format("{} then hang{} in the air", names, now.size() == 1 ? "s" : ""),
        fmt::format(
            "The stage `{}` removes what carries {}. Remove that soil first, or the parts of it that stand free.",
            whole.stages[k].name, now.size() == 1 ? "it" : "them"),
        "stage.remove", false, {"stage", "body"}});
    before->insert(now.begin(), now.end());
  }
}

/// A load whose ground falls to one side, narrower than a cell, or drawn twice: its places, or the ground, are of
/// another frame or unit.
void find_odd_loads(const Model& model, Problems& warnings)
{
  constexpr Real steep = 1.0 / 6.0;
  const Overburden overburden(model);
  const auto& loads = model.description.loads;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Real half = 0.5 * (loads[k].to - loads[k].from), middle = loads[k].from + half;
    const auto left = overburden.ground(loads[k].from + 1e-3 * half), mid = overburden.ground(middle),
               right = overburden.ground(loads[k].to - 1e-3 * half);
    if (!left || !mid || !right || !(loads[k].pressure > 0.0)) continue;
    const auto key = [](const LoadCase& load) { return std::tie(load.from, load.to, load.pressure, load.start); };
    for (std::size_t other = 0; other < k; ++other)
      if (key(loads[other]) == key(loads[k]))
        warnings.push_back({fmt::format("load[{}]", k),
            fmt::format("the loads `{}` and `{}` are the same", loads[other].name, loads[k].name),
            "Loads on the same ground add: it bears twice the pressure. Leave one out, or give one load the sum.",
            "load"});
    if (const Real cell = typical_cell_size(*model.mesh); 2.0 * half < (1.0 - 1e-9) * cell)
      warnings.push_back({fmt::format("load[{}].from", k),
          fmt::format("the load `{}` is narrower than a cell", loads[k].name),
          fmt::format("Its width is {:.3g} m, cells are {:.3g} m: together {:.3g} kN per m. `pressure` is per area, no "
                      "force per m, and\n`from` and `to` are in m.",
              2.0 * half, cell, 2e-3 * half * loads[k].pressure),
          "load", false, {fmt::format("load[{}]", k), "mesh"}});
    const Real first = (*mid - *left) / half, second = (*right - *mid) / half;
    if (!(std::min(first, second) > steep) && !(std::max(first, second) < -steep)) continue;
    warnings.push_back({fmt::format("load[{}].from", k), fmt::format("the load `{}` stands on a slope", loads[k].name),
        fmt::format("The ground lies at {:.4g} m at its left end and at {:.4g} m at its right one, {:.3g} m apart. "
                    "Traffic and fills stand on\nlevel ground: are `from` and `to` in the frame of the section?",
            *left, *right, 2.0 * half),
        "load.from", false, {fmt::format("load[{}]", k), "body"}});
  }
}

}  // namespace

void find_odd_places(const Model& model, Problems& warnings)
{
  SectionCheck(model).check(warnings);
  find_undermined_soil(model, warnings);
  find_odd_loads(model, warnings);
}

}  // namespace terp
