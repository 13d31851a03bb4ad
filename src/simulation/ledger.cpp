#include "simulation/ledger.hpp"

#include "simulation/failure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
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

/// Squares of the speeds of all points [m^2/s^2].
std::vector<Real> squared_speeds(const PointBlocks<2>& points)
{
  std::vector<Real> squares;
  squares.reserve(static_cast<std::size_t>(points.n_points()));
  for_each_block(points, [&](const PointBlock<2>& block) {
    const Real *vx = block.row(Rows::v), *vy = block.row(Rows::v + 1);
    for (Index lane = 0; lane < block.n; ++lane) squares.push_back(vx[lane] * vx[lane] + vy[lane] * vy[lane]);
  });
  return squares;
}

/// Drops most values that are not among the n largest. By the leading bits, in which numbers that are not negative have their order.
void keep_large(std::vector<Real>& values, std::size_t n)
{
  constexpr int shift = 48;  // sign, exponent, four bits of the fraction
  std::vector<std::uint32_t> count(std::size_t{1} << (64 - shift));
  const auto bucket = [](Real v) { return std::bit_cast<std::uint64_t>(v) >> shift; };
  for (const Real v : values) ++count[bucket(v)];
  std::size_t lowest = count.size(), kept = 0;
  while (lowest > 0 && kept < n) kept += count[--lowest];
  std::erase_if(values, [&](Real v) { return bucket(v) < lowest; });
}

void enter_speeds(const PointBlocks<2>& points, LedgerRow& row)
{
  std::vector<Real> squares = squared_speeds(points);
  if (squares.empty()) return;  // all soil has left
  const std::size_t n_above = squares.size() - 1 - static_cast<std::size_t>(0.999 * static_cast<double>(squares.size() - 1));
  keep_large(squares, n_above + 1);
  const auto quantile = squares.end() - 1 - static_cast<std::ptrdiff_t>(n_above);
  std::nth_element(squares.begin(), quantile, squares.end());
  row.v_999 = std::sqrt(*quantile);
  row.v_max = std::sqrt(*std::max_element(quantile, squares.end()));
}

/// Marks the points of a block whose strain fell or whose strength rose.
void audit_block(const SoilMaterial& material, const PointBlock<2>& block, HistoryAudit& audit)
{
  const int k = find_eps_eq_p(*material.type), su_field = find_su(*material.type);
  if (k < 0) return;
  const bool eps_is_all = material.n_state() == 1;  // then the strength cannot change without it
  for (Index lane = 0; lane < block.n; ++lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real eps = block.row(Rows::state + k)[lane], before = audit.last_eps_eq_p[id];
    audit.growth[id] = std::max(0.0, eps - before);
    if (eps == before && eps_is_all && std::isfinite(audit.last_su[id])) continue;
    if (eps < before * (1.0 - audit_tolerance)) audit.fell[id] = 1;
    audit.last_eps_eq_p[id] = eps;
    if (su_field < 0) continue;
    const Real su = material.law->derived(su_field, state_of(block, lane, material.n_state()).data());
    if (su > audit.last_su[id] * (1.0 + audit_tolerance)) audit.rose[id] = 1;
    audit.last_su[id] = su;
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
  state.audit.last_eps_eq_p.assign(n, 0.0);
  state.audit.last_su.assign(n, std::numeric_limits<Real>::infinity());
  state.audit.growth.assign(n, 0.0);
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
  state.largest_v_999 = std::max(state.largest_v_999, row.v_999);
  audit_history(model, state);
  follow_failure(state, row);
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
