#include "simulation/initial.hpp"

#include "simulation/ledger.hpp"
#include "simulation/overburden.hpp"
#include "simulation/run.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// Velocity, strain and history to zero; positions stay and become the initial ones.
void reset_history(const RowTable& table, State& state)
{
  using Rows = PointRows<2>;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int d = 0; d < 2; ++d) {
      block.row(Rows::v + d)[lane] = 0.0;
      state.x_initial[2 * id + d] = block.row(Rows::x + d)[lane];
    }
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::strain + k)[lane] = 0.0;
    for (const RowInfo& row : table.added())
      if (row.averaging != Averaging::keep) block.row(row.first)[lane] = row.initial;
  });
  state.work = {};
  state.clamped = 0;
  std::fill(state.put_back.begin(), state.put_back.end(), false);
}

/// Soil that yielded in the search and moved beyond its cell: another body came to rest than the one that was drawn.
struct Flow {
  Index n = 0;     ///< points
  Real way = 0.0;  ///< the longest [m]
};

Flow find_flow(const Model& model, const State& state)
{
  using Rows = PointRows<2>;
  constexpr Real yielded = 0.1;  // eps_eq_p; single points at a toe come to 0.09 in soil that stands
  Flow flow;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const int strain = row_of(model.materials[block.material], Role::plastic_strain);
    if (strain < 0 || block.row(strain)[lane] < yielded) return;
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real way = std::hypot(
        block.row(Rows::x)[lane] - state.x_initial[2 * id], block.row(Rows::x + 1)[lane] - state.x_initial[2 * id + 1]);
    const Vec<2> a = model.mesh->nodes[model.mesh->cells[block.cell][0]],
                 c = model.mesh->nodes[model.mesh->cells[block.cell][2]];
    if (way <= std::hypot(c[0] - a[0], c[1] - a[1])) return;
    ++flow.n;
    flow.way = std::max(flow.way, way);
  });
  return flow;
}

std::string describe_flow(const Flow& flow, Index n_points)
{
  return fmt::format(
      "no equilibrium: the body came to rest only after {:.2g} % of its soil had yielded and moved by up to {:.3g} "
      "m\n\n"
      "  likely   the body cannot stand under its own weight\n"
      "  try      initial.stress = \"none\" or \"k0\", or a stronger soil (docs/troubleshooting.md#no-equilibrium)",
      100.0 * static_cast<Real>(flow.n) / static_cast<Real>(n_points), flow.way);
}

constexpr Real most_that_flows = 0.01;  // of the points: some trickle down the face of soil that stands

constexpr const char* soil_left =
    "in the search for equilibrium soil left through an open side; give that side a `roller`, or start with \"k0\"";

std::string describe_no_equilibrium(const InitialCase& initial, Real ratio)
{
  return fmt::format(
      "no equilibrium: after {} steps the out-of-balance force is {:.2e} of the weight, limit {:.2e}\n\n"
      "  likely   the body cannot stand under its own weight, or needs more steps\n"
      "  try      initial.stress = \"none\" or \"k0\", a stronger soil, or a larger initial.max_steps "
      "(docs/troubleshooting.md#no-equilibrium)",
      initial.max_steps, ratio, initial.limit);
}

}  // namespace

void set_initial_stress(const Model& model, State& state)
{
  using Rows = PointRows<2>;
  const Case& c = model.description;
  if (c.initial.stress != InitialStress::k0) return;
  const Overburden overburden(model);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const MaterialCase& material = c.materials[block.material];
    const Real k0 = std::isnan(material.k0) ? c.initial.k0 : material.k0;
    Real vertical = model.gravity[1] * overburden.mass_above(x), stored = 0.0;
    if (model.water) {
      vertical = -overburden.effective(x, c.water.start);
      stored = material.is_drained() ? 0.0 : overburden.pore_pressure(x, c.water.start);
    }
    block.row(Rows::sigma)[lane] = k0 * vertical - stored;
    block.row(Rows::sigma + 1)[lane] = vertical - stored;
    block.row(Rows::sigma + 2)[lane] = k0 * vertical - stored;
  });
}

Search seek_equilibrium(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop)
{
  const InitialCase& initial = model.description.initial;
  constexpr std::int64_t fewest_steps = 10;  // before the ratio says anything
  work.damping_local = initial.damping;
  work.settling = true;
  const auto goes_on = [&] {
    ++state.equilibrium_steps;
    return state.left.empty() && (state.equilibrium_steps < fewest_steps || work.unbalanced_ratio > initial.limit);
  };
  const StepsMade made = make_steps(model, state, work,
      {.most_steps = initial.max_steps - state.equilibrium_steps,
          .stop = &stop,
          .clock_stands = true,
          .after_step = goes_on});
  if (made.end == LoopEnd::fault) return {.fault = "in the search for equilibrium: " + made.fault};
  if (made.end == LoopEnd::stopped) return {};
  if (made.end == LoopEnd::all_steps) return {.fault = describe_no_equilibrium(initial, work.unbalanced_ratio)};
  if (!state.left.empty()) return {.fault = soil_left};
  if (const Flow flow = find_flow(model, state); flow.n > most_that_flows * static_cast<Real>(state.n_ids()))
    return {.fault = describe_flow(flow, state.n_ids())};
  work.damping_local = model.damping.local;
  work.settling = false;
  reset_history(model.rows, state);
  return {.reached = true};
}

}  // namespace terp
