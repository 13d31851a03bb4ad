// What speaks against computed water: levels that touch no soil, aquifers whose side has no condition, thin layers.

#include "model/seepage/computed_water.hpp"
#include "model/water/water_pressure.hpp"
#include "mpm/mesh/mesh.hpp"
#include "run/findings/water_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real aquifer_over_cover = 100.0;  // ratio of permeabilities from which on a layer leads the water
constexpr Real slow_soil = 1e-5;            // [m/s] drained soil below it keeps its water in a slide
constexpr Real cells_in_layer = 4.0;

std::string path_of_situation(std::size_t number)
{
  return number == 0 ? "water" : fmt::format("water.situation[{}]", number - 1);
}

/// Low and high end of the edges of a kind [m]; NaN: there is none.
std::array<Real, 2> heights_of(const SeepageSection& section, EdgeKind kind)
{
  std::array<Real, 2> range{INFINITY, -INFINITY};
  for (const SoilEdge& edge : section.edges)
    if (edge.kind == kind)
      for (const Vec<2>& x : {edge.a, edge.b}) range = {std::min(range[0], x[1]), std::max(range[1], x[1])};
  return range;
}

/// Highest place of a wall at an x [m]; minus infinity: none stands there.
Real wall_at(const SeepageSection& section, Real x)
{
  Real top = -std::numeric_limits<Real>::infinity();
  for (const Side& wall : section.walls)
    if (std::min(wall.a[0], wall.b[0]) <= x && x <= std::max(wall.a[0], wall.b[0]))
      top = std::max({top, wall.a[1], wall.b[1]});
  return top;
}

/// Free water that ends over ground which lies below its level would run off, if no wall holds it.
void find_open_end(
    const SeepageSection& section, const PondCase& pond, const std::string& key, std::vector<Problem>& warnings)
{
  constexpr Real little = 0.05;  // of levels that are drawn by hand [m]
  for (const Real x : {pond.from, pond.to}) {
    const Real ground = std::max(ground_over(section, x), wall_at(section, x));
    const bool is_end = x < section.left + section.cell || x > section.right - section.cell;
    if (is_end || !std::isfinite(ground) || pond.level <= ground + little) continue;
    warnings.push_back({key, "the pond ends where the ground lies below its level",
        fmt::format(
            "Its level is {:g} m, the ground at its end x = {:g} m lies at {:.4g} m: the water would run off. Lower "
            "it, or let\nthe pond reach to where the ground meets its level.",
            pond.level, x, ground),
        "water.ponds"});
    return;
  }
}

void find_odd_levels(
    const SeepageSection& section, const WaterSituation& of, std::size_t number, std::vector<Problem>& warnings)
{
  const std::string path = path_of_situation(number);
  if (const auto& river = of.seepage.river) {
    const EdgeKind kind = river->side == SectionSide::left ? EdgeKind::left : EdgeKind::right;
    const Real end = river->side == SectionSide::left ? section.left : section.right;
    const Real ground = ground_over(section, end), from_end = heights_of(section, kind)[1];
    if (river->level < std::max(ground, from_end) - 1e-9)
      warnings.push_back({path + ".river", "the river lies below the ground at its side",
          fmt::format("Its level is {:g} m, the ground there {:.4g} m. No water stands on the soil; give the head of "
                      "the soil in `boundary`.",
              river->level, std::max(ground, from_end)),
          "water.river"});
  }
  for (std::size_t k = 0; k < of.seepage.ponds.size(); ++k) {
    const PondCase& pond = of.seepage.ponds[k];
    Real lowest = INFINITY;
    for (int i = 0; i <= 50; ++i)
      if (const Real y = ground_over(section, std::lerp(pond.from, pond.to, i / 50.0)); std::isfinite(y))
        lowest = std::min(lowest, y);
    if (pond.level > lowest) {
      find_open_end(section, pond, fmt::format("{}.ponds[{}]", path, k), warnings);
      continue;
    }
    warnings.push_back({fmt::format("{}.ponds[{}]", path, k), "the pond holds no water",
        fmt::format("Its level is {:g} m, the lowest ground from {:g} to {:g} m {:.4g} m. Raise it, or leave it out: "
                    "bare ground is a seepage face.",
            pond.level, pond.from, pond.to, lowest),
        "water.ponds"});
  }
  for (std::size_t k = 0; k < of.seepage.boundary.size(); ++k) {
    const SideHead& head = of.seepage.boundary[k];
    const Real thickness = head.to - head.from;
    if (head.side != SectionSide::bottom && std::isfinite(thickness) && head.head[0][1] < head.from)
      warnings.push_back({fmt::format("{}.boundary[{}]", path, k), "the head lies below the layer in which it acts",
          fmt::format("It is {:g} m, the layer lies from {:g} to {:g} m: it sucks water out of the soil there. A head "
                      "is the elevation in m\nto which the water of the layer rises, in the frame of the mesh.",
              head.head[0][1], head.from, head.to),
          "water.boundary"});
    if (head.side == SectionSide::bottom || !(head.leakage_length > 0.0) || !std::isfinite(thickness)) continue;
    constexpr Real most = 1000.0;  // of the width of the section
    if (const Real width = section.right - section.left; head.leakage_length > most * width)
      warnings.push_back({fmt::format("{}.boundary[{}]", path, k), "the leakage length lets no water through",
          fmt::format("Got {:g} m beside a section of {:.4g} m: its head does nothing. It is sqrt(k D c) in m, usually "
                      "tens to thousands: of the\nlayer with permeability k and thickness D, c the resistance of its "
                      "cover in s.",
              head.leakage_length, width),
          "water.boundary"});
    if (head.leakage_length >= thickness) continue;
    warnings.push_back(
        {fmt::format("{}.boundary[{}]", path, k), "the leakage length is shorter than the layer is thick",
            fmt::format("Got {:g} m for a layer of {:.4g} m. It is sqrt(k D c) in m, usually tens to thousands: of the "
                        "layer with\npermeability k and thickness D, c the resistance of its cover.",
                head.leakage_length, thickness),
            "water.boundary"});
  }
}

/// Layers that lead the water to a side of the section where no head is given.
void find_open_aquifers(
    const SeepageSection& section, const WaterSituation& situation, std::size_t number, std::vector<Problem>& warnings)
{
  Real least = INFINITY;
  for (const FlowMaterial& material : section.materials) least = std::min(least, material.k.horizontal);
  const SeepageCase& of = situation.seepage;
  for (const EdgeKind kind : {EdgeKind::left, EdgeKind::right}) {
    const SectionSide side = kind == EdgeKind::left ? SectionSide::left : SectionSide::right;
    bool is_found = false;  // one of each side
    for (const SoilEdge& edge : section.edges) {
      if (is_found || edge.kind != kind || edge.is_open) continue;
      const Real y = 0.5 * (edge.a[1] + edge.b[1]);
      const auto has_head = [&](const SideHead& head) {
        return head.side == SectionSide::bottom || (head.side == side && y > head.from && y < head.to);
      };
      if (std::ranges::any_of(of.boundary, has_head)) continue;
      const Vec<2> inside{0.5 * (edge.a[0] + edge.b[0]) - 1e-3 * section.cell * edge.normal[0], y};
      const auto soil = section.soil_at(inside);
      if (!soil || section.materials[*soil].k.horizontal < aquifer_over_cover * least) continue;
      const char* name = kind == EdgeKind::left ? "left" : "right";
      warnings.push_back(
          {path_of_situation(number) + ".boundary", fmt::format("an aquifer meets the {} side without a head", name),
              fmt::format("At y = {:.4g} m the soil is {:.0f} times as permeable as its cover, and no water passes its "
                          "side.\nGive {{ side = \"{}\", from = Y, to = Y, head = H, leakage_length = L }} "
                          "(docs/seepage.md).",
                  y, section.materials[*soil].k.horizontal / least, name),
              "water.boundary", true, {"water"}});
      is_found = true;
    }
  }
}

/// A level layer of other soil thinner than some cells, askew in them or not.
void find_thin_layers(const Model& model, const SeepageSection& section, std::vector<Problem>& warnings)
{
  const bool is_along = std::ranges::all_of(
      model.mesh->geometries, [](const CellGeometry<Quad4>& g) { return g.map.affine && g.map.axis_xi[1] == 0.0; });
  for (std::size_t b = 0; b < section.outlines.size(); ++b) {
    const Polygon& polygon = section.outlines[b].polygon;
    if (polygon.size() < 3) continue;
    const BoundingBox box = box_around(polygon);
    const Real thickness = area(section.outlines[b]) / std::max(box.high[0] - box.low[0], 1e-12),
               cells = thickness / section.cell;
    if (box.high[0] - box.low[0] < 4.0 * thickness) continue;  // no layer
    const bool is_thin = cells < 1.0 - 1e-9, is_askew = !is_along && cells < cells_in_layer;
    if (!is_thin && !is_askew) continue;
    warnings.push_back({fmt::format("body[{}]", b), "the layer is thin for the flow of the water",
        fmt::format(
            "It is {:.3g} m thick, cells are {:.3g} m{}. Its flow along it can be wrong by a tenth and more; give "
            "cells of {:.2g} m.",
            thickness, section.cell, is_askew ? " and askew to it" : "", thickness / (is_askew ? cells_in_layer : 2.0)),
        "mesh.cell", false, {"mesh"}});
  }
}

/// Walls at which no node has two heads: the water passes them as if they were not there.
void find_idle_walls(const Case& whole, const SeepageSection& section, std::vector<Problem>& warnings)
{
  const auto lies_on = [&](Index node, const WallCase& wall) {
    const Vec<2> x = section.walled.mesh->nodes[static_cast<std::size_t>(node)];
    for (std::size_t k = 0; k + 1 < wall.line.size(); ++k)
      if (distance_to_line(wall.line[k], wall.line[k + 1], x) < 1e-3 * section.cell) return true;
    return false;
  };
  for (std::size_t w = 0; w < whole.water.walls.size(); ++w) {
    const WallCase& wall = whole.water.walls[w];
    if (std::ranges::any_of(section.walled.twins, [&](Index node) { return lies_on(node, wall); })) continue;
    warnings.push_back({fmt::format("water.walls[{}]", w), "the wall holds back no water",
        "Water passes its ends, and no node of the mesh lies between them with soil on both sides. Let the wall pass "
        "two cells or\nmore in the soil.",
        "water.walls", false, {"mesh"}});
  }
}

void find_slow_drained_soil(const Case& whole, std::vector<Problem>& warnings)
{
  for (const MaterialCase& material : whole.materials) {
    const Permeability& k = material.permeability;
    if (!k.is_given() || k.horizontal >= slow_soil || !material.stores_effective() || material.has_excess_pressure())
      continue;
    warnings.push_back({"material." + material.called() + ".permeability",
        fmt::format("`{}` is drained, and its water cannot leave in a slide", material.name),
        fmt::format("Its permeability is {:.2g} m/s: in ten seconds pressures balance over centimetres. Where it is "
                    "sheared fast,\ngive drainage = \"undrained_effective\" in a stage after the rise of the water.",
            k.horizontal),
        "material.drainage", false, {"material." + material.called()}});
  }
}

}  // namespace

void find_odd_seepage(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  if (whole.water.kind != WaterKind::seepage) return;
  const SeepageSection section = seepage_section(whole, model.mesh);
  for (std::size_t k = 0; k <= whole.water.situations.size(); ++k) {
    const WaterSituation& of = situation_of(whole.water, k);
    find_odd_levels(section, of, k, warnings);
    if (k == 0 || of.seepage.boundary != whole.water.start.seepage.boundary)
      find_open_aquifers(section, of, k, warnings);
  }
  find_thin_layers(model, section, warnings);
  find_idle_walls(whole, section, warnings);
  find_slow_drained_soil(whole, warnings);
}

}  // namespace terp
