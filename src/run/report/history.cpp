// Looking a point up by its number takes a pass over all points. Its block and lane are therefore remembered, and the
// number that lies there is compared before use: exchanges and moves may have put another point there.

#include "run/report/history.hpp"

#include "math/nan.hpp"
#include "run/report/frame_fields.hpp"
#include "run/report/ledger.hpp"

#include <algorithm>

namespace terp {
namespace {

struct NamedPoint {
  const Model& model;
  const State& state;
  const PointBlock<2>& block;
  Index lane;

  const SoilMaterial& material() const { return model.materials[block.material]; }
  Real row(int r) const { return block.row(r)[lane]; }
};

Real plastic_strain_of(const NamedPoint& p)
{
  const int row = row_of(p.material(), Role::plastic_strain);
  return row < 0 ? nan : p.row(row);
}

Real strain_of_strength(const NamedPoint& p)
{
  const int row = row_of(p.material(), driver_of_strength(p.material()));
  return row < 0 ? nan : p.row(row);
}

Real strength_of(const NamedPoint& p)
{
  return has_strength(p.material()) ? strength_of(p.material(), p.block, p.lane) : nan;
}

struct HistoryQuantity {
  QuantityInfo info;
  Real (*read)(const NamedPoint&);
};

using N = const NamedPoint&;

/// Numbers of history.csv after the time. A new one is one entry here.
constexpr HistoryQuantity history_quantities[] = {
    {{"id", "-", "number of the point",
         "number of the material point: the one nearest to the place given, at t = 0 (ties: lower x, then lower y)"},
        [](N p) { return p.row(Rows::id); }},
    {{"x", "m", "x", "its place now"}, [](N p) { return p.row(Rows::x); }},
    {{"y", "m", "y", "its place now"}, [](N p) { return p.row(Rows::x + 1); }},
    {{"eps_deviatoric", "-", "total deviatoric strain", "total deviatoric strain, sqrt(1/2 e:e)"},
        [](N p) { return deviatoric_strain(p.block, p.lane); }},
    {{"eps_eq_p", "-", "equivalent plastic strain", "accumulated equivalent plastic strain, Eq. (6)"},
        plastic_strain_of},
    {{"su", "Pa", "undrained shear strength", "undrained shear strength now, Eq. (5)"}, strength_of},
    {{"pressure", "Pa", "mean stress, tension positive", "mean stress tr(sigma)/3, tension positive"},
        [](N p) { return (p.row(Rows::sigma) + p.row(Rows::sigma + 1) + p.row(Rows::sigma + 2)) / 3.0; }},
    {{"eps_softening", "-", "strain that the strength follows",
         "strain that the strength follows: eps_eq_p, or with a softening length its nonlocal form"},
        strain_of_strength},
};

bool holds(const PointBlocks<2>& points, PointPlace place, std::int64_t id)
{
  if (place.block < 0 || place.block >= points.n_blocks()) return false;
  const PointBlock<2>& block = points.block(place.block);
  return place.lane < block.n && block.row(Rows::id)[place.lane] == static_cast<Real>(id);
}

/// Renews the places of points where they are no longer right; those of points that left stay wrong.
void find_points(const State& state, const std::vector<std::int64_t>& ids, std::vector<PointPlace>& places)
{
  places.resize(ids.size(), {-1, -1});
  std::vector<std::size_t> lost;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const bool has_left = std::ranges::any_of(state.left, [&](const LeftPoint& p) { return p.id == ids[k]; });
    if (!has_left && !holds(state.points, places[k], ids[k])) lost.push_back(k);
  }
  if (lost.empty()) return;
  for (const Index cell : state.points.occupied())
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index b) {
      for (Index lane = 0; lane < block.n; ++lane)
        for (const std::size_t k : lost)
          if (block.row(Rows::id)[lane] == static_cast<Real>(ids[k])) places[k] = {b, lane};
    });
}

/// Of a point that left through an open side: the place where it left.
void enter_left(const State& state, std::int64_t id, TableRow& row)
{
  row["id"] = static_cast<Real>(id);
  for (const LeftPoint& p : state.left)
    if (p.id == id) row["x"] = p.x[0], row["y"] = p.x[1];
}

}  // namespace

const std::shared_ptr<const RunTable>& history_table()
{
  static const auto table = [] {
    RunTable t{.name = "history",
        .meaning = "the named points over time",
        .columns = {{"time", "s", "time", "of the step"}, {"point", "", "point", "name in the case file", true}},
        .from_start = true};
    for (const HistoryQuantity& quantity : history_quantities) t.columns.push_back(quantity.info);
    return std::make_shared<const RunTable>(std::move(t));
  }();
  return table;
}

std::vector<TableRow> make_history(const Model& model, const State& state, std::vector<PointPlace>& places)
{
  const auto& names = model.description.output.history_points;
  find_points(state, model.history_ids, places);
  std::vector<TableRow> rows;
  for (std::size_t k = 0; k < names.size(); ++k) {
    TableRow& row = rows.emplace_back(history_table(), names[k].first);
    row["time"] = state.time;
    if (!holds(state.points, places[k], model.history_ids[k])) {
      enter_left(state, model.history_ids[k], row);
      continue;
    }
    const NamedPoint point{model, state, state.points.block(places[k].block), places[k].lane};
    for (std::size_t q = 0; q < std::size(history_quantities); ++q)
      row.values[q + 1] = history_quantities[q].read(point);
  }
  return rows;
}

}  // namespace terp
