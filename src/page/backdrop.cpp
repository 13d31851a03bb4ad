// A line is a flat list x, y, x, y, ... in single precision; a pair of NaN separates its pieces. Results hold no
// phreatic line: it is made again from the case and the times at which stages ended. Between two waters the line has
// the corners of both, so that its interpolation is exact; a vertical step keeps both of its ends.

#include "page/backdrop.hpp"

#include "math/interpolate.hpp"
#include "model/bodies/body_outline.hpp"
#include "run/loop/stages.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace terp {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr Real infinity = std::numeric_limits<Real>::infinity();

void add_place(std::vector<float>& line, Vec<2> x)
{
  line.push_back(static_cast<float>(x[0]));
  line.push_back(static_cast<float>(x[1]));
}

void end_line(std::vector<float>& line)
{
  if (!line.empty()) line.insert(line.end(), {nan, nan});
}

void add_ring(std::vector<float>& line, const std::vector<Vec<2>>& corners)
{
  end_line(line);
  for (const Vec<2> x : corners) add_place(line, x);
  add_place(line, corners.front());
}

/// The sides of a body of cells, each as a line of its own.
void add_region(std::vector<float>& line, const Mesh<2>& mesh, const std::string& name)
{
  for (const NamedRegion& region : mesh.regions) {
    if (region.name != name) continue;
    const BodyOutline body{.polygon = {}, .points_per_cell = {1, 1}, .holes = {}, .cells = region.cells};
    for (const Side& side : outline_sides(mesh, body)) {
      end_line(line);
      add_place(line, side.a);
      add_place(line, side.b);
    }
  }
}

/// The water of the stage that has a time, on its ramp; where no stage names any, that of the times of the situations.
/// stages: those that have ended. begin: time with which the run begins [s].
WaterWay water_at(const Case& description, const std::vector<StageSummary>& stages, Real begin, Real time)
{
  std::size_t k = 0;
  while (k + 1 < description.stages.size() && k < stages.size() && time > stages[k].record.end) ++k;
  const StageWater water = water_of_stage(description, k);
  if (!water.given) return way_at(knots_of(description.water), time);
  const Real start = k > 0 ? stages[k - 1].record.end : begin;
  return {water.from, water.to, Ramp{start, description.stages[k].ramp}.share_at(time)};
}

/// Elevation of a line just left of x [m].
Real elevation_left_of(std::span<const Vec<2>> line, Real x)
{
  for (const Vec<2>& place : line)
    if (place[0] == x) return place[1];  // the first of a vertical step
  return elevation_at(line, x);
}

}  // namespace

std::vector<float> mesh_edges(const Mesh<2>& mesh)
{
  std::vector<float> edges;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int side = 0; side < 4; ++side) {
      const Index other = mesh.neighbours[cell][side];
      if (other != outside && other < cell) continue;  // drawn with the other cell
      for (const int end : {side, (side + 1) % 4}) add_place(edges, mesh.nodes[mesh.cells[cell][end]]);
    }
  return edges;
}

std::vector<float> first_outline(const Case& description, const Mesh<2>& mesh)
{
  std::vector<float> line;
  for (const BodyCase& body : description.bodies) {
    if (body.placed > 0) continue;
    if (!body.polygon.empty()) add_ring(line, body.polygon);
    for (const auto& hole : body.holes) add_ring(line, hole);
    if (!body.region.empty()) add_region(line, mesh, body.region);
  }
  return line;
}

std::vector<float> phreatic_line(
    const Case& description, const std::vector<StageSummary>& stages, const Mesh<2>& mesh, Real begin, Real time)
{
  const WaterCase& water = description.water;
  const WaterWay now = water_at(description, stages, begin, time);
  const Real share = now.share;
  const auto [first, last] = std::ranges::minmax(mesh.nodes, {}, [](const Vec<2>& x) { return x[0]; });
  const auto [lowest, highest] = std::ranges::minmax(mesh.nodes, {}, [](const Vec<2>& x) { return x[1]; });
  const Vec<2> low{first[0], lowest[1]}, high{last[0], highest[1]};
  const std::vector<Vec<2>> from = water_table(water, situation_of(water, now.from), low, high);
  const std::vector<Vec<2>> to = water_table(water, situation_of(water, now.to), low, high);
  if (from.empty() || to.empty()) return {};
  std::vector<Real> places{first[0], last[0]};
  for (const auto* line : {&from, &to})
    for (const Vec<2>& x : *line)
      if (x[0] > first[0] && x[0] < last[0]) places.push_back(x[0]);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<float> out;
  for (const Real x : places) {
    const Real left = std::lerp(elevation_left_of(from, x), elevation_left_of(to, x), share);
    const Real here = std::lerp(elevation_at(from, x), elevation_at(to, x), share);
    if (left != here) add_place(out, {x, left});  // a vertical step
    add_place(out, {x, here});
  }
  return out;
}

std::vector<float> surface_line(const std::vector<Real>& places, const SurfaceColumns& columns)
{
  std::map<long, std::size_t> highest;  // point by column
  for (std::size_t p = 0; p < places.size() / 2; ++p) {
    if (!is_soil(places, p)) continue;
    const auto [entry, fresh] = highest.try_emplace(std::lround(std::floor(places[2 * p] / columns.width)), p);
    if (!fresh && places[2 * p + 1] > places[2 * entry->second + 1]) entry->second = p;
  }
  std::vector<float> line;
  for (const auto& [column, p] : highest) add_place(line, {places[2 * p], places[2 * p + 1] + columns.half_point});
  return line;
}

std::vector<Vec<2>> places_of(std::span<const float> line)
{
  std::vector<Vec<2>> places;
  for (std::size_t k = 0; k + 1 < line.size(); k += 2) places.push_back({line[k], line[k + 1]});
  return places;
}

std::optional<Real> corner_near(std::span<const float> outline, Real x, Real reach)
{
  std::optional<Vec<2>> best;
  for (const Vec<2>& corner : places_of(outline)) {
    if (!(std::abs(corner[0] - x) <= reach * (1.0 + 1e-6))) continue;
    const bool is_nearer = best && corner[1] == (*best)[1] && std::abs(corner[0] - x) < std::abs((*best)[0] - x);
    if (!best || corner[1] > (*best)[1] || is_nearer) best = corner;
  }
  return best ? std::optional((*best)[0]) : std::nullopt;
}

std::vector<float> water_in_moved_soil(const std::vector<Real>& first, const std::vector<Real>& now,
    std::span<const float> line, const SurfaceColumns& columns)
{
  struct Column {
    Real ground = -infinity, table = -infinity;  // of the soil there now; of the wet part of it [m]
    bool has_moved = false;
  };
  const std::vector<Vec<2>> drawn = places_of(line);
  if (drawn.empty()) return {};
  const std::vector<Vec<2>> ground = places_of(surface_line(first, columns));
  std::map<long, Column> soil;
  for (std::size_t p = 0; p < now.size() / 2; ++p) {
    if (!is_soil(now, p) || !is_soil(first, p)) continue;
    const Real x = now[2 * p], y = now[2 * p + 1];
    Column& column = soil[std::lround(std::floor(x / columns.width))];
    column.has_moved |= std::hypot(x - first[2 * p], y - first[2 * p + 1]) > 0.25 * columns.width;
    column.ground = std::max(column.ground, y + columns.half_point);
    const Real level = interpolate(drawn, first[2 * p]);
    if (first[2 * p + 1] <= level)
      column.table = std::max(column.table, std::min(y + columns.half_point, y + level - first[2 * p + 1]));
  }
  constexpr Real shallow = 0.1;  // m; the surface of points is no sharper
  const auto is_free = [&](Real x) {
    return !ground.empty() && interpolate(drawn, x) > interpolate(ground, x) + shallow;
  };
  // The river ends at the highest ground that is left: what lay below it beyond that has none.
  const auto top = std::ranges::max_element(soil, {}, [](const auto& column) { return column.second.ground; });
  const auto x_of = [&](long column) { return (static_cast<Real>(column) + 0.5) * columns.width; };
  std::array<Real, 2> beyond{infinity, -infinity};
  const bool from_left = is_free(drawn.front()[0]);
  if (top != soil.end() && from_left != is_free(drawn.back()[0]) && is_free(x_of(top->first))) {
    beyond = {x_of(top->first), x_of(top->first)};
    for (long k = top->first; soil.contains(k) && is_free(x_of(k)); k += from_left ? 1 : -1)
      beyond[from_left ? 1 : 0] = x_of(k) + (from_left ? columns.half_point : -columns.half_point);
  }
  std::vector<float> out;
  const auto enter = [&](Vec<2> x) {
    const auto column = soil.find(std::lround(std::floor(x[0] / columns.width)));
    const bool is_river = is_free(x[0]) && !(x[0] > beyond[0] && x[0] < beyond[1]);
    const bool stays = column == soil.end() || !column->second.has_moved || (is_river && x[1] > column->second.ground);
    if (!stays && column->second.table == -infinity) return;  // no wet soil
    add_place(out, stays ? x : Vec<2>{x[0], column->second.table});
  };
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    enter(drawn[k]);
    for (const auto& [number, column] : soil)
      if (const Real x = x_of(number);
          column.has_moved && k + 1 < drawn.size() && x > drawn[k][0] && x < drawn[k + 1][0])
        enter({x, interpolate(drawn, x)});
  }
  return out;
}

}  // namespace terp
