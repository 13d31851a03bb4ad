// The search runs on a copy of the model whose stiffness is 1000 times that of the soil, with a time step that fits it.
// Softening per strain stays, at strains 1000 times smaller: nothing softens. With divided strengths the copy is
// elastic. If the soil rests, its stress alone goes back to the state. If not, rows of the copy are made those of the
// case.

#include "run/rest/equilibrium.hpp"

#include "mpm/features/loads.hpp"
#include "mpm/features/search.hpp"
#include "mpm/features/sides.hpp"
#include "mpm/kernels/time_step.hpp"
#include "run/rest/elastic_model.hpp"
#include "run/rest/no_equilibrium.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/parts/reduce.hpp"
#include "run/loop/run.hpp"
#include "run/rest/search_windows.hpp"
#include "run/rest/static_search.hpp"
#include "model/parts/setup.hpp"
#include "run/report/state_image.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// Strains in the search are this many times smaller than in the soil, so that it keeps its shape (decision 0035).
constexpr Real stiffening = 1000.0;

constexpr std::int64_t ramp_windows = 2;  // over which the forces out of balance come on (decision 0050)

constexpr const char* soil_left =
    "in the search for equilibrium soil left through an open side; give that side a `roller`, or start with \"k0\"";

/// Velocity, strain and history to zero; positions stay and become the initial ones.
void reset_history(const RowTable& table, State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int d = 0; d < 2; ++d) {
      block.row(Rows::v + d)[lane] = 0.0;
      state.x_initial[2 * id + d] = block.row(Rows::x + d)[lane];
    }
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::strain + k)[lane] = 0.0;
    for (const RowInfo& row : table.added())
      if (row.averaging != Averaging::keep) block.row(row.first)[lane] = row.initial_in(block.material);
  });
  state.work = {};
  state.clamped = 0;
  std::fill(state.put_back.begin(), state.put_back.end(), false);
}

/// Critical damping of the motion as it is, of which the stiffness is a Rayleigh quotient: c = 2 sqrt(v K v / v M v),
/// smoothed [1/s]. None where more motion meets less force, as in soil that fails.
Real critical_damping(const Model& model, const SearchScratch& search, bool first)
{
  constexpr Real weight = 0.02;  // of the newest value: a mean of 50 steps
  const Real square = search.inertia > 0.0 ? std::max(search.stiffness / search.inertia, 0.0) : 0.0;
  const Real now = std::min(2.0 * std::sqrt(square), 1.0 / model.dt);
  return first ? now : search.viscous + weight * (now - search.viscous);
}

/// A case that is at rest but for its weight, its water and its loads.
Case without_motion(Case c)
{
  for (SideCondition& side : c.sides) side.velocity = {0.0, 0.0}, side.velocity_at = {};
  for (BodyCase& body : c.bodies) body.velocity = {0.0, 0.0}, body.velocity_at = {};
  return c;
}

/// The strains of a case times 1/s, but what softens per strain, and no strength of fast shearing: so nothing softens.
Case case_of_search(const Case& c)
{
  Case still = without_motion(leave_out_rate(stiffen(c, stiffening)));
  for (MaterialCase& material : still.materials)
    if (const MaterialType* law = find_material(material.model))
      change_parameters(material, [law](std::size_t k, Real value) {
        return is_shape_factor(law->parameters[k]) ? value / stiffening : value;
      });
  return still;
}

Model model_of_search(const Model& model)
{
  Case c = case_of_search(model.description);
  Model still = model;
  if (model.description.at_strength != 1.0) {
    still = build_elastic_model(c, model.mesh, model.threads, model.rows);
    still.stage = model.stage;
    still.ramp = model.ramp;
    still.gravity_before = model.gravity_before;
    if (model.with.loads) {
      LoadsModel loads = *still.with.loads;
      for (std::size_t k = 0; k < loads.all.size(); ++k) loads.all[k].before = model.with.loads->all[k].before;
      still.with.loads = std::make_shared<const LoadsModel>(std::move(loads));
    }
    return still;
  }
  for (std::size_t m = 0; m < c.materials.size(); ++m) {
    SoilMaterial& material = still.materials[m];
    material.law =
        material.type->make_varying(c.materials[m].parameters, varying_parameters(c.materials[m], *material.type));
    material.water_stiffness *= stiffening;
  }
  still.with.sides =
      std::make_shared<const SidesModel>(SidesModel{Boundary(*model.mesh, c.sides), model.with.sides->open});
  still.damping.viscous = c.forces.viscous_damping;
  still.dt /= std::sqrt(stiffening);
  still.description = std::move(c);
  still.followers = {};
  still.history_ids.clear();
  return still;
}

/// Stress of all points by id, shape [n_points, n_sym] [Pa].
std::vector<Real> stress_by_id(const State& state)
{
  std::vector<Real> stress(n_sym<2> * static_cast<std::size_t>(state.n_ids()));
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int k = 0; k < n_sym<2>; ++k) stress[n_sym<2> * id + k] = block.row(Rows::sigma + k)[lane];
  });
  return stress;
}

void set_stress(const std::vector<Real>& stress, State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::sigma + k)[lane] = stress[n_sym<2> * id + k];
    for (int d = 0; d < 2; ++d) block.row(Rows::v + d)[lane] = 0.0;
  });
}

/// Displacement and strain as of soil that was not stiffened; the places stay those of the section.
void undo_stiffening(const Model& model, State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int d = 0; d < 2; ++d) {
      Real& from = state.x_initial[2 * id + d];
      from -= (stiffening - 1.0) * (block.row(Rows::x + d)[lane] - from);
    }
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::strain + k)[lane] *= stiffening;
    if (const int row = row_of(model.materials[block.material], Role::plastic_strain); row >= 0)
      block.row(row)[lane] *= stiffening;
  });
}

Search at_rest(const Model& model, State& state, Workspace& work)
{
  work.with.search.clear();
  reset_history(model.rows, state);
  return {.reached = true};
}

}  // namespace

Search settle(const Model& model, State& state, Workspace& work, Real s, const std::atomic<bool>& stop,
    const SearchCallback& report)
{
  state.equilibrium_steps = 0;
  const StaticEnd end = search_statically(model, state, work, stop, report, state.equilibrium_steps);
  if (end == StaticEnd::stopped) return {};
  return end == StaticEnd::rests ? at_rest(model, state, work) : settle_in_motion(model, state, work, s, stop, report);
}

Search settle_in_motion(const Model& model, State& state, Workspace& work, Real s, const std::atomic<bool>& stop,
    const SearchCallback& report)
{
  const InitialCase& initial = model.description.initial;
  SearchWindows windows(model, state, s);
  const std::int64_t ramp = ramp_windows * windows.steps(), first = state.equilibrium_steps;
  SearchScratch& forces = begin_search(initial.damping, work);
  const auto goes_on = [&] {
    const std::int64_t n = ++state.equilibrium_steps - first;
    forces.viscous = critical_damping(model, forces, n <= 2);  // the second step has the first change of force
    forces.share = std::min(1.0, static_cast<Real>(n) / static_cast<Real>(ramp));
    if (n % windows.steps() == 0) windows.enter(state, work.unbalanced_ratio, n > ramp);
    if (report) report({first + n, work.unbalanced_ratio, windows.more_steps(work.unbalanced_ratio, initial.limit)});
    const bool rests = work.unbalanced_ratio <= initial.limit && windows.at_rest();
    return state.left.empty() && !rests && !windows.runs_away();
  };
  const StepsMade made = make_steps(model, state, work,
      {.most_steps = initial.max_steps, .stop = &stop, .clock_stands = true, .after_step = goes_on});
  if (made.end == LoopEnd::fault) return {.fault = "in the search for equilibrium: " + made.fault};
  if (made.end == LoopEnd::stopped) return {};
  if (made.end == LoopEnd::all_steps) return {.fault = describe_no_equilibrium(model, state, work, s)};
  if (!state.left.empty()) return {.fault = soil_left};
  if (windows.runs_away())
    return {.fault = describe_failure(model, state, windows.moved(), s), .slides_as_drawn = true};
  return at_rest(model, state, work);
}

Search find_equilibrium(const Model& model, State& state, const std::atomic<bool>& stop, const SearchCallback& report)
{
  Model still = model_of_search(model);
  State settled = build_state(still);
  Workspace work(still, settled);
  Search search = settle(still, settled, work, stiffening, stop, report);
  if (!search.reached && search.fault.empty()) return search;
  if (search.reached) {
    set_stress(stress_by_id(settled), state);
    state.equilibrium_steps = settled.equilibrium_steps;
    return search;
  }
  undo_stiffening(still, settled);
  settled.followers = std::move(state.followers);  // those of the search, which has none, do not fit
  state = restore(model, image_of_rows(settled, model.rows));
  set_point_parameters(model, seeds_of(make_points(model)), state);
  state.has_no_start = true;
  search.slides_as_drawn = search.slides_as_drawn && model.description.at_strength == 1.0;  // else it was elastic
  return search;
}

}  // namespace terp
