#include "simulation/reached_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

bool has_soil(const PointBlocks<2>& points, const NamedSide& side)
{
  return std::any_of(side.edges.begin(), side.edges.end(), [&](const CellSide& edge) { return points.first_block(edge.cell) >= 0; });
}

bool is_open(const Model& model, const std::string& name)
{
  const auto& sides = model.description.sides;
  return std::any_of(sides.begin(), sides.end(), [&](const SideCase& s) { return s.side == name && s.kind == SideKind::open; });
}

/// Sides without soil so far get the time if there is some now.
void note_sides(const Model& model, Real time, State& state)
{
  for (std::size_t k = 0; k < state.side_reached.size(); ++k)
    if (std::isnan(state.side_reached[k]) && has_soil(state.points, model.mesh.sides[k])) state.side_reached[k] = time;
}

}  // namespace

void start_following_sides(const Model& model, State& state)
{
  state.side_reached.assign(model.mesh.sides.size(), std::numeric_limits<Real>::quiet_NaN());
  note_sides(model, 0.0, state);
}

void follow_sides(const Model& model, State& state) { note_sides(model, state.time, state); }

std::vector<ReachedSide> list_reached_sides(const Model& model, const State& state)
{
  std::vector<ReachedSide> reached;
  for (std::size_t k = 0; k < state.side_reached.size(); ++k)
    if (state.side_reached[k] > 0.0 && !is_open(model, model.mesh.sides[k].name)) reached.push_back({model.mesh.sides[k].name, state.side_reached[k]});
  std::stable_sort(reached.begin(), reached.end(), [](const ReachedSide& a, const ReachedSide& b) { return a.time < b.time; });
  return reached;
}

}  // namespace terp
