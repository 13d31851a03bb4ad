#include "stability/elastic_start.hpp"

#include "base/errors.hpp"
#include "materials/elastic_constants.hpp"
#include "simulation/initial.hpp"
#include "simulation/ledger.hpp"
#include "simulation/point_parameters.hpp"
#include "simulation/setup.hpp"
#include "simulation/state_image.hpp"
#include "stability/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace terp {
namespace {

bool has_strength(const MaterialType& law)
{
  return std::ranges::any_of(law.parameters, [](const ParameterInfo& p) { return is_strength(p.reduction); });
}

std::vector<Real> elastic_parameters(Moduli m) { return {m.shear, poisson_ratio_of(m)}; }

/// linear_elastic with the moduli of a law, at each place if any of its parameters varies. It lies where the soil lies,
/// and stores the stress that the soil stores.
MaterialCase elastic_twin(const MaterialCase& material, const MaterialType& law)
{
  MaterialCase twin{
      material.name, "linear_elastic", material.density, elastic_parameters(law.make(material.parameters)->moduli())};
  twin.drainage = material.stores_effective() ? Drainage::drained : Drainage::undrained;
  twin.k0 = material.k0;
  twin.soil = material.soil;
  twin.zone = material.zone;
  if (material.fields.empty()) return twin;
  for (std::size_t k = 0; k < twin.parameters.size(); ++k)
    twin.fields.push_back({k, [material, &law, k](const PlaceInSoil& at) {
                             return elastic_parameters(law.make(parameters_at(material, law, at))->moduli())[k];
                           }});
  return twin;
}

/// The rows of both tables. Those of the second that the elastic soil does not look at keep their initial values.
RowTable joined(RowTable table, const RowTable& other)
{
  for (const RowInfo& row : other.added()) table.add(row);
  return table;
}

/// Leaves of the points in an image what a table has: parameters of the elastic soil that vary go.
void drop_rows_but(const RowTable& table, StateImage& image)
{
  const auto is_row = [&](const std::string& name) {
    return std::ranges::any_of(table.entries(), [&](const RowInfo& row) { return "points/" + row.name == name; });
  };
  std::erase_if(image.arrays,
      [&](const NamedArray& array) { return array.name.starts_with("points/parameter_") && !is_row(array.name); });
}

/// The case without a limit to any strength: laws are elastic, contact planes that hold along themselves do not let go.
Case elastic_case(Case c)
{
  for (MaterialCase& material : c.materials) {
    const MaterialType* law = find_material(material.model);
    if (has_strength(*law)) material = elastic_twin(material, *law);
  }
  for (SideCondition& side : c.sides)
    if (side.adhesion > 0.0 || side.friction > 0.0) side.adhesion = std::numeric_limits<Real>::infinity();
  return c;
}

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
  for (const Stiffness& s : list_stiffness(model, all)) {
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

}  // namespace

Case quiet_case(Case c)
{
  if (!c.stages.empty()) c = Case(*c.stages.back().changed);
  c.time.until = Until::end;
  c.footings.clear();
  for (LoadCase& load : c.loads) load = {load.name, load.from, load.to, load.pressure};
  for (SideCondition& side : c.sides) side.velocity = {0.0, 0.0}, side.velocity_at = {};
  for (BodyCase& body : c.bodies) body.velocity = {0.0, 0.0}, body.velocity_at = {};
  c.water.situations.clear();  // the water of the start stays
  if (c.water.start.formula_changes) {
    c.water.start.formula = [at = c.water.start.formula](Vec<2> x, Real) { return at(x, 0.0); };
    c.water.start.formula_changes = false;
  }
  return c;
}

ElasticStart settle_elastically(
    const Case& quiet, const SharedMesh& mesh, Real stiffening, int threads, const std::atomic<bool>& stop)
{
  if (quiet.forces.gravity == Vec<2>{0.0, 0.0})
    throw InputError(Problem{"forces.gravity", "a factor of safety needs gravity",
        "Set gravity = [0.0, -9.81] in [forces].", "forces", true, {"forces"}});
  Model model = build_model(elastic_case(stiffen(quiet, stiffening)), mesh, threads);
  const RowTable of_trials = build_model(quiet, mesh, threads).rows;
  model.rows = joined(model.rows, of_trials);
  State state = build_state(model);
  ElasticStart start;
  start.stiffening = stiffening;
  start.places = state.x_initial;
  set_scales(model, state, start);
  Workspace work(model, state);
  const Search search = seek_equilibrium(model, state, work, stop);
  if (!search.fault.empty()) throw RunError(search.fault);
  if (!search.reached) throw RunError("stopped in the search for the state at rest; nothing was found");
  start.steps = state.equilibrium_steps;
  start.rest = make_image(state);
  drop_rows_but(of_trials, start.rest);
  return start;
}

}  // namespace terp
