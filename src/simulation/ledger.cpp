#include "simulation/ledger.hpp"

#include <algorithm>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;

constexpr Real audit_tolerance = 1e-12;  // relative: below is round-off of averaging equal values

Real elastic_energy(const Material& law, const PointBlock<2>& block, Index lane)
{
  std::array<Real, 4> sigma;
  for (int k = 0; k < n_sym<2>; ++k) sigma[k] = block.row(Rows::sigma + k)[lane];
  return elastic_energy(law, sigma, block.row(Rows::volume)[lane]);
}

Real speed_squared(const PointBlock<2>& block, Index lane)
{
  const Real vx = block.row(Rows::v)[lane], vy = block.row(Rows::v + 1)[lane];
  return vx * vx + vy * vy;
}

int find_name(auto infos, std::string_view name)
{
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (infos[k].name == name) return static_cast<int>(k);
  return -1;
}

void enter_points(const Model& model, const State& state, LedgerRow& row)
{
  std::vector<Real> speeds;
  speeds.reserve(static_cast<std::size_t>(state.points.n_points()));
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real mass = block.row(Rows::mass)[lane];
    row.mass += mass;
    row.momentum_x += mass * block.row(Rows::v)[lane];
    row.momentum_y += mass * block.row(Rows::v + 1)[lane];
    row.kinetic += 0.5 * mass * speed_squared(block, lane);
    row.elastic += elastic_energy(*model.materials[block.material].law, block, lane);
    speeds.push_back(speed_squared(block, lane));
  });
  if (speeds.empty()) return;  // all soil has left
  const auto quantile = speeds.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), quantile, speeds.end());
  row.v_999 = std::sqrt(*quantile);
  row.v_max = std::sqrt(*std::max_element(quantile, speeds.end()));
}

void audit_point(const SoilMaterial& material, const PointBlock<2>& block, Index lane, HistoryAudit& audit)
{
  const int k = find_eps_eq_p(*material.type), su_field = find_su(*material.type);
  if (k < 0) return;
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  const auto values = state_of(block, lane, material.n_state());
  const Real eps = values[k];
  if (eps < audit.last_eps_eq_p[id] * (1.0 - audit_tolerance)) audit.fell[id] = 1;
  audit.last_eps_eq_p[id] = eps;
  if (su_field < 0) return;
  const Real su = material.law->derived(su_field, values.data());
  if (su > audit.last_su[id] * (1.0 + audit_tolerance)) audit.rose[id] = 1;
  audit.last_su[id] = su;
}

void audit_history(const Model& model, State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    audit_point(model.materials[block.material], block, lane, state.audit);
  });
}

/// Of the points that left, when they did.
Real kinetic_and_elastic_energy(const std::vector<LeftPoint>& points)
{
  Real energy = 0.0;
  for (const LeftPoint& p : points) energy += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]) + p.elastic;
  return energy;
}

}  // namespace

Real elastic_energy(const Material& law, std::array<Real, 4> sigma, Real volume)
{
  const Real p = (sigma[0] + sigma[1] + sigma[2]) / 3.0;
  for (int k = 0; k < 3; ++k) sigma[k] -= p;
  const Real deviatoric = sigma[0] * sigma[0] + sigma[1] * sigma[1] + sigma[2] * sigma[2] + 2.0 * sigma[3] * sigma[3];
  return volume * (0.5 * p * p / law.bulk_modulus() + 0.25 * deviatoric / law.shear_modulus());
}

int find_eps_eq_p(const MaterialType& type) { return find_name(type.state, "eps_eq_p"); }
int find_su(const MaterialType& type) { return find_name(type.derived, "su"); }

std::array<Real, max_state> state_of(const PointBlock<2>& block, Index lane, int n_state)
{
  std::array<Real, max_state> values{};
  for (int k = 0; k < n_state; ++k) values[k] = block.row(Rows::state + k)[lane];
  return values;
}

Real kinetic_and_elastic_energy(const Model& model, const State& state)
{
  Real energy = kinetic_and_elastic_energy(state.left);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    energy += 0.5 * block.row(Rows::mass)[lane] * speed_squared(block, lane);
    energy += elastic_energy(*model.materials[block.material].law, block, lane);
  });
  return energy;
}

void start_audit(const Model& model, State& state)
{
  const auto n = static_cast<std::size_t>(state.n_ids());
  state.audit.last_eps_eq_p.assign(n, 0.0);
  state.audit.last_su.assign(n, std::numeric_limits<Real>::infinity());
  state.audit.fell.assign(n, 0);
  state.audit.rose.assign(n, 0);
  audit_history(model, state);
}

LedgerRow keep_ledger(const Model& model, State& state)
{
  LedgerRow row;
  row.time = state.time;
  row.step = state.step;
  enter_points(model, state, row);
  row.plastic = state.work.plastic;
  row.gravity_work = state.work.gravity;
  row.damping_work = state.work.damping;
  row.boundary_work = state.work.boundary;
  row.left_energy = kinetic_and_elastic_energy(state.left);
  row.numerical = row.kinetic + row.elastic + row.left_energy + row.plastic - state.start_energy -
                  (row.gravity_work + row.damping_work + row.boundary_work);
  row.clamped = state.clamped;
  row.left = static_cast<std::int64_t>(state.left.size());
  row.front_x = front(state.points);
  row.crest_x = find_crest(state.crest, state.points);
  state.crest.time.push_back(row.time);
  state.crest.x.push_back(row.crest_x);
  state.largest_v_999 = std::max(state.largest_v_999, row.v_999);
  audit_history(model, state);
  return row;
}

Real softened_fraction(const Model& model, const State& state)
{
  Real soft = 0.0, all = 0.0;
  constexpr std::array<Real, max_state> fresh{};
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    const Real volume = block.row(Rows::volume)[lane];
    const int su = find_su(*material.type);
    all += volume;
    if (su < 0) return;
    const auto values = state_of(block, lane, material.n_state());
    if (material.law->derived(su, values.data()) < 0.5 * material.law->derived(su, fresh.data())) soft += volume;
  });
  return all > 0.0 ? soft / all : 0.0;
}

}  // namespace terp
