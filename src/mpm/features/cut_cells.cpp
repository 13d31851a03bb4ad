// The slips of a cell from the mean stress of its blocks, and from the plastic work that the law gave their points in
// the step before. The two soils with most volume give the border and the kink of the corners; every soil of the cell
// then slips along that border, each by its own stiffness, so that one tau holds. Blocks of one material follow each
// other in a cell: the list of soils relies on it. `keep_mean_stress` has just set all slips to zero. So a cell that is
// left on the way keeps one strain for all its soils: none yielded, too many of them, one without shear stiffness, or
// no border to be seen.

#include "mpm/features/cut_cells.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr int most_soils = 8;  // in a cell; with more there is no slip

/// Plastic work of a step over sigma : sigma/G from which a soil has yielded. Round-off of a stress is 1e-16 of it, and
/// leaves as much of work in a law that takes it for the difference of strain and stress/G. The laws of Terp yield by
/// 1e-11 or more of their strength (yield_round_off of tresca_softening.cpp).
constexpr Real least_work = 1e-12;

/// The soil of one material in a cell.
struct Soil {
  Index material;
  Real weight = 0.0;
  SymTensor<Real, 2> sigma = {};  ///< sum, times weight
  Real G = 0.0;                   ///< the largest of its points [Pa]
  Real plastic_work = 0.0;        ///< of the step before [J per m]

  Real tau(const BlockSlip& unit) const
  {
    return (unit.normal * (sigma[0] - sigma[1]) + 2.0 * unit.shear * sigma[3]) / weight;
  }
  bool has_yielded() const
  {
    const Real square = sigma[0] * sigma[0] + sigma[1] * sigma[1] + sigma[2] * sigma[2] + 2.0 * sigma[3] * sigma[3];
    return plastic_work * G * weight > least_work * square;  // of sigma times weight
  }
};

struct Soils {
  std::array<Soil, most_soils> of;
  int n = 0;

  std::span<Soil> all() { return {of.data(), static_cast<std::size_t>(n)}; }
  std::span<const Soil> all() const { return {of.data(), static_cast<std::size_t>(n)}; }
};

bool has_several_soils(const PointBlocks<2>& points, Index cell)
{
  const Index first = points.first_block(cell);
  for (Index b = points.block(first).next; b >= 0; b = points.block(b).next)
    if (points.block(b).material != points.block(first).material) return true;
  return false;
}

/// Of the step before, of the points of a block [J per m].
Real plastic_work_of(const PointBlock<2>& block, int row)
{
  Pack work(0.0);
  for (Index p = 0; p < block.n; p += pack_width)
    work = fma(Pack::load(block.row(Rows::volume) + p), Pack::load(block.row(row) + p), work);
  return sum(work);
}

/// Whether the law gave any work to the points of a cell: most cut cells do not, and need no more than this.
bool has_plastic_work(const SchemeContext& context, const PointBlocks<2>& points, Index cell)
{
  bool any = false;
  for_each_block(points, cell,
      [&](const PointBlock<2>& block, Index) { any = any || plastic_work_of(block, context.work_row) > 0.0; });
  return any;
}

/// False: one of them has no shear stiffness, or there are too many.
bool list_soils(const SchemeContext& context, const CellGroup<Quad4>& group, std::span<const BlockSlip> slips,
    Index cell, Soils& soils)
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
    const BlockSlip& slip = slips[b];
    soil.weight += slip.weight;
    soil.plastic_work += plastic_work_of(block, context.work_row);
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

/// The kink of a cell by the one of its first two soils with the lower shear stress, soil a. None where soil a did not
/// yield, since elastic soils differ in tau, too, where they bend; nor where they shear in opposite directions.
Kink find_kink(const CellGroup<Quad4>& group, int c, Border border, const Soils& soils, const BlockSlip& unit)
{
  const Soil *a = &soils.of[0], *b = &soils.of[1];
  if (std::abs(b->tau(unit)) < std::abs(a->tau(unit))) {
    std::swap(a, b);
    border = turned(border);
  }
  const Real tau_a = a->tau(unit), tau_b = b->tau(unit);
  if (!a->has_yielded() || !(tau_a * tau_b > 0.0)) return {};
  const Vec<2> n = border.across;
  Kink kink{.along = {n[1], -n[0]}, .share = a->weight / (a->weight + b->weight), .slipped = (tau_b - tau_a) / a->G};
  kink.above = within_soil(group.mesh, group.cells[c], border, kink.share);
  const auto& force = group.corners[c].internal_force;
  for (std::size_t i = 0; i < 4; ++i)
    kink.force += kink.above[i] * (kink.along[0] * force[0][i] + kink.along[1] * force[1][i]);
  // It may give back to the soils no more than what yielding took from them.
  Real lost = kink.force, plastic_work = 0.0;  // on the border by a kink of 1; of the cell
  for (const Soil& soil : soils.all()) {
    lost -= kink.share * soil.weight * soil.tau(unit);
    plastic_work += std::max(soil.plastic_work, 0.0);
  }
  if (kink.slipped * lost < -plastic_work) kink.slipped = -plastic_work / lost;
  return kink;
}

void find_slips_of_cell(const SchemeContext& context, const CellGroup<Quad4>& group, std::span<BlockSlip> slips, int c)
{
  const Index cell = group.cells[c];
  Soils soils;
  if (!list_soils(context, group, slips, cell, soils) || std::ranges::none_of(soils.all(), &Soil::has_yielded)) return;
  sort_by_volume(soils);
  const Border border = find_border(group.mesh, group.points, cell, {soils.of[0].material, soils.of[1].material});
  const Vec<2> n = border.across;
  const BlockSlip unit{.normal = n[0] * n[1], .shear = 0.5 * (n[1] * n[1] - n[0] * n[0])};
  if (!unit.acts()) return;
  Real softness = 0.0, strain = 0.0;
  for (const Soil& soil : soils.all()) {
    softness += soil.weight / soil.G;
    strain += soil.weight * soil.tau(unit) / soil.G;
  }
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index b) {
    const Soil& soil = *std::ranges::find(soils.all(), block.material, &Soil::material);
    BlockSlip& slip = slips[b];
    slip.normal = unit.normal;
    slip.shear = unit.shear;
    slip.g = (strain / softness - soil.tau(unit)) / soil.G;
  });
  slips[group.points.first_block(cell)].kink = find_kink(group, c, border, soils, unit);
}

}  // namespace

void find_slips(const SchemeContext& context, const CellGroup<Quad4>& group, std::span<BlockSlip> slips)
{
  for (int c = 0; c < group.n(); ++c)
    if (has_several_soils(group.points, group.cells[c]) && has_plastic_work(context, group.points, group.cells[c]))
      find_slips_of_cell(context, group, slips, c);
}

}  // namespace terp
