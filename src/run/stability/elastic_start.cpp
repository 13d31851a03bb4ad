// Scales (traversal, displacement, free motion) are those of the soil as it is, so they are divided by the stiffening.
// quiet_case takes out all that would move the soil but weight, water and loads: a new kind of motion must go there,
// too.

#include "run/stability/elastic_start.hpp"

#include "math/errors.hpp"
#include "mpm/mesh/locate.hpp"
#include "mpm/step/workspace.hpp"
#include "run/rest/elastic_model.hpp"
#include "run/rest/equilibrium.hpp"
#include "model/ground/ground_section.hpp"
#include "model/soils/settle_fields.hpp"
#include "model/parts/reduce.hpp"
#include "model/parts/setup.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "run/loop/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace terp {
namespace {

/// Extent of the points along a direction [m].
Real extent_along(const State& state, Vec<2> e)
{
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  for (std::size_t k = 0; k + 1 < state.x_initial.size(); k += 2) {
    const Real s = state.x_initial[k] * e[0] + state.x_initial[k + 1] * e[1];
    low = std::min(low, s);
    high = std::max(high, s);
  }
  return high - low;
}

/// Scales of the softest material with stiffness in shear, as it is before it was stiffened.
void set_scales(const Model& model, const State& state, ElasticStart& start)
{
  const Real g = std::hypot(model.gravity[0], model.gravity[1]);
  start.height = extent_along(state, model.damping.down);
  std::vector<Index> all(model.materials.size());
  std::iota(all.begin(), all.end(), 0);
  for (const Stiffness& s : list_stiffness(model, all, fields_of_points(model))) {
    const Real density = model.materials[s.material].density;
    const Real bulk = s.moduli.bulk / start.stiffening, shear = s.moduli.shear / start.stiffening;
    if (!(shear > 0.0)) continue;
    const Real young = 9.0 * bulk * shear / (3.0 * bulk + shear);
    start.traversal = std::max(start.traversal, start.height / std::sqrt(shear / density));
    start.displacement = std::max(start.displacement, density * g * start.height * start.height / young);
  }
  const Real window = window_traversals * start.traversal;
  start.free_motion = g * window * window;
}

/// Of an odd number of points along a side the middle ones lie on the border of two sub-cells. Vibrations of stiffened
/// soil take them across and back, and level ground never came to rest. With 1e-6 of half a cell some still do; with
/// 1e-4 they change side in the trials, and soil near its limit creeps.
void leave_borders_of_sub_cells(const Mesh<2>& mesh, PointBlocks<2>& points)
{
  constexpr Real on_border = 1e-9, beside = 1e-5;  // in local coordinates, which run from -1 to 1
  for_each_block(points, [&](const PointBlock<2>& block) {
    for (Index lane = 0; lane < block.n; ++lane) {
      Vec<2> local{block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]};
      bool leaves = false;
      for (Real& at : local)
        if (std::abs(at) < on_border) at = beside, leaves = true;
      if (!leaves) continue;
      const Vec<2> x = place_in_cell(mesh, block.cell, local);
      for (int d = 0; d < 2; ++d) block.row(Rows::xi + d)[lane] = local[d], block.row(Rows::x + d)[lane] = x[d];
    }
  });
}

/// A formula of the time stays as it is at t = 0.
void stop_formula(WaterSituation& situation)
{
  if (!situation.formula_changes) return;
  situation.formula = [at = situation.formula](Vec<2> x, Real) { return at(x, 0.0); };
  situation.formula_changes = false;
}

}  // namespace

Case quiet_case(Case c)
{
  if (!c.ground_of) c.ground_of = std::make_shared<const Case>(c);
  const auto ground_of = c.ground_of;
  while (!c.stages.empty() && c.stages.back().trigger) c.stages.pop_back();  // of the section as it is
  const std::size_t standing = c.stages.empty() ? 0 : water_of_stage(c, c.stages.size() - 1).to;
  if (!c.stages.empty()) c = Case(*c.stages.back().changed);
  c = leave_out_rate(reduce_strength(std::move(c), c.at_strength));
  c.at_strength = 1.0;
  c.ground_of = ground_of;
  c.time.until = Until::end;
  if (c.method.shares == Shares::by_law) c.method.shares = Shares::point;  // no point comes to another sub-cell
  c.footings.clear();
  c.output.field_names.clear();
  for (LoadCase& load : c.loads) load = {load.name, load.from, load.to, load.pressure};
  for (SideCondition& side : c.sides) side.velocity = {0.0, 0.0}, side.velocity_at = {};
  for (BodyCase& body : c.bodies) body.velocity = {0.0, 0.0}, body.velocity_at = {};
  c.water.standing = standing;
  stop_formula(c.water.start);
  for (WaterSituation& situation : c.water.situations) stop_formula(situation);
  return c;
}

ElasticStart settle_elastically(
    const Case& quiet, const SharedMesh& mesh, Real stiffening, int threads, const std::atomic<bool>& stop)
{
  if (quiet.forces.gravity == Vec<2>{0.0, 0.0})
    throw InputError(Problem{"forces.gravity", "a factor of safety needs gravity",
        "Set gravity = [0.0, -9.81] in [forces].", "forces", true, {"forces"}});
  const RowTable of_trials = build_model(quiet, mesh, threads).rows;
  Model model = build_elastic_model(stiffen(quiet, stiffening), mesh, threads, of_trials);
  State state = build_state(model);
  ElasticStart start;
  start.stiffening = stiffening;
  start.seeds = seeds_of(make_points(model));
  leave_borders_of_sub_cells(*model.mesh, state.points);
  set_scales(model, state, start);
  start.cell = typical_cell_size(*model.mesh);
  const Section section = first_section(model, state.points, ground_of(model));
  start.relief = is_flat(section) ? start.height : relief(section);
  Workspace work(model, state);
  const Search search = settle(model, state, work, stiffening, stop);
  if (!search.fault.empty()) throw RunError(search.fault);
  if (!search.reached) throw RunError("stopped in the search for the state at rest; nothing was found");
  start.steps = state.equilibrium_steps;
  start.rest = image_of_rows(state, of_trials);
  return start;
}

}  // namespace terp
