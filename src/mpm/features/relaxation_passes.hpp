// Points keep velocities that no node sees: within the cells around a node they cancel in its sum. Nothing acts on
// them, so in FLIP they stay for ever. Here they fade with a time constant, and a velocity that is bilinear in the
// cells and continuous between them stays as it is (decision 0048). Corner values F are fitted to the points of each
// cell, nodes take their means U weighted by mass, and points approach sum N_i U_i. Momentum is kept to round-off.
#pragma once

#include "mpm/features/relaxation.hpp"
#include "mpm/kernels/map_to_corners.hpp"
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/step/walks.hpp"

#include <cmath>

namespace terp {

/// Pull of the fit towards the velocity of the nodes, so that corners far from all points of a cell stay near it. Fifty
/// times more takes energy from shear bands (decision 0048).
inline constexpr Real noise_pull = 1e-3;

/// Steps between two fits: four in a time constant.
inline std::int64_t noise_interval(const StepModel& model)
{
  return std::max<std::int64_t>(1, std::llround(0.25 * model.method.relaxation_time / model.dt));
}

/// Sums of m_p N_i, m_p N_i N_j and m_p N_i v_p over the points of a cell.
inline void sum_corner_fit(const PointBlocks<2>& points, Index cell, CornerFit& fit)
{
  constexpr int n = Quad4::n_corners;
  auto mass = zero_packs<n>();
  auto matrix = zero_packs<n_fit_terms>();
  auto momentum = zero_packs<2, n>();
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    for (Index p = 0; p < block.n; p += pack_width) {
      const auto N = mapping_shares<Quad4>(load_rows<2>(block, Rows::xi, p));
      const Pack m = Pack::load(block.row(Rows::mass) + p);
      const auto v = load_rows<2>(block, Rows::v, p);
      for (int i = 0, k = 0; i < n; ++i) {
        const Pack weight = N[i] * m;
        mass[i] += weight;
        for (int j = 0; j <= i; ++j, ++k) matrix[k] = fma(weight, N[j], matrix[k]);
        for (int d = 0; d < 2; ++d) momentum[d][i] = fma(weight, v[d], momentum[d][i]);
      }
    }
  });
  fit = {};
  add_lanes(mass, fit.mass);
  for (int k = 0; k < n_fit_terms; ++k) fit.matrix[k] = sum(matrix[k]);
  for (int d = 0; d < 2; ++d) add_lanes(momentum[d], fit.momentum[d]);
}

/// Replaces the momentum of the corners by m_i F_i, where sum_j (m_p N_i N_j + pull m_i delta_ij) F_j = sum m_p N_i v_p
/// + pull m_i v_i. node: v_i [m/s]. Cholesky; the matrix is positive with any number of points.
inline void solve_corner_fit(const std::array<Vec<2>, Quad4::n_corners>& node, CornerFit& fit)
{
  constexpr int n = Quad4::n_corners;
  Real L[n][n];
  for (int i = 0, k = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j, ++k) {
      L[i][j] = fit.matrix[k] + (i == j ? noise_pull * fit.mass[i] : 0.0);
      for (int l = 0; l < j; ++l) L[i][j] -= L[i][l] * L[j][l];
      L[i][j] = i == j ? std::sqrt(L[i][i]) : L[i][j] / L[j][j];
    }
  for (int d = 0; d < 2; ++d) {
    auto& y = fit.momentum[d];
    for (int i = 0; i < n; ++i) {
      y[i] += noise_pull * fit.mass[i] * node[i][d];
      for (int l = 0; l < i; ++l) y[i] -= L[i][l] * y[l];
      y[i] /= L[i][i];
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int l = i + 1; l < n; ++l) y[i] -= L[l][i] * y[l];
      y[i] /= L[i][i];
    }
    for (int i = 0; i < n; ++i) y[i] *= fit.mass[i];
  }
}

/// Momentum over mass of the corners of the occupied cells around a node, in order of cell number [m/s].
inline Vec<2> mean_of_fits(const StepModel& model, const StepState& state, std::span<const CornerFit> fits, Index node)
{
  Real mass = 0.0;
  Vec<2> momentum{0.0, 0.0};
  for (Index k = model.mesh->first_cell_of_node[node]; k < model.mesh->first_cell_of_node[node + 1]; ++k) {
    const auto [cell, corner] = model.mesh->cells_of_node[k];
    const Index slot = state.points.slot_of_cell()[cell];
    if (slot < 0) continue;
    mass += fits[slot].mass[corner];
    for (int d = 0; d < 2; ++d) momentum[d] += fits[slot].momentum[d][corner];
  }
  return mass > 0.0 ? Vec<2>{momentum[0] / mass, momentum[1] / mass} : Vec<2>{0.0, 0.0};
}

/// v_p += share (sum N_i U_i - v_p). Returns the kinetic energy that the points of the cell gain [J per m].
inline Real relax_points(PointBlocks<2>& points, Index cell, const std::array<Vec<2>, Quad4::n_corners>& U, Real share)
{
  Pack gained(0.0);
  for_each_block(points, cell, [&](PointBlock<2> block, Index) {
    for (Index p = 0; p < block.n; p += pack_width) {
      const auto N = mapping_shares<Quad4>(load_rows<2>(block, Rows::xi, p));
      const Pack m = Pack::load(block.row(Rows::mass) + p);
      const Mask in_use = lane_numbers() < Pack(static_cast<Real>(block.n - p));
      for (int d = 0; d < 2; ++d) {
        Pack seen(0.0);
        for (int i = 0; i < Quad4::n_corners; ++i) seen = fma(N[i], Pack(U[i][d]), seen);
        const Pack v = Pack::load(block.row(Rows::v + d) + p);
        const Pack relaxed = select(in_use, fma(Pack(share), seen - v, v), v);
        gained = fma(Pack(0.5) * m, (relaxed - v) * (relaxed + v), gained);
        relaxed.store(block.row(Rows::v + d) + p);
      }
    }
  });
  return sum(gained);
}

/// What points move against each other unseen by the nodes fades.
inline void relax_velocities(const StepModel& model, StepState& state, Workspace& work)
{
  RelaxationScratch& relaxation = *work.with.relaxation;
  const Real time = static_cast<Real>(noise_interval(model)) * model.dt;
  const Real share = 1.0 - std::exp(-time / model.method.relaxation_time);
  const auto for_each_cell = [&](auto&& f) {
    for_each_slot(state, work, [&](Index slot, Index chunk) { f(slot, state.points.occupied()[slot], chunk); });
  };
  const auto take_means = [&] {
    for_each_node(
        work, [&](Index i, NodeSums&) { relaxation.fitted[i] = mean_of_fits(model, state, relaxation.fits, i); });
  };
  const auto corners_of = [&](Index cell) {
    std::array<Vec<2>, Quad4::n_corners> at;
    for (int i = 0; i < Quad4::n_corners; ++i) at[i] = relaxation.fitted[model.mesh->cells[cell][i]];
    return at;
  };
  for_each_cell([&](Index slot, Index cell, Index) { sum_corner_fit(state.points, cell, relaxation.fits[slot]); });
  take_means();
  for_each_cell([&](Index slot, Index cell, Index) { solve_corner_fit(corners_of(cell), relaxation.fits[slot]); });
  take_means();
  for (CellSums& sums : work.cell_sums) sums.relaxation = 0.0;
  for_each_cell([&](Index, Index cell, Index chunk) {
    work.cell_sums[chunk].relaxation += relax_points(state.points, cell, corners_of(cell), share);
  });
  for (const CellSums& sums : work.cell_sums) state.work.relaxation += sums.relaxation;
}

}  // namespace terp
