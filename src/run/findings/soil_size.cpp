#include "run/findings/soil_size.hpp"

#include "model/meshes/setup_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

SoilSize measure_soil(const Model& model, const State& state)
{
  const Real g = std::hypot(model.gravity[0], model.gravity[1]);
  const Vec<2> down = g > 0.0 ? Vec<2>{model.gravity[0] / g, model.gravity[1] / g} : Vec<2>{0.0, -1.0};
  Real low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k + 1 < state.x_initial.size(); k += 2) {
    const Real depth = state.x_initial[k] * down[0] + state.x_initial[k + 1] * down[1];
    low = std::min(low, depth);
    high = std::max(high, depth);
  }
  return {g, std::max(high - low, 0.0), typical_cell_size(*model.mesh)};
}

std::array<Real, 2> ends_of_soil(const State& state)
{
  std::array<Real, 2> ends{INFINITY, -INFINITY};
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real x = block.row(Rows::x)[lane];
    ends = {std::min(ends[0], x), std::max(ends[1], x)};
  });
  return ends;
}

std::vector<bool> cells_of_soil(const Model& model, const State& state)
{
  constexpr Real filled = 0.5;
  std::vector<Real> volume(model.mesh->cells.size(), 0.0);
  for_each_point(state.points,
      [&](const PointBlock<2>& block, Index lane) { volume[block.cell] += block.row(Rows::volume)[lane]; });
  std::vector<bool> soil(volume.size());
  for (Index e = 0; e < model.mesh->n_cells(); ++e) soil[e] = volume[e] > filled * model.mesh->geometry(e).volume;
  return soil;
}

bool is_used(const Model& model, const std::string& material)
{
  return std::ranges::any_of(model.bodies, [&](const BodyShare& body) {
    return body.n_points > 0 && (" + " + body.material + " + ").find(" + " + material + " + ") != std::string::npos;
  });
}

}  // namespace terp
