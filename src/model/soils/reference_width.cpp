// A cell of width h in simple shear has gamma = tau/G + 2 eps_p. With tau = S_r + (S_p - S_r) exp(-eta (h/t_ref) eps_p)
// its strain grows as tau falls while eta (h/t_ref) (S_p - S_r) < 2 G: h < 2 G t_ref / (eta (S_p - S_r)). In a wider
// cell the stress would drop at once. The laws refuse shape factors beyond 1.5 G, for the sake of the edges of the
// yield surface.

#include "model/soils/reference_width.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// True if the law takes its shape factors times a scale.
bool is_admitted(const MaterialCase& material, Real scale)
{
  const MaterialType& law = *find_material(material.model);
  std::vector<Real> values = material.parameters;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (is_shape_factor(law.parameters[k])) values[k] *= scale;
  return law.check(values).empty();
}

/// The largest scale that the law takes, at most `scale`.
Real largest_admitted(const MaterialCase& material, Real scale)
{
  if (is_admitted(material, scale)) return scale;
  Real low = 0.0, high = scale;
  for (int k = 0; k < 60; ++k) {
    const Real middle = 0.5 * (low + high);
    (is_admitted(material, middle) ? low : high) = middle;
  }
  return low;
}

struct Widest {
  Real with_soil = 0.0, anywhere = 0.0;  ///< h [m]
};

Widest widest_cells(const Model& model, const StepState& state, Index material)
{
  const SoilMaterial& soil = model.materials[material];
  Widest widest;
  if (soil.softening_scale.empty()) return widest;
  for (const Real scale : soil.softening_scale) widest.anywhere = std::max(widest.anywhere, scale);
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    if (block.material == material) widest.with_soil = std::max(widest.with_soil, soil.softening_scale[block.cell]);
  });
  widest.anywhere *= soil.softening.reference_width;
  widest.with_soil *= soil.softening.reference_width;
  return widest;
}

Problem too_wide(const Model& model, Index material, Real width, std::string what, std::string_view which)
{
  const Real reference = model.materials[material].softening.reference_width;
  const Real scale = width / reference, admitted = largest_admitted(model.description.materials[material], scale);
  return {fmt::format("material.\"{}\".softening.reference_width", model.materials[material].name), std::move(what),
      fmt::format("{} measure up to {:.4g} m (square root of the area): softening there is {:.3g} times as steep as "
                  "given.\nAllowed: cells of at most {:.4g} m with this width, or a width of at least {:.4g} m with "
                  "these cells.\nA smaller shape factor or a stiffer soil serves too.",
          which, width, scale, admitted * reference, width / admitted),
      "material.softening", false, {"mesh.cell", "mesh"}};
}

}  // namespace

std::vector<Real> scale_by_cell(const Mesh<2>& mesh, const SoilMaterial& material)
{
  if (material.softening.is_nonlocal() || !material.softening.is_scaled()) return {};
  std::vector<Real> scale(mesh.cells.size());
  for (Index cell = 0; cell < static_cast<Index>(scale.size()); ++cell)
    scale[cell] = std::sqrt(mesh.geometry(cell).volume) / material.softening.reference_width;
  return scale;
}

void check_reference_widths(const Model& model, const StepState& state)
{
  for (Index m = 0; m < static_cast<Index>(model.materials.size()); ++m) {
    const Real width = widest_cells(model, state, m).with_soil;
    const Real reference = model.materials[m].softening.reference_width;
    if (width > 0.0 && !is_admitted(model.description.materials[m], width / reference))
      throw InputError(too_wide(
          model, m, width, "a cell is too wide for the reference width: it would snap back", "Cells with this soil"));
  }
}

void find_wide_cells(const Model& model, const StepState& state, std::vector<Problem>& warnings)
{
  for (Index m = 0; m < static_cast<Index>(model.materials.size()); ++m) {
    const Widest widest = widest_cells(model, state, m);
    const Real reference = model.materials[m].softening.reference_width;
    if (widest.with_soil > 0.0 && widest.anywhere > widest.with_soil &&
        !is_admitted(model.description.materials[m], widest.anywhere / reference))
      warnings.push_back(
          too_wide(model, m, widest.anywhere, "soil may come to cells too wide for the reference width", "Cells"));
  }
}

}  // namespace terp
