// Spreads a quantity of the nodes over a distance l with weights exp(-r^2/l^2): a few explicit steps of diffusion on
// the mesh, decision 0045. Nodes gather from their neighbours in a fixed order, so that the bits are the same on any
// number of threads.
// Not for: what is spread, and how points and nodes exchange it.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "math/tables.hpp"

namespace terp {

/// Part of h^2 by which increments are spread without diffusion, as a variance along each direction: 1/3 by the mapping
/// to the nodes and back of points that fill their cells evenly, 1/6 as an increment is the same all over a cell
/// (measured: decision 0045).
inline constexpr Real spread_by_mapping = 0.5;

/// A number of each node. Eight at a time, they begin at any node, and may end beyond the first and the last.
class NodeNumbers {
 public:
  explicit NodeNumbers(Index n_nodes = 0) : packs_(static_cast<std::size_t>(n_nodes) / pack_width + 3, Pack(0.0)) {}

  Real& operator[](Index i) { return numbers_of(packs_[0])[pack_width + i]; }
  Real operator[](Index i) const { return numbers_of(packs_[0])[pack_width + i]; }
  /// Of the nodes i ... i + 7, i above -pack_width.
  Pack eight_from(Index i) const { return load_some(numbers_of(packs_[0]) + pack_width + i, pack_width); }
  /// Of the nodes of a group.
  Pack& of_group(Index g) { return packs_[1 + g]; }
  const Pack& of_group(Index g) const { return packs_[1 + g]; }
  void clear() { std::ranges::fill(packs_, Pack(0.0)); }

 private:
  static Real* numbers_of(Pack& first) { return reinterpret_cast<Real*>(&first); }
  static const Real* numbers_of(const Pack& first) { return reinterpret_cast<const Real*>(&first); }

  std::vector<Pack> packs_;
};

/// What the mesh and the length decide. Group g has the nodes 8 g ... 8 g + 7, and entries k, first[g] ... first[g + 1]
/// - 1: the node in lane c has the neighbour 8 g + c + offset[k] if its coupling there is not 0.
struct NodeDiffusion {
  std::vector<Index> first;      ///< shape [n_groups + 1]
  std::vector<Index> offset;     ///< ascending for each group
  std::vector<Pack> coupling;    ///< -sum_e int grad N_i . grad N_j [-]; below 0 along stretched cells
  NodeNumbers full_volume;       ///< int N_i [m^2]
  NodeNumbers mapping_variance;  ///< spread_by_mapping h^2, h^2 the mean area of the cells [m^2]
  int n_substeps = 0;            ///< of one spreading over the largest length, so that no step overshoots

  Index n_groups() const { return static_cast<Index>(first.size()) - 1; }
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
  NodeNumbers value, next;     ///< per volume
  NodeNumbers inverse_volume;  ///< 1 / V_i of the soil that takes part [1/m^2]; 0 without
  NodeNumbers filling;         ///< V_i / int N_i [-]
  NodeNumbers variance;        ///< variance_to_spread [m^2]
  std::vector<Pack> rate;      ///< by entry of NodeDiffusion: what a sub-step takes of the difference [-]

  explicit NodeSpread(const NodeDiffusion& diffusion)
      : value(diffusion.full_volume),
        next(value),
        inverse_volume(value),
        filling(value),
        variance(value),
        rate(diffusion.coupling.size())
  {
    for (NodeNumbers* numbers : {&value, &next, &inverse_volume, &filling, &variance}) numbers->clear();
  }
};

/// Rates of the nodes of a group from filling and variance of them and their neighbours: coupling min(filling_i,
/// filling_j) tau_ij / (n V_i). A neighbour without soil takes nothing, so that a gap is not bridged.
inline void set_rates(const NodeDiffusion& diffusion, Index g, NodeSpread& spread)
{
  const Pack filling = spread.filling.of_group(g), variance = spread.variance.of_group(g);
  const Pack factor = Pack(0.25) * spread.inverse_volume.of_group(g) /
                      Pack(static_cast<Real>(diffusion.n_substeps));  // tau_ij: mean of half the variances
  for (Index k = diffusion.first[g]; k < diffusion.first[g + 1]; ++k) {
    const Index j = pack_width * g + diffusion.offset[k];
    spread.rate[k] = diffusion.coupling[k] * min(filling, spread.filling.eight_from(j)) *
                     (variance + spread.variance.eight_from(j)) * factor;
  }
}

/// One sub-step at the nodes of a group, from value to next.
inline void spread_nodes(const NodeDiffusion& diffusion, Index g, NodeSpread& spread)
{
  const Pack own = spread.value.of_group(g);
  Pack change(0.0);
  for (Index k = diffusion.first[g]; k < diffusion.first[g + 1]; ++k)
    change += spread.rate[k] * (spread.value.eight_from(pack_width * g + diffusion.offset[k]) - own);
  spread.next.of_group(g) = own + change;
}

}  // namespace terp
