// What the kernels of one walk hand on: the step, a group of cells, a layer of soil in a group, a block, a strip of its
// points, a batch of nodes. They lie in the first cache of the thread, and nothing in them is set before its place in
// score.def.
#pragma once

#include "mpm/features/patch_group.hpp"
#include "mpm/step/score.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <optional>

namespace terp {

struct StepNow {
  const StepModel& model;
  StepState& state;
  Workspace& work;
  const Score& score;
  SchemeContext context;
};

/// Up to eight neighbouring cells.
struct GroupNow {
  StepNow& step;
  const CellGroup<Quad4>& group;
  std::vector<PointPlace>& points_leaving;  ///< of the thread
  CellSums& sums;                           ///< of the chunk
  StressSums stress = {};

  bool one_layer;                 ///< there is but one, and its Gauss values are kept no longer than the walk:
  GaussValues<Quad4, Pack> only;  ///< they are here
  PerGauss<Quad4, Pack> volume = zero_packs<Quad4::n_gauss>();  ///< of all soil
  GeometryLanes<Quad4> geometry;
  Pack within;  ///< 0 in lanes whose cell the surface cuts, else 1

  GroupVectors<Quad4> du, room;         ///< v_i dt of the corners [m]; zero beyond the last cell
  const GroupVectors<Quad4>* strained;  ///< what of it strains the soil
  GaussStrain<Quad4, Pack> strain;
  std::array<GaussStrain<Quad4>, pack_width> strain_of_cell;  ///< where blocks follow in the same walk

  GroupNow(StepNow& now, const CellGroup<Quad4>& cells, std::vector<PointPlace>& leaving, CellSums& of_chunk)
      : step(now), group(cells), points_leaving(leaving), sums(of_chunk)
  {
  }
  template <class T>
  std::span<T> here(std::span<T> of_cells) const
  {
    return of_cells.empty() ? of_cells : of_cells.subspan(group.number * pack_width, group.n());
  }
  GaussValues<Quad4, Pack>& gauss_of(const BlockLayer& layer) { return one_layer ? only : group.gauss_of(layer); }
};

/// What the law did at the Gauss points of a layer, of schemes whose Gauss points own the history.
struct GaussLaw {
  GaussRow<Quad4> plastic_work;                                         ///< of the step [J/m^3]
  Pack plastic;                                                         ///< of the cells [J per m]
  std::array<std::array<PerGauss<Quad4>, n_sym<2>>, pack_width> sigma;  ///< by cell
  std::optional<HalfCompliance> compliance;
};

/// The blocks of one material and body in a group.
struct LayerNow {
  GroupNow& at;
  const BlockLayer& layer;
  const SoilMaterial& material;
  GaussValues<Quad4, Pack>& gauss;
  GaussRow<Quad4>* rows;  ///< of the law

  const GaussStrain<Quad4, Pack>* strain;
  GaussStrain<Quad4, Pack> own;         ///< room for it
  const PerGauss<Quad4, Pack>* booked;  ///< weights with which plastic work counts
  PerGauss<Quad4, Pack> booked_room;
  bool weighed = false;  ///< what goes back to the points is weighed by their shares
  GaussLaw law;
  LeftRows<Quad4> left;

  LayerNow(GroupNow& group, const BlockLayer& blocks)
      : at(group),
        layer(blocks),
        material(group.step.context.materials[blocks.material]),
        gauss(group.gauss_of(blocks)),
        rows(group.group.rows_of(blocks)),
        strain(&group.strain),
        booked(&gauss.weight)
  {
  }
};

struct BlockNow {
  GroupNow& at;
  const PointBlock<2>& block;
  Index number;
  int c;            ///< number of its cell in the group
  LayerNow* layer;  ///< nullptr where blocks are walked cell by cell
  const SoilMaterial& material;

  const GaussStrain<Quad4>* strain;
  GaussStrain<Quad4> own;          ///< room for it
  PatchSize size;                  ///< where shares count in patches, with
  std::optional<PatchView> patch;  ///< what the Gauss points around hold
  Pack shift;                      ///< of the pore pressure of the points

  BlockNow(GroupNow& group, Index b, int cell, LayerNow* of = nullptr)
      : at(group),
        block(group.group.points.block(b)),
        number(b),
        c(cell),
        layer(of),
        material(group.step.context.materials[block.material]),
        strain(&group.strain_of_cell[cell])
  {
  }
  StressSums& sums() { return at.stress; }
  const SchemeContext& context() const { return at.step.context; }
  const CellGeometry<Quad4>& geometry() const { return at.group.mesh.geometry(at.group.cells[c]); }
};

/// Strain of points `first` to `first` + n - 1 of a block, padding included, before the law.
struct StripNow {
  BlockNow& at;
  Index first, n;
  const StripArrays<2>& strip;
};

inline void run_strip(BlockNow& block, Index first, Index n, const StripArrays<2>& strip)
{
  StripNow now{block, first, n, strip};
  for (const Kernel* kernel : block.at.step.score.strips()) (*std::get_if<void (*)(StripNow&)>(&kernel->run))(now);
}

/// Of a chunk of the active nodes those that move, and their values until the last kernel of the pass writes them. Of
/// the pass that takes the velocities from the points: v_0, free, v are those of pass 2, before the clamps, and now.
struct Nodes {
  StepNow& step;
  NodeSums& sums;
  Index chunk;
  std::span<const Index> active;

  int n = 0;
  std::array<Index, nodes_per_chunk> number;
  std::array<Real, nodes_per_chunk> mass;
  std::array<Vec<2>, nodes_per_chunk> v_0, out_of_balance;  ///< [m/s], [N per m]
  std::array<Vec<2>, nodes_per_chunk> force, v;             ///< the free part of them, which damping looks at
  std::array<Vec<2>, nodes_per_chunk> damping;              ///< [N per m]
  std::array<Vec<2>, nodes_per_chunk> v_free, v_star;       ///< before and after the boundary conditions [m/s]

  Nodes(StepNow& now, NodeSums& of_chunk, Index number_of_chunk, std::span<const Index> nodes)
      : step(now), sums(of_chunk), chunk(number_of_chunk), active(nodes)
  {
  }
  void enter(Index i, Real m)
  {
    number[n] = i;
    mass[n++] = m;
  }
};

/// Of features that a run has where their scratch is.
template <auto slot>
bool slot_is_full(const StepModel&, const Workspace& work)
{
  return static_cast<bool>(work.with.*slot);
}

}  // namespace terp

/// Last line of the kernels of a feature, in namespace terp: its table NAME_score, and whether a run has it.
#define TERP_FEATURE_KERNELS(NAME, ...)               \
  extern const FeatureKernels feature_kernels_##NAME; \
  constinit const FeatureKernels feature_kernels_##NAME{#NAME, &__VA_ARGS__, NAME##_score};
