// Spreads a quantity of the nodes over a distance l with weights exp(-r^2/l^2): a few explicit steps of diffusion on
// the mesh, decision 0045. Nodes gather from their neighbours in a fixed order, so that the bits are the same on any
// number of threads.
// Not for: what is spread, and how points and nodes exchange it.
#pragma once

#include "mesh/mesh.hpp"

#include <span>

namespace terp {

/// Part of h^2 by which increments are spread without diffusion, as a variance along each direction: 1/3 by the mapping
/// to the nodes and back of points that fill their cells evenly, 1/6 as an increment is the same all over a cell
/// (measured: decision 0045).
inline constexpr Real spread_by_mapping = 0.5;

inline constexpr Index reach_run = 8;

/// What the mesh and the length decide. Entries k of node i: first[i] ... first[i + 1] - 1.
struct NodeDiffusion {
  std::vector<Index> first;            ///< shape [n_nodes + 1]
  std::vector<Index> neighbour;        ///< ascending for each node
  std::vector<Real> coupling;          ///< -sum_e int grad N_i . grad N_j [-]; below 0 along stretched cells
  std::vector<Real> full_volume;       ///< int N_i [m^2], shape [n_nodes]
  std::vector<Real> mapping_variance;  ///< spread_by_mapping h^2, h^2 the mean area of the cells [m^2], shape [n_nodes]
  /// Cells in runs of reach_run, and which runs hold all cells that soil in a run can reach: those of run r are
  /// reached[first_reached[r]] ... reached[first_reached[r + 1] - 1].
  std::vector<Index> first_reached, reached;
  std::vector<Index> run_of_node;  ///< the run of the first cell around it, shape [n_nodes]
  int n_substeps = 0;              ///< of one spreading over the largest length, so that no step overshoots
};

/// 2 tau: variance along each direction that is left to diffusion, [m^2], for weights exp(-r^2/l^2).
inline Real variance_to_spread(Real length_squared, Real mapping_variance)
{
  const Real left = 0.5 * length_squared - mapping_variance;
  return left > 0.0 ? left : 0.0;
}

/// length: the largest of any material [m].
NodeDiffusion make_node_diffusion(const Mesh<2>& mesh, Real length);

/// A quantity of the nodes while it is spread, by node of the mesh. Nodes without soil: volume 0.
struct NodeSpread {
  std::vector<Real> value, next;     ///< per volume
  std::vector<Real> inverse_volume;  ///< 1 / V_i of the soil that takes part [1/m^2]; 0 without
  std::vector<Real> filling;         ///< V_i / int N_i [-]
  std::vector<Real> variance;        ///< variance_to_spread [m^2]
  std::vector<Real> rate;            ///< by entry of NodeDiffusion: what a sub-step takes of the difference [-]

  explicit NodeSpread(const NodeDiffusion& diffusion);
};

/// Rates of node i from filling and variance of it and its neighbours: coupling min(filling_i, filling_j) tau_ij / (n
/// V_i). A neighbour without soil takes nothing, so that a gap is not bridged.
inline void set_rates(const NodeDiffusion& diffusion, Index i, NodeSpread& spread)
{
  const Real factor = 0.25 * spread.inverse_volume[i] / diffusion.n_substeps;  // tau_ij: mean of half the variances
  for (Index k = diffusion.first[i]; k < diffusion.first[i + 1]; ++k) {
    const Index j = diffusion.neighbour[k];
    const Real filling = spread.filling[i] < spread.filling[j] ? spread.filling[i] : spread.filling[j];
    spread.rate[k] = diffusion.coupling[k] * filling * (spread.variance[i] + spread.variance[j]) * factor;
  }
}

/// One sub-step at node i, from value to next.
inline void spread_node(const NodeDiffusion& diffusion, Index i, NodeSpread& spread)
{
  Real change = 0.0;
  for (Index k = diffusion.first[i]; k < diffusion.first[i + 1]; ++k)
    change += spread.rate[k] * (spread.value[diffusion.neighbour[k]] - spread.value[i]);
  spread.next[i] = spread.value[i] + change;
}

}  // namespace terp
