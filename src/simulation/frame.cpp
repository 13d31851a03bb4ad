#include "simulation/frame.hpp"

#include "simulation/ledger.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

std::size_t id_of(const PointBlock<2>& block, Index lane)
{
  return static_cast<std::size_t>(block.row(Rows::id)[lane]);
}

std::array<Real, 4> strain_of(const PointBlock<2>& block, Index lane)
{
  std::array<Real, 4> strain;
  for (int k = 0; k < n_sym<2>; ++k) strain[k] = block.row(Rows::strain + k)[lane];
  return strain;
}

/// Where the points of a block stand in a frame, by lane; `nowhere`: not in this part of it.
using Places = std::span<const std::size_t>;
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// A field's name, unit, size and how to read the values of a block into those of the frame.
struct FieldRecipe {
  std::string name, unit;
  int n_components;
  std::function<void(const PointBlock<2>&, Places, Real* values)> read;
};

/// Calls f(lane, out) for the points of a block that are in the frame; out: their n_components values.
template <class F>
void for_each_place(const PointBlock<2>& block, Places places, int n_components, Real* values, F&& f)
{
  for (Index lane = 0; lane < block.n; ++lane)
    if (const std::size_t place = places[static_cast<std::size_t>(lane)]; place != nowhere)
      f(lane, values + place * static_cast<std::size_t>(n_components));
}

/// read(block, lane, out): the values of one point.
template <class F>
FieldRecipe recipe(std::string name, std::string unit, int n_components, F read)
{
  return {std::move(name), std::move(unit), n_components, [=](const PointBlock<2>& block, Places places, Real* values) {
            for_each_place(block, places, n_components, values, [&](Index lane, Real* out) { read(block, lane, out); });
          }};
}

FieldRecipe rows_recipe(std::string name, std::string unit, int first_row, int n_rows, int n_components)
{
  return recipe(std::move(name), std::move(unit), n_components, [=](const PointBlock<2>& block, Index lane, Real* out) {
    for (int k = 0; k < n_rows; ++k) out[k] = block.row(first_row + k)[lane];
  });
}

/// Fields of every point, whatever its material. Vectors have three components, as viewers expect.
std::vector<FieldRecipe> common_recipes(const Model& model, const State& state)
{
  std::vector<FieldRecipe> recipes;
  recipes.push_back(rows_recipe("velocity", "m/s", Rows::v, 2, 3));
  recipes.push_back(recipe("displacement", "m", 3, [&state](const PointBlock<2>& block, Index lane, Real* out) {
    for (int d = 0; d < 2; ++d) out[d] = block.row(Rows::x + d)[lane] - state.x_initial[2 * id_of(block, lane) + d];
  }));
  recipes.push_back(rows_recipe("stress", "Pa", Rows::sigma, n_sym<2>, n_sym<2>));
  recipes.push_back(rows_recipe("volume", "m^2", Rows::volume, 1, 1));
  recipes.push_back(
      recipe("material", "-", 1, [](const PointBlock<2>& block, Index, Real* out) { *out = block.material; }));
  recipes.push_back(recipe("cell", "-", 1, [](const PointBlock<2>& block, Index, Real* out) { *out = block.cell; }));
  recipes.push_back(rows_recipe("strain", "-", Rows::strain, n_sym<2>, n_sym<2>));
  const DeviatoricNorm norm = model.description.output.deviatoric_norm;
  recipes.push_back(recipe("eps_deviatoric", "-", 1, [norm](const PointBlock<2>& block, Index lane, Real* out) {
    *out = deviatoric_strain(strain_of(block, lane), norm);
  }));
  return recipes;
}

bool known(const std::vector<FieldRecipe>& recipes, std::string_view name)
{
  return std::any_of(recipes.begin(), recipes.end(), [&](const FieldRecipe& r) { return r.name == name; });
}

/// State and derived fields of all materials; NaN at points whose material has no such field.
void add_material_recipes(const Model& model, std::vector<FieldRecipe>& recipes)
{
  /// value(material, number of the field, block, lane); infos: the fields of a material.
  const auto add = [&](const auto& info, auto infos, auto value) {
    if (known(recipes, info.name)) return;
    recipes.push_back({std::string(info.name), std::string(info.unit), 1,
        [&model, name = info.name, infos, value](const PointBlock<2>& block, Places places, Real* values) {
          const SoilMaterial& material = model.materials[block.material];
          const int k = find_name(infos(*material.type), name);
          for_each_place(block, places, 1, values,
              [&](Index lane, Real* out) { *out = k < 0 ? nan : value(material, k, block, lane); });
        }});
  };
  for (const SoilMaterial& m : model.materials) {
    for (const StateInfo& info : m.type->state)
      add(
          info, [](const MaterialType& type) { return type.state; },
          [](const SoilMaterial&, int k, const PointBlock<2>& block, Index lane) {
            return block.row(Rows::state + k)[lane];
          });
    for (const DerivedInfo& info : m.type->derived)
      add(
          info, [](const MaterialType& type) { return type.derived; },
          [](const SoilMaterial& material, int k, const PointBlock<2>& block, Index lane) {
            return material.law->derived(k, state_of(block, lane, material.n_state()).data());
          });
  }
}

bool wanted(const Model& model, const std::string& name)
{
  const auto& names = model.description.output.field_names;
  if (names.empty()) return name != "strain";  // four numbers per point, which eps_deviatoric sums up
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Points that left the mesh stay in the frames where they left, with volume 0, material -1 and cell -1.
void mark_left(const State& state, Frame& frame)
{
  for (const LeftPoint& point : state.left) {
    if (point.id < frame.first || point.id >= frame.first + frame.n_points()) continue;
    const auto k = static_cast<std::size_t>(point.id - frame.first);
    for (int d = 0; d < 2; ++d) frame.x[2 * k + d] = point.x[d];
    for (PointField& field : frame.fields)
      if (field.name == "material" || field.name == "cell") field.values[k] = -1.0;
  }
}

HistoryRow history_of(const Model& model, const State& state, const PointBlock<2>& block, Index lane)
{
  const SoilMaterial& material = model.materials[block.material];
  const auto values = state_of(block, lane, material.n_state());
  const int eps = find_eps_eq_p(*material.type), su = find_su(*material.type);
  const Real pressure =
      (block.row(Rows::sigma)[lane] + block.row(Rows::sigma + 1)[lane] + block.row(Rows::sigma + 2)[lane]) / 3.0;
  return {.time = state.time,
      .point = "",
      .id = static_cast<std::int64_t>(id_of(block, lane)),
      .x = block.row(Rows::x)[lane],
      .y = block.row(Rows::x + 1)[lane],
      .eps_deviatoric = deviatoric_strain(strain_of(block, lane), model.description.output.deviatoric_norm),
      .eps_eq_p = eps < 0 ? nan : values[eps],
      .su = su < 0 ? nan : material.law->derived(su, values.data()),
      .pressure = pressure};
}

bool holds(const PointBlocks<2>& points, PointPlace place, std::int64_t id)
{
  if (place.block < 0 || place.block >= points.n_blocks()) return false;
  const PointBlock<2>& block = points.block(place.block);
  return place.lane < block.n && id_of(block, place.lane) == static_cast<std::size_t>(id);
}

/// Renews the places of points where they are no longer right; those of points that left stay wrong.
void find_points(const State& state, const std::vector<std::int64_t>& ids, std::vector<PointPlace>& places)
{
  places.resize(ids.size(), {-1, -1});
  std::vector<std::size_t> lost;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const bool has_left =
        std::any_of(state.left.begin(), state.left.end(), [&](const LeftPoint& p) { return p.id == ids[k]; });
    if (!has_left && !holds(state.points, places[k], ids[k])) lost.push_back(k);
  }
  if (lost.empty()) return;
  for (const Index cell : state.points.occupied())
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index b) {
      for (Index lane = 0; lane < block.n; ++lane)
        for (const std::size_t k : lost)
          if (id_of(block, lane) == static_cast<std::size_t>(ids[k])) places[k] = {b, lane};
    });
}

/// Of a point that left through an open side: the place where it left.
HistoryRow history_of_left(const State& state, std::int64_t id)
{
  HistoryRow row{.time = state.time,
      .point = "",
      .id = id,
      .x = nan,
      .y = nan,
      .eps_deviatoric = nan,
      .eps_eq_p = nan,
      .su = nan,
      .pressure = nan};
  for (const LeftPoint& p : state.left)
    if (p.id == id) row.x = p.x[0], row.y = p.x[1];
  return row;
}

}  // namespace

Real deviatoric_strain(const std::array<Real, 4>& strain, DeviatoricNorm norm)
{
  const Real mean = (strain[0] + strain[1] + strain[2]) / 3.0;
  Real square = 2.0 * strain[3] * strain[3];
  for (int k = 0; k < 3; ++k) square += (strain[k] - mean) * (strain[k] - mean);
  return std::sqrt(square * (norm == DeviatoricNorm::half ? 0.5 : 2.0 / 3.0));
}

Frame make_frame(const Model& model, const State& state) { return make_frame(model, state, 0, state.n_ids()); }

Frame make_frame(const Model& model, const State& state, std::int64_t first, std::int64_t n)
{
  std::vector<FieldRecipe> recipes = common_recipes(model, state);
  add_material_recipes(model, recipes);
  std::erase_if(recipes, [&](const FieldRecipe& r) { return !wanted(model, r.name); });

  const auto size = static_cast<std::size_t>(n);
  Frame frame{.time = state.time,
      .step = state.step,
      .x = std::vector<Real>(2 * size),
      .fields = {},
      .first = first,
      .n_all = state.n_ids()};
  for (const FieldRecipe& r : recipes)
    frame.fields.push_back({r.name, r.unit, r.n_components, std::vector<Real>(size * r.n_components, 0.0)});
  std::vector<std::size_t> places;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    places.clear();
    for (Index lane = 0; lane < block.n; ++lane) {
      const std::size_t place = id_of(block, lane) - static_cast<std::size_t>(first);  // wraps below `first`
      places.push_back(place < size ? place : nowhere);
    }
    for_each_place(block, places, 2, frame.x.data(), [&](Index lane, Real* out) {
      for (int d = 0; d < 2; ++d) out[d] = block.row(Rows::x + d)[lane];
    });
    for (std::size_t r = 0; r < recipes.size(); ++r) recipes[r].read(block, places, frame.fields[r].values.data());
  });
  mark_left(state, frame);
  return frame;
}

std::vector<HistoryRow> make_history(const Model& model, const State& state, std::vector<PointPlace>& places)
{
  const auto& names = model.description.output.history_points;
  find_points(state, model.history_ids, places);
  std::vector<HistoryRow> rows;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool is_there = holds(state.points, places[k], model.history_ids[k]);
    rows.push_back(is_there ? history_of(model, state, state.points.block(places[k].block), places[k].lane)
                            : history_of_left(state, model.history_ids[k]));
    rows.back().point = names[k].first;
  }
  return rows;
}

}  // namespace terp
