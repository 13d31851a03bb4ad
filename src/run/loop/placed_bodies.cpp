// The body of a point follows from its number, by making the points again (seeds_of). A body is in the state if any of
// its points is there or has left the mesh: else one that flowed out would come again. Soil
// that has moved there shows as too much volume in the cells of the new points.

#include "run/loop/placed_bodies.hpp"

#include "math/errors.hpp"
#include "model/meshes/mesh_error.hpp"
#include "mpm/features/bodies.hpp"
#include "mpm/features/water.hpp"
#include "mpm/step/stored_energy.hpp"
#include "model/water/nodal_water.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/bodies/setup_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// Where soil has moved to the place of new points: by how much a cell is overfull, and where most.
struct Crowd {
  Real area = 0.0, worst = 0.0;  ///< [m^2]
  Vec<2> where{0.0, 0.0};        ///< [m]
};

/// is_new: of cells.
Crowd find_crowd(const Model& model, const State& state, const std::vector<bool>& is_new)
{
  Crowd crowd;
  for (const Index cell : state.points.occupied()) {
    if (!is_new[static_cast<std::size_t>(cell)]) continue;
    Real volume = -model.mesh->geometry(cell).volume;
    for_each_block(state.points, cell, [&](const PointBlock<2>& block, Index) {
      for (Index lane = 0; lane < block.n; ++lane) volume += block.row(Rows::volume)[lane];
    });
    crowd.area += std::max(volume, Real(0.0));
    if (volume > crowd.worst) crowd.worst = volume, crowd.where = model.mesh->centres[cell];
  }
  return crowd;
}

/// What of the bodies is in the state, by number.
std::vector<bool> bodies_in(const State& state, const std::vector<Index>& body, std::size_t n)
{
  std::vector<bool> there(n, false);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    there[static_cast<std::size_t>(body[static_cast<std::size_t>(block.row(Rows::id)[lane])])] = true;
  });
  for (const LeftPoint& p : state.left) there[static_cast<std::size_t>(body[static_cast<std::size_t>(p.id)])] = true;
  return there;
}

/// Total stress of soil that stores it: that of the water around it.
void start_stress(const Model& model, const PorePressure& pore, const PointBlock<2>& block, Index lane)
{
  if (!model.with.water || model.materials[block.material].stores_effective) return;
  const Real pressure = pore_pressure_at(model, pore, block, lane);
  for (int k = 0; k < 3; ++k) block.row(Rows::sigma + k)[lane] = -pressure;
}

void place(const Model& model, const std::vector<Index>& body, const std::vector<bool>& comes, State& state)
{
  const BodyCase* first = model.description.bodies.data();
  add_points(
      model, make_points(model), [&](const BodyCase& b) { return comes[static_cast<std::size_t>(&b - first)]; }, state);
  state.points.update_occupied();
  const PorePressure pore = model.with.water ? water_at(model, state) : PorePressure();
  std::vector<bool> is_new(model.mesh->cells.size(), false);
  Real area = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (!comes[static_cast<std::size_t>(body[static_cast<std::size_t>(block.row(Rows::id)[lane])])]) return;
    block.row(held_row_of(model))[lane] = 1.0;
    start_stress(model, pore, block, lane);
    state.mass_placed += block.row(Rows::mass)[lane];
    area += block.row(Rows::volume)[lane];
    is_new[static_cast<std::size_t>(block.cell)] = true;
  });
  constexpr Real most = 0.1;  // of the area of the new bodies
  if (const Crowd crowd = find_crowd(model, state, is_new); crowd.area > most * area)
    throw RunError(fmt::format(
        "t = {:.4f} s: soil has moved to where the stage `{}` places a body: {:.3g} m^2 of {:.3g} m^2, most at {} m\n"
        "  Draw the body where there is room then, or place it in an earlier stage "
        "(docs/stages.md#bodies-that-come-and-go)",
        state.time, model.stage.name, crowd.area, area, place_text(crowd.where)));
}

}  // namespace

void change_bodies(const Model& model, const Seeds& seeds, State& state)
{
  if (!model.with.bodies) return;
  const std::vector<BodyCase>& bodies = model.description.bodies;
  const std::vector<Index>& body = seeds.bodies;
  std::vector<bool> comes = bodies_in(state, body, bodies.size()), goes = comes;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    comes[b] = !comes[b] && bodies[b].is_there;
    goes[b] = goes[b] && !bodies[b].is_there;
  }
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto of = static_cast<std::size_t>(body[static_cast<std::size_t>(block.row(Rows::id)[lane])]);
    block.row(held_row_of(model))[lane] = goes[of] ? -1.0 : 0.0;
  });
  if (std::ranges::find(comes, true) == comes.end()) return;
  place(model, body, comes, state);
  set_point_parameters(model, seeds, state, comes);
}

void remove_held_bodies(const Model& model, State& state)
{
  if (!model.with.bodies) return;
  const Real before = kinetic_and_stored_energy(model, state);
  std::vector<Real> values(static_cast<std::size_t>(state.points.n_rows()));
  bool any = false;
  for (const Index cell : state.points.occupied())
    for (Index b = state.points.first_block(cell); b >= 0; b = state.points.block(b).next)
      for (Index lane = state.points.block(b).n; lane-- > 0;) {
        if (!(state.points.block(b).row(held_row_of(model))[lane] < 0.0)) continue;
        state.points.take(b, lane, values);
        state.mass_removed += values[Rows::mass];
        any = true;
      }
  if (!any) return;
  state.points.update_occupied();
  state.start_energy += kinetic_and_stored_energy(model, state) - before;
}

bool remove_due_bodies(const Model& model, State& state)
{
  if (!model.with.bodies || state.step != step_of_removal(model, state)) return false;
  const std::int64_t n = state.points.n_points();
  remove_held_bodies(model, state);
  return state.points.n_points() != n;
}

}  // namespace terp
