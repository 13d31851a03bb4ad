// The errors named in the message were measured: docs/limits.md, 4.

#include "run/findings/shared_cells.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real most = 0.5;  // of a layer: 0.68 of one of two cells that lie askew by 30 degrees, 0.34 of four cells

bool holds_another(const PointBlocks<2>& points, const PointBlock<2>& block)
{
  for (Index b = points.first_block(block.cell); b >= 0; b = points.block(b).next)
    if (points.block(b).material != block.material) return true;
  return false;
}

}  // namespace

std::vector<Real> shares_in_shared_cells(const Model& model, const State& state)
{
  std::vector<Real> whole(model.materials.size(), 0.0), shared = whole;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const bool is_shared = holds_another(state.points, block);
    for (Index p = 0; p < block.n; ++p) {
      const Real volume = block.row(Rows::volume)[p];
      whole[block.material] += volume;
      if (is_shared) shared[block.material] += volume;
    }
  });
  for (std::size_t m = 0; m < whole.size(); ++m) shared[m] = whole[m] > 0.0 ? shared[m] / whole[m] : 0.0;
  return shared;
}

void find_shared_layers(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  if (model.with.slip) return;
  const char* remedy = looks_at(*model.scheme, "cut_cells") ? "method.cut_cells = \"slip\"" : "another scheme";
  const std::vector<Real> shares = shares_in_shared_cells(model, state);
  for (std::size_t m = 0; m < shares.size(); ++m) {
    const SoilMaterial& material = model.materials[m];
    if (!(shares[m] > most) || row_of(material, Role::plastic_strain) < 0) continue;
    warnings.push_back({fmt::format("material.\"{}\"", material.name),
        fmt::format("most of `{}` lies in cells that it shares with other soil", material.name),
        fmt::format(
            "Got {:.0f} % of its volume. Such a cell has the mean strength of its soils: between stronger soil, slip "
            "along a layer\nof two cells that lie askew takes up to 34 % more force, of four cells 5 %.\nUsual: "
            "{}, cells along the layer, or smaller ones (docs/limits.md, 4).",
            100.0 * shares[m], remedy),
        "mesh", false, {"mesh.cell", "mesh"}});
  }
}

}  // namespace terp
