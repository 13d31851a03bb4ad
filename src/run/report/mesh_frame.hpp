// What the background mesh carries at one time: mass and velocity of the nodes, from the points as they are now, the
// kinetic energy of the motion that the mesh can see, and the pressure of the cells. Not for: a step, which has its own
// nodal values (workspace).
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

namespace terp {

struct NodeMotion {
  std::vector<Real> mass;      ///< m_i = sum_p N_i m_p [kg per m], shape [n_nodes]
  std::vector<Real> velocity;  ///< v_i = sum_p N_i m_p v_p / m_i, before boundary conditions [m/s], shape [n_nodes, 2];
                               ///< 0 where m_i = 0
};

/// Cells in order, one after the other: the same bits on any number of threads.
NodeMotion map_motion(const Model& model, const State& state);

/// 1/2 sum m_i |v_i|^2 [J per m]: at most that of the points. What points move against each other within a cell, which
/// in pure FLIP no force ever sees, is not in it.
Real kinetic_energy(const NodeMotion& motion);

struct MeshFrame : NodeMotion {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  std::vector<Real> pressure;  ///< mean of tr(sigma)/3 over the points, by volume, tension positive [Pa], shape
                               ///< [n_cells]; NaN without soil
};

MeshFrame make_mesh_frame(const Model& model, const State& state);

}  // namespace terp
