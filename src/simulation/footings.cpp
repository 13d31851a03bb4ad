// The place of a footing follows from the time alone and is found anew for each step. So the state of a run does not
// hold it. The box is widened by a small part of the lowest cell, or round-off would decide whether a node on its
// outline belongs to it.

#include "simulation/footings.hpp"

#include "mesh/mesh_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real outline_slack = 1e-6;  // of the lowest cell: nodes on the outline belong to the footing

Real slack_of(const Model& model) { return outline_slack * model.mesh->smallest_altitude; }

bool touches_soil(const Model& model, const State& state, const PlacedFooting& footing)
{
  const auto has_node = [&](Index cell) {
    return std::ranges::any_of(
        model.mesh->cells[cell], [&](Index node) { return footing.holds(model.mesh->nodes[node]); });
  };
  return std::ranges::any_of(state.points.occupied(), has_node);
}

/// How far the footing may come until the nodes at its front leave it at its back [m].
Real longest_way(const Footing& footing)
{
  const Vec<2> way = footing.displacement(2.0 * footing.ramp + 1.0);
  Real longest = INFINITY;
  for (int d = 0; d < 2; ++d)
    if (way[d] != 0.0)
      longest = std::min(longest, (footing.high[d] - footing.low[d]) / std::abs(way[d]) * std::hypot(way[0], way[1]));
  return longest;
}

}  // namespace

void place_footings(const Model& model, const State& state, Workspace& work)
{
  work.footings.clear();
  if (work.settling) return;
  for (const Footing& footing : model.footings)
    work.footings.push_back(place_footing(footing, state.time, model.dt, slack_of(model)));
}

std::vector<Problem> find_idle_footings(const Model& model, const State& state)
{
  std::vector<Problem> warnings;
  for (std::size_t k = 0; k < model.footings.size(); ++k) {
    const Footing& footing = model.footings[k];
    const std::string key = fmt::format("footing[{}].", k);
    if (!touches_soil(model, state, place_footing(footing, 0.0, model.dt, slack_of(model))))
      warnings.push_back({key + "box", fmt::format("the footing `{}` touches no soil", footing.name),
          "No node of a cell with soil lies in its box at t = 0. Let the lower side of the box lie on a row of nodes "
          "at the surface.",
          "footing"});
    const Vec<2> end = footing.displacement(model.description.time.end);
    if (const Real way = std::hypot(end[0], end[1]); way > longest_way(footing))
      warnings.push_back({key + "box",
          fmt::format("the footing `{}` moves out of the soil that it holds", footing.name),
          fmt::format(
              "It comes {:.3g} m far; the nodes at its front leave it at its back after {:.3g} m. Make the box larger.",
              way, longest_way(footing)),
          "footing"});
  }
  return warnings;
}

}  // namespace terp
