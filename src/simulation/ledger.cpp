#include "simulation/ledger.hpp"

#include "simulation/failure.hpp"
#include "simulation/node_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;

constexpr Real audit_tolerance = 1e-12;  // relative: below is round-off of averaging equal values

/// Energy stored per volume, of one point or of a pack of them.
struct ElasticEnergy {
  Real half_over_bulk, quarter_over_shear;  // [1/Pa]; a fluid stores no shear
  explicit ElasticEnergy(const Material& law) : half_over_bulk(0.5 / law.bulk_modulus()), quarter_over_shear(law.shear_modulus() > 0.0 ? 0.25 / law.shear_modulus() : 0.0) {}

  template <class R>
  R operator()(R xx, R yy, R zz, R xy) const
  {
    const R p = (xx + yy + zz) * R(1.0 / 3.0), a = xx - p, b = yy - p, c = zz - p;
    return R(half_over_bulk) * p * p + R(quarter_over_shear) * (a * a + b * b + c * c + R(2.0) * xy * xy);
  }
};

int find_name(auto infos, std::string_view name)
{
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (infos[k].name == name) return static_cast<int>(k);
  return -1;
}

Real sum_of(Pack a)
{
  Real sum = 0.0;
  for (int k = 0; k < pack_width; ++k) sum += a[k];
  return sum;
}

/// Adds mass, momentum and energies of a block. Lanes that hold no point have no mass and no volume.
void enter_block(const Material& law, const PointBlock<2>& block, LedgerRow& row)
{
  const ElasticEnergy energy(law);
  Pack mass(0.0), kinetic(0.0), elastic(0.0);
  std::array<Pack, 2> momentum{Pack(0.0), Pack(0.0)};
  const auto at = [&](int r, Index p) { return Pack::load(block.row(r) + p); };
  for (Index p = 0; p < block.n; p += pack_width) {
    const Pack m = at(Rows::mass, p), vx = at(Rows::v, p), vy = at(Rows::v + 1, p);
    mass += m;
    momentum[0] += m * vx;
    momentum[1] += m * vy;
    kinetic += m * (vx * vx + vy * vy);
    elastic += at(Rows::volume, p) * energy(at(Rows::sigma, p), at(Rows::sigma + 1, p), at(Rows::sigma + 2, p), at(Rows::sigma + 3, p));
  }
  row.mass += sum_of(mass);
  row.momentum_x += sum_of(momentum[0]);
  row.momentum_y += sum_of(momentum[1]);
  row.kinetic += 0.5 * sum_of(kinetic);
  row.elastic += sum_of(elastic);
}

/// Squares of the speeds of eight points [m^2/s^2]; of lanes that hold no point zero (what stands there is the trace of the last step).
Pack squared_speeds(const PointBlock<2>& block, Index p)
{
  const Pack vx = Pack::load(block.row(Rows::v) + p), vy = Pack::load(block.row(Rows::v + 1) + p);
  return select(lane_numbers() < Pack(static_cast<Real>(block.n - p)), vx * vx + vy * vy, Pack(0.0));
}

/// Largest squared speed of each block, in their order.
std::vector<Real> fastest_of_blocks(const PointBlocks<2>& points)
{
  std::vector<Real> fastest;
  fastest.reserve(static_cast<std::size_t>(points.n_blocks()));
  for_each_block(points, [&](const PointBlock<2>& block) {
    Pack most(0.0);
    for (Index p = 0; p < block.n; p += pack_width) most = max(most, squared_speeds(block, p));
    Real largest = 0.0;
    for (int k = 0; k < pack_width; ++k) largest = std::max(largest, most[k]);
    fastest.push_back(largest);
  });
  return fastest;
}

/// The n-th largest value, n from 1; zero if there are fewer.
Real nth_largest(std::vector<Real> values, std::size_t n)
{
  if (values.size() < n) return 0.0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(n - 1);
  std::nth_element(values.begin(), nth, values.end(), std::greater<>());
  return *nth;
}

/// The n-th largest of all points cannot be below that of the blocks' fastest, so only blocks with a faster point are looked into.
void enter_speeds(const PointBlocks<2>& points, LedgerRow& row)
{
  if (points.n_points() == 0) return;  // all soil has left
  const auto n_others = static_cast<std::size_t>(points.n_points() - 1);
  const std::size_t n = n_others - static_cast<std::size_t>(0.999 * static_cast<double>(n_others)) + 1;
  const std::vector<Real> fastest = fastest_of_blocks(points);
  const Real least = nth_largest(fastest, n);
  std::vector<Real> fast;
  std::size_t b = 0;
  for_each_block(points, [&](const PointBlock<2>& block) {
    if (fastest[b++] < least) return;
    for (Index p = 0; p < block.n; p += pack_width) {
      const Pack squares = squared_speeds(block, p);
      for (int k = 0; k < std::min(pack_width, static_cast<int>(block.n - p)); ++k)
        if (squares[k] >= least) fast.push_back(squares[k]);
    }
  });
  row.v_999 = std::sqrt(nth_largest(fast, n));
  row.v_max = std::sqrt(*std::max_element(fastest.begin(), fastest.end()));
}

/// S_u is a function of eps_eq_p alone: it need not be remembered beside it.
bool strain_tells_strength(const SoilMaterial& material) { return material.n_state() == 1; }

/// Marks the points of a block whose strain fell or whose strength rose, and remembers both. Where the strain tells the strength, a rise
/// is one only if the strain fell: a law that hardens as it strains is no fault.
void audit_block(const SoilMaterial& material, const PointBlock<2>& block, HistoryAudit& audit)
{
  const int k = find_eps_eq_p(*material.type), su_field = find_su(*material.type);
  if (k < 0) return;
  const bool told = strain_tells_strength(material);
  for (Index lane = 0; lane < block.n; ++lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real eps = block.row(Rows::state + k)[lane], before = audit.last_eps_eq_p[id];
    const bool fell = eps < before * (1.0 - audit_tolerance);
    audit.growth[id] = static_cast<float>(eps - before);
    audit.last_eps_eq_p[id] = eps;
    if (fell) audit.fell[id] = true;
    if (su_field < 0 || (told && !fell)) continue;
    const Real su = material.law->derived(su_field, state_of(block, lane, material.n_state()).data());
    const Real su_before = told ? material.law->derived(su_field, &before) : audit.last_su[id];
    if (su > su_before * (1.0 + audit_tolerance)) audit.rose[id] = true;
    if (!audit.last_su.empty()) audit.last_su[id] = su;
  }
}

void audit_history(const Model& model, State& state)
{
  for_each_block(state.points, [&](const PointBlock<2>& block) { audit_block(model.materials[block.material], block, state.audit); });
}

void enter_points(const Model& model, const State& state, LedgerRow& row)
{
  for_each_block(state.points, [&](const PointBlock<2>& block) { enter_block(*model.materials[block.material].law, block, row); });
  enter_speeds(state.points, row);
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
  return volume * ElasticEnergy(law)(sigma[0], sigma[1], sigma[2], sigma[3]);
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
  LedgerRow row;
  for_each_block(state.points, [&](const PointBlock<2>& block) { enter_block(*model.materials[block.material].law, block, row); });
  return row.kinetic + row.elastic + kinetic_and_elastic_energy(state.left);
}

Real energy_exchanged(const State& state)
{
  const WorkTotals& w = state.work;
  return std::abs(w.gravity) + std::abs(w.damping) + std::abs(w.boundary) + w.plastic + state.start_energy;
}

void start_audit(const Model& model, State& state)
{
  const auto n = static_cast<std::size_t>(state.n_ids());
  const bool needs_su = std::any_of(model.materials.begin(), model.materials.end(), [](const SoilMaterial& m) {
    return find_eps_eq_p(*m.type) >= 0 && find_su(*m.type) >= 0 && !strain_tells_strength(m);
  });
  state.audit.last_eps_eq_p.assign(n, 0.0);
  state.audit.last_su.assign(needs_su ? n : 0, std::numeric_limits<Real>::infinity());
  state.audit.growth.assign(n, 0.0f);
  for (auto* flags : {&state.audit.fell, &state.audit.rose}) flags->assign(n, false);
  audit_history(model, state);
  for (auto* flags : {&state.audit.fell, &state.audit.rose}) flags->assign(n, false);  // from nothing to the start is no change
}

LedgerRow keep_ledger(const Model& model, State& state)
{
  LedgerRow row;
  row.time = state.time;
  row.step = state.step;
  enter_points(model, state, row);
  row.kinetic_nodal = kinetic_energy(map_motion(model, state));
  row.plastic = state.work.plastic;
  row.gravity_work = state.work.gravity;
  row.damping_work = state.work.damping;
  row.boundary_work = state.work.boundary;
  row.left_energy = kinetic_and_elastic_energy(state.left);
  row.numerical = row.kinetic + row.elastic + row.left_energy + row.plastic - state.start_energy -
                  (row.gravity_work + row.damping_work + row.boundary_work);
  row.clamped = state.clamped;
  row.left = static_cast<std::int64_t>(state.left.size());
  state.largest_v_999 = std::max(state.largest_v_999, row.v_999);
  audit_history(model, state);
  follow_failure(model, state, row);
  ++state.ledger_rows;
  return row;
}

Real softened_fraction(const Model& model, const State& state)
{
  Real soft = 0.0, all = 0.0;
  constexpr std::array<Real, max_state> fresh{};
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const int field = find_su(*material.type);
    const auto su = [&](const Real* values) { return field < 0 ? 1.0 : material.law->derived(field, values); };
    const Real half = 0.5 * su(fresh.data());
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real volume = block.row(Rows::volume)[lane];
      all += volume;
      if (su(state_of(block, lane, material.n_state()).data()) < half) soft += volume;
    }
  });
  return all > 0.0 ? soft / all : 0.0;
}

}  // namespace terp
