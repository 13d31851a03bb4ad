// Each node on a side has one or two conditions: what a side does to the node. They are built once, in order (contacts
// first) and with parts of a straight base joined. In a step the question is which of them act: rollers and bilateral
// contacts always, a separating contact where it is pressed on. At a corner this is a problem with two unknowns, and
// exactly one set of acting sides satisfies Signorini's condition (decision 0038). `constrain` then removes the
// velocity across the acting sides and shortens the rest by adhesion and friction. `clamp` does the same to the
// remapped velocity with the strength that is left (decision 0037). Damping uses the same sets, to exclude what sides
// carry.
#include "mpm/features/conditions.hpp"

#include "math/plane.hpp"
#include "math/errors.hpp"
#include "mpm/features/side_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace terp {
namespace {

/// Sum of outward edge normals times length, and of half lengths, for each node of a side.
struct EdgeSums {
  Vec<2> normal{0.0, 0.0};
  Real half_length = 0.0;
};

std::map<Index, EdgeSums> sum_edges(const Mesh<2>& mesh, const NamedSide& side)
{
  std::map<Index, EdgeSums> nodes;
  for (const CellSide& edge : side.edges) {
    const Index a = mesh.cells[edge.cell][edge.side], b = mesh.cells[edge.cell][(edge.side + 1) % 4];
    const Vec<2> along{mesh.nodes[b][0] - mesh.nodes[a][0], mesh.nodes[b][1] - mesh.nodes[a][1]};
    for (const Index i : {a, b}) {
      nodes[i].normal[0] += along[1];  // the cell lies to the left of a -> b
      nodes[i].normal[1] -= along[0];
      nodes[i].half_length += 0.5 * std::hypot(along[0], along[1]);
    }
  }
  return nodes;
}

bool is_contact(const NodeSide& side) { return side.action.along == Along::resisted; }

bool is_fixed(const NodeSide& side) { return side.action.along == Along::prescribed; }

bool is_smooth(const NodeSide& side) { return side.action.along == Along::free; }

/// Acts across itself whatever the node does, and leaves it to others along itself.
bool stops(const NodeSide& side) { return side.action.across == Across::prescribed && !is_fixed(side); }

bool opens(const NodeSide& side) { return side.action.across == Across::opens; }

/// Velocity across a side that it prescribes [m/s].
Real prescribed_across(const NodeSide& side) { return is_smooth(side) ? dot(side.velocity, side.normal) : 0.0; }

constexpr Real straight = 0.996;  // cosine between normals of sides that count as one line: 5 degrees

/// Parts of a straight base with equal conditions.
bool are_parts_of_one(const NodeSide& a, const NodeSide& b)
{
  return a.action == b.action && !is_fixed(a) && a.velocity == b.velocity && dot(a.normal, b.normal) >= straight;
}

/// Contacts first, so that a roller at a corner decides about its direction.
void order_and_join(NodeCondition& c)
{
  if (c.n == 2 && !is_contact(c.sides[0]) && is_contact(c.sides[1])) std::swap(c.sides[0], c.sides[1]);
  const bool across = c.n == 2 && std::abs(dot(c.sides[0].normal, c.sides[1].normal)) < straight;
  c.corner = across && std::ranges::all_of(c.sides, [](const NodeSide& side) { return stops(side) || opens(side); });
  if (c.n == 2 && !across && is_contact(c.sides[0]) &&
      is_contact(c.sides[1])) {  // parts of a base with different conditions share the push
    const Real length = c.sides[0].half_length + c.sides[1].half_length;
    for (NodeSide& side : c.sides) side.friction *= side.half_length / length;
  }
  if (!c.corner) return;
  const Vec<2> n = c.sides[0].normal, m = c.sides[1].normal;
  const Real determinant = n[0] * m[1] - n[1] * m[0], a = prescribed_across(c.sides[0]),
             b = prescribed_across(c.sides[1]);
  c.corner_velocity = {(a * m[1] - b * n[1]) / determinant, (b * n[0] - a * m[0]) / determinant};
}

/// Which sides of a node act.
using Acting = std::array<bool, 2>;

/// Those that act whatever the node does.
Acting always(const NodeCondition& c) { return {c.n > 0 && stops(c.sides[0]), c.n > 1 && stops(c.sides[1])}; }

/// Which sides act on a velocity or a force w: those that must, and separating ones that it pushes on. At a corner the
/// push on one side is what the other leaves. So both act together or one alone: the only choice in which none pulls
/// and no motion passes through (Signorini's condition).
Acting acting_on(const NodeCondition& c, Vec<2> w, Acting must, std::array<Real, 2> prescribed)
{
  std::array<Real, 2> push{};
  for (int k = 0; k < c.n; ++k) push[k] = dot(w, c.sides[k].normal) - prescribed[k];
  const auto acts = [&](int k) { return must[k] || (opens(c.sides[k]) && !(push[k] < 0.0)); };
  if (!c.corner) return {c.n > 0 && acts(0), c.n > 1 && acts(1)};
  const Real cosine = dot(c.sides[0].normal, c.sides[1].normal);
  const Acting beside_other = {
      must[0] || push[0] - cosine * push[1] > 0.0, must[1] || push[1] - cosine * push[0] > 0.0};
  if (beside_other[0] && beside_other[1]) return {true, true};
  if (must[0] || must[1]) return must;
  if (!(push[0] < 0.0) && !beside_other[1]) return {true, false};
  if (!(push[1] < 0.0) && !beside_other[0]) return {false, true};
  return {false, false};
}

Acting acting_on_velocity(const NodeCondition& c, Vec<2> v, Acting must)
{
  return acting_on(c, v, must, {prescribed_across(c.sides[0]), c.n > 1 ? prescribed_across(c.sides[1]) : 0.0});
}

/// Shortens a vector by a length, at most to zero.
void shorten(Real by, Vec<2>& value)
{
  const Real length = std::hypot(value[0], value[1]);
  const Real kept = length > by ? 1.0 - by / length : 0.0;
  for (Real& component : value) component *= kept;
}

/// Impulses of a contact plane on a node: normal, then tangential up to adhesion, and friction under the push of the
/// trial velocity.
void apply_contact(const NodeSide& side, Real mass, SideStep step, Vec<2> trial, Vec<2>& v)
{
  const Real v_n = dot(v, side.normal);
  for (int d = 0; d < 2; ++d) v[d] -= v_n * side.normal[d];
  const Real strength = side.action.strength(side, mass * dot(trial, side.normal) / step.dt) / step.at_strength;
  shorten(strength * step.dt / mass, v);
}

/// Strength along the acting contact planes that their reaction in step 2 left unused [N per m].
Real unused_strength(const NodeCondition& c, Acting acts, Vec<2> reaction, Real at_strength)
{
  Real strength = 0.0, along = 0.0;
  for (int k = 0; k < c.n; ++k) {
    const NodeSide& side = c.sides[k];
    const Real push = -dot(reaction, side.normal);
    if (!acts[k] || !is_contact(side) || (opens(side) && !(push > 0.0))) continue;
    strength += side.action.strength(side, push) / at_strength;
    along = std::hypot(reaction[0] + push * side.normal[0], reaction[1] + push * side.normal[1]);
  }
  return std::max(strength - along, 0.0);
}

void stop_across(const NodeSide& side, Vec<2>& v)
{
  const Real v_n = dot(v, side.normal) - prescribed_across(side);
  for (int d = 0; d < 2; ++d) v[d] -= v_n * side.normal[d];
}

/// True if side k of a node acted in step 2. At a corner where one alone did it is the one that v_1 runs along.
bool acted(const NodeCondition& c, int k, Vec<2> v_1, Vec<2> reaction)
{
  if (stops(c.sides[k])) return true;
  if (!opens(c.sides[k]) || !(dot(reaction, c.sides[k].normal) < 0.0)) return false;
  return !c.corner || std::abs(dot(v_1, c.sides[k].normal)) < std::abs(dot(v_1, c.sides[1 - k].normal));
}

}  // namespace

const NamedSide& find_side(const Mesh<2>& mesh, const std::string& name)
{
  std::string known;
  bool is_inside = false;
  for (const auto& side : mesh.sides) {
    if (side.name == name && !side.is_inside) return side;
    is_inside = is_inside || side.name == name;
    if (side.is_inside) continue;
    known += (known.empty() ? "" : ", ") + side.name;
  }
  if (is_inside)
    throw InputError(Problem{"boundary." + name, "the side `" + name + "` lies inside the mesh, between two cells",
        "Its curve bounds nothing there: only parts of the boundary take a condition." +
            (known.empty() ? "" : " Sides of this mesh: " + known),
        "boundary", true, {"mesh.file"}});
  throw InputError(Problem{"boundary." + name, "the mesh has no side `" + name + "`",
      known.empty()
          ? "No side of this mesh has a name. A mesh file names them by physical groups: in gmsh\n"
            "`Physical Curve(\"" +
                name + "\") = {1, 2};`. In [mesh] of a polygon: edges = { " + name +
                " = [0] }.\nFiles .bdf, .nas and .vtk carry no names of groups: save the mesh as .msh or .unv."
          : "Sides of this mesh: " + known,
      "boundary", true, {"mesh.file", "mesh.edges"}});
}

Boundary::Boundary(const Mesh<2>& mesh, const std::vector<SideCondition>& sides)
    : condition_of_node_(mesh.nodes.size(), -1)
{
  std::vector<int> n_sides;
  for (const SideCondition& given : sides) {
    const NamedSide& place = find_side(mesh, given.side);
    if (info_of(given.kind).action == SideAction{}) continue;
    for (const auto& [node, sums] : sum_edges(mesh, place)) {
      if (condition_of_node_[node] < 0) {
        condition_of_node_[node] = static_cast<Index>(conditions_.size());
        conditions_.emplace_back();
        n_sides.push_back(0);
      }
      NodeCondition& c = conditions_[condition_of_node_[node]];
      if (++n_sides[condition_of_node_[node]] > 2)
        throw InputError(Problem{"boundary." + given.side, "a node lies on more than two sides with conditions", "",
            "boundary", true, {"boundary"}});
      const NodeSide side = node_side(given, sums.normal, sums.half_length, mesh.nodes[node]);
      if (c.n == 1 && are_parts_of_one(c.sides[0], side))
        c.sides[0] = joined(c.sides[0], side);
      else
        c.sides[c.n++] = side;
    }
  }
  for (auto& c : conditions_) order_and_join(c);
}

template <class TakeAlong>
Vec<2> Boundary::free_part(Index node, Vec<2> value, Vec<2> push, TakeAlong take_along) const
{
  const NodeCondition* c = at(node);
  if (c == nullptr) return value;
  for (int k = 0; k < c->n; ++k)
    if (is_fixed(c->sides[k])) return {0.0, 0.0};
  const Acting acts = acting_on(*c, push, always(*c), {});
  if (c->corner && acts[0] && acts[1]) return {0.0, 0.0};
  for (int k = 0; k < c->n; ++k) {
    if (!acts[k]) continue;
    const NodeSide& side = c->sides[k];
    const Real across = dot(value, side.normal);
    for (int d = 0; d < 2; ++d) value[d] -= across * side.normal[d];
    if (is_contact(side)) take_along(side, value);
  }
  return value;
}

Vec<2> Boundary::free_velocity(Index node, Vec<2> v, Vec<2> push) const
{
  return free_part(node, v, push, [](const NodeSide&, Vec<2>&) {});
}

Vec<2> Boundary::free_force(Index node, Vec<2> force, Real at_strength) const
{
  return free_part(node, force, force, [&](const NodeSide& side, Vec<2>& along) {
    shorten(side.action.strength(side, dot(force, side.normal)) / at_strength, along);
  });
}

void Boundary::constrain(Index node, Real mass, SideStep step, Vec<2>& v) const
{
  const NodeCondition* c = at(node);
  if (c == nullptr) return;
  const Acting acts = acting_on_velocity(*c, v, always(*c));
  const Vec<2> trial = v;
  for (int k = 0; k < c->n; ++k) {
    const NodeSide& side = c->sides[k];
    if (acts[k] && is_contact(side)) apply_contact(side, mass, step, trial, v);
    if (acts[k] && is_smooth(side)) stop_across(side, v);
  }
  if (c->corner && acts[0] && acts[1]) v = c->corner_velocity;
  for (int k = 0; k < c->n; ++k)
    if (is_fixed(c->sides[k])) v = c->sides[k].velocity;
}

void Boundary::clamp(
    Index node, Real mass, SideStep step, Vec<2> v_1, Vec<2> reaction, Vec<2>& v, bool across_alone) const
{
  const NodeCondition* c = at(node);
  if (c == nullptr) return;
  Acting before{};
  for (int k = 0; k < c->n; ++k) before[k] = acted(*c, k, v_1, reaction);
  const bool both_before = c->corner && v_1 == c->corner_velocity && dot(reaction, reaction) > 0.0;
  const Acting acts = both_before ? Acting{true, true} : acting_on_velocity(*c, v, before);
  for (int k = 0; k < c->n; ++k)
    if (acts[k] && !is_fixed(c->sides[k])) stop_across(c->sides[k], v);
  if (!across_alone) shorten(unused_strength(*c, acts, reaction, step.at_strength) * step.dt / mass, v);
  if (c->corner && acts[0] && acts[1]) v = c->corner_velocity;
  for (int k = 0; k < c->n; ++k)
    if (is_fixed(c->sides[k])) v = c->sides[k].velocity;
}

}  // namespace terp
