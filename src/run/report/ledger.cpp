// All sums over points come from one pass (`add_up`), which computes what the followers asked for as well; so `request`
// comes first. Energies here and those of the pass use the same `BalanceSums` and `ElasticEnergy`, or the balance would
// show the difference.

#include "run/report/ledger.hpp"

#include "mpm/step/kernels.hpp"
#include "mpm/features/rest.hpp"
#include "mpm/step/workspace.hpp"
#include "run/report/mesh_frame.hpp"

#include <algorithm>
#include <limits>

namespace terp {
namespace {

/// What the balance of energy does not explain [J per m].
Real numerical_energy(const LedgerContext& c)
{
  const WorkTotals& w = c.state.work;
  return c.totals.kinetic + c.totals.elastic + c.totals.pore_elastic + c.left_energy + w.plastic + w.slip -
         c.state.start_energy - w.given();
}

/// The same without what is known as a loss. A gain where there may only be losses is not explained.
Real unexplained_energy(const LedgerContext& c)
{
  const WorkTotals& w = c.state.work;
  return numerical_energy(c) - std::min(w.transfer(), 0.0) - std::min(w.reset, 0.0);
}

struct LedgerQuantity {
  QuantityInfo info;
  Real (*read)(const LedgerContext&);
};

using C = const LedgerContext&;

/// Columns of ledger.csv; those of the followers come after them. A new one is one entry here.
constexpr LedgerQuantity balance[] = {
    {{"time", "s", "time", "of the step"}, [](C c) { return c.state.time; }},
    {{"step", "-", "step", "number of the step"}, [](C c) { return static_cast<Real>(c.state.step); }},
    {{"stage", "-", "stage", "number of the stage, from 1; 0: the run has none"},
        [](C c) { return c.model.stage.name.empty() ? 0.0 : static_cast<Real>(c.state.stage + 1); }},
    {{"kinetic", "J/m", "kinetic energy of the points", "kinetic energy of the material points"},
        [](C c) { return c.totals.kinetic; }},
    {{"kinetic_nodal", "J/m", "kinetic energy of the nodes",
         "of the nodes at the start of the last step, 1/2 sum m_i v_i^2: the part that the mesh sees, without the "
         "motion of points against each other within a cell"},
        [](C c) { return c.kinetic_nodal; }},
    {{"elastic", "J/m", "elastic energy", "elastic energy stored in the stress of the soil"},
        [](C c) { return c.totals.elastic; }},
    {{"pore_elastic", "J/m", "elastic energy of the pore water",
         "elastic energy stored in the excess pressure of undrained soil of effective stress"},
        [](C c) { return c.totals.pore_elastic; }},
    {{"plastic", "J/m", "plastic work", "plastic work of the laws so far; it never falls"},
        [](C c) { return c.state.work.plastic; }},
    {{"slip_work", "J/m", "work of slip in cut cells",
         "what soils lost so far that slip along their border in the cells that it cuts"},
        [](C c) { return c.state.work.slip; }},
    {{"gravity_work", "J/m", "work of gravity", "work of gravity so far"}, [](C c) { return c.state.work.gravity; }},
    {{"damping_work", "J/m", "work of damping", "work of damping so far"}, [](C c) { return c.state.work.damping; }},
    {{"boundary_work", "J/m", "work of boundaries", "work of boundaries so far: friction, adhesion, prescribed motion"},
        [](C c) { return c.state.work.boundary; }},
    {{"clamp_work", "J/m", "work of clamps",
         "what points keep of the velocity that sides and footings take from the nodes as they move: its product with "
         "the forces so far"},
        [](C c) { return c.state.work.clamps; }},
    {{"water_work", "J/m", "work of the water",
         "work so far of the water pressure that the case gives, in and around the soil"},
        [](C c) { return c.state.work.outer[outer_water]; }},
    {{"load_work", "J/m", "work of loads", "work of loads and of forces.body so far"},
        [](C c) { return c.state.work.outer[outer_load]; }},
    {{"balance_work", "J/m", "work of the slope of the pressure",
         "work of the slope that the pressure has within cells so far (method.pressure = balanced)"},
        [](C c) { return c.state.work.outer[outer_balance]; }},
    {{"relaxation_work", "J/m", "work of relaxation",
         "kinetic energy so far of velocities that the mesh does not see, as they fade (method.relaxation_time, and "
         "method.flip below 1); a loss"},
        [](C c) { return c.state.work.relaxation; }},
    {{"left_energy", "J/m", "energy of soil that left",
         "kinetic and elastic energy that points took along through open sides so far"},
        [](C c) { return c.left_energy; }},
    {{"numerical", "J/m", "not explained by the balance",
         "what the balance does not explain: (kinetic + elastic + pore_elastic) - (the same at t = 0) + left_energy + "
         "plastic + slip_work - the works above"},
        numerical_energy},
    {{"transfer", "J/m", "stress work lost between nodes and points",
         "part of `numerical`: work of the stress on the strain of the points and slip_work, less the work of the "
         "internal forces on the nodes, so far; above 0 it is energy from nowhere"},
        [](C c) { return c.state.work.transfer(); }},
    {{"pressure_reset", "J/m", "elastic energy lost as pressures are smoothed",
         "part of `numerical`: change of elastic energy so far as each step begins with the smooth pressure of the "
         "cells; above 0 it is energy from nowhere"},
        [](C c) { return c.state.work.reset; }},
    {{"unexplained", "J/m", "energy from nowhere, or lost",
         "`numerical` less what `transfer` and `pressure_reset` lost; what they gained is part of it"},
        unexplained_energy},
    {{"mass", "kg/m", "mass", "of all material points"}, [](C c) { return c.totals.mass; }},
    {{"mass_placed", "kg/m", "mass of bodies placed", "of bodies that stages placed so far"},
        [](C c) { return c.state.mass_placed; }},
    {{"mass_removed", "kg/m", "mass of bodies dug away", "of bodies that stages dug away so far"},
        [](C c) { return c.state.mass_removed; }},
    {{"momentum_x", "kg/s", "momentum, x", "of all material points, per metre"},
        [](C c) { return c.totals.momentum[0]; }},
    {{"momentum_y", "kg/s", "momentum, y", "of all material points, per metre"},
        [](C c) { return c.totals.momentum[1]; }},
    {{"clamped", "-", "points put back at walls", "points so far that ever had to be put back at a wall"},
        [](C c) { return static_cast<Real>(c.state.clamped); }},
    {{"left", "-", "points that left", "points so far that left through open sides"},
        [](C c) { return static_cast<Real>(c.state.left.size()); }},
    {{"v_max", "m/s", "largest speed", "largest speed of a material point"}, [](C c) { return c.totals.v_max; }},
    {{"v_999", "m/s", "speed, 99.9 % quantile", "speed that 99.9 % of the points do not exceed"},
        [](C c) { return c.totals.v_999; }},
};

}  // namespace

Real energy_from_outside(const State& state) { return state.work.from_outside + std::max(state.start_energy, 0.0); }

Real energy_exchanged(const State& state) { return energy_exchanged(state.work) + state.start_energy; }

bool must_remember_strength(const Model& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& m) {
    const bool follows_strain = !has_strength(m) || strain_gives_strength(m);
    return row_of(m, Role::plastic_strain) >= 0 && (!follows_strain || row_of(m, Role::softening) >= 0);
  });
}

StrainMemory remember_strain(const Model& model, const State& state)
{
  const auto n = static_cast<std::size_t>(state.n_ids());
  StrainMemory memory{std::vector<Real>(n, 0.0),
      std::vector<Real>(must_remember_strength(model) ? n : 0, std::numeric_limits<Real>::infinity())};
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const SoilMaterial& material = model.materials[block.material];
    const int strain = row_of(material, Role::plastic_strain);
    if (strain < 0) return;
    memory.last_eps_eq_p[id] = block.row(strain)[lane];
    if (const int driver = row_of(material, Role::softening); driver >= 0)
      memory.last_su[id] = block.row(driver)[lane];
    else if (has_strength(material) && !memory.last_su.empty())
      memory.last_su[id] = strength_of(material, block, lane);
  });
  return memory;
}

std::shared_ptr<const RunTable> ledger_table(const FollowerTypes& followers)
{
  RunTable table{.name = "ledger", .meaning = "balances over time", .columns = {}, .from_start = true};
  for (const LedgerQuantity& quantity : balance) table.columns.push_back(quantity.info);
  for (const FollowerType* type : followers)
    table.columns.insert(table.columns.end(), type->columns.begin(), type->columns.end());
  return std::make_shared<const RunTable>(std::move(table));
}

TableRow keep_ledger(const Model& model, State& state, Workspace& work)
{
  TotalsRequest request;
  for (const ActiveFollower& active : state.followers) active.follower->request(request);
  const Totals totals = kernels().add_up(model, state, work.threads, request);
  const LedgerContext context{.model = model,
      .state = state,
      .request = request,
      .totals = totals,
      .kinetic_nodal = state.step == 0 ? kinetic_energy(map_motion(model, state)) : work.kinetic_nodal,
      .left_energy = energy_of_left(state),
      .fastest_node = fastest_node(work)};
  state.largest_v_999 = std::max(state.largest_v_999, totals.v_999);
  FollowerTypes types;
  for (const ActiveFollower& active : state.followers) types.push_back(active.type);
  TableRow row(ledger_table(types));
  std::span<Real> values = row.values;
  for (std::size_t k = 0; k < std::size(balance); ++k) values[k] = balance[k].read(context);
  values = values.subspan(std::size(balance));
  for (const ActiveFollower& active : state.followers) {
    const std::size_t n = active.type->columns.size();
    active.follower->row(context, values.first(n));
    values = values.subspan(n);
  }
  return row;
}

}  // namespace terp
