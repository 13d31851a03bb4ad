// Each node on a side has one or two holds: what a side does to the node. They are built once, in order (contacts
// first) and with parts of a straight base joined. In a step the question is which of them act: rollers and bilateral
// contacts always, a separating contact where it is pressed on. At a corner this is a problem with two unknowns, and
// exactly one set of acting sides satisfies Signorini's condition (decision 0038). `constrain` then removes the
// velocity across the acting sides and shortens the rest by adhesion and friction. `clamp` does the same to the
// remapped velocity with the strength that is left (decision 0037). Damping uses the same sets, to exclude what sides
// carry.
#include "boundary/conditions.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace terp {
namespace {

Real dot(Vec<2> a, Vec<2> b) { return a[0] * b[0] + a[1] * b[1]; }

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

bool is_contact(Hold hold) { return hold == Hold::contact || hold == Hold::separating; }

bool stops(Hold hold) { return hold == Hold::normal || hold == Hold::contact; }

/// Velocity across a side that it prescribes [m/s].
Real prescribed_across(const NodeHold& hold)
{
  return hold.hold == Hold::normal ? dot(hold.velocity, hold.normal) : 0.0;
}

constexpr Real straight = 0.996;  // cosine between normals of sides that count as one line: 5 degrees

/// Parts of a straight base with equal conditions.
bool are_parts_of_one(const NodeHold& a, const NodeHold& b)
{
  return a.hold == b.hold && a.hold != Hold::all && a.velocity == b.velocity && dot(a.normal, b.normal) >= straight;
}

/// The base of two parts at the node between them: the push is shared by their half lengths.
NodeHold joined(const NodeHold& a, const NodeHold& b)
{
  const Real length = a.half_length + b.half_length, part = a.half_length / length;
  const Vec<2> sum{part * a.normal[0] + (1.0 - part) * b.normal[0], part * a.normal[1] + (1.0 - part) * b.normal[1]};
  const Real norm = std::hypot(sum[0], sum[1]);
  return {a.hold, {sum[0] / norm, sum[1] / norm}, length, a.adhesion_force + b.adhesion_force,
      part * a.friction + (1.0 - part) * b.friction, a.velocity};
}

/// Contacts first, so that a roller at a corner decides about its direction.
void order_and_join(NodeCondition& c)
{
  if (c.n == 2 && !is_contact(c.holds[0].hold) && is_contact(c.holds[1].hold)) std::swap(c.holds[0], c.holds[1]);
  const bool across = c.n == 2 && std::abs(dot(c.holds[0].normal, c.holds[1].normal)) < straight;
  c.corner = across && c.holds[0].hold != Hold::all && c.holds[1].hold != Hold::all;
  if (c.n == 2 && !across && is_contact(c.holds[0].hold) &&
      is_contact(c.holds[1].hold)) {  // parts of a base with different conditions share the push
    const Real length = c.holds[0].half_length + c.holds[1].half_length;
    for (NodeHold& hold : c.holds) hold.friction *= hold.half_length / length;
  }
  if (!c.corner) return;
  const Vec<2> n = c.holds[0].normal, m = c.holds[1].normal;
  const Real determinant = n[0] * m[1] - n[1] * m[0], a = prescribed_across(c.holds[0]),
             b = prescribed_across(c.holds[1]);
  c.corner_velocity = {(a * m[1] - b * n[1]) / determinant, (b * n[0] - a * m[0]) / determinant};
}

/// Which holds of a node act.
using Acting = std::array<bool, 2>;

/// Those that act whatever the node does.
Acting always(const NodeCondition& c) { return {c.n > 0 && stops(c.holds[0].hold), c.n > 1 && stops(c.holds[1].hold)}; }

/// Which holds act on a velocity or a force w: those that must, and separating ones that it pushes on. At a corner the
/// push on one side is what the other leaves. So both act together or one alone: the only choice in which none pulls
/// and no motion passes through (Signorini's condition).
Acting acting_on(const NodeCondition& c, Vec<2> w, Acting must, std::array<Real, 2> prescribed)
{
  std::array<Real, 2> push{};
  for (int k = 0; k < c.n; ++k) push[k] = dot(w, c.holds[k].normal) - prescribed[k];
  if (!c.corner) return {c.n > 0 && (must[0] || !(push[0] < 0.0)), c.n > 1 && (must[1] || !(push[1] < 0.0))};
  const Real cosine = dot(c.holds[0].normal, c.holds[1].normal);
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
  return acting_on(c, v, must, {prescribed_across(c.holds[0]), c.n > 1 ? prescribed_across(c.holds[1]) : 0.0});
}

/// Force that a contact plane can carry along itself under a push across it [N per m].
Real strength_of(const NodeHold& hold, Real push) { return hold.adhesion_force + hold.friction * std::max(push, 0.0); }

/// Shortens a vector by a length, at most to zero.
void shorten(Real by, Vec<2>& value)
{
  const Real length = std::hypot(value[0], value[1]);
  const Real kept = length > by ? 1.0 - by / length : 0.0;
  for (Real& component : value) component *= kept;
}

/// Impulses of a contact plane on a node: normal, then tangential up to adhesion, and friction under the push of the
/// trial velocity.
void apply_contact(const NodeHold& hold, Real mass, Real dt, Vec<2> trial, Vec<2>& v)
{
  const Real v_n = dot(v, hold.normal);
  for (int d = 0; d < 2; ++d) v[d] -= v_n * hold.normal[d];
  shorten(strength_of(hold, mass * dot(trial, hold.normal) / dt) * dt / mass, v);
}

/// Strength along the acting contact planes that their reaction in step 2 left unused [N per m].
Real unused_strength(const NodeCondition& c, Acting acts, Vec<2> reaction)
{
  Real strength = 0.0, along = 0.0;
  for (int k = 0; k < c.n; ++k) {
    const NodeHold& hold = c.holds[k];
    const Real push = -dot(reaction, hold.normal);
    if (!acts[k] || !is_contact(hold.hold) || (hold.hold == Hold::separating && !(push > 0.0))) continue;
    strength += strength_of(hold, push);
    along = std::hypot(reaction[0] + push * hold.normal[0], reaction[1] + push * hold.normal[1]);
  }
  return std::max(strength - along, 0.0);
}

void stop_across(const NodeHold& hold, Vec<2>& v)
{
  const Real v_n = dot(v, hold.normal) - prescribed_across(hold);
  for (int d = 0; d < 2; ++d) v[d] -= v_n * hold.normal[d];
}

/// True if hold k of a node acted in step 2. At a corner where one alone did it is the one that v_1 runs along.
bool acted(const NodeCondition& c, int k, Vec<2> v_1, Vec<2> reaction)
{
  if (stops(c.holds[k].hold)) return true;
  if (!(dot(reaction, c.holds[k].normal) < 0.0)) return false;
  return !c.corner || std::abs(dot(v_1, c.holds[k].normal)) < std::abs(dot(v_1, c.holds[1 - k].normal));
}

}  // namespace

const NamedSide& find_side(const Mesh<2>& mesh, const std::string& name)
{
  std::string known;
  for (const auto& side : mesh.sides) {
    if (side.name == name) return side;
    known += (known.empty() ? "" : ", ") + side.name;
  }
  throw InputError(Problem{"boundary." + name, "the mesh has no side `" + name + "`",
      known.empty() ? "No side of this mesh has a name. A mesh file names them by physical groups: in gmsh\n"
                      "`Physical Curve(\"" +
                          name + "\") = {1, 2};`. In [mesh] of a polygon: edges = { " + name + " = [0] }."
                    : "Sides of this mesh: " + known,
      "boundary", true, {"mesh.file", "mesh.edges"}});
}

Boundary::Boundary(const Mesh<2>& mesh, const std::vector<SideCondition>& sides)
    : condition_of_node_(mesh.nodes.size(), -1)
{
  std::vector<int> n_sides;
  for (const auto& side : sides)
    for (const auto& [node, sums] : sum_edges(mesh, find_side(mesh, side.side))) {
      if (condition_of_node_[node] < 0) {
        condition_of_node_[node] = static_cast<Index>(conditions_.size());
        conditions_.emplace_back();
        n_sides.push_back(0);
      }
      NodeCondition& c = conditions_[condition_of_node_[node]];
      if (++n_sides[condition_of_node_[node]] > 2)
        throw InputError(Problem{"boundary." + side.side, "a node lies on more than two sides with conditions", "",
            "boundary", true, {"boundary"}});
      const Real length = std::hypot(sums.normal[0], sums.normal[1]);
      const NodeHold hold{side.hold, {sums.normal[0] / length, sums.normal[1] / length}, sums.half_length,
          side.adhesion * sums.half_length, side.friction,
          side.velocity_at ? side.velocity_at(mesh.nodes[node]) : side.velocity};
      if (c.n == 1 && are_parts_of_one(c.holds[0], hold))
        c.holds[0] = joined(c.holds[0], hold);
      else
        c.holds[c.n++] = hold;
    }
  for (auto& c : conditions_) order_and_join(c);
}

template <class TakeAlong>
Vec<2> Boundary::free_part(Index node, Vec<2> value, Vec<2> push, TakeAlong take_along) const
{
  const NodeCondition* c = at(node);
  if (c == nullptr) return value;
  for (int k = 0; k < c->n; ++k)
    if (c->holds[k].hold == Hold::all) return {0.0, 0.0};
  const Acting acts = acting_on(*c, push, always(*c), {});
  if (c->corner && acts[0] && acts[1]) return {0.0, 0.0};
  for (int k = 0; k < c->n; ++k) {
    if (!acts[k]) continue;
    const NodeHold& hold = c->holds[k];
    const Real across = dot(value, hold.normal);
    for (int d = 0; d < 2; ++d) value[d] -= across * hold.normal[d];
    if (is_contact(hold.hold)) take_along(hold, value);
  }
  return value;
}

Vec<2> Boundary::free_velocity(Index node, Vec<2> v, Vec<2> push) const
{
  return free_part(node, v, push, [](const NodeHold&, Vec<2>&) {});
}

Vec<2> Boundary::free_force(Index node, Vec<2> force) const
{
  return free_part(node, force, force,
      [&](const NodeHold& hold, Vec<2>& along) { shorten(strength_of(hold, dot(force, hold.normal)), along); });
}

void Boundary::constrain(Index node, Real mass, Real dt, Vec<2>& v) const
{
  const NodeCondition* c = at(node);
  if (c == nullptr) return;
  const Acting acts = acting_on_velocity(*c, v, always(*c));
  const Vec<2> trial = v;
  for (int k = 0; k < c->n; ++k) {
    const NodeHold& hold = c->holds[k];
    if (acts[k] && is_contact(hold.hold)) apply_contact(hold, mass, dt, trial, v);
    if (hold.hold == Hold::normal) stop_across(hold, v);
  }
  if (c->corner && acts[0] && acts[1]) v = c->corner_velocity;
  for (int k = 0; k < c->n; ++k)
    if (c->holds[k].hold == Hold::all) v = c->holds[k].velocity;
}

void Boundary::clamp(Index node, Real mass, Real dt, Vec<2> v_1, Vec<2> reaction, Vec<2>& v) const
{
  const NodeCondition* c = at(node);
  if (c == nullptr) return;
  Acting before{};
  for (int k = 0; k < c->n; ++k) before[k] = acted(*c, k, v_1, reaction);
  const bool both_before = c->corner && v_1 == c->corner_velocity && dot(reaction, reaction) > 0.0;
  const Acting acts = both_before ? Acting{true, true} : acting_on_velocity(*c, v, before);
  for (int k = 0; k < c->n; ++k)
    if (acts[k] && c->holds[k].hold != Hold::all) stop_across(c->holds[k], v);
  shorten(unused_strength(*c, acts, reaction) * dt / mass, v);
  if (c->corner && acts[0] && acts[1]) v = c->corner_velocity;
  for (int k = 0; k < c->n; ++k)
    if (c->holds[k].hold == Hold::all) v = c->holds[k].velocity;
}

}  // namespace terp
