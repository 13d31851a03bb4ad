#include "run/stability/soil_motion.hpp"

#include "math/errors.hpp"
#include "model/ground/ground_section.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace terp {

Judged points_below(const Model& model, const State& state, Real depth)
{
  if (!(depth > 0.0)) return {};
  const Section section = first_section(model, state.points, ground_of(model));
  Judged judged(static_cast<std::size_t>(state.n_ids()), 0);
  Real deepest = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real k = (state.x_initial[2 * id] - section.columns.left) / section.columns.width;
    if (!(k >= 0.0 && k < section.columns.n)) return;
    const Real below = section.heights[static_cast<Index>(k)] - state.x_initial[2 * id + 1];
    deepest = std::max(deepest, below);
    judged[id] = below >= depth;
  });
  if (std::ranges::count(judged, 1) == 0)
    throw InputError(Problem{"", fmt::format("no soil lies {:g} m below the ground, as --least-depth asks", depth),
        fmt::format("The deepest lies {:.3g} m below it. Give a smaller depth.", deepest), "", false});
  return judged;
}

Real displacement_of_the_fastest(const State& state, const Judged& judged)
{
  std::vector<Real> way;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    if (!judged.empty() && judged[id] == 0) return;
    way.push_back(std::hypot(block.row(Rows::x)[lane] - state.x_initial[2 * id],
        block.row(Rows::x + 1)[lane] - state.x_initial[2 * id + 1]));
  });
  const std::size_t n = std::max<std::size_t>(1, way.size() / 100);
  if (way.size() < n) return 0.0;
  std::nth_element(way.begin(), way.end() - static_cast<std::ptrdiff_t>(n), way.end());
  Real sum = 0.0;
  for (auto w = way.end() - static_cast<std::ptrdiff_t>(n); w != way.end(); ++w) sum += *w;
  return sum / static_cast<Real>(n);
}

void OutOfBalance::add_forces(const Model& model, const Workspace& work)
{
  for (const Index i : work.active_nodes) {
    const NodeValues& node = work.node[i];
    for (int d = 0; d < 2; ++d) {
      force_[i][d] += node.mass * node.dv[d] / model.dt;
      weight_ += std::abs(node.mass * model.gravity[d]);
    }
  }
}

Real OutOfBalance::take_share()
{
  Real unbalanced = 0.0;
  for (Vec<2>& f : force_) {
    unbalanced += std::abs(f[0]) + std::abs(f[1]);
    f = {0.0, 0.0};
  }
  const Real weight = std::exchange(weight_, 0.0);
  return weight > 0.0 ? unbalanced / weight : 0.0;
}

}  // namespace terp
