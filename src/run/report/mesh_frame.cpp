// The array of velocities holds momentum while the cells are summed, and is divided by the mass at the end. Shape
// functions and sums are those of mpm/kernels/map_to_corners. The pressure of a cell is weighted by the volume of its
// points, so that small points do not count like large ones.

#include "run/report/mesh_frame.hpp"

#include "mpm/kernels/map_to_corners.hpp"

#include <limits>

namespace terp {
namespace {

/// Adds what a cell's points give to its corners: m_i, and (m v)_i in place of the velocity.
void add_corners(const std::array<Index, 4>& nodes, const CornerSums<Quad4>& corners, NodeMotion& motion)
{
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(nodes[i]);
    motion.mass[node] += corners.mass[i];
    for (std::size_t d = 0; d < 2; ++d) motion.velocity[2 * node + d] += corners.momentum[d][i];
  }
}

struct PressureSum {
  Real volume = 0.0;    ///< sum of Omega_p [m^2]
  Real pressure = 0.0;  ///< sum of tr(sigma)/3 Omega_p [Pa m^2]
};

void add_pressure(const PointBlock<2>& block, PressureSum& sum)
{
  for (Index lane = 0; lane < block.n; ++lane) {
    const Real trace =
        block.row(Rows::sigma)[lane] + block.row(Rows::sigma + 1)[lane] + block.row(Rows::sigma + 2)[lane];
    const Real volume = block.row(Rows::volume)[lane];
    sum.volume += volume;
    sum.pressure += trace / 3.0 * volume;
  }
}

}  // namespace

NodeMotion map_motion(const Model& model, const State& state)
{
  const auto n_nodes = static_cast<std::size_t>(model.mesh->n_nodes());
  NodeMotion motion{.mass = std::vector<Real>(n_nodes), .velocity = std::vector<Real>(2 * n_nodes)};
  for (const Index cell : state.points.occupied()) {
    CornerSums<Quad4> corners{};
    for_each_block(
        state.points, cell, [&](const PointBlock<2>& block, Index) { map_mass_and_momentum(block, corners); });
    add_corners(model.mesh->cells[static_cast<std::size_t>(cell)], corners, motion);
  }
  for (std::size_t i = 0; i < n_nodes; ++i)
    for (std::size_t d = 0; d < 2; ++d) motion.velocity[2 * i + d] /= motion.mass[i] > 0.0 ? motion.mass[i] : 1.0;
  return motion;
}

Real kinetic_energy(const NodeMotion& motion)
{
  Real sum = 0.0;
  for (std::size_t i = 0; i < motion.mass.size(); ++i) {
    const Real vx = motion.velocity[2 * i], vy = motion.velocity[2 * i + 1];
    sum += 0.5 * motion.mass[i] * (vx * vx + vy * vy);
  }
  return sum;
}

MeshFrame make_mesh_frame(const Model& model, const State& state)
{
  MeshFrame frame{map_motion(model, state), state.time, state.step,
      std::vector<Real>(static_cast<std::size_t>(model.mesh->n_cells()), std::numeric_limits<Real>::quiet_NaN())};
  for (const Index cell : state.points.occupied()) {
    PressureSum sum;
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index) { add_pressure(block, sum); });
    if (sum.volume > 0.0) frame.pressure[static_cast<std::size_t>(cell)] = sum.pressure / sum.volume;
  }
  return frame;
}

}  // namespace terp
