#include "model/loads/footings.hpp"

#include "model/meshes/mesh_error.hpp"
#include "mpm/features/footings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

bool touches_soil(const Model& model, const StepState& state, const PlacedFooting& footing)
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

std::vector<Problem> find_idle_footings(const Model& model, const StepState& state)
{
  std::vector<Problem> warnings;
  const std::span<const Footing> footings = footings_of(model);
  for (std::size_t k = 0; k < footings.size(); ++k) {
    const Footing& footing = footings[k];
    const std::string key = fmt::format("footing[{}].", k);
    if (!touches_soil(model, state, place_footing(footing, 0.0, model.dt, outline_slack(*model.mesh))))
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
