#include "simulation/initial.hpp"

#include "simulation/nodal_water.hpp"
#include "simulation/no_equilibrium.hpp"
#include "simulation/overburden.hpp"
#include "simulation/run.hpp"
#include "water/water_pressure.hpp"

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

constexpr Real most_that_flows = 0.01;  // of the points: some trickle down the face of soil that stands

constexpr const char* soil_left =
    "in the search for equilibrium soil left through an open side; give that side a `roller`, or start with \"k0\"";

}  // namespace

void set_initial_stress(const Model& model, State& state)
{
  using Rows = PointRows<2>;
  const Case& c = model.description;
  const bool first_guess = c.initial.stress == InitialStress::equilibrium && model.water;
  if (c.initial.stress != InitialStress::k0 && !first_guess) return;
  const Overburden overburden(model, -model.gravity_at(0.0)[1]);
  if (first_guess && !overburden.is_known()) return;
  const WaterWay way = water_way(model, 0.0, model.ramp.share_at(0.0));
  const WaterSituation& water = situation_of(c.water, way.share > 0.0 ? way.to : way.from);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const MaterialCase& material = c.materials[block.material];
    const Real k0 = std::isnan(material.k0) ? c.initial.k0 : material.k0;
    const Real vertical = -overburden.effective(x, water),
               stored = material.stores_effective() ? 0.0 : overburden.pore_pressure(x, water);
    block.row(Rows::sigma)[lane] = k0 * vertical - stored;
    block.row(Rows::sigma + 1)[lane] = vertical - stored;
    block.row(Rows::sigma + 2)[lane] = k0 * vertical - stored;
  });
}

Search seek_equilibrium(
    const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop, const std::function<void()>& told)
{
  const InitialCase& initial = model.description.initial;
  constexpr std::int64_t fewest_steps = 10;  // before the ratio says anything
  work.damping_local = initial.damping;
  work.settling = true;
  const auto goes_on = [&] {
    ++state.equilibrium_steps;
    if (told) told();
    return state.left.empty() && (state.equilibrium_steps < fewest_steps || work.unbalanced_ratio > initial.limit);
  };
  const StepsMade made = make_steps(model, state, work,
      {.most_steps = initial.max_steps - state.equilibrium_steps,
          .stop = &stop,
          .clock_stands = true,
          .after_step = goes_on});
  if (made.end == LoopEnd::fault) return {.fault = "in the search for equilibrium: " + made.fault};
  if (made.end == LoopEnd::stopped) return {};
  if (made.end == LoopEnd::all_steps) return {.fault = describe_no_equilibrium(model, state, work)};
  if (!state.left.empty()) return {.fault = soil_left};
  if (const Flow flow = find_flow(model, state); flow.n > most_that_flows * static_cast<Real>(state.n_ids()))
    return {.fault = describe_flow(model, state, flow)};
  work.damping_local = model.damping.local;
  work.settling = false;
  reset_history(model.rows, state);
  return {.reached = true};
}

}  // namespace terp
