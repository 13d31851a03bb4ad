#include "simulation/reached_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

bool holds_soil(const State& state, const CellSide& edge) { return state.points.first_block(edge.cell) >= 0; }

bool has_soil(const State& state, const NamedSide& side)
{
  return std::any_of(
      side.edges.begin(), side.edges.end(), [&](const CellSide& edge) { return holds_soil(state, edge); });
}

/// What the case says of a side; free if it says nothing.
SideKind kind_of(const Model& model, const std::string& name)
{
  const auto& sides = model.description.sides;
  const auto found = std::find_if(sides.begin(), sides.end(), [&](const SideCase& s) { return s.side == name; });
  return found == sides.end() ? SideKind::free : found->kind;
}

/// One that ends the mesh rather than being a wall of the problem.
bool is_end_of_mesh(const Model& model, const std::string& name)
{
  const SideKind kind = kind_of(model, name);
  return kind == SideKind::free || kind == SideKind::roller || kind == SideKind::fixed;
}

/// The lower and the upper end of a cell's side [m]; of one that is steeper than 1:1.
struct Steep {
  Real low, high;
  bool is = false;
};

Steep heights_of(const Mesh<2>& mesh, const CellSide& edge)
{
  const auto x = mesh.corners(edge.cell);
  const Vec<2>&a = x[static_cast<std::size_t>(edge.side)], &b = x[static_cast<std::size_t>(edge.side + 1) % x.size()];
  return {std::min(a[1], b[1]), std::max(a[1], b[1]), std::abs(b[1] - a[1]) > std::abs(b[0] - a[0])};
}

/// NaN where no soil lies at a steep part of the side.
Real top_of_soil(const Model& model, const State& state, const NamedSide& side)
{
  Real top = nan;
  for (const CellSide& edge : side.edges)
    if (const Steep part = heights_of(*model.mesh, edge); part.is && holds_soil(state, edge))
      top = std::fmax(top, part.high);
  return top;
}

/// True where soil lies at the side with a cell between it and where it was.
bool has_risen(const Model& model, const State& state, const NamedSide& side, Real top)
{
  if (std::isnan(top) || !is_end_of_mesh(model, side.name)) return false;
  return std::any_of(side.edges.begin(), side.edges.end(), [&](const CellSide& edge) {
    const Steep part = heights_of(*model.mesh, edge);
    return part.is && part.low > top + 0.5 * (part.high - part.low) && holds_soil(state, edge);
  });
}

/// Sides that soil has come to get the time.
void note_sides(const Model& model, Real time, State& state)
{
  for (std::size_t k = 0; k < state.side_reached.size(); ++k) {
    Real& reached = state.side_reached[k];
    const NamedSide& side = model.mesh->sides[k];
    if (std::isnan(reached) ? has_soil(state, side)
                            : reached == 0.0 && has_risen(model, state, side, state.side_top[k]))
      reached = time;
  }
}

}  // namespace

void start_following_sides(const Model& model, State& state)
{
  state.side_reached.clear(), state.side_top.clear();
  for (const NamedSide& side : model.mesh->sides) {
    state.side_reached.push_back(has_soil(state, side) ? 0.0 : nan);
    state.side_top.push_back(top_of_soil(model, state, side));
  }
}

void follow_sides(const Model& model, State& state) { note_sides(model, state.time, state); }

std::vector<ReachedSide> list_reached_sides(const Model& model, const State& state)
{
  std::vector<ReachedSide> reached;
  for (std::size_t k = 0; k < state.side_reached.size(); ++k)
    if (const std::string& name = model.mesh->sides[k].name;
        state.side_reached[k] > 0.0 && kind_of(model, name) != SideKind::open)
      reached.push_back({name, state.side_reached[k], !std::isnan(state.side_top[k])});
  std::stable_sort(
      reached.begin(), reached.end(), [](const ReachedSide& a, const ReachedSide& b) { return a.time < b.time; });
  return reached;
}

}  // namespace terp
