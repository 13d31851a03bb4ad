// The slips of a cell from the mean stress of its blocks. The two soils with most volume give the border and the kink
// of the corners; every soil of the cell then slips along that border, each by its own stiffness, so that one tau
// holds. Blocks of one material follow each other in a cell: the list of soils relies on it. `keep_mean_stress` has
// just set all slips to zero. So a cell that is left on the way keeps one strain for all its soils: too many of them,
// one without shear stiffness, or no border to be seen.

#include "schemes/cut_cells.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr int most_soils = 8;  // in a cell; with more there is no slip

/// The soil of one material in a cell.
struct Soil {
  Index material;
  Real weight = 0.0;
  SymTensor<Real, 2> sigma = {};  ///< sum, times weight
  Real G = 0.0;                   ///< the largest of its points [Pa]

  Real tau(const BlockSlip& unit) const
  {
    return (unit.normal * (sigma[0] - sigma[1]) + 2.0 * unit.shear * sigma[3]) / weight;
  }
};

struct Soils {
  std::array<Soil, most_soils> of;
  int n = 0;

  std::span<Soil> all() { return {of.data(), static_cast<std::size_t>(n)}; }
};

bool has_several_soils(const PointBlocks<2>& points, Index cell)
{
  const Index first = points.first_block(cell);
  for (Index b = points.block(first).next; b >= 0; b = points.block(b).next)
    if (points.block(b).material != points.block(first).material) return true;
  return false;
}

/// False: one of them has no shear stiffness, or there are too many.
bool list_soils(const SchemeContext& context, const CellGroup<Quad4>& group, Index cell, Soils& soils)
{
  bool known = true;
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index b) {
    if (!known) return;
    if (soils.n == 0 || soils.of[soils.n - 1].material != block.material) {
      known = soils.n < most_soils;
      if (!known) return;
      soils.of[soils.n++] = {.material = block.material};
    }
    Soil& soil = soils.of[soils.n - 1];
    const BlockSlip& slip = group.slips[b];
    soil.weight += slip.weight;
    for (int k = 0; k < n_sym<2>; ++k) soil.sigma[k] += slip.weight * slip.sigma[k];
    const SoilMaterial& material = context.materials[block.material];
    for (Index p = 0; p < block.n; ++p)
      soil.G = std::max(soil.G, material.law->moduli_at(material.view(block, p), stress_at(block, p)).shear);
    known = soil.G > 0.0 && soil.weight > 0.0;
  });
  return known;
}

/// Puts the two soils with most volume first.
void sort_by_volume(Soils& soils)
{
  std::ranges::stable_sort(soils.all(), [](const Soil& a, const Soil& b) { return a.weight > b.weight; });
}

/// The same border with the other soil first.
Border turned(const Border& border)
{
  return {{-border.across[0], -border.across[1]}, border.band < 0 ? -1 : 1 - border.band, -border.height};
}

/// Of two soils, a the first: their border, and the slip of the one with the lower shear stress, the new soil a.
Kink kink_between(
    const CellGroup<Quad4>& group, int c, const Border& border, const Soil& a, const Soil& b, const BlockSlip& unit)
{
  const Real tau_a = a.tau(unit), tau_b = b.tau(unit);
  if (std::abs(tau_b) < std::abs(tau_a)) return kink_between(group, c, turned(border), b, a, unit);
  const Vec<2> n = border.across;
  Kink kink{.along = {n[1], -n[0]}, .share = a.weight / (a.weight + b.weight), .slipped = (tau_b - tau_a) / a.G};
  kink.above = within_soil(group.mesh, group.cells[c], border, kink.share);
  const auto& force = group.corners[c].internal_force;
  for (std::size_t i = 0; i < 4; ++i)
    kink.force += kink.above[i] * (kink.along[0] * force[0][i] + kink.along[1] * force[1][i]);
  return kink;
}

void find_slips_of_cell(const SchemeContext& context, const CellGroup<Quad4>& group, int c)
{
  const Index cell = group.cells[c];
  Soils soils;
  if (!list_soils(context, group, cell, soils)) return;
  sort_by_volume(soils);
  const Soil &a = soils.of[0], &b = soils.of[1];
  const Border border = find_border(group.mesh, group.points, cell, {a.material, b.material});
  const Vec<2> n = border.across;
  const BlockSlip unit{.normal = n[0] * n[1], .shear = 0.5 * (n[1] * n[1] - n[0] * n[0])};
  if (!unit.acts()) return;
  Real volume = 0.0, yielding = 0.0, held = 0.0;
  for (const Soil& soil : soils.all()) {
    volume += soil.weight;
    yielding += soil.weight / soil.G;
    held += soil.weight * soil.tau(unit) / soil.G;
  }
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index b) {
    const Soil& soil = *std::ranges::find(soils.all(), block.material, &Soil::material);
    BlockSlip& slip = group.slips[b];
    slip.normal = unit.normal;
    slip.shear = unit.shear;
    slip.held = (held / yielding - soil.tau(unit)) / soil.G;
    slip.rate = volume / (soil.G * yielding) - 1.0;
  });
  group.slips[group.points.first_block(cell)].kink = kink_between(group, c, border, a, b, unit);
}

}  // namespace

void find_slips(const SchemeContext& context, const CellGroup<Quad4>& group)
{
  for (int c = 0; c < group.n(); ++c)
    if (has_several_soils(group.points, group.cells[c])) find_slips_of_cell(context, group, c);
}

}  // namespace terp
