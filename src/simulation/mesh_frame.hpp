// What the background mesh carries at one time: mass and velocity of the nodes, pressure of the cells.
// Not for: a step, which has its own nodal values (workspace).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace terp {

struct MeshFrame {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  std::vector<Real> mass;  ///< m_i = sum_p N_i m_p [kg per m], shape [n_nodes]
  std::vector<Real>
      velocity;  ///< sum_p N_i m_p v_p / m_i, before boundary conditions [m/s], shape [n_nodes, 2]; 0 where m_i = 0
  std::vector<Real> pressure;  ///< mean of tr(sigma)/3 over the points, by volume, tension positive [Pa], shape
                               ///< [n_cells]; NaN without soil
};

/// Of the points as they are now, with the shape functions of the method.
MeshFrame make_mesh_frame(const Model& model, const State& state);

}  // namespace terp
