#include "simulation/node_motion.hpp"

#include "transfer/map_to_corners.hpp"

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

}  // namespace terp
