// What a cell keeps of the slope of its pressure: scratch of one step.
// Not for: what is done with it (pressure_balance.hpp).
#pragma once

#include "mpm/mesh/element.hpp"

namespace terp {

/// Of one occupied cell in one step.
struct CellBalance {
  using Matrix = std::array<Vec<2>, 2>;  ///< [d][e]: force along d of a G along e
  PerCorner<Quad4, Matrix> moment;       ///< sum over blocks of rho k_i [kg/m per m]
  Vec<2> acceleration;                   ///< a_K [m/s^2]

  /// Of G/rho on corner i [N per m].
  Vec<2> force(int i, Vec<2> g) const
  {
    const Matrix& k = moment[i];
    return {k[0][0] * g[0] + k[0][1] * g[1], k[1][0] * g[0] + k[1][1] * g[1]};
  }
};

}  // namespace terp
