// The limits and the errors named in the messages were measured: decision 0045.

#include "model/soils/softening_scales.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

constexpr Real resolved = 2.0;                // cells in a length
constexpr Real part_of_height = 20.0;         // of the section over the length, at least
constexpr Real most_cells_in_length = 100.0;  // in a length: spreading then takes 7000 sub-steps in each step
constexpr Real halo_widths = 2.0;             // lengths beside a slip surface within which soil softens
constexpr Real half_spacing = 0.02;           // of the height, by which the outermost points fall short of it
constexpr Real equal_within = 1e-9;           // of cells of a mesh that ought to be equal

std::string key_of(const Model& model, Index material)
{
  return fmt::format("material.\"{}\".softening.length", model.materials[material].name);
}

Real height_of(const Model& model, const StepState& state)
{
  Real low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k + 1 < state.x_initial.size(); k += 2) {
    const Real depth = state.x_initial[k] * model.damping.down[0] + state.x_initial[k + 1] * model.damping.down[1];
    low = std::min(low, depth);
    high = std::max(high, depth);
  }
  return std::max(high - low, 0.0);
}

/// The greater distance between the middles of opposite sides [m].
Real width_of(const Mesh<2>& mesh, Index cell)
{
  const auto& map = mesh.geometry(cell).map;
  return 2.0 * std::max(std::hypot(map.axis_xi[0], map.axis_xi[1]), std::hypot(map.axis_eta[0], map.axis_eta[1]));
}

}  // namespace

Real least_length_over_width(const Model& model, const StepState& state)
{
  Real least = std::numeric_limits<Real>::quiet_NaN();
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    if (material.increment_row >= 0)
      least = std::fmin(least, material.softening.length / width_of(*model.mesh, block.cell));
  });
  return least;
}

std::vector<SofteningScale> softening_scales(const Model& model, const StepState& state)
{
  std::vector<Real> area(model.materials.size(), 0.0), width = area;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    area[block.material] = std::max(area[block.material], model.mesh->geometry(block.cell).volume);
    width[block.material] = std::max(width[block.material], width_of(*model.mesh, block.cell));
  });
  std::vector<SofteningScale> scales;
  for (Index m = 0; m < static_cast<Index>(model.materials.size()); ++m)
    if (model.materials[m].increment_row >= 0 && area[m] > 0.0)
      scales.push_back({m, model.materials[m].softening.length, std::sqrt(area[m]), width[m], height_of(model, state)});
  return scales;
}

bool softens_point_by_point(const Model& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& m) {
    return row_of(m, Role::plastic_strain) >= 0 && std::isfinite(m.law->softened_strain()) &&
           !m.softening.is_nonlocal() && !m.softening.is_scaled();
  });
}

void check_cells_in_length(const Model& model, const std::vector<Index>& materials)
{
  const Real cell = model.mesh->smallest_altitude;
  for (const Index m : materials) {
    const Real length = model.materials[m].softening.length;
    if (model.materials[m].increment_row < 0 || length <= most_cells_in_length * cell) continue;
    throw InputError(Problem{key_of(model, m), "the softening length spans too many cells",
        fmt::format("Got {:.4g} m; the smallest cell is {:.4g} m high. Allowed: at most {:.0f} of them, {:.4g} m.\n"
                    "Lengths are in m.",
            length, cell, most_cells_in_length, most_cells_in_length * cell),
        "material.softening", false, {"mesh.cell", "mesh"}});
  }
}

void check_softening_lengths(const Model& model, const StepState& state)
{
  for (const SofteningScale& scale : softening_scales(model, state)) {
    if (scale.length >= scale.cell * (1.0 - equal_within)) continue;
    throw InputError(Problem{key_of(model, scale.material), "the softening length is shorter than a cell",
        fmt::format(
            "Got {:.4g} m; cells with this soil measure up to {:.4g} m (square root of the area): nothing would "
            "spread.\nAllowed: at least {:.4g} m, better {:.4g} m or more. Give that, or smaller cells.",
            scale.length, scale.cell, scale.cell, resolved * scale.cell),
        "material.softening", false, {"mesh.cell", "mesh"}});
  }
}

void find_odd_softening_lengths(const Model& model, const StepState& state, std::vector<Problem>& warnings)
{
  std::vector<SofteningScale> said;
  const std::vector<SofteningScale> scales = softening_scales(model, state);
  for (const SofteningScale& scale : scales) {
    const auto is_like = [&](const SofteningScale& other) {
      return other.length == scale.length && std::abs(other.width - scale.width) <= equal_within * scale.width;
    };
    if (std::ranges::any_of(said, is_like)) continue;
    said.push_back(scale);
    std::string soils;
    for (const SofteningScale& other : scales)
      if (is_like(other))
        soils += fmt::format("{}`{}`", soils.empty() ? "" : ", ", model.materials[other.material].name);
    const bool is_short = scale.length < resolved * scale.width * (1.0 - equal_within);
    const bool is_long = scale.height > 0.0 && scale.length > scale.height / part_of_height * (1.0 + half_spacing);
    const Real longest = scale.height / part_of_height;
    const std::string got = fmt::format("Got {:.4g} m for {}; ", scale.length, soils);
    const std::string cells = fmt::format("cells with this soil are up to {:.4g} m wide", scale.width),
                      height = fmt::format("the soil is H = {:.4g} m high", scale.height);
    const auto warn = [&](std::string what, std::string detail) {
      warnings.push_back({key_of(model, scale.material), std::move(what), got + std::move(detail), "material.softening",
          false, {"mesh.cell", "mesh"}});
    };
    if (is_short && is_long)
      warn("the cells are too large for a softening length that suits the section",
          fmt::format(
              "{}, {}.\nA slip surface takes up to 14 % more energy than on fine cells, and soil within about 2 l "
              "of it softens, too.\nUsual: {:.4g} m (H/{:g}) on cells of at most {:.4g} m.",
              cells, height, longest, part_of_height, longest / resolved));
    else if (is_short)
      warn("the softening length holds less than two cells",
          fmt::format(
              "{}. A slip surface takes up to 14 % more energy than on fine cells.\nUsual: at least {:.4g} m, or "
              "cells of at most {:.4g} m.",
              cells, resolved * scale.width, scale.length / resolved));
    else if (is_long)  // in one line: every run of such a case says it
      warnings.push_back({key_of(model, scale.material),
          fmt::format("{}: soil within {:.3g} m of a slip surface softens, too, as the length of {:.3g} m is more than "
                      "H/{:g}; give {:.3g} m{} (docs/softening_length.md)",
              soils, halo_widths * scale.length, scale.length, part_of_height, longest,
              longest < resolved * scale.width ? fmt::format(" on cells of at most {:.3g} m", longest / resolved) : ""),
          "", "", false, {"mesh.cell", "mesh"}});
  }
}

}  // namespace terp
