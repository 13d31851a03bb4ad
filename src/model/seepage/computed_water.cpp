// The heads of a situation become its formula, so that all that asks for the pressure at a place takes them as those of
// a grid; its phreatic line is the table of that water. Nodes beside the soil have the level of the free water there,
// or no pressure.

#include "model/seepage/computed_water.hpp"

#include "math/errors.hpp"
#include "math/interpolate.hpp"
#include "math/plane.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/ground/ground_section.hpp"
#include "model/parts/stage_case.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real no_level = -std::numeric_limits<Real>::infinity();
constexpr Real below_ground = 1e-3;  // of a cell: a table at bare ground stands this much lower, or it were free water

/// Which edges the river wets: open ones that hang together with its end of the soil by places below its level, as far
/// as no wall stands there above its level.
std::vector<char> edges_in_river(const SeepageSection& section, const RiverCase& river)
{
  const std::vector<SoilEdge>& edges = section.edges;
  const bool from_left = river.side == SectionSide::left;
  Real end = from_left ? std::numeric_limits<Real>::infinity() : no_level;
  for (const SoilEdge& edge : edges)
    for (const Vec<2>& x : {edge.a, edge.b})
      if (edge.is_open && x[1] < river.level) end = from_left ? std::min(end, x[0]) : std::max(end, x[0]);
  const Real near = 1e-2 * section.cell;  // as a gap that is none
  const auto is_below = [&](Vec<2> x) { return x[1] < river.level; };
  const auto is_walled = [&](Vec<2> x) {
    return std::ranges::any_of(section.walls, [&](const Side& wall) {
      return std::max(wall.a[1], wall.b[1]) >= river.level && distance_to_line(wall.a, wall.b, x) < near;
    });
  };
  std::vector<char> wet(edges.size(), 0);
  std::vector<std::size_t> next;
  const auto enter = [&](std::size_t e) {
    if (!wet[e] && edges[e].is_open) wet[e] = 1, next.push_back(e);
  };
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const Vec<2>& x : {edges[e].a, edges[e].b})
      if (std::abs(x[0] - end) < near && is_below(x)) enter(e);
  while (!next.empty()) {
    const SoilEdge& from = edges[next.back()];
    next.pop_back();
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const Vec<2>& x : {from.a, from.b})
        for (const Vec<2>& y : {edges[e].a, edges[e].b})
          if (is_below(x) && distance(x, y) < near && !is_walled(x)) enter(e);
  }
  return wet;
}

/// To where the river reaches: the wet place that lies furthest from its side.
Real end_of_river(const SeepageSection& section, const RiverCase& river, const std::vector<char>& wet)
{
  const bool from_left = river.side == SectionSide::left;
  Real end = from_left ? no_level : std::numeric_limits<Real>::infinity();
  for (std::size_t e = 0; e < section.edges.size(); ++e) {
    if (!wet[e]) continue;
    Vec<2> a = section.edges[e].a, b = section.edges[e].b;
    if (a[1] > b[1]) std::swap(a, b);
    if (a[1] >= river.level) continue;
    const Real x = b[1] <= river.level ? b[0] : std::lerp(a[0], b[0], (river.level - a[1]) / (b[1] - a[1]));
    for (const Real at : {a[0], x}) end = from_left ? std::max(end, at) : std::min(end, at);
  }
  return end;
}

/// Shares at which a piece of the surface is parted, with 0 and 1.
std::vector<Real> parted(const SoilEdge& edge, std::span<const Real> at_x, std::span<const Real> at_y)
{
  std::vector<Real> shares{0.0, 1.0};
  const auto enter = [&](Real a, Real b, Real at) {
    if ((a - at) * (b - at) < 0.0) shares.push_back((at - a) / (b - a));
  };
  for (const Real x : at_x) enter(edge.a[0], edge.b[0], x);
  for (const Real y : at_y) enter(edge.a[1], edge.b[1], y);
  std::ranges::sort(shares);
  return shares;
}

template <class Use>
void for_each_part(const SoilEdge& edge, std::span<const Real> at_x, std::span<const Real> at_y, Use&& use)
{
  const std::vector<Real> shares = parted(edge, at_x, at_y);
  for (std::size_t k = 0; k + 1 < shares.size(); ++k)
    if (shares[k + 1] > shares[k]) use(part_of(edge, shares[k], shares[k + 1]));
}

Vec<2> middle_of(const SoilEdge& edge) { return {0.5 * (edge.a[0] + edge.b[0]), 0.5 * (edge.a[1] + edge.b[1])}; }

EdgeKind kind_of(SectionSide side)
{
  return side == SectionSide::left ? EdgeKind::left : side == SectionSide::right ? EdgeKind::right : EdgeKind::base;
}

}  // namespace

Real ground_over(const SeepageSection& section, Real x)
{
  Real ground = no_level;
  for (const SoilEdge& edge : section.edges) {
    const Real low = std::min(edge.a[0], edge.b[0]), high = std::max(edge.a[0], edge.b[0]);
    if (x < low || x > high) continue;
    const Real t = high > low ? (x - edge.a[0]) / (edge.b[0] - edge.a[0]) : 0.0;
    ground = std::max(ground, high > low ? std::lerp(edge.a[1], edge.b[1], t) : std::max(edge.a[1], edge.b[1]));
  }
  return ground;
}

std::optional<std::size_t> SeepageSection::soil_at(Vec<2> x) const
{
  for (std::size_t b = sides.size(); b-- > 0;)  // the last one lies on top
    if (encloses(sides[b], x)) return b;
  return std::nullopt;
}

SeepageSection seepage_section(const Case& whole, const SharedMesh& mesh)
{
  const Case& start = case_of_stage(whole, 0);
  std::vector<Problem> problems;
  SeepageSection section;
  for (const WallCase& wall : whole.water.walls)
    for (std::size_t k = 0; k + 1 < wall.line.size(); ++k) section.walls.push_back({wall.line[k], wall.line[k + 1]});
  const std::vector<BodyOutline> outlines = outlines_of(start, *mesh);
  const std::vector<MaterialCase>& materials = start.materials;
  std::vector<std::string> missing;
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const BodyCase& body = start.bodies[b];
    if (!body.is_there) continue;
    if (!body.points_file.empty()) {
      problems.push_back({fmt::format("body[{}].points", b), "computed water needs the outline of every body",
          "Give the body as box, polygon or region, or the water as lines.", "water.model", false, {"water.model"}});
      continue;
    }
    const auto material = std::ranges::find(materials, body.material, &MaterialCase::called);
    if (material == materials.end()) continue;  // reported elsewhere
    if (!material->permeability.is_given()) {
      if (std::ranges::find(missing, body.material) == missing.end()) missing.push_back(body.material);
      continue;
    }
    section.outlines.push_back(outlines[b]);
    section.materials.push_back({material->permeability, material->storage});
  }
  for (const std::string& name : missing)
    problems.push_back({"material." + name, fmt::format("`{}` has no permeability", name),
        "Computed water flows through every soil. Give permeability = \"1 m/d\": clay 1e-5 to 1e-3 m/d, sand 1 to 100 "
        "m/d\n(1e-10 to 1e-8 and 1e-5 to 1e-3 m/s).",
        "material.permeability", false, {"water.model"}});
  if (!problems.empty()) throw InputError(std::move(problems));
  for (const BodyOutline& outline : section.outlines) section.sides.push_back(outline_sides(*mesh, outline));
  section.walled = with_walls(mesh, whole.water.walls, [&](Vec<2> x) { return section.soil_at(x).has_value(); });
  section.edges = surface_of(*mesh, section.outlines, section.walls);
  section.left = std::numeric_limits<Real>::infinity(), section.right = no_level;
  for (const SoilEdge& edge : section.edges)
    for (const Vec<2>& x : {edge.a, edge.b})
      section.left = std::min(section.left, x[0]), section.right = std::max(section.right, x[0]);
  section.cell = columns_of_section(*mesh).width;
  return section;
}

FreeWaterLevels::FreeWaterLevels(const SeepageSection& section, const SeepageCase& of)
{
  Index part = 1;
  if (of.river) {
    in_river_ = edges_in_river(section, *of.river);
    const Real end = end_of_river(section, *of.river, in_river_);
    constexpr Real far = std::numeric_limits<Real>::infinity();
    stretches_.push_back(of.river->side == SectionSide::left ? Stretch{-far, end, of.river->level, part}
                                                             : Stretch{end, far, of.river->level, part});
    ++part;
  }
  for (const PondCase& pond : of.ponds) stretches_.push_back({pond.from, pond.to, pond.level, part++});
}

const FreeWaterLevels::Stretch* FreeWaterLevels::on(std::size_t edge, Vec<2> x) const
{
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    const Stretch& stretch = stretches_[k];
    if (x[1] >= stretch.level) continue;
    const bool is_river = k == 0 && !in_river_.empty();
    if (is_river ? in_river_[edge] != 0 : x[0] >= stretch.from && x[0] <= stretch.to) return &stretch;
  }
  return nullptr;
}

Real FreeWaterLevels::level_over(Real x) const
{
  for (const Stretch& stretch : stretches_)
    if (x >= stretch.from && x <= stretch.to) return stretch.level;
  return no_level;
}

SeepageCase between(const SeepageCase& from, const SeepageCase& to, Real share)
{
  SeepageCase now = to;
  const auto run = [share](Real a, Real& b) { b = std::lerp(a, b, share); };
  if (from.river && now.river && from.river->side == now.river->side) run(from.river->level, now.river->level);
  if (from.ponds.size() == now.ponds.size())
    for (std::size_t k = 0; k < now.ponds.size(); ++k)
      if (from.ponds[k].from == now.ponds[k].from && from.ponds[k].to == now.ponds[k].to)
        run(from.ponds[k].level, now.ponds[k].level);
  if (from.boundary.size() == now.boundary.size())
    for (std::size_t k = 0; k < now.boundary.size(); ++k) {
      const SideHead& a = from.boundary[k];
      SideHead& b = now.boundary[k];
      if (a.side != b.side || a.from != b.from || a.to != b.to || a.head.size() != b.head.size()) continue;
      for (std::size_t i = 0; i < b.head.size(); ++i) run(a.head[i][1], b.head[i][1]);
    }
  return now;
}

std::vector<std::string> names_of_parts(const SeepageCase& of)
{
  std::vector<std::string> names{"seepage faces"};
  if (of.river) names.push_back("river");
  for (std::size_t k = 0; k < of.ponds.size(); ++k)
    names.push_back(of.ponds[k].name.empty() ? fmt::format("pond {}", k + 1) : of.ponds[k].name);
  for (std::size_t k = 0; k < of.boundary.size(); ++k)
    names.push_back(of.boundary[k].name.empty() ? fmt::format("boundary {}", k + 1) : of.boundary[k].name);
  return names;
}

std::vector<SurfacePlace> side_conditions(
    const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of, const std::string& path)
{
  std::vector<SurfacePlace> places;
  Index number = 1 + (of.river ? 1 : 0) + static_cast<Index>(of.ponds.size());
  for (std::size_t k = 0; k < of.boundary.size(); ++k, ++number) {
    const SideHead& side = of.boundary[k];
    const bool is_base = side.side == SectionSide::bottom;
    const std::array limits{side.from, side.to};
    const std::size_t before = places.size();
    for (const SoilEdge& edge : section.edges) {
      if (edge.kind != kind_of(side.side)) continue;
      const auto add = [&](const SoilEdge& part) {
        const Real at = middle_of(part)[is_base ? 0 : 1];
        if (!(at > side.from && at < side.to)) return;
        add_places(mesh, part,
            {side.leakage_length > 0.0 ? FlowCondition::leak : FlowCondition::head, side.head[0][1],
                side.leakage_length, number},
            places);
      };
      is_base ? for_each_part(edge, limits, {}, add) : for_each_part(edge, {}, limits, add);
    }
    if (places.size() == before)
      throw InputError(Problem{fmt::format("{}.boundary[{}]", path, k), "no soil lies at this part of the side",
          is_base ? "At the bottom from and to are x, in m. Leave them out for the whole bottom."
                  : "At the left and the right side from and to are elevations, in m.",
          "water.boundary"});
    if (is_base)
      for (std::size_t q = before; q < places.size(); ++q) places[q].head = interpolate(side.head, places[q].x[0]);
  }
  return places;
}

/// A pond lies on ground, and not where the river is.
static void check_ponds(
    const SeepageSection& section, const SeepageCase& of, const FreeWaterLevels& free, const std::string& path)
{
  for (std::size_t k = 0; k < of.ponds.size(); ++k) {
    const PondCase& pond = of.ponds[k];
    const std::string key = fmt::format("{}.ponds[{}]", path, k);
    if (pond.to < section.left || pond.from > section.right)
      throw InputError(Problem{key, "no ground lies where the pond is",
          fmt::format("It lies from {:g} to {:g} m, the soil from {:g} to {:g} m.", pond.from, pond.to, section.left,
              section.right),
          "water.ponds"});
    if (!of.river) continue;
    const auto& river = free.stretches()[0];
    if (pond.from < river.to && pond.to > river.from && pond.level < river.level)
      throw InputError(Problem{key, "the pond lies in the river",
          fmt::format("The river stands at {:g} m there, the pond at {:g} m. Two levels cannot be at one place.",
              river.level, pond.level),
          "water.ponds", false, {path + ".river"}});
  }
}

std::vector<SurfacePlace> surface_conditions(
    const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of, const std::string& path)
{
  const FreeWaterLevels free(section, of);
  std::vector<SurfacePlace> places;
  std::vector<Real> ends, levels;
  for (const FreeWaterLevels::Stretch& stretch : free.stretches()) {
    ends.insert(ends.end(), {stretch.from, stretch.to});
    levels.push_back(stretch.level);
  }
  const auto has_head = [&](const SoilEdge& part) {
    const Vec<2> x = middle_of(part);
    return std::ranges::any_of(of.boundary,
        [&](const SideHead& side) { return kind_of(side.side) == part.kind && x[1] > side.from && x[1] < side.to; });
  };
  for (const SideHead& side : of.boundary) levels.insert(levels.end(), {side.from, side.to});
  for (std::size_t e = 0; e < section.edges.size(); ++e)
    if (section.edges[e].is_open)
      for_each_part(section.edges[e], ends, levels, [&](const SoilEdge& part) {
        if (has_head(part)) return;
        EdgeCondition condition;
        if (const FreeWaterLevels::Stretch* water = free.on(e, middle_of(part)))
          condition = {FlowCondition::head, water->level, 0.0, water->part};
        add_places(mesh, part, condition, places);
      });
  check_ponds(section, of, free, path);
  const std::vector<SurfacePlace> sides = side_conditions(mesh, section, of, path);
  places.insert(places.end(), sides.begin(), sides.end());
  return places;
}

Real suction_band_of(const WaterCase& water, const SeepageSection& section)
{
  return water.suction_band > 0.0 ? water.suction_band : 0.5 * section.cell;
}

std::vector<Vec<2>> table_of(
    const Mesh<2>& mesh, const SeepageSection& section, const FreeWaterLevels& free, std::span<const Real> heads)
{
  const Real left = section.left, right = section.right;
  Real base = std::numeric_limits<Real>::infinity();
  std::vector<Real> xs;
  for (const SoilEdge& edge : section.edges)
    for (const Vec<2>& x : {edge.a, edge.b}) {
      base = std::min(base, x[1]);
      if (edge.is_open) xs.push_back(x[0]);
    }
  const Real step = 0.5 * section.cell;
  for (int k = 0; left + k * step < right; ++k) xs.push_back(left + k * step);
  for (const FreeWaterLevels::Stretch& stretch : free.stretches())
    for (const Real x : {stretch.from, stretch.to})
      if (x > left && x < right) xs.push_back(x);
  xs.push_back(right);
  std::ranges::sort(xs);
  std::vector<Vec<2>> table;
  for (const Real x : xs) {
    if (!table.empty() && x < table.back()[0] + 1e-6 * section.cell) continue;
    const Real ground = ground_over(section, x), level = free.level_over(x);
    if (ground == no_level) continue;
    if (level > ground) {
      table.push_back({x, level});
      continue;
    }
    const Real fine = 0.125 * section.cell, highest = ground - below_ground * section.cell;
    Real found = base, above = ground, psi_above = -1.0;
    for (Real y = highest; y > base; y -= fine) {
      const Real psi = head_at(mesh, heads, {x, y}).value_or(y) - y;
      if (psi > 0.0) {
        found = y >= highest ? highest : y + (above - y) * psi / (psi - psi_above);
        break;
      }
      above = y, psi_above = psi;
    }
    table.push_back({x, std::min(found, highest)});
  }
  // Free water beside soil that ends in the mesh.
  const auto beside = [&](Real x) { return free.level_over(x) == no_level ? base : free.level_over(x); };
  const auto [low, high] = std::ranges::minmax(mesh.nodes, {}, [](const Vec<2>& x) { return x[0]; });
  if (low[0] < left - step) table.insert(table.begin(), {left, beside(left - step)});
  if (high[0] > right + step) table.push_back({right, beside(right + step)});
  return table;
}

ComputedWater compute_water(const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of,
    const WaterOptions& given, const std::string& path)
{
  ComputedWater water;
  water.soil = make_flow_soil(
      mesh, section.outlines, section.materials, surface_conditions(mesh, section, of, path), given.stores);
  FlowOptions options;
  options.band.width = given.band;
  const std::vector<std::string> names = names_of_parts(of);
  water.flow = find_flow(
      mesh, water.soil, names.size(), options, given.step ? given.step->heads : std::span<const Real>(), given.step);
  const FlowResult& flow = water.flow;
  if (!flow.counts) {
    std::string flows;
    for (std::size_t k = 0; k < names.size(); ++k)
      flows += fmt::format("{}{} {:.3g}", k > 0 ? ", " : "", names[k], flow.outflow[k]);
    throw InputError(Problem{path, "the flow of the water was not found",
        fmt::format(
            "After {} iterations heads still change by {:.2g} of the height of the soil, and {:.2g} of the flow "
            "is out of balance.\nOut of the soil, in m2/s: {}. Give a wider water.suction_band; it is {:.3g} m.",
            flow.iterations, flow.change, flow.imbalance, flows, given.band),
        "water.suction_band", false, {"water"}});
  }
  const FreeWaterLevels free(section, of);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Real level = free.level_over(mesh.nodes[i][0]);
    if (!flow.has_flow[i] && level > mesh.nodes[i][1]) water.flow.heads[i] = level;
  }
  water.table = table_of(mesh, section, free, flow.heads);
  return water;
}

void set_computed(WaterSituation& situation, const SeepageSection& section, const ComputedWater& water)
{
  situation.phreatic_line = water.table;
  const std::vector<Real> joined = section.walled.joined(water.flow.heads);
  std::vector<std::pair<Vec<2>, Real>> along_walls;  // the soil there has one head
  for (const Index node : section.walled.twins)
    along_walls.emplace_back(section.walled.mesh->nodes[node], joined[static_cast<std::size_t>(node)]);
  situation.formula = [along_walls, mesh = section.walled.mesh,
                          heads = std::make_shared<const std::vector<Real>>(water.flow.heads)](Vec<2> x, Real) {
    const auto at_wall = std::ranges::find(along_walls, x, &std::pair<Vec<2>, Real>::first);
    return at_wall != along_walls.end() ? at_wall->second : head_at(*mesh, *heads, x).value_or(x[1]);
  };
  situation.formula_gives_head = true;
  situation.formula_text = "computed";
}

/// The cases of stages and ground of a case have the water of the case.
static void take_over(const WaterCase& water, Case& of)
{
  const auto changed = [&](const std::shared_ptr<const Case>& inner) {
    auto other = std::make_shared<Case>(*inner);
    other->water.start = water.start;
    other->water.situations = water.situations;
    take_over(water, *other);
    return other;
  };
  for (StageCase& stage : of.stages) stage.changed = changed(stage.changed);
  if (of.ground_of) of.ground_of = changed(of.ground_of);
}

Case with_computed_water(const Case& whole, const SharedMesh& mesh)
{
  Case solved = whole;
  if (whole.water.kind != WaterKind::seepage) return solved;
  std::optional<SeepageSection> section;
  const auto solve = [&](WaterSituation& situation, const std::string& path) {
    if (situation.formula) return;  // it was
    if (!section) section = seepage_section(whole, mesh);
    set_computed(situation, *section,
        compute_water(*section->walled.mesh, *section, situation.seepage,
            {.band = suction_band_of(whole.water, *section)}, path));
  };
  solve(solved.water.start, "water");
  for (std::size_t k = 0; k < solved.water.situations.size(); ++k) {
    WaterSituation& situation = solved.water.situations[k];
    if (situation.seepage == whole.water.start.seepage) {
      const std::string name = situation.name;
      const Real time = situation.time;
      situation = solved.water.start;
      situation.name = name, situation.time = time;
    } else {
      solve(situation, fmt::format("water.situation[{}]", k));
    }
  }
  take_over(solved.water, solved);
  return solved;
}

}  // namespace terp
