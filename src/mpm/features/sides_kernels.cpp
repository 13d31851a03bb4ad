// What the sides of the mesh do to nodes and points.
#include "mpm/features/sides.hpp"
#include "mpm/step/now.hpp"
#include "mpm/step/stored_energy.hpp"

namespace terp {
namespace {

/// Enters a point that crossed an open side in the list of those that left.
void enter_left(const StepModel& model, Index number, std::span<Real> values, StepState& state)
{
  state.left.push_back({.time = model.time_of(state.step + 1),
      .id = static_cast<std::int64_t>(values[Rows::id]),
      .x = {values[Rows::x], values[Rows::x + 1]},
      .v = {values[Rows::v], values[Rows::v + 1]},
      .mass = values[Rows::mass],
      .elastic = elastic_energy(model.materials[number], values),
      .volume = values[Rows::volume]});
}

/// Counts a point that had to be put back at a wall, once.
void enter_put_back(std::span<const Real> values, StepState& state)
{
  auto before = state.put_back[static_cast<std::size_t>(values[Rows::id])];
  if (!before) ++state.clamped;
  before = true;
}

/// Most nodes are on no side. f(k, number of the node).
template <class F>
void for_each_on_side(const Nodes& nodes, const Boundary& boundary, F&& f)
{
  for (int k = 0; k < nodes.n; ++k)
    if (boundary.at(nodes.number[k]) != nullptr) f(k, nodes.number[k]);
}

SideStep side_step(const Nodes& nodes) { return {nodes.step.model.dt, nodes.step.context.at_strength}; }

void free_part_sides(Nodes& nodes)
{
  const Boundary& boundary = nodes.step.model.with.sides->boundary;
  for_each_on_side(nodes, boundary, [&](int k, Index i) {
    nodes.force[k] = boundary.free_force(i, nodes.out_of_balance[k], nodes.step.context.at_strength);
    nodes.v[k] = boundary.free_velocity(i, nodes.v_0[k], nodes.out_of_balance[k]);
  });
}

void constrain(Nodes& nodes)
{
  const Boundary& boundary = nodes.step.model.with.sides->boundary;
  for_each_on_side(nodes, boundary,
      [&](int k, Index i) { boundary.constrain(i, nodes.mass[k], side_step(nodes), nodes.v_star[k]); });
}

void clamp(Nodes& nodes)
{
  const StepModel& model = nodes.step.model;
  const Boundary& boundary = model.with.sides->boundary;
  const bool across_alone = model.method.remap_contact == RemapContact::across;
  for_each_on_side(nodes, boundary, [&](int k, Index i) {
    boundary.clamp(i, nodes.mass[k], side_step(nodes), nodes.v_0[k], nodes.step.work.node[i].boundary, nodes.v_star[k],
        across_alone);
  });
}

void move_leavers(StepNow& now)
{
  const StepModel& model = now.model;
  StepState& state = now.state;
  Workspace& work = now.work;
  const OpenSides& open = model.with.sides->open;
  for (const CellSums& sums : work.cell_sums)
    for (std::size_t k = sums.end_of_leaving;
         k-- > sums.first_leaving;) {  // from the last lane of a block to the first: see take()
      const PointPlace place = work.points_leaving[sums.thread][k];
      const Index material = state.points.block(place.block).material;
      const Moved moved = move_to_new_cell(*model.mesh, open, state.points, place, work.point_leaving);
      if (moved == Moved::put_back) enter_put_back(work.point_leaving, state);
      if (moved == Moved::left) enter_left(model, material, work.point_leaving, state);
    }
}

bool present_sides(const StepModel& model, const Workspace&) { return model.with.sides != nullptr; }

using P = ScorePlace;
constexpr Kernel sides_score[] = {
    {P::free, "sides", &free_part_sides},
    {P::constrain, "sides", &constrain},
    {P::clamp, "sides", &clamp},
    {P::leavers, "sides", &move_leavers},
};

}  // namespace

TERP_FEATURE_KERNELS(sides, present_sides)

}  // namespace terp
