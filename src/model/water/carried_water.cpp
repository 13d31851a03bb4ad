// Soil is counted in columns of the width of a cell, each point in the two whose middles it lies between, so that a
// table does not jump as points pass from column to column. Down from the surface the soil is dry until the first wet
// soil: their volume is the depth of the table below the surface. Nothing changes before soil has moved by an eighth of
// a cell; from a quarter on all is as it carries it. A look sees the soil where it will be at the next one.

#include "model/water/carried_water.hpp"

#include "model/ground/ground_section.hpp"
#include "model/seepage/computed_water.hpp"
#include "model/seepage/frozen_field.hpp"
#include "model/water/nodal_water.hpp"
#include "mpm/mesh/locate.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real nowhere = -std::numeric_limits<Real>::infinity();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

constexpr Real begins = 0.125;       // of the width of a column: motion from which on the soil carries its water
constexpr Real between_looks = 0.5;  // the same, of the fastest soil from look to look
constexpr Real renews_after = 0.25;  // the same, after which the heads of computed water are found anew
constexpr int layers_per_cell = 8;   // in which a column counts its soil
constexpr Real least_steps = 8.0, most_steps = 64.0;

/// 0 up to an eighth of a column's width of motion, 1 from a quarter on.
Real share_of_motion(Real motion, Real width) { return std::clamp(motion / (begins * width) - 1.0, 0.0, 1.0); }

struct Soil {
  Real mass = 0.0;            ///< [kg per m]
  Real wet = 0.0, dry = 0.0;  ///< volume [m^2]
};

/// The two columns between whose middles an x lies, and the part of the second.
struct AboutPlace {
  Index first, next;
  Real part;
};

AboutPlace about(const Columns& columns, Real x)
{
  const Real place = (x - columns.left) / columns.width - 0.5;
  const auto k = static_cast<Index>(std::clamp(place, 0.0, std::max(columns.n - 2.0, 0.0)));
  return {k, std::min(k + 1, columns.n - 1), std::clamp(place - k, 0.0, 1.0)};
}

/// The soil in columns and layers.
class SoilColumns {
 public:
  SoilColumns(const Mesh<2>& mesh, Columns columns) : columns_(columns)
  {
    const auto [low, high] = std::ranges::minmax(mesh.nodes, {}, [](const Vec<2>& x) { return x[1]; });
    base_ = low[1];
    layer_ = columns.width / layers_per_cell;
    n_layers_ = static_cast<Index>(std::ceil((high[1] - low[1]) / layer_)) + 1;
    soil_.resize(static_cast<std::size_t>(columns.n * n_layers_));
    moved_.resize(static_cast<std::size_t>(columns.n), 0.0);
    gained_.resize(static_cast<std::size_t>(columns.n), 0.0);
  }

  void enter_motion(Real x, Real square)
  {
    const auto [k, next, part] = about(columns_, x);
    if (part < 1.0) moved_[static_cast<std::size_t>(k)] = std::max(moved_[static_cast<std::size_t>(k)], square);
    if (part > 0.0) moved_[static_cast<std::size_t>(next)] = std::max(moved_[static_cast<std::size_t>(next)], square);
  }

  /// Positive: gains.
  void enter_volume(Real x, Real volume)
  {
    const auto [k, next, part] = about(columns_, x);
    gained_[static_cast<std::size_t>(k)] += (1.0 - part) * volume;
    gained_[static_cast<std::size_t>(next)] += part * volume;
  }

  /// A square of soil about x whose lower part is wet.
  void enter_soil(Vec<2> x, Real mass, Real size, Real wet)
  {
    const auto [k, next, part] = about(columns_, x[0]);
    const Real low = x[1] - 0.5 * size, table = low + wet * size, high = low + size;
    for (Index layer = layer_of(low); layer <= layer_of(high); ++layer) {
      // What reaches beyond the mesh is in its first or last layer.
      const Real from = layer == 0 ? low : std::max(low, base_ + layer * layer_);
      const Real to = layer == n_layers_ - 1 ? high : std::min(high, base_ + (layer + 1) * layer_);
      const Real below = std::max(std::min(to, table) - from, 0.0);
      for (const auto& [column, share] : {std::pair{k, 1.0 - part}, std::pair{next, part}}) {
        Soil& soil = soil_[static_cast<std::size_t>(column * n_layers_ + layer)];
        soil.mass += share * mass * (to - from) / size;
        soil.wet += share * size * below;
        soil.dry += share * size * (to - from - below);
      }
    }
  }

  Real moved(Index column) const { return std::sqrt(moved_[static_cast<std::size_t>(column)]); }

  Real gained(Index column) const { return gained_[static_cast<std::size_t>(column)]; }

  /// To which the wet soil of a column reaches below the surface [m]; its lowest soil where none is wet. The dry soil
  /// has its share of the height as it has of the volume: the column need not be full from side to side.
  Real table(Index column, Real ground) const
  {
    Real dry = 0.0, all = 0.0;
    Index k = top_of(ground);
    for (; k >= 0; --k) {
      const Soil& soil = at(column, k);
      all += soil.wet + soil.dry;
      dry += soil.dry;
      if (soil.wet > soil.dry) break;
    }
    const Real height = ground - (base_ + std::max(k, Index{0}) * layer_);
    return ground - (dry > 0.0 ? height * dry / all : 0.0);
  }

  /// Per area, of the soil between a place and the surface, of its mean density [kg/m^2].
  Real mass_above(Index column, Real y, Real ground) const
  {
    if (!(y < ground)) return 0.0;
    Real mass = 0.0, volume = 0.0;
    for (Index k = layer_of(y); k <= top_of(ground); ++k) {
      mass += at(column, k).mass;
      volume += at(column, k).wet + at(column, k).dry;
    }
    return volume > 0.0 ? mass / volume * (ground - y) : 0.0;
  }

 private:
  Index layer_of(Real y) const
  {
    return std::clamp(static_cast<Index>(std::floor((y - base_) / layer_)), Index{0}, n_layers_ - 1);
  }
  Index top_of(Real ground) const { return std::min(layer_of(ground) + 1, n_layers_ - 1); }
  const Soil& at(Index column, Index layer) const
  {
    return soil_[static_cast<std::size_t>(column * n_layers_ + layer)];
  }

  Columns columns_;
  Real base_ = 0.0, layer_ = 0.0;  // [m]
  Index n_layers_ = 0;
  std::vector<Soil> soil_;    // shape [columns, layers]
  std::vector<Real> gained_;  // volume that a column will have gained [m^2]
  std::vector<Real> moved_;   // square of the largest displacement in a column [m^2]
};

/// By columns.
using Elevations = std::vector<Real>;

/// The first and the last column of a stretch.
struct Stretch {
  Index first, last;
};

/// Where the river at an end of the section stops: at the highest ground that is left, as water that flows over is not
/// simulated. Not where the whole section is drawn below water. from: a stretch that is drawn below water.
Stretch reach_of_river(Stretch from, const Elevations& ground, const Elevations& walls)
{
  const auto n = static_cast<Index>(ground.size());
  const bool left = from.first == 0, right = from.last == n - 1;
  if (left == right) return {0, n - 1};  // a pond, or all
  const auto highest = static_cast<Index>(std::ranges::max_element(ground) - ground.begin());
  const auto wall = static_cast<Index>(std::ranges::max_element(walls) - walls.begin());
  const bool at_wall = walls[wall] > ground[highest];
  return left ? Stretch{0, at_wall ? wall : highest} : Stretch{at_wall ? wall + 1 : highest, n - 1};
}

/// What the columns have, at the nodes: from the middles of the two columns that hold soil, or water, on both sides.
CarriedWater at_nodes(const Mesh<2>& mesh, const Columns& columns, const SoilColumns& soil, const Elevations& share,
    const Elevations& table, const Elevations& ground)
{
  CarriedWater carried;
  for (const Vec<2>& x : mesh.nodes) {
    auto [k, next, part] = about(columns, x[0]);
    const auto is_empty = [&](Index column) { return ground[column] == nowhere && table[column] == nowhere; };
    if (is_empty(k)) part = 1.0;
    if (is_empty(next)) part = is_empty(k) ? part : 0.0;
    const auto between = [&](const Elevations& of, Real none) {
      const Real a = of[k] == nowhere ? none : of[k], b = of[next] == nowhere ? none : of[next];
      return std::lerp(a, b, part);
    };
    const Real base = x[1] - columns.width;  // of a column without soil or water: below the node
    carried.share.push_back(std::lerp(share[k], share[next], part));
    carried.table.push_back(between(table, base));
    carried.ground.push_back(between(ground, base));
    carried.mass.push_back(
        std::lerp(soil.mass_above(k, x[1], ground[k]), soil.mass_above(next, x[1], ground[next]), part));
  }
  return carried;
}

/// The places of points that came since the last look are those that they have now.
void keep_places(StepState& state, WaterState& water)
{
  water.places.resize(state.x_initial.size(), nan);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    Real* place = &water.places[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
    if (!std::isnan(place[0])) return;
    for (int d = 0; d < 2; ++d) place[d] = block.row(Rows::x + d)[lane];
  });
}

/// [m/s]
Real fastest_soil(const StepState& state)
{
  Real square = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real vx = block.row(Rows::v)[lane], vy = block.row(Rows::v + 1)[lane];
    square = std::max(square, vx * vx + vy * vy);
  });
  return std::sqrt(square);
}

/// Those in which the fastest soil goes half the width of a column.
Real steps_to_next_look(const Model& model, Real fastest)
{
  const Real width = model.nodal_water->drawn()->columns.width;
  return std::round(std::clamp(between_looks * width / (fastest * model.dt), least_steps, most_steps));
}

/// What soil that goes on for a while as it moves now will carry [s]. Empty: none has moved. known_heads: of computed
/// water, which hold on; nullptr: they are found.
CarriedWater see(const Model& model, const StepState& state, const WaterState& water, const Elevations& ground_now,
    Real ahead, const std::vector<Real>* known_heads)
{
  const DrawnWater& drawn = *model.nodal_water->drawn();
  const WaterWay way = water_way(model, state.time);
  const WaterSituation &from = situation_of(model.description.water, way.from),
                       &to = situation_of(model.description.water, way.to);
  SoilColumns soil(*model.mesh, drawn.columns);
  const auto first_place = [&](const PointBlock<2>& block, Index lane) {
    return &water.places[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
  };
  const bool has_line = !from.phreatic_line.empty() && !to.phreatic_line.empty();
  const auto wet_part = [&](const Real* place, Real volume) {
    if (!has_line) return 1.0;
    const Real line =
        std::lerp(elevation_at(from.phreatic_line, place[0]), elevation_at(to.phreatic_line, place[0]), way.share);
    return std::clamp((line - place[1]) / std::sqrt(volume) + 0.5, 0.0, 1.0);
  };
  const auto place_ahead = [&](const PointBlock<2>& block, Index lane) {
    return Vec<2>{block.row(Rows::x)[lane] + ahead * block.row(Rows::v)[lane],
        block.row(Rows::x + 1)[lane] + ahead * block.row(Rows::v + 1)[lane]};
  };
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real* place = first_place(block, lane);
    const Vec<2> x = place_ahead(block, lane);
    const Real dx = x[0] - place[0], dy = x[1] - place[1];
    soil.enter_motion(x[0], dx * dx + dy * dy);
  });
  const auto n = static_cast<std::size_t>(drawn.columns.n);
  Elevations share(n);
  for (std::size_t k = 0; k < n; ++k) {
    const bool had = water.ground[k] > nowhere, has = ground_now[k] > nowhere;
    const Real change = had && has ? std::abs(ground_now[k] - water.ground[k]) : had == has ? 0.0 : -nowhere;
    share[k] = share_of_motion(std::max(soil.moved(static_cast<Index>(k)), change), drawn.columns.width);
  }
  const auto most_moved = std::ranges::max_element(share);
  if (most_moved == share.end() || !(*most_moved > 0.0)) return {};
  if (model.nodal_water->section() != nullptr) std::ranges::fill(share, Real(*most_moved));  // it is one flow

  // The nodes beside a column that has moved ask the one on its other side, too.
  const auto counts = [&](Real x) {
    const auto [first, next, part] = about(drawn.columns, x);
    const auto begin = share.begin() + std::max(first - 1, 0),
               end = share.begin() + std::min<Index>(next + 2, drawn.columns.n);
    return std::any_of(begin, end, [](Real of_column) { return of_column > 0.0; });
  };
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x = place_ahead(block, lane);
    const Real volume = block.row(Rows::volume)[lane];
    if (counts(block.row(Rows::x)[lane])) soil.enter_volume(block.row(Rows::x)[lane], -volume);
    if (!counts(x[0])) return;
    const Real* place = first_place(block, lane);
    const Real wet = wet_part(place, volume);
    soil.enter_volume(x[0], volume);
    soil.enter_soil(x, block.row(Rows::mass)[lane], std::sqrt(volume), wet);
  });
  Elevations level(n), table(n);
  for (std::size_t k = 0; k < n; ++k)
    level[k] = std::lerp(drawn.levels[way.from][k], drawn.levels[way.to][k], way.share);
  Elevations ground = ground_now;
  for (std::size_t k = 0; k < n; ++k) ground[k] += soil.gained(static_cast<Index>(k)) / drawn.columns.width;
  const Elevations free =
      free_water(level, drawn.ground, ground, walls_between(drawn.columns, model.description.water.walls));
  for (std::size_t k = 0; k < n; ++k)
    table[k] = std::max(free[k], ground[k] > nowhere ? soil.table(static_cast<Index>(k), ground[k]) : nowhere);
  CarriedWater carried = at_nodes(*model.mesh, drawn.columns, soil, share, table, ground);
  if (model.nodal_water->section() == nullptr) return carried;
  if (known_heads != nullptr) {
    carried.head = *known_heads;
    return carried;
  }
  const auto at_columns = [&](const Elevations& of) {
    return [&of, &drawn](Real x) {
      const auto k = static_cast<Index>(std::floor((x - drawn.columns.left) / drawn.columns.width));
      return of[std::clamp(k, Index{0}, drawn.columns.n - 1)];
    };
  };
  const AboveSoil above{at_columns(ground), at_columns(free)};
  std::vector<WetPoint> points;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x = place_ahead(block, lane);
    const Location at = locate(*model.mesh, x, block.cell);
    const Real volume = block.row(Rows::volume)[lane];
    const Real wet = above.free_water(x[0]) > above.ground(x[0]) ? 1.0 : wet_part(first_place(block, lane), volume);
    if (at.inside && wet > 0.0)
      points.push_back({x, at.cell, wet * volume, model.description.materials[block.material].permeability});
  });
  const SeepageSection& section = *model.nodal_water->section();
  const Mesh<2>& mesh = *section.walled.mesh;
  carried.head = section.walled.joined(frozen_heads(
      mesh, points, above, side_conditions(mesh, section, between(from.seepage, to.seepage, way.share), "water")));
  for (std::size_t i = 0; i < carried.head.size(); ++i)
    if (std::isnan(carried.head[i])) carried.head[i] = carried.table[i];
  return carried;
}

}  // namespace

std::vector<Real> free_water(const std::vector<Real>& level, const std::vector<Real>& drawn_ground,
    const std::vector<Real>& ground, const std::vector<Real>& walls)
{
  const auto n = static_cast<Index>(level.size());
  Elevations free(level.size(), nowhere);
  const auto is_drawn = [&](Index k) { return level[k] > drawn_ground[k] + least_free_depth; };
  for (Index a = 0; a < n; ++a) {
    if (!is_drawn(a)) continue;
    Index b = a;
    Real lowest = level[a];
    for (; b + 1 < n && is_drawn(b + 1); ++b) lowest = std::min(lowest, level[b + 1]);
    const Stretch reach = reach_of_river({a, b}, ground, walls);
    const auto enter = [&](Index k, Real at) {
      if (k < reach.first || k > reach.last || !(ground[k] < at)) return false;
      free[k] = std::max(free[k], at);
      return true;
    };
    for (Index k = a; k <= b; ++k) enter(k, level[k]);
    for (Index k = b + 1; k < n && walls[k - 1] < lowest && enter(k, lowest);) ++k;
    for (Index k = a; k-- > 0 && walls[k] < lowest && enter(k, lowest);) {
    }
    a = b;
  }
  return free;
}

std::vector<Real> walls_between(const Columns& columns, std::span<const WallCase> walls)
{
  std::vector<Real> tops(static_cast<std::size_t>(columns.n), nowhere);
  for (const WallCase& wall : walls)
    for (std::size_t k = 0; k + 1 < wall.line.size(); ++k) {
      const Vec<2>&a = wall.line[k], &b = wall.line[k + 1];
      const auto column = [&](Real x) { return about(columns, x).first; };
      for (Index c = column(std::min(a[0], b[0])); c <= column(std::max(a[0], b[0])); ++c)
        tops[static_cast<std::size_t>(c)] = std::max({tops[static_cast<std::size_t>(c)], a[1], b[1]});
    }
  return tops;
}

void look_at_soil(const Model& model, StepState& state)
{
  if (!model.nodal_water || !model.nodal_water->follows_soil()) return;
  const bool first = !state.with.water;
  WaterState& water = state.with.water.made();
  if (!first && state.step < water.next) return;
  keep_places(state, water);
  const Elevations ground = standing_ground(model, state.points, 0.0).heights;
  if (water.ground.empty()) water.ground = ground;
  const Real fastest = fastest_soil(state), steps = steps_to_next_look(model, fastest);
  water.before = std::move(water.last);
  water.way += fastest * steps * model.dt;
  const bool holds = !water.before.head.empty() && water.way < renews_after * model.nodal_water->drawn()->columns.width;
  water.last = see(model, state, water, ground, steps * model.dt, holds ? &water.before.head : nullptr);
  if (!holds) water.way = 0.0;
  water.looked = state.step;
  water.next = state.step + static_cast<std::int64_t>(steps);
}

void look_anew(const Model& model, StepState& state)
{
  if (!state.with.water) return;
  state.with.water->next = state.step;
  if (model.with.bodies) state.with.water->ground.clear();
}

}  // namespace terp
