// A border of soils counts where the one below is ten times as permeable. Toe and tip of a wall are singular: gradients
// are means over a length, never values at a point.

#include "model/seepage/seepage_results.hpp"

#include "math/plane.hpp"
#include "math/sparse_cholesky.hpp"
#include "model/ground/ground_section.hpp"
#include "model/soils/overburden.hpp"
#include "model/water/water_pressure.hpp"
#include "mpm/mesh/locate.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real more_permeable = 10.0;

/// The soils along a vertical line: the bodies between crossings, from the ground down.
struct SoilStretch {
  Real top, bottom;  // [m]
  std::size_t body;
};

std::vector<SoilStretch> soils_along(const SeepageSection& section, Real x)
{
  std::vector<Real> heights;
  for (const std::vector<Side>& sides : section.sides) {
    const std::vector<Real> of = crossings_of_vertical(sides, x);
    heights.insert(heights.end(), of.begin(), of.end());
  }
  std::ranges::sort(heights, std::ranges::greater{});
  std::vector<SoilStretch> soils;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    if (heights[k] - heights[k + 1] < 1e-9 * section.cell) continue;
    const auto body = section.soil_at({x, 0.5 * (heights[k] + heights[k + 1])});
    if (!body) continue;
    if (!soils.empty() && soils.back().body == *body && soils.back().bottom == heights[k])
      soils.back().bottom = heights[k + 1];
    else
      soils.push_back({heights[k], heights[k + 1], *body});
  }
  return soils;
}

}  // namespace

std::vector<UpliftPlace> uplift_over_land(
    const Model& model, const SeepageSection& section, const WaterSituation& situation)
{
  const Overburden overburden(model);
  const WaterCase& water = model.description.water;
  const Columns columns = columns_of_section(*model.mesh);
  std::vector<Real> ground(static_cast<std::size_t>(columns.n), -std::numeric_limits<Real>::infinity());
  for (Index k = 0; k < columns.n; ++k)
    ground[k] = overburden.ground(columns.left + (k + 0.5) * columns.width).value_or(ground[k]);
  const bool river_left = !situation.seepage.river || situation.seepage.river->side == SectionSide::left;
  auto crest = static_cast<Index>(std::ranges::max_element(ground) - ground.begin());
  if (situation.seepage.river) {  // beyond its reach, whatever stands on the land
    const FreeWaterLevels levels(section, situation.seepage);
    const auto& river = levels.stretches()[0];
    const Real end = (river_left ? river.to : river.from) - columns.left;
    crest = static_cast<Index>(std::clamp(std::floor(end / columns.width), 0.0, columns.n - 1.0));
  }
  std::vector<UpliftPlace> places;
  for (Index k = river_left ? crest : 0; k < (river_left ? columns.n : crest + 1); ++k) {
    const Real x = columns.left + (k + 0.5) * columns.width;
    const std::vector<SoilStretch> soils = soils_along(section, x);
    std::optional<UpliftPlace> worst;
    for (std::size_t s = 0; s + 1 < soils.size(); ++s) {
      const Real above = section.materials[soils[s].body].k.vertical,
                 below = section.materials[soils[s + 1].body].k.vertical;
      if (below < (1.0 - 1e-9) * more_permeable * above) continue;
      UpliftPlace place{.x = {x, soils[s].bottom}, .ground = soils[0].top};
      place.stress = overburden.total(place.x, situation);
      // Where the border lies in a cell, the head there is that of a mixture: it is taken from two places below.
      const Real depth = std::min(section.cell, (soils[s + 1].top - soils[s + 1].bottom) / 3.0);
      const auto head = [&](Real y) {
        return y + unlimited_pressure(water, situation, {x, y}, 0.0) / water.unit_weight;
      };
      const Real top = std::max(place.ground, elevation_at(situation.phreatic_line, x));
      const Real below_cover = 2.0 * head(place.x[1] - depth) - head(place.x[1] - 2.0 * depth);
      place.pressure = std::max(water.unit_weight * (below_cover - place.x[1]), 0.0);
      place.gradient = (below_cover - top) / (place.ground - place.x[1]);
      if (!worst || place.factor() < worst->factor()) worst = place;
    }
    if (worst) places.push_back(*worst);
  }
  return places;
}

ExitGradient steepest_exit(const Mesh<2>& mesh, const SeepageSection& section, const ComputedWater& water)
{
  ExitGradient steepest;
  for (std::size_t q = 0; q < water.soil.surface.size(); ++q) {
    const SurfacePlace& place = water.soil.surface[q];
    if (!(water.flow.q[q] > 0.0) || place.condition == FlowCondition::leak || !(place.normal[1] > 0.0)) continue;
    const Vec<2> inside{place.x[0] - section.cell * place.normal[0], place.x[1] - section.cell * place.normal[1]};
    const std::optional<Real> head = head_at(mesh, water.flow.heads, inside);
    if (!head) continue;
    const Real gradient = (*head - place.head) / section.cell;
    if (gradient > steepest.gradient) steepest = {place.x, gradient};
  }
  return steepest;
}

std::vector<Real> stream_function(const Mesh<2>& mesh, const ComputedWater& water, Real band)
{
  const std::vector<Real>& heads = water.flow.heads;
  std::vector<Index> unknown(mesh.nodes.size(), -1);
  Index n = 0;
  for (const FlowPlace& place : water.soil.places)
    for (const Index i : mesh.cells[place.cell])
      if (water.flow.has_flow[i] && unknown[i] < 0) unknown[i] = n++;
  std::vector<Real> psi(mesh.nodes.size(), 0.0);
  if (n == 0) return psi;
  std::vector<MatrixEntry> entries;
  std::vector<Real> b(static_cast<std::size_t>(n), 0.0);
  const SuctionBand law{band};
  Real weight = 0.0;
  for (const FlowPlace& place : water.soil.places) {
    const auto& nodes = mesh.cells[place.cell];
    if (unknown[nodes[0]] < 0) continue;
    Vec<2> gradient{0.0, 0.0};
    Real head = 0.0;
    for (int i = 0; i < 4; ++i) {
      head += place.shape[i] * heads[nodes[i]];
      for (int d = 0; d < 2; ++d) gradient[d] += place.gradient[i][d] * heads[nodes[i]];
    }
    const Vec<2> flux = place.k.times(gradient);
    const Real k_r = place.is_soil ? law.relative_permeability(head - place.x[1]) : 1.0;
    const Vec<2> q{-k_r * flux[0], -k_r * flux[1]};
    for (int i = 0; i < 4; ++i) {
      // q = (d psi/dy, -d psi/dx)
      b[unknown[nodes[i]]] += place.weight * (place.gradient[i][1] * q[0] - place.gradient[i][0] * q[1]);
      for (int j = 0; j < 4; ++j)
        if (unknown[nodes[i]] >= unknown[nodes[j]])
          entries.push_back(
              {unknown[nodes[i]], unknown[nodes[j]], place.weight * dot(place.gradient[i], place.gradient[j])});
    }
    weight += place.weight;
  }
  for (Index i = 0; i < n; ++i) entries.push_back({i, i, 1e-12 * weight});  // up to a constant, near zero in the mean
  const SparseCholesky factor(n, entries);
  if (!factor.is_factored()) return psi;
  factor.solve(b, b);
  for (std::size_t i = 0; i < psi.size(); ++i)
    if (unknown[i] >= 0) psi[i] = b[unknown[i]];
  return psi;
}

std::vector<Side> lines_of_equal(const Mesh<2>& mesh, const SeepageSection& section, const ComputedWater& water,
    std::span<const Real> values, Real step)
{
  std::vector<Side> lines;
  if (!(step > 0.0)) return lines;
  const auto is_wet_soil = [&](Vec<2> x) {
    return section.soil_at(x) && head_at(mesh, water.flow.heads, x).value_or(x[1]) > x[1];
  };
  constexpr int parts = 4;  // of a piece that may leave the wet soil
  std::vector<char> has_soil(mesh.cells.size(), 0);
  for (const FlowPlace& place : water.soil.places)
    if (place.is_soil) has_soil[place.cell] = 1;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    if (!has_soil[cell]) continue;
    const auto& nodes = mesh.cells[cell];
    if (!std::ranges::all_of(nodes, [&](Index i) { return water.flow.has_flow[i] != 0; })) continue;
    const auto corners = mesh.corners(cell);
    const auto [low, high] =
        std::ranges::minmax({values[nodes[0]], values[nodes[1]], values[nodes[2]], values[nodes[3]]});
    if (!(high - low < 1e3 * step)) continue;
    for (Real level = std::ceil(low / step) * step; level < high; level += step) {
      std::vector<Vec<2>> crossings;
      for (int s = 0; s < 4; ++s) {
        const Real a = values[nodes[s]] - level, b = values[nodes[(s + 1) % 4]] - level;
        if ((a < 0.0) != (b < 0.0)) crossings.push_back(between(corners[s], corners[(s + 1) % 4], a / (a - b)));
      }
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        for (int part = 0; part < parts; ++part) {
          const Vec<2> a = between(crossings[k], crossings[k + 1], static_cast<Real>(part) / parts),
                       b = between(crossings[k], crossings[k + 1], static_cast<Real>(part + 1) / parts);
          if (is_wet_soil(between(a, b, 0.5))) lines.push_back({a, b});
        }
    }
  }
  return lines;
}

}  // namespace terp
