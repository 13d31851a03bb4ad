#include "stability/elastic_start.hpp"

#include "base/errors.hpp"
#include "simulation/initial.hpp"
#include "simulation/ledger.hpp"
#include "simulation/setup.hpp"
#include "simulation/state_image.hpp"
#include "stability/stiffen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

bool has_strength(const MaterialType& law)
{
  return std::ranges::any_of(law.parameters, [](const ParameterInfo& p) { return p.reduction != Reduction::none; });
}

/// linear_elastic with the moduli of a law.
MaterialCase elastic_twin(const MaterialCase& material, const Material& law)
{
  const Real bulk = law.bulk_modulus(), shear = law.shear_modulus();
  return {material.name, "linear_elastic", material.density,
      {shear, (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))}};
}

int most_state(const Case& c)
{
  std::size_t n = 0;
  for (const MaterialCase& material : c.materials) n = std::max(n, find_material(material.model)->state.size());
  return static_cast<int>(n);
}

/// The case without a limit to any strength: laws are elastic, contact planes that hold along themselves do not let go.
Case elastic_case(Case c)
{
  for (MaterialCase& material : c.materials) {
    const MaterialType* law = find_material(material.model);
    if (has_strength(*law)) material = elastic_twin(material, *law->make(material.parameters));
  }
  for (SideCase& side : c.sides)
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
  for (const SoilMaterial& m : model.materials) {
    const Real bulk = m.law->bulk_modulus() / start.stiffening, shear = m.law->shear_modulus() / start.stiffening;
    if (!(shear > 0.0)) continue;
    const Real young = 9.0 * bulk * shear / (3.0 * bulk + shear);
    start.traversal = std::max(start.traversal, start.height / std::sqrt(shear / m.density));
    start.displacement = std::max(start.displacement, m.density * g * start.height * start.height / young);
  }
  const Real window = window_traversals * start.traversal;
  start.free_motion = g * window * window;
}

}  // namespace

Case quiet_case(Case c)
{
  c.footings.clear();
  for (SideCase& side : c.sides) side.velocity = {0.0, 0.0};
  for (BodyCase& body : c.bodies) body.velocity = {0.0, 0.0};
  return c;
}

ElasticStart settle_elastically(
    const Case& quiet, const SharedMesh& mesh, Real stiffening, int threads, const std::atomic<bool>& stop)
{
  if (quiet.forces.gravity == Vec<2>{0.0, 0.0})
    throw InputError(Problem{"forces.gravity", "a factor of safety needs gravity",
        "Set gravity = [0.0, -9.81] in [forces].", "forces", true, {"forces"}});
  Model model = build_model(elastic_case(stiffen(quiet, stiffening)), mesh, threads);
  model.n_state = most_state(quiet);
  State state = build_state(model);
  ElasticStart start;
  start.stiffening = stiffening;
  set_scales(model, state, start);
  start_audit(model, state);
  Workspace work(model, state);
  const Search search = seek_equilibrium(model, state, work, stop);
  if (!search.fault.empty()) throw RunError(search.fault);
  if (!search.reached) throw RunError("stopped in the search for the state at rest; nothing was found");
  start.steps = state.equilibrium_steps;
  start_audit(model, state);
  start.rest = make_image(state);
  return start;
}

}  // namespace terp
