#include "simulation/mesh_frame.hpp"

#include "transfer/map_to_corners.hpp"

#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// Adds what a cell's points give to its corners: m_i, and (m v)_i in place of the velocity.
void add_corners(const std::array<Index, 4>& nodes, const CornerSums<2>& corners, MeshFrame& frame)
{
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(nodes[i]);
    frame.mass[node] += corners.mass[i];
    for (std::size_t d = 0; d < 2; ++d) frame.velocity[2 * node + d] += corners.momentum[d][i];
  }
}

struct PressureSum {
  Real volume = 0.0;    ///< sum of Omega_p [m^2]
  Real pressure = 0.0;  ///< sum of tr(sigma)/3 Omega_p [Pa m^2]
};

void add_pressure(const PointBlock<2>& block, PressureSum& sum)
{
  for (Index lane = 0; lane < block.n; ++lane) {
    const Real trace = block.row(Rows::sigma)[lane] + block.row(Rows::sigma + 1)[lane] + block.row(Rows::sigma + 2)[lane];
    const Real volume = block.row(Rows::volume)[lane];
    sum.volume += volume;
    sum.pressure += trace / 3.0 * volume;
  }
}

}  // namespace

MeshFrame make_mesh_frame(const Model& model, const State& state)
{
  const auto n_nodes = static_cast<std::size_t>(model.mesh.n_nodes()), n_cells = static_cast<std::size_t>(model.mesh.n_cells());
  MeshFrame frame{.time = state.time, .step = state.step, .mass = std::vector<Real>(n_nodes), .velocity = std::vector<Real>(2 * n_nodes),
                  .pressure = std::vector<Real>(n_cells, std::numeric_limits<Real>::quiet_NaN())};
  for (const Index cell : state.points.occupied()) {
    CornerSums<2> corners{};
    PressureSum sum;
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index) {
      map_mass_and_momentum(block, corners);
      add_pressure(block, sum);
    });
    add_corners(model.mesh.cells[static_cast<std::size_t>(cell)], corners, frame);
    if (sum.volume > 0.0) frame.pressure[static_cast<std::size_t>(cell)] = sum.pressure / sum.volume;
  }
  for (std::size_t i = 0; i < n_nodes; ++i)
    for (std::size_t d = 0; d < 2; ++d) frame.velocity[2 * i + d] /= frame.mass[i] > 0.0 ? frame.mass[i] : 1.0;
  return frame;
}

}  // namespace terp
