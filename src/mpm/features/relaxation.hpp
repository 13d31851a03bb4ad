// Velocities that the mesh does not see and that fade, in a step. Not for: how they fade (relaxation_passes.hpp).
#pragma once

#include "mpm/kernels/cell_sums.hpp"

#include <vector>

namespace terp {

inline constexpr int n_fit_terms = Quad4::n_corners * (Quad4::n_corners + 1) / 2;

/// Of the points of one cell, at its corners.
struct CornerFit {
  PerCorner<Quad4> mass;                 ///< sum m_p N_i [kg per m]
  std::array<Real, n_fit_terms> matrix;  ///< sum m_p N_i N_j, the lower half by rows [kg per m]
  CornerVectors<Quad4> momentum;         ///< sum m_p N_i v_p, then mass times the fitted velocity [kg/s]
};

struct RelaxationScratch {
  std::vector<CornerFit> fits;  ///< shape [n_occupied]
  std::vector<Vec<2>> fitted;   ///< U_i [m/s], shape [n_nodes]
};

}  // namespace terp
