// Each node goes to the best of the places one step away, and its step grows or shrinks with success. First all nodes
// are moved, then those of the worst cells alone. Flat cells have a finite penalty that falls as they open.

#include "model/meshes/improve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace terp {
namespace {

// Measured on 24 meshes of a rectangle, a curved and a refined domain and a dike section: three times as many sweeps of
// either kind enlarge the smallest altitude by at most 2 %.
constexpr int n_sweeps = 60;  // over all nodes
constexpr int n_worst_sweeps =
    240;  // over the nodes of the worst cells: what a wedge lacks comes from far along its sides
constexpr Real worst_share =
    1.2;  // a cell is one of the worst if its altitude over target is at most this times the smallest
constexpr Real longest_step = 0.2, shortest_step = 1e-3;  // of a trial move, over the target size
constexpr int patience = 8;   // sweeps without a move before giving up: from the longest step to the shortest
constexpr Real growth = 1.5;  // of the trial move after a success; halved after a failure
constexpr int n_directions = 8;
constexpr Real floor_altitude = 0.02;  // over the target size: below, the penalty grows on linearly through zero

/// Large for a flat cell: (target / altitude)^16, so that the worst cell around a node decides and the others still
/// count. Power 8 left the smallest altitude about a tenth smaller.
Real penalty(Real altitude, Real target)
{
  const Real part = altitude / target;
  const Real inverse = 1.0 / std::max(part, floor_altitude);
  const Real squared = inverse * inverse, fourth = squared * squared, eighth = fourth * fourth;
  return eighth * eighth * (1.0 + 16.0 * inverse * std::max(0.0, floor_altitude - part));
}

class Improver {
 public:
  Improver(const std::vector<std::array<Index, 4>>& cells, const std::vector<Real>& target, std::vector<Vec<2>>& nodes)
      : cells_(cells), target_(target), nodes_(nodes), cells_of_node_(nodes.size()), size_(nodes.size(), 0.0)
  {
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const Index i : cells[e]) {
        cells_of_node_[i].push_back(static_cast<Index>(e));
        size_[i] = std::max(size_[i], target[e]);
      }
    step_.assign(nodes.size(), longest_step);
  }

  /// To the best of the places one step away, if it is better than where the node is. False: it stays.
  bool move(Index i, const Freedom& freedom)
  {
    const Vec<2> start = nodes_[i];
    Vec<2> best = start;
    Real least = penalty_around(i);
    for (int k = 0; k < (freedom.n == 1 ? 2 : n_directions); ++k) {
      const Vec<2> way =
          freedom.n == 1 ? Vec<2>{(1 - 2 * k) * freedom.along[0], (1 - 2 * k) * freedom.along[1]} : direction(k);
      nodes_[i] = {start[0] + step_[i] * size_[i] * way[0], start[1] + step_[i] * size_[i] * way[1]};
      const Real here = penalty_around(i);
      if (here >= least * (1.0 - 1e-9)) continue;  // 1e-9: a gain above round-off
      least = here;
      best = nodes_[i];
    }
    step_[i] = best == start ? std::max(0.5 * step_[i], shortest_step) : std::min(growth * step_[i], longest_step);
    nodes_[i] = best;
    return best != start;
  }

  /// Nodes of the cells whose altitude over target is near the smallest, ascending.
  std::vector<Index> nodes_of_worst_cells() const
  {
    std::vector<Real> part(cells_.size());
    for (std::size_t e = 0; e < cells_.size(); ++e) part[e] = smallest_altitude(cells_[e], nodes_) / target_[e];
    const Real limit = worst_share * *std::ranges::min_element(part);
    std::vector<Index> list;
    for (std::size_t e = 0; e < cells_.size(); ++e)
      if (part[e] <= limit) list.insert(list.end(), cells_[e].begin(), cells_[e].end());
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

 private:
  static Vec<2> direction(int k)
  {
    const Real angle = 2.0 * std::numbers::pi * k / n_directions;
    return {std::cos(angle), std::sin(angle)};
  }

  Real penalty_around(Index i) const
  {
    Real sum = 0.0;
    for (const Index e : cells_of_node_[i]) sum += penalty(smallest_altitude(cells_[e], nodes_), target_[e]);
    return sum;
  }

  const std::vector<std::array<Index, 4>>& cells_;
  const std::vector<Real>& target_;
  std::vector<Vec<2>>& nodes_;
  std::vector<std::vector<Index>> cells_of_node_;
  std::vector<Real> size_;  ///< largest target of the cells around a node [m], shape [n_nodes]
  std::vector<Real> step_;  ///< length of the next trial move over size_ [-], shape [n_nodes]
};

}  // namespace

Real smallest_altitude(const std::array<Index, 4>& cell, const std::vector<Vec<2>>& nodes)
{
  Real smallest = 1e300;
  for (int side = 0; side < 4; ++side) {
    const Vec<2>&a = nodes[cell[side]], &b = nodes[cell[(side + 1) % 4]], &c = nodes[cell[(side + 2) % 4]],
          &d = nodes[cell[(side + 3) % 4]];
    const Real x = b[0] - a[0], y = b[1] - a[1];
    const Real area = std::min(x * (c[1] - a[1]) - y * (c[0] - a[0]), x * (d[1] - a[1]) - y * (d[0] - a[0]));
    smallest = std::min(smallest, area / std::sqrt(x * x + y * y));
  }
  return smallest;
}

void enlarge_altitudes(const std::vector<std::array<Index, 4>>& cells, const std::vector<Freedom>& freedom,
    const std::vector<Real>& target, std::vector<Vec<2>>& nodes)
{
  Improver improver(cells, target, nodes);
  std::vector<Index> all(nodes.size());
  std::iota(all.begin(), all.end(), 0);
  int idle = 0;
  for (int sweep = 0; sweep < n_sweeps + n_worst_sweeps && idle < patience; ++sweep) {
    ++idle;
    for (const Index i : sweep < n_sweeps ? all : improver.nodes_of_worst_cells())
      if (freedom[i].n > 0 && improver.move(i, freedom[i])) idle = 0;
  }
}

}  // namespace terp
