// The limits and the errors named in the messages were measured: decision 0045.

#include "simulation/softening_scales.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real resolved = 2.0;         // cells in a length
constexpr Real part_of_height = 20.0;  // of the section over the length, at least
constexpr Real half_spacing = 0.02;    // of the height, by which the outermost points fall short of it
constexpr Real round_off = 1e-9;       // of cells of a mesh that ought to be equal

std::string key_of(const Model& model, const SofteningScale& scale)
{
  return fmt::format("material.\"{}\".softening.length", model.materials[scale.material].name);
}

Real height_of(const Model& model, const State& state)
{
  Real low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k + 1 < state.x_initial.size(); k += 2) {
    const Real depth = state.x_initial[k] * model.damping.down[0] + state.x_initial[k + 1] * model.damping.down[1];
    low = std::min(low, depth);
    high = std::max(high, depth);
  }
  return std::max(high - low, 0.0);
}

}  // namespace

std::vector<SofteningScale> softening_scales(const Model& model, const State& state)
{
  std::vector<Real> area(model.materials.size(), 0.0);
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    area[block.material] = std::max(area[block.material], model.mesh->geometry(block.cell).volume);
  });
  std::vector<SofteningScale> scales;
  for (Index m = 0; m < static_cast<Index>(model.materials.size()); ++m)
    if (model.materials[m].increment_row >= 0 && area[m] > 0.0)
      scales.push_back({m, model.materials[m].softening.length, std::sqrt(area[m]), height_of(model, state)});
  return scales;
}

bool softens_point_by_point(const Model& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& m) {
    return row_of(m, Role::plastic_strain) >= 0 && std::isfinite(m.law->softened_strain()) &&
           !m.softening.is_nonlocal() && !m.softening.is_scaled();
  });
}

void check_softening_lengths(const Model& model, const State& state)
{
  for (const SofteningScale& scale : softening_scales(model, state)) {
    if (scale.length >= scale.cell * (1.0 - round_off)) continue;
    throw InputError(Problem{key_of(model, scale), "the softening length is shorter than a cell",
        fmt::format(
            "Got {:.4g} m; cells with this soil measure up to {:.4g} m (square root of the area): nothing would "
            "spread.\nAllowed: at least {:.4g} m, better {:.4g} m or more. Give that, or smaller cells.",
            scale.length, scale.cell, scale.cell, resolved * scale.cell),
        "material.softening", false, {"mesh.cell", "mesh"}});
  }
}

void find_odd_softening_lengths(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  std::vector<SofteningScale> said;
  const std::vector<SofteningScale> scales = softening_scales(model, state);
  for (const SofteningScale& scale : scales) {
    const auto is_like = [&](const SofteningScale& other) {
      return other.length == scale.length && std::abs(other.cell - scale.cell) <= round_off * scale.cell;
    };
    if (std::ranges::any_of(said, is_like)) continue;
    said.push_back(scale);
    std::string soils;
    for (const SofteningScale& other : scales)
      if (is_like(other))
        soils += fmt::format("{}`{}`", soils.empty() ? "" : ", ", model.materials[other.material].name);
    const bool is_short = scale.length < resolved * scale.cell * (1.0 - round_off);
    const bool is_long = scale.height > 0.0 && scale.length > scale.height / part_of_height * (1.0 + half_spacing);
    const Real longest = scale.height / part_of_height;
    const std::string got = fmt::format("Got {:.4g} m for {}; ", scale.length, soils);
    const std::string cells = fmt::format("cells with this soil measure up to {:.4g} m", scale.cell),
                      height = fmt::format("the soil is H = {:.4g} m high", scale.height);
    const auto warn = [&](std::string what, std::string detail) {
      warnings.push_back({key_of(model, scale), std::move(what), got + std::move(detail), "material.softening", false,
          {"mesh.cell", "mesh"}});
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
              cells, resolved * scale.cell, scale.length / resolved));
    else if (is_long)
      warn("the softening length is long beside the section",
          fmt::format("usual: at most H/{:g} = {:.4g} m, as {}.\nSoil within about 2 l of a slip surface softens, too.",
              part_of_height, longest, height));
  }
}

}  // namespace terp
