// The ring of filled cells beside part-filled ones is left out too, as its nodes move with the soil that ravels. In
// thin soil nothing may be left; then all of it counts, or a trial would see no motion and call any factor stable.

#include "stability/judged_soil.hpp"

#include "transfer/gauss_average.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terp {
namespace {

bool is_filled(const Model& model, const State& state, Index cell)
{
  Real volume = 0.0;
  for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index) {
    for (Index lane = 0; lane < block.n; ++lane) volume += block.row(Rows::volume)[lane];
  });
  return filled_share(model.mesh->geometry(cell), volume, model.method) >= 1.0;
}

std::size_t id_of(const PointBlock<2>& block, Index lane)
{
  return static_cast<std::size_t>(block.row(Rows::id)[lane]);
}

}  // namespace

JudgedSoil::JudgedSoil(const Model& model, const State& state)
    : point_(static_cast<std::size_t>(state.n_ids()), true),
      node_(model.mesh->nodes.size(), true),
      force_(model.mesh->nodes.size(), Vec<2>{0.0, 0.0})
{
  for (const Index cell : state.points.occupied())
    if (!is_filled(model, state, cell))
      for (const Index node : model.mesh->cells[cell]) node_[node] = false;
  bool any = false;
  for (const Index cell : state.points.occupied()) {
    const bool counts = std::ranges::all_of(model.mesh->cells[cell], [&](Index node) { return node_[node]; });
    any |= counts;
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index) {
      for (Index lane = 0; lane < block.n; ++lane) point_[id_of(block, lane)] = counts;
    });
  }
  if (any) return;
  point_.assign(point_.size(), true);
  node_.assign(node_.size(), true);
}

Real JudgedSoil::largest_displacement(const State& state) const
{
  std::vector<Real> way;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const std::size_t id = id_of(block, lane);
    if (!point_[id]) return;
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

void JudgedSoil::add_forces(const Model& model, const Workspace& work)
{
  for (const Index i : work.active_nodes) {
    if (!node_[i]) continue;
    const NodeValues& node = work.node[i];
    for (int d = 0; d < 2; ++d) {
      force_[i][d] += node.mass * node.dv[d] / model.dt;
      weight_ += std::abs(node.mass * model.gravity[d]);
    }
  }
}

Real JudgedSoil::take_out_of_balance()
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
