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

/// A row of the table; NaN at points whose material does not have it. Vectors have three components, as viewers expect.
FieldRecipe row_recipe(const RowInfo& row)
{
  const int n_components = row.n == 2 ? 3 : row.n;
  return recipe(row.name, row.unit, n_components, [&row](const PointBlock<2>& block, Index lane, Real* out) {
    const bool has = row.is_of(block.material);
    for (int k = 0; k < row.n; ++k) out[k] = has ? block.row(row.first + k)[lane] : nan;
  });
}

/// Fields that follow from the rows of any point.
void add_common_recipes(const Model& model, const State& state, std::vector<FieldRecipe>& recipes)
{
  recipes.push_back(recipe("displacement", "m", 3, [&state](const PointBlock<2>& block, Index lane, Real* out) {
    for (int d = 0; d < 2; ++d) out[d] = block.row(Rows::x + d)[lane] - state.x_initial[2 * id_of(block, lane) + d];
  }));
  recipes.push_back(
      recipe("material", "-", 1, [](const PointBlock<2>& block, Index, Real* out) { *out = block.material; }));
  recipes.push_back(recipe("cell", "-", 1, [](const PointBlock<2>& block, Index, Real* out) { *out = block.cell; }));
  const DeviatoricNorm norm = model.description.output.deviatoric_norm;
  recipes.push_back(recipe("eps_deviatoric", "-", 1,
      [norm](const PointBlock<2>& block, Index lane, Real* out) { *out = deviatoric_strain(block, lane, norm); }));
}

/// Derived fields of all materials; NaN at points whose law has no such field.
void add_derived_recipes(const Model& model, std::vector<FieldRecipe>& recipes)
{
  const auto known = [&](std::string_view name) {
    return std::ranges::any_of(recipes, [&](const FieldRecipe& r) { return r.name == name; });
  };
  for (const SoilMaterial& of : model.materials)
    for (const DerivedInfo& info : of.type->derived) {
      if (known(info.name)) continue;
      recipes.push_back(recipe(std::string(info.name), std::string(info.unit), 1,
          [&model, name = info.name](const PointBlock<2>& block, Index lane, Real* out) {
            const SoilMaterial& material = model.materials[block.material];
            const int k = find_name(material.type->derived, name);
            *out = k < 0 ? nan : material.law->derived(k, material.view(block, lane));
          }));
    }
}

/// Every field that the points of a run have.
std::vector<FieldRecipe> all_recipes(const Model& model, const State& state)
{
  std::vector<FieldRecipe> recipes;
  for (const RowInfo& row : model.rows.entries())
    if (row.shown) recipes.push_back(row_recipe(row));
  add_common_recipes(model, state, recipes);
  add_derived_recipes(model, recipes);
  return recipes;
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

/// The fields of n points from the id `first` on.
Frame gather_frame(const State& state, const std::vector<FieldRecipe>& recipes, std::int64_t first, std::int64_t n)
{
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

}  // namespace

Real deviatoric_strain(const PointBlock<2>& block, Index lane, DeviatoricNorm norm)
{
  std::array<Real, 4> strain;
  for (int k = 0; k < n_sym<2>; ++k) strain[k] = block.row(Rows::strain + k)[lane];
  return deviatoric_strain(strain, norm);
}

Real deviatoric_strain(const std::array<Real, 4>& strain, DeviatoricNorm norm)
{
  const Real mean = (strain[0] + strain[1] + strain[2]) / 3.0;
  Real square = 2.0 * strain[3] * strain[3];
  for (int k = 0; k < 3; ++k) square += (strain[k] - mean) * (strain[k] - mean);
  return std::sqrt(square * (norm == DeviatoricNorm::half ? 0.5 : 2.0 / 3.0));
}

std::optional<PointField> make_field(
    const Model& model, const State& state, const std::string& name, std::vector<std::string>& names)
{
  std::vector<FieldRecipe> recipes = all_recipes(model, state);
  names = {"position"};
  for (const FieldRecipe& r : recipes) names.push_back(r.name);
  std::erase_if(recipes, [&](const FieldRecipe& r) { return r.name != name; });
  if (recipes.empty() && name != "position") return {};
  Frame frame = gather_frame(state, recipes, 0, state.n_ids());
  if (recipes.empty()) return PointField{"position", "m", 2, std::move(frame.x)};
  return std::move(frame.fields[0]);
}

Frame make_frame(const Model& model, const State& state) { return make_frame(model, state, 0, state.n_ids()); }

Frame make_frame(const Model& model, const State& state, std::int64_t first, std::int64_t n)
{
  std::vector<FieldRecipe> recipes = all_recipes(model, state);
  std::erase_if(recipes, [&](const FieldRecipe& r) { return !wanted(model, r.name); });
  return gather_frame(state, recipes, first, n);
}

}  // namespace terp
