// One entry of the table per limit: what to look for, and where docs/limits.md says more. A limit stands here only
// where the case shows it and its user can do something about it.

#include "run/findings/limit_warnings.hpp"

#include "model/meshes/setup_mesh.hpp"
#include "model/parts/reduce.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/water/free_water.hpp"
#include "model/water/water_pressure.hpp"
#include "run/findings/thin_layers.hpp"
#include "run/findings/weak_borders.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Index fewest_points = 3;      // along a side of a cell: with 2 x 2 soil that flows leaves gaps in its cells
constexpr Real fewest_in_layer = 2.0;   // cells across a layer: one takes 1.35 times its strength and more, two 1.05
constexpr Real fewest_in_cover = 8.0;   // two reach a fifth of the speed, four 0.6, eight 0.86 of it
constexpr Real much_at_the_top = 10e3;  // what a row of cells carries more than the top of the soil [N per m]
constexpr Real level = 0.05;            // share of gravity along a cover that does not slide, some 3 degrees
constexpr Real fewest_below_footing = 8.0;  // cells over the width: with eight the load is 13 % too large

using Problems = std::vector<Problem>;

bool softens_or_flows(const SoilMaterial& soil)
{
  const bool yields = row_of(soil, Role::plastic_strain) >= 0;
  return yields ? std::isfinite(soil.law->softened_strain()) : soil.law->shear_modulus() == 0.0;
}

/// Soil that softens or flows goes far when it fails.
void find_few_points(const Model& model, const State&, Problems& found)
{
  const std::vector<BodyCase>& bodies = model.description.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto [nx, ny] = bodies[b].points_per_cell;
    if (std::min(nx, ny) >= fewest_points || !bodies[b].points_file.empty()) continue;
    const auto is_it = [&](const SoilMaterial& soil) {
      return soil.name == bodies[b].material && softens_or_flows(soil);
    };
    const auto has_far_more = [n = nx * ny](const BodyCase& other) {
      return other.points_file.empty() && other.points_per_cell[0] * other.points_per_cell[1] > 8 * n;
    };
    const bool flows = std::ranges::any_of(model.materials, is_it);
    if (!flows && std::ranges::none_of(bodies, has_far_more)) continue;
    found.push_back({fmt::format("body[{}].points_per_cell", b),
        fmt::format("{} has few points per cell {}", called(bodies[b], b),
            flows ? "for soil that flows" : "beside another body"),
        fmt::format("Got {} x {}. Where it flows far, points leave gaps in their cells, and it comes farther than with "
                    "more. Give 3 or 4.",
            nx, ny),
        "body.points_per_cell"});
  }
}

/// Of layers in cells that have one strain another warning speaks (shared_cells.cpp).
void find_thin_layers(const Model& model, const State& state, Problems& found)
{
  for (const ThinLayer& layer : find_layers(model, state)) {
    const Real fewest = layer.at_surface ? fewest_in_cover : fewest_in_layer;
    const bool slides = layer.at_surface ? layer.driving > level : model.with.slip != nullptr;
    if (!slides || !(layer.cells() < fewest * (1.0 - 1e-6))) continue;
    const std::string& name = model.materials[layer.material].name;
    found.push_back({fmt::format("material.\"{}\"", name),
        fmt::format("`{}` is a {} stronger soil, {:.2g} m thick on cells of {:.2g} m", name,
            layer.at_surface ? "cover on" : "layer in", layer.thickness, layer.cell),
        fmt::format("{} Give cells of at most {:.2g} m.",
            layer.at_surface
                ? "Such a cover slides too slowly, or not at all: two cells take some 1.5 times its strength."
                : "Slip along it takes more than its strength, above all where it lies askew to the cells.",
            layer.thickness / fewest),
        "mesh", false, {"mesh.cell", "mesh"}});
  }
}

void find_narrow_footings(const Model& model, const State&, Problems& found)
{
  const Real cell = typical_cell_size(*model.mesh);
  const auto [from, to] = extent_in_x(*model.mesh);
  for (std::size_t k = 0; k < model.description.footings.size(); ++k) {
    const FootingCase& footing = model.description.footings[k];
    const bool is_half = footing.low[0] <= from || footing.high[0] >= to;  // beyond the side is the other half
    const Real width = (footing.high[0] - footing.low[0]) * (is_half ? 2.0 : 1.0), cells = width / cell;
    if (!(footing.velocity[1] < 0.0) || !(cells < fewest_below_footing * (1.0 - 1e-6))) continue;
    found.push_back(
        {fmt::format("footing[{}].box", k), fmt::format("the footing `{}` is {:.2g} cells wide", footing.name, cells),
            fmt::format("Its load comes out some {:.0f} % too large. Give cells of at most {:.2g} m below it.",
                100.0 / cells, width / fewest_below_footing),
            "footing", false, {"mesh.cell", "mesh"}});
  }
}

/// A limit of tension that acts at no point, of soil that varies; of numbers the case file is asked.
void find_idle_cutoffs(const Model& model, const State& state, Problems& found)
{
  const Case& c = model.description;
  const Overburden overburden(model);
  std::vector<Real> cutoff(c.materials.size(), 0.0), most(c.materials.size(), 0.0);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto m = static_cast<std::size_t>(block.material);
    const MaterialCase& material = c.materials[m];
    const MaterialType* law = material.type();
    if (material.fields.empty() || law == nullptr || cutoff[m] < 0.0) return;
    const auto k = std::ranges::find(law->parameters, tension_cutoff, &ParameterInfo::name) - law->parameters.begin();
    if (k == std::ssize(law->parameters)) return;
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const std::vector<Real> values = parameters_at(material, *law, {x, &overburden});
    const Real limit = values[static_cast<std::size_t>(k)], here = largest_tension(*law, values);
    const bool acts = std::isinf(limit) || limit <= here;
    cutoff[m] = acts ? -1.0 : std::max(cutoff[m], limit), most[m] = std::max(most[m], here);
  });
  for (std::size_t m = 0; m < cutoff.size(); ++m)
    if (cutoff[m] > 0.0) found.push_back(idle_cutoff(c.materials[m], cutoff[m], most[m]));
}

/// Where slip along the top of an aquifer takes more than the soil carries, in the water that makes it worst.
void find_weak_tops(const Model& model, const State&, Problems& found)
{
  const Case& whole = model.whole();
  const Real row = typical_cell_size(*model.mesh);
  const auto most = [row](const std::vector<WeakBorder>& borders) {
    Real largest = 0.0;
    for (const WeakBorder& border : borders) largest = std::max(largest, border.carried_more(row));
    return largest;
  };
  std::vector<WeakBorder> worst;
  for (const std::size_t number : situations_asked_for(whole, whole.stages.size()))
    if (auto borders = find_weak_borders(model, situation_of(whole.water, number), row); most(borders) > most(worst))
      worst = std::move(borders);
  for (const WeakBorder& border : worst) {
    const Real more = border.carried_more(row);
    if (!(more > much_at_the_top)) continue;
    Real enough = row;
    while (border.carried_more(enough) > much_at_the_top) enough *= 0.99;
    const std::string& name = model.materials[border.material].name;
    found.push_back({fmt::format("material.\"{}\"", name),
        fmt::format("a row of cells carries {:.0f} kN/m more than the top of `{}`, x = {:.4g} to {:.4g} m", more / 1e3,
            name, border.from(), border.to()),
        fmt::format("Water pushes from below there, so that the soil slides in its upper centimetres, and cells of "
                    "{:.2g} m see it\nstronger. Draw a film as `terp import` does, or give cells of {:.2g} m, which "
                    "carry {:.0f} kN/m more.",
            row, enough, much_at_the_top / 1e3),
        "mesh", false, {"mesh.cell", "mesh"}});
  }
}

struct KnownLimit {
  const char* section;  ///< of docs/limits.md
  void (*find)(const Model&, const State&, Problems& found);
};

constexpr KnownLimit known_limits[] = {
    {"docs/limits.md#12-few-points-per-cell", find_few_points},
    {"docs/limits.md#4-a-mesh-carries-more-than-the-soil", find_thin_layers},
    {"docs/limits.md#4-a-mesh-carries-more-than-the-soil", find_weak_tops},
    {"docs/limits.md#8-sides-contact-and-footings", find_narrow_footings},
    {"docs/stability.md#what-is-reduced", find_idle_cutoffs},
};

}  // namespace

void find_known_limits(const Model& model, const State& state, Problems& warnings)
{
  for (const KnownLimit& limit : known_limits) {
    Problems found;
    limit.find(model, state, found);
    for (Problem& problem : found) {
      problem.detail += fmt::format("\nMore: {}", limit.section);
      warnings.push_back(std::move(problem));
    }
  }
}

}  // namespace terp
