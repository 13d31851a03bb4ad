// Only blocks in which some strain fell, or whose strength does not follow from the strain alone, are looked at point
// by point (audit_points). Lanes that hold no point may hold what the last step left there: each sum and extreme must
// leave them out.

#include "mpm/step/totals.hpp"

#include "mpm/points/moved_search.hpp"
#include "mpm/step/balance_sums.hpp"

#include "mpm/step/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace terp {
namespace {

constexpr Real audit_tolerance = 1e-12;  // relative: below is round-off of averaging equal values

Real largest(Pack a)
{
  Real most = a[0];
  for (int k = 1; k < pack_width; ++k) most = std::max(most, a[k]);
  return most;
}

/// Squares of the speeds of eight points [m^2/s^2]; of lanes that hold no point zero (what stands there is the trace of
/// the last step).
Pack squared_speeds(const PointBlock<2>& block, Index p)
{
  const Pack vx = Pack::load(block.row(Rows::v) + p), vy = Pack::load(block.row(Rows::v + 1) + p);
  return select(lane_numbers() < Pack(static_cast<Real>(block.n - p)), vx * vx + vy * vy, Pack(0.0));
}

/// The n-th largest value, n from 1; zero if there are fewer.
Real nth_largest(std::vector<Real> values, std::size_t n)
{
  if (values.size() < n) return 0.0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(n - 1);
  std::nth_element(values.begin(), nth, values.end(), std::greater<>());
  return *nth;
}

/// The n-th largest of all points cannot be below that of the blocks' fastest, so only what is faster is looked at:
/// nothing in soil that rests or falls as a whole. fastest: largest squared speed by block number.
void enter_speeds(const PointBlocks<2>& points, const std::vector<Real>& fastest, Totals& totals)
{
  if (points.n_points() == 0) return;  // all soil has left
  const auto n_others = static_cast<std::size_t>(points.n_points() - 1);
  const std::size_t n = n_others - static_cast<std::size_t>(0.999 * static_cast<double>(n_others)) + 1;
  const Real least = nth_largest(fastest, n);
  std::vector<Real> fast;
  for (Index b = 0; b < points.n_blocks(); ++b) {
    if (!(fastest[b] > least)) continue;
    const PointBlock<2>& block = points.block(b);
    for (Index p = 0; p < block.n; p += pack_width) {
      const Pack squares = squared_speeds(block, p);
      for (int k = 0; k < std::min(pack_width, static_cast<int>(block.n - p)); ++k)
        if (squares[k] > least) fast.push_back(squares[k]);
    }
  }
  totals.v_max = std::sqrt(*std::ranges::max_element(fastest));
  totals.v_999 = std::sqrt(std::max(least, nth_largest(std::move(fast), n)));
}

struct MaterialRows {
  const SoilMaterial& material;
  ElasticEnergy<Real> energy{material.law->moduli()};
  int strain = row_of(material, Role::plastic_strain);  ///< -1: none
  int driver = row_of(material, Role::softening);       ///< -1: the strength follows the strain itself
  bool has_su = has_strength(material);
  bool by_strain = strain_gives_strength(material);
  bool may_harden = by_strain || material.type->by_library;
  bool is_ground = true;
};

struct ChunkTotals {
  BalanceSums balance;
  MovedSearch moved;
  std::array<Pack, most_slopes> growth{Pack(0.0), Pack(0.0)};
  std::vector<std::size_t> fell, rose;
};

/// Looks at the history of a block point by point. Where the strain tells the strength, and of soil of a library, a
/// rise is one only if the strain fell: a law that hardens as it strains is no fault.
void audit_points(const MaterialRows& rows, const PointBlock<2>& block, StrainMemory& memory, ChunkTotals& chunk)
{
  for (Index lane = 0; lane < block.n; ++lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real eps = block.row(rows.strain)[lane], before = memory.last_eps_eq_p[id];
    const bool fell = eps < before * (1.0 - audit_tolerance);
    if (fell) chunk.fell.push_back(id);
    if (rows.driver >= 0) {
      const Real now = block.row(rows.driver)[lane];
      if (now < memory.last_su[id] * (1.0 - audit_tolerance)) chunk.rose.push_back(id);
      memory.last_su[id] = now;
      continue;
    }
    if (!rows.has_su || (rows.by_strain && !fell)) continue;
    const Real su = strength_of(rows.material, block, lane);
    const Real su_before = rows.by_strain ? strength_at(rows.material, block, lane, before) : memory.last_su[id];
    if (su > su_before * (1.0 + audit_tolerance) && (fell || !rows.may_harden)) chunk.rose.push_back(id);
    if (!memory.last_su.empty()) memory.last_su[id] = su;
  }
}

struct StrainChange {
  Mask changed, fell;
};

/// Sums its growth by the columns of the slopes.
StrainChange enter_strain(const PointBlock<2>& block, Index p, int strain, std::span<const Real> last,
    std::span<const Columns> shear, ChunkTotals& chunk)
{
  const Index n = block.n - p;
  const Mask in_use = lane_numbers() < Pack(static_cast<Real>(n));
  const Pack before = Pack::gather(last.data(), 1, block.row(Rows::id) + p, n), eps = Pack::load(block.row(strain) + p);
  const Pack x = Pack::load(block.row(Rows::x) + p), growth = Pack::load(block.row(Rows::volume) + p) * (eps - before);
  for (std::size_t k = 0; k < shear.size(); ++k) {
    const Mask inside = (x >= Pack(shear[k].left)) & (x < Pack(shear[k].right())) & in_use;
    chunk.growth[k] += select(inside, growth, Pack(0.0));
  }
  const Mask same = (eps >= before) & (eps <= before);
  return {(!same) & in_use, (eps < before * Pack(1.0 - audit_tolerance)) & in_use};
}

/// Enters all points of a block; fastest: largest squared speed [m^2/s^2]. Returns true if eps_eq_p of any changed.
bool enter_block(const MaterialRows& rows, std::span<const Columns> shear, const PointBlock<2>& block,
    StrainMemory* memory, ChunkTotals& chunk, Real& fastest)
{
  Pack most(0.0);
  StrainChange any{lane_numbers() < Pack(0.0), lane_numbers() < Pack(0.0)};
  for (Index p = 0; p < block.n; p += pack_width) {
    chunk.balance.enter(rows.material, rows.energy, block, p);
    if (rows.is_ground) chunk.moved.enter(block, p);
    most = max(most, squared_speeds(block, p));
    if (rows.strain < 0) continue;
    const StrainChange change = enter_strain(block, p, rows.strain, memory->last_eps_eq_p, shear, chunk);
    any = {any.changed | change.changed, any.fell | change.fell};
  }
  fastest = largest(most);
  if (rows.strain >= 0 && (any_of(any.fell) || !rows.by_strain)) audit_points(rows, block, *memory, chunk);
  return any_of(any.changed);
}

void add_chunks(const std::vector<ChunkTotals>& chunks, Totals& totals)
{
  for (const ChunkTotals& chunk : chunks) {
    totals.mass += sum(chunk.balance.mass);
    totals.momentum[0] += sum(chunk.balance.momentum_x);
    totals.momentum[1] += sum(chunk.balance.momentum_y);
    totals.kinetic += 0.5 * sum(chunk.balance.twice_kinetic);
    totals.elastic += sum(chunk.balance.elastic);
    totals.pore_elastic += sum(chunk.balance.pore_elastic);
    totals.moved = join(totals.moved, chunk.moved.found());
    for (int k = 0; k < most_slopes; ++k) totals.growth[k] += sum(chunk.growth[k]);
    totals.fell.insert(totals.fell.end(), chunk.fell.begin(), chunk.fell.end());
    totals.rose.insert(totals.rose.end(), chunk.rose.begin(), chunk.rose.end());
  }
}

}  // namespace

Totals add_up_compiled(const StepModel& model, const StepState& state, Threads& threads, const TotalsRequest& request)
{
  const auto n_blocks = static_cast<std::size_t>(state.points.n_blocks());
  const auto n_cells = static_cast<Index>(state.points.occupied().size());
  std::vector<MaterialRows> rows;
  for (const SoilMaterial& material : model.materials) {
    rows.push_back({material});
    if (request.memory == nullptr) rows.back().strain = -1;
    if (!request.ground.empty()) rows.back().is_ground = request.ground[rows.size() - 1] != 0;
  }
  const ChunkTotals empty{.balance = {}, .moved = {state.x_initial, request.moved_distance}, .fell = {}, .rose = {}};
  std::vector<ChunkTotals> chunks(static_cast<std::size_t>(Threads::n_chunks(n_cells, cells_per_chunk)), empty);
  std::vector<Real> fastest(n_blocks, 0.0);
  Totals totals;
  totals.strained.resize(n_blocks);
  threads.for_each_range(n_cells, cells_per_chunk, [&](Index begin, Index end, Index number, int) {
    ChunkTotals& chunk = chunks[number];
    for (Index slot = begin; slot < end; ++slot)
      for_each_block(state.points, state.points.occupied()[slot], [&](const PointBlock<2>& block, Index b) {
        totals.strained[b] = enter_block(rows[block.material], request.shear, block, request.memory, chunk, fastest[b]);
      });
  });
  add_chunks(chunks, totals);
  enter_speeds(state.points, fastest, totals);
  return totals;
}

}  // namespace terp
