#include "simulation/frame.hpp"

#include "simulation/ledger.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

std::size_t id_of(const PointBlock<2>& block, Index lane) { return static_cast<std::size_t>(block.row(Rows::id)[lane]); }

std::array<Real, 4> strain_of(const PointBlock<2>& block, Index lane)
{
  std::array<Real, 4> strain;
  for (int k = 0; k < n_sym<2>; ++k) strain[k] = block.row(Rows::strain + k)[lane];
  return strain;
}

/// A field's name, unit, size and how to read one point's values into `out`.
struct FieldRecipe {
  std::string name, unit;
  int n_components;
  std::function<void(const PointBlock<2>&, Index, Real* out)> read;
};

FieldRecipe rows_recipe(std::string name, std::string unit, int first_row, int n_rows, int n_components)
{
  return {std::move(name), std::move(unit), n_components, [=](const PointBlock<2>& block, Index lane, Real* out) {
            for (int k = 0; k < n_rows; ++k) out[k] = block.row(first_row + k)[lane];
          }};
}

/// Fields of every point, whatever its material. Vectors have three components, as viewers expect.
std::vector<FieldRecipe> common_recipes(const Model& model, const State& state)
{
  std::vector<FieldRecipe> recipes;
  recipes.push_back(rows_recipe("velocity", "m/s", Rows::v, 2, 3));
  recipes.push_back({"displacement", "m", 3, [&](const PointBlock<2>& block, Index lane, Real* out) {
                       for (int d = 0; d < 2; ++d) out[d] = block.row(Rows::x + d)[lane] - state.x_initial[2 * id_of(block, lane) + d];
                     }});
  recipes.push_back(rows_recipe("stress", "Pa", Rows::sigma, n_sym<2>, n_sym<2>));
  recipes.push_back(rows_recipe("volume", "m^2", Rows::volume, 1, 1));
  recipes.push_back({"material", "-", 1, [](const PointBlock<2>& block, Index, Real* out) { *out = block.material; }});
  recipes.push_back({"cell", "-", 1, [](const PointBlock<2>& block, Index, Real* out) { *out = block.cell; }});
  recipes.push_back(rows_recipe("strain", "-", Rows::strain, n_sym<2>, n_sym<2>));
  const DeviatoricNorm norm = model.description.output.deviatoric_norm;
  recipes.push_back({"eps_deviatoric", "-", 1, [norm](const PointBlock<2>& block, Index lane, Real* out) {
                       *out = deviatoric_strain(strain_of(block, lane), norm);
                     }});
  return recipes;
}

bool known(const std::vector<FieldRecipe>& recipes, std::string_view name)
{
  return std::any_of(recipes.begin(), recipes.end(), [&](const FieldRecipe& r) { return r.name == name; });
}

/// State and derived fields of all materials; NaN at points whose material has no such field.
void add_material_recipes(const Model& model, std::vector<FieldRecipe>& recipes)
{
  const auto add = [&](std::string_view name, std::string_view unit, auto read) {
    if (!known(recipes, name)) recipes.push_back({std::string(name), std::string(unit), 1, read});
  };
  for (const SoilMaterial& m : model.materials) {
    for (const StateInfo& info : m.type->state)
      add(info.name, info.unit, [&model, name = info.name](const PointBlock<2>& block, Index lane, Real* out) {
        const auto states = model.materials[block.material].type->state;
        *out = nan;
        for (std::size_t k = 0; k < states.size(); ++k)
          if (states[k].name == name) *out = block.row(Rows::state + static_cast<int>(k))[lane];
      });
    for (const DerivedInfo& info : m.type->derived)
      add(info.name, info.unit, [&model, name = info.name](const PointBlock<2>& block, Index lane, Real* out) {
        const SoilMaterial& material = model.materials[block.material];
        const auto fields = material.type->derived;
        *out = nan;
        for (std::size_t k = 0; k < fields.size(); ++k)
          if (fields[k].name == name) *out = material.law->derived(static_cast<int>(k), state_of(block, lane, material.n_state()).data());
      });
  }
}

bool wanted(const Model& model, const std::string& name)
{
  const auto& names = model.description.output.field_names;
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Points that left the mesh stay in the frames where they left, with volume 0, material -1 and cell -1.
void mark_left(const State& state, Frame& frame)
{
  for (const LeftPoint& point : state.left) {
    const auto id = static_cast<std::size_t>(point.id);
    for (int d = 0; d < 2; ++d) frame.x[2 * id + d] = point.x[d];
    for (PointField& field : frame.fields)
      if (field.name == "material" || field.name == "cell") field.values[id] = -1.0;
  }
}

HistoryRow history_of(const Model& model, const State& state, const PointBlock<2>& block, Index lane)
{
  const SoilMaterial& material = model.materials[block.material];
  const auto values = state_of(block, lane, material.n_state());
  const int eps = find_eps_eq_p(*material.type), su = find_su(*material.type);
  const Real pressure = (block.row(Rows::sigma)[lane] + block.row(Rows::sigma + 1)[lane] + block.row(Rows::sigma + 2)[lane]) / 3.0;
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

/// Of a point that left through an open side: the place where it left.
HistoryRow history_of_left(const State& state, std::int64_t id)
{
  HistoryRow row{.time = state.time, .point = "", .id = id, .x = nan, .y = nan, .eps_deviatoric = nan, .eps_eq_p = nan, .su = nan, .pressure = nan};
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

Frame make_frame(const Model& model, const State& state)
{
  std::vector<FieldRecipe> recipes = common_recipes(model, state);
  add_material_recipes(model, recipes);
  std::erase_if(recipes, [&](const FieldRecipe& r) { return !wanted(model, r.name); });

  const auto n = static_cast<std::size_t>(state.n_ids());
  Frame frame{.time = state.time, .step = state.step, .x = std::vector<Real>(2 * n), .fields = {}};
  for (const FieldRecipe& r : recipes) frame.fields.push_back({r.name, r.unit, r.n_components, std::vector<Real>(n * r.n_components, 0.0)});
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const std::size_t id = id_of(block, lane);
    for (int d = 0; d < 2; ++d) frame.x[2 * id + d] = block.row(Rows::x + d)[lane];
    for (std::size_t k = 0; k < recipes.size(); ++k) recipes[k].read(block, lane, &frame.fields[k].values[id * recipes[k].n_components]);
  });
  mark_left(state, frame);
  return frame;
}

std::vector<HistoryRow> make_history(const Model& model, const State& state)
{
  const auto& names = model.description.output.history_points;
  if (names.empty()) return {};
  std::vector<HistoryRow> rows;
  for (std::size_t k = 0; k < names.size(); ++k) rows.push_back(history_of_left(state, model.history_ids[k]));
  std::vector<std::uint8_t> named(static_cast<std::size_t>(state.n_ids()));
  for (const std::int64_t id : model.history_ids) named[static_cast<std::size_t>(id)] = 1;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = id_of(block, lane);
    if (named[id] == 0) return;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (model.history_ids[k] == static_cast<std::int64_t>(id)) rows[k] = history_of(model, state, block, lane);
  });
  for (std::size_t k = 0; k < names.size(); ++k) rows[k].point = names[k].first;
  return rows;
}

}  // namespace terp
