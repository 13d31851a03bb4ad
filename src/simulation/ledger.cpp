#include "simulation/ledger.hpp"

#include "simulation/failure.hpp"
#include "simulation/kernels.hpp"
#include "simulation/node_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// What the audit remembers of a point as it is.
void remember(const SoilMaterial& material, const PointBlock<2>& block, Index lane, HistoryAudit& audit)
{
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  const int strain = row_of(material, Role::plastic_strain);
  if (strain < 0) return;
  audit.last_eps_eq_p[id] = block.row(strain)[lane];
  if (has_strength(material) && !audit.last_su.empty()) audit.last_su[id] = strength_of(material, block, lane);
}

/// Takes up what the walk has found of the history.
void audit_history(const Model& model, const Totals& totals, State& state)
{
  for (const std::size_t id : totals.fell) state.audit.fell[id] = true;
  for (const std::size_t id : totals.rose) state.audit.rose[id] = true;
  for (Index b = 0; b < state.points.n_blocks(); ++b) {
    if (!totals.strained[b]) continue;
    const PointBlock<2>& block = state.points.block(b);
    const Real* eps = block.row(row_of(model.materials[block.material], Role::plastic_strain));
    for (Index lane = 0; lane < block.n; ++lane)
      state.audit.last_eps_eq_p[static_cast<std::size_t>(block.row(Rows::id)[lane])] = eps[lane];
  }
}

/// What the balance of energy does not explain [J per m].
Real numerical_energy(const LedgerContext& c)
{
  const WorkTotals& w = c.state.work;
  return c.totals.kinetic + c.totals.elastic + c.left_energy + w.plastic - c.state.start_energy -
         (w.gravity + w.damping + w.boundary);
}

/// Of the points that left, when they did.
Real kinetic_and_elastic_energy(const std::vector<LeftPoint>& points)
{
  Real energy = 0.0;
  for (const LeftPoint& p : points) energy += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]) + p.elastic;
  return energy;
}

struct LedgerQuantity {
  QuantityInfo info;
  Real (*read)(const LedgerContext&);
};

using C = const LedgerContext&;

/// Columns of ledger.csv; those of the failure follow them. A new one is one entry here.
constexpr LedgerQuantity balance[] = {
    {{"time", "s", "time", "of the step"}, [](C c) { return c.state.time; }},
    {{"step", "-", "step", "number of the step"}, [](C c) { return static_cast<Real>(c.state.step); }},
    {{"kinetic", "J/m", "kinetic energy of the points", "kinetic energy of the material points"},
        [](C c) { return c.totals.kinetic; }},
    {{"kinetic_nodal", "J/m", "kinetic energy of the nodes",
         "of the nodes at the start of the last step, 1/2 sum m_i v_i^2: the part that the mesh sees, without the "
         "motion of points against each other within a cell"},
        [](C c) { return c.kinetic_nodal; }},
    {{"elastic", "J/m", "elastic energy", "elastic energy stored"}, [](C c) { return c.totals.elastic; }},
    {{"plastic", "J/m", "plastic work", "plastic work so far"}, [](C c) { return c.state.work.plastic; }},
    {{"gravity_work", "J/m", "work of gravity", "work of gravity so far"}, [](C c) { return c.state.work.gravity; }},
    {{"damping_work", "J/m", "work of damping", "work of damping so far"}, [](C c) { return c.state.work.damping; }},
    {{"boundary_work", "J/m", "work of boundaries", "work of boundaries so far: friction, adhesion, prescribed motion"},
        [](C c) { return c.state.work.boundary; }},
    {{"left_energy", "J/m", "energy of soil that left",
         "kinetic and elastic energy that points took along through open sides so far"},
        [](C c) { return c.left_energy; }},
    {{"numerical", "J/m", "not explained by the balance",
         "what the balance does not explain: (kinetic + elastic) - (the same at t = 0) + left_energy + plastic - the "
         "three works"},
        numerical_energy},
    {{"mass", "kg/m", "mass", "of all material points"}, [](C c) { return c.totals.mass; }},
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

Real elastic_energy(Moduli moduli, std::array<Real, 4> sigma, Real volume)
{
  return volume * ElasticEnergy<Real>(moduli)(sigma[0], sigma[1], sigma[2], sigma[3]);
}

Real kinetic_and_elastic_energy(const Model& model, const State& state)
{
  Books books;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const ElasticEnergy<Real> energy(material.law->moduli());
    for (Index p = 0; p < block.n; p += pack_width) books.enter(material, energy, block, p);
  });
  return 0.5 * sum(books.twice_kinetic) + sum(books.elastic) + kinetic_and_elastic_energy(state.left);
}

Real energy_exchanged(const State& state) { return energy_exchanged(state.work) + state.start_energy; }

void start_audit(const Model& model, State& state)
{
  const auto n = static_cast<std::size_t>(state.n_ids());
  const bool needs_su = std::any_of(model.materials.begin(), model.materials.end(), [](const SoilMaterial& m) {
    return row_of(m, Role::plastic_strain) >= 0 && has_strength(m) && !strain_gives_strength(m);
  });
  state.audit.last_eps_eq_p.assign(n, 0.0);
  state.audit.last_su.assign(needs_su ? n : 0, std::numeric_limits<Real>::infinity());
  for (auto* flags : {&state.audit.fell, &state.audit.rose}) flags->assign(n, false);
  remember_history(model, state);
}

void remember_history(const Model& model, State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    remember(model.materials[block.material], block, lane, state.audit);
  });
}

const std::shared_ptr<const RunTable>& ledger_table()
{
  static const auto table = [] {
    RunTable t{.name = "ledger", .meaning = "balances over time", .columns = {}, .from_start = true};
    for (const LedgerQuantity& quantity : balance) t.columns.push_back(quantity.info);
    t.columns.insert(t.columns.end(), failure_columns.begin(), failure_columns.end());
    return std::make_shared<const RunTable>(std::move(t));
  }();
  return table;
}

TableRow keep_ledger(const Model& model, State& state, Workspace& work)
{
  const Totals totals =
      kernels().add_up(model, state, work.threads, moved_distance(state.section), shear_columns(state));
  const LedgerContext context{.model = model,
      .state = state,
      .totals = totals,
      .kinetic_nodal = state.step == 0 ? kinetic_energy(map_motion(model, state)) : work.kinetic_nodal,
      .left_energy = kinetic_and_elastic_energy(state.left)};
  TableRow row(ledger_table());
  for (std::size_t k = 0; k < std::size(balance); ++k) row.values[k] = balance[k].read(context);
  state.largest_v_999 = std::max(state.largest_v_999, totals.v_999);
  follow_failure(context, state, std::span(row.values).subspan(std::size(balance)));
  audit_history(model, totals, state);
  return row;
}

Real softened_fraction(const Model& model, const State& state)
{
  Real soft = 0.0, all = 0.0;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const bool softens = has_strength(material);
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real volume = block.row(Rows::volume)[lane];
      all += volume;
      if (softens && strength_of(material, block, lane) < 0.5 * strength_at(material, block, lane, 0.0)) soft += volume;
    }
  });
  return all > 0.0 ? soft / all : 0.0;
}

}  // namespace terp
