#include "simulation/mesh_frame.hpp"

#include "simulation/node_motion.hpp"

#include <limits>
#include <utility>

namespace terp {
namespace {

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

MeshFrame make_mesh_frame(const Model& model, const State& state)
{
  NodeMotion motion = map_motion(model, state);
  MeshFrame frame{.time = state.time,
      .step = state.step,
      .mass = std::move(motion.mass),
      .velocity = std::move(motion.velocity),
      .pressure =
          std::vector<Real>(static_cast<std::size_t>(model.mesh->n_cells()), std::numeric_limits<Real>::quiet_NaN())};
  for (const Index cell : state.points.occupied()) {
    PressureSum sum;
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index) { add_pressure(block, sum); });
    if (sum.volume > 0.0) frame.pressure[static_cast<std::size_t>(cell)] = sum.pressure / sum.volume;
  }
  return frame;
}

}  // namespace terp
