// A point of another material goes to another block. All that change are taken out before any is put in, as a walk
// would meet them again. They are taken from the last lane on, since take() fills a gap with the last point. Stress is
// converted with the water of the model before, so this comes before the laws change.

#include "model/parts/change_soil.hpp"

#include "model/parts/initial.hpp"
#include "model/water/nodal_water.hpp"
#include "model/soils/point_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// Whether a state variable of one means the same in the other. Names of libraries are the user's: two of them may name
/// other things alike.
bool share_state(const MaterialCase& a, const MaterialCase& b)
{
  const LibraryCase &of_a = a.library, &of_b = b.library;
  return of_a.file == of_b.file && of_a.interface == of_b.interface && of_a.symbol == of_b.symbol;
}

/// Gives a point of another material the mass of that material and the rows that only its law has.
void change_row_values(const Model& model, Index from, Index to, std::vector<Real>& values)
{
  values[Rows::mass] *= model.materials[to].density / model.materials[from].density;
  const bool shared = share_state(model.description.materials[from], model.description.materials[to]);
  const int plastic_strain = row_of(model.materials[to], Role::plastic_strain);
  for (const RowInfo& row : model.rows.added()) {
    const bool is_other = !shared && row.owner == "law" && row.first != plastic_strain;
    if (row.is_of(to) && (!row.is_of(from) || is_other))
      std::fill_n(values.begin() + row.first, row.n, row.initial_in(to));
  }
}

/// Where a law has the largest pressure that its soil was loaded to, and the logarithm that it remembers that by.
struct CarriedPressure {
  int row;      ///< of the points; -1: the law knows none
  int derived;  ///< number of the field; -1: the law knows none

  explicit CarriedPressure(const SoilMaterial& material)
      : row(row_of(material, Role::carried_pressure)),
        derived(find_role(material.type->derived, Role::carried_pressure))
  {
  }
};

struct MovedPoint {
  BlockKey key;
  std::vector<Real> values;
};

/// Material in the stage of a model of a point that was of another one. What was below the water line stays so.
Index material_in_stage(const Model& model, Index body, Index from)
{
  const BodyCase& of = model.description.bodies[body];
  const MaterialCase& now = model.description.materials[from];
  const bool stays = !of.points_file.empty() || now.called() == of.material;
  return stays ? from : material_number(model, of.material, now.zone);
}

std::vector<MovedPoint> take_changed_points(const Model& model, const std::vector<Index>& body, StepState& state)
{
  std::vector<MovedPoint> moved;
  for (const Index cell : state.points.occupied())
    for (Index b = state.points.first_block(cell); b >= 0; b = state.points.block(b).next)
      for (Index lane = state.points.block(b).n; lane-- > 0;) {
        const PointBlock<2>& block = state.points.block(b);
        const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
        const Index from = block.material, to = material_in_stage(model, body[id], from);
        if (to == from) continue;
        MovedPoint& point =
            moved.emplace_back(MovedPoint{block, std::vector<Real>(static_cast<std::size_t>(state.points.n_rows()))});
        state.points.take(b, lane, point.values);
        change_row_values(model, from, to, point.values);
        point.key.material = to;
      }
  return moved;
}

}  // namespace

std::vector<Real> carried_pressures(const Model& model, const StepState& state)
{
  std::vector<Real> carried(static_cast<std::size_t>(state.n_ids()), std::numeric_limits<Real>::quiet_NaN());
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const CarriedPressure of(material);
    if (of.row < 0) return;
    for (Index lane = 0; lane < block.n; ++lane)
      carried[static_cast<std::size_t>(block.row(Rows::id)[lane])] =
          material.law->derived(of.derived, material.view(block, lane));
  });
  return carried;
}

void keep_carried_pressures(const Model& model, const std::vector<Real>& carried, StepState& state)
{
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const CarriedPressure of(material);
    if (of.row < 0) return;
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real before = carried[static_cast<std::size_t>(block.row(Rows::id)[lane])];
      const Real now = material.law->derived(of.derived, material.view(block, lane));
      if (std::isfinite(before) && before != now) block.row(of.row)[lane] += std::log(before / now);
    }
  });
}

bool have_same_materials(const Model& a, const Model& b)
{
  return std::ranges::equal(a.description.bodies, b.description.bodies, {}, &BodyCase::material, &BodyCase::material);
}

bool stores_other_stress(const Model& before, const Model& model)
{
  return !have_same_materials(before, model) || !std::ranges::equal(before.materials, model.materials, {},
                                                    &SoilMaterial::stores_effective, &SoilMaterial::stores_effective);
}

void change_stored_stress(const Model& before, const Model& model, const Seeds& seeds, StepState& state)
{
  const PorePressure pore = before.with.water ? water_at(before, state) : PorePressure();
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& from = before.materials[block.material];
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Index to = material_in_stage(model, seeds.bodies[id], block.material);
    if (from.stores_effective == model.materials[to].stores_effective) return;
    Real pressure = before.with.water ? pore_pressure_at(before, pore, block, lane) : 0.0;
    if (from.excess_row >= 0) {
      pressure += block.row(from.excess_row)[lane];
      block.row(from.excess_row)[lane] = 0.0;
    }
    for (int k = 0; k < 3; ++k) block.row(Rows::sigma + k)[lane] += from.stores_effective ? -pressure : pressure;
  });
}

void change_materials(const Model& model, const Seeds& seeds, const std::vector<Real>& carried, StepState& state)
{
  std::vector<MovedPoint> moved = take_changed_points(model, seeds.bodies, state);
  for (auto point = moved.rbegin(); point != moved.rend(); ++point) state.points.add(point->key, point->values);
  state.points.update_occupied();
  const auto varies = [&](const MovedPoint& point) { return model.materials[point.key.material].varies(); };
  if (std::ranges::any_of(moved, varies)) set_point_parameters(model, seeds, state);
  std::vector<bool> is_moved(static_cast<std::size_t>(state.n_ids()));
  std::vector<Real> of_moved(is_moved.size(), std::numeric_limits<Real>::quiet_NaN());
  for (const MovedPoint& point : moved) {
    const auto id = static_cast<std::size_t>(point.values[Rows::id]);
    is_moved[id] = true, of_moved[id] = carried[id];
  }
  keep_carried_pressures(model, of_moved, state);
  if (const auto wrong = find_wrong_start(model, state, [&](std::size_t id) { return is_moved[id]; }))
    throw RunError(fmt::format("t = {:.4f} s: {}: {}\n  {}", state.time, wrong->key, wrong->what, wrong->detail));
}

void change_densities(const Model& before, const Model& model, StepState& state)
{
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const Real was = before.materials[block.material].density, is = model.materials[block.material].density;
    if (is == was) return;
    for (Index lane = 0; lane < block.n; ++lane) block.row(Rows::mass)[lane] *= is / was;
  });
}

}  // namespace terp
