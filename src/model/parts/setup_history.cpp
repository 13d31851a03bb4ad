// Points at equal distances from a place are usual in a regular grid, and round-off would decide between them. So
// distances are rounded to a nanometre before they are compared, and the coordinates decide a tie. Points are named by
// id, which indexes the places at t = 0 and stays when a point changes its cell.

#include "model/parts/setup_history.hpp"

#include "model/meshes/mesh_error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

Real distance(const std::vector<Real>& x, std::size_t id, Vec<2> place)
{
  return std::hypot(x[2 * id] - place[0], x[2 * id + 1] - place[1]);
}

/// The point nearest to a place; of equals the one with lower x, then lower y (reading R21).
std::int64_t nearest_point(const std::vector<Real>& x, Vec<2> place)
{
  const auto key = [&](std::size_t k) {
    return std::array<Real, 3>{
        std::round(distance(x, k, place) * 1e9), x[2 * k], x[2 * k + 1]};  // equal to a nanometre: a tie
  };
  std::size_t best = 0;
  for (std::size_t k = 1; 2 * k < x.size(); ++k)
    if (key(k) < key(best)) best = k;
  return static_cast<std::int64_t>(best);
}

/// Side of a square of the area of the cell that holds a point [m].
Real cell_size_at(const Model& model, const StepState& state, std::int64_t id)
{
  Real area = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (static_cast<std::int64_t>(block.row(Rows::id)[lane]) == id) area = model.mesh->geometry(block.cell).volume;
  });
  return std::sqrt(area);
}

}  // namespace

void follow_history_points(Model& model, const StepState& state)
{
  for (const auto& [name, place] : model.description.output.history_points)
    model.history_ids.push_back(nearest_point(state.x_initial, place));
}

std::vector<Problem> find_far_history_points(const Model& model, const StepState& state)
{
  std::vector<Problem> far;
  const auto& places = model.description.output.history_points;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [name, place] = places[k];
    const auto id = static_cast<std::size_t>(model.history_ids[k]);
    const Real away = distance(state.x_initial, id, place), size = cell_size_at(model, state, model.history_ids[k]);
    if (away <= size) continue;
    far.push_back({fmt::format("output.history.points.\"{}\"", name),
        fmt::format("no soil is near the history point `{}`", name),
        fmt::format(
            "The nearest material point, which is followed, lies {:.3g} m away at {} m; a cell there is {:.3g} m wide.",
            away, place_text({state.x_initial[2 * id], state.x_initial[2 * id + 1]}), size),
        "output.history.points"});
  }
  return far;
}

}  // namespace terp
