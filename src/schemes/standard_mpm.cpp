// Standard MPM: force and strain at the material points, with B at the point. The baseline: it locks and oscillates.
#include "schemes/scheme.hpp"

namespace terp {
namespace {

struct StandardMpm {
  static void gather(const SchemeContext&, const CellGroup& group)
  {
    for (int c = 0; c < group.n(); ++c)
      for_each_block(group.points, group.cells[c], [&](const PointBlock<2>& block, Index) {
        add_internal_force_of_points(group.mesh.geometry(group.cells[c]), block, group.corners[c]);
      });
  }

  static void update_stress(const SchemeContext& context, const CellGroup& group,
      std::span<const CornerVectors, pack_width> du, StressSums& sums)
  {
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<2>& block, Index) {
        update_points(context, group.mesh.geometry(group.cells[c]), du[c], block, sums);
      });
    }
  }

 private:
  static void update_points(const SchemeContext& context, const CellGeometry<2>& cell, const CornerVectors& du,
      const PointBlock<2>& block, StressSums& sums)
  {
    for (Index first = 0; first < block.n_padded(); first += strip_length) {
      const Index n = std::min(strip_length, block.n_padded() - first);
      StripArrays strip;
      for (Index p = 0; p < n; p += pack_width) prepare_points(context.method, cell, du, block, first + p, strip, p);
      update_strip(context, block, first, n, strip);
      sums.plastic_work += sum_plastic_work(block, first, n, strip);
      for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
    }
  }

  static void prepare_points(const MethodOptions& method, const CellGeometry<2>& cell, const CornerVectors& du,
      const PointBlock<2>& block, Index p, StripArrays& strip, Index at)
  {
    using Rows = PointRows<2>;
    const auto gradient =
        gradients_at(cell, Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p));
    const auto l = displacement_gradient(gradient, du);
    l[0][0].store(strip.d_eps[0] + at);
    l[1][1].store(strip.d_eps[1] + at);
    Pack(0.0).store(strip.d_eps[2] + at);
    ((l[0][1] + l[1][0]) * Pack(0.5)).store(strip.d_eps[3] + at);
    if (method.objective_rate == ObjectiveRate::none) return;

    SymTensor<Pack, 2> sigma;
    for (int k = 0; k < n_sym<2>; ++k) sigma[k] = Pack::load(block.row(Rows::sigma + k) + p);
    rotate_stress(sigma, (l[1][0] - l[0][1]) * Pack(0.5));
    for (int k = 0; k < n_sym<2>; ++k) sigma[k].store(block.row(Rows::sigma + k) + p);
  }

  static void add_strain(const PointBlock<2>& block, Index p, const StripArrays& strip, Index at)
  {
    SymTensor<Pack, 2> d_eps;
    for (int k = 0; k < n_sym<2>; ++k) d_eps[k] = Pack::load(strip.d_eps[k] + at);
    scale_volume(block, p, accumulate_strain(block, p, d_eps));
  }
};

// Rows: sigma, strain, Omega and one state variable, read and written. Flops: gradients 44, force or strain 28; an
// elastic law 30.
constexpr PassCost gather_cost{.flops = 3 + 44 + 28, .rows = 1 + 4};
constexpr PassCost stress_cost{.flops = 44 + 28 + 20 + 30 + 9, .rows = 2 * (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(standard_mpm, StandardMpm, .title = "standard MPM",
    .summary = "points carry strain and force; the baseline, which locks and oscillates",
    .unused_options = "weights filled_fraction b_bar force_operator point_pressure pressure_relaxation state_averaging",
    .locks = true, .gather_cost = gather_cost, .stress_cost = stress_cost)

}  // namespace terp
