// Material points to Gauss points: means over sub-cells, integration weights and the cell's pressure, Eqs. (1) to (3).
#pragma once

#include "mesh/cell_geometry.hpp"
#include "transfer/cell_sums.hpp"
#include "transfer/method_options.hpp"

namespace terp {

/// Sums over each sub-cell of one block: Omega_p -> gauss.volume, sigma_p Omega_p -> gauss.sigma, and, for the first n_state
/// state variables, alpha_p Omega_p -> gauss.state. The numerators and denominator of Eq. (1).
void sum_over_sub_cells(const PointBlock<2>& block, int n_state, GaussValues<2>& gauss);

/// Integration weights of one block (reading R3): w_g detJ in a filled cell, shared between blocks by volume; the points'
/// own volume otherwise. cell_volume: sum over all blocks of the cell, shape [g].
void set_weights(const CellGeometry<2>& cell, const std::array<Real, 4>& cell_volume, const MethodOptions& method,
                 GaussValues<2>& gauss);

/// Turns the sums into means, Eq. (1). An empty sub-cell takes the block's mean (reading R8).
void divide_by_volume(int n_state, GaussValues<2>& gauss);

/// p_e by Eq. (2) and sigma_hat by Eq. (3). Returns true if p_e was cut to the tension limit.
bool smooth_pressure(bool part_filled, const MethodOptions& method, GaussValues<2>& gauss);

/// Replaces state variable k at all Gauss points by its mean over the cell with the weights of Eq. (2).
void average_state_over_cell(int k, GaussValues<2>& gauss);

/// How far a cell counts as filled: 0 part-filled, 1 filled, between only with a blend.
Real filled_share(const CellGeometry<2>& cell, Real volume, const MethodOptions& method);

}  // namespace terp
