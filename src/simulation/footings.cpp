#include "simulation/footings.hpp"

#include "mesh/mesh_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::string_view reaction_meaning =
    "force of the soil on the footing, summed over its nodes, mean since the row before: the momentum that the footing "
    "gave over the time";
constexpr Real outline_slack = 1e-6;  // of the lowest cell: nodes on the outline belong to the footing

Real slack_of(const Model& model) { return outline_slack * model.mesh->smallest_altitude; }

Real dot(Vec<2> a, Vec<2> b) { return a[0] * b[0] + a[1] * b[1]; }

/// Component of a reaction against the motion of the footing; its size if the footing rests.
Real resistance(const Footing& footing, Vec<2> reaction)
{
  const Real speed = std::hypot(footing.velocity[0], footing.velocity[1]);
  return speed > 0.0 ? -dot(reaction, footing.velocity) / speed : std::hypot(reaction[0], reaction[1]);
}

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

void add_footing_impulses(const Workspace& work, const std::array<Vec<2>, most_footings>& impulse, State& state)
{
  for (std::size_t k = 0; k < work.footings.size(); ++k) {
    for (int d = 0; d < 2; ++d) state.footings[k].impulse[d] -= impulse[k][d];
    state.footings[k].work += dot(impulse[k], work.footings[k].velocity);
  }
}

const std::shared_ptr<const RunTable>& footings_table()
{
  static const auto table = std::make_shared<const RunTable>(RunTable{.name = "footings",
      .meaning = "displacement and measured reaction of each footing",
      .columns = {{"time", "s", "time", "of the step"}, {"footing", "", "footing", "name in the case file", true},
          {"displacement_x", "m", "displacement, x", "of the footing since t = 0"},
          {"displacement_y", "m", "displacement, y", "of the footing since t = 0"},
          {"reaction_x", "N/m", "reaction, x", reaction_meaning},
          {"reaction_y", "N/m", "reaction, y", reaction_meaning},
          {"work", "J/m", "work", "done by the footing on the soil so far; part of `boundary_work` of the ledger"}}});
  return table;
}

std::vector<TableRow> keep_footings(const Model& model, State& state)
{
  std::vector<TableRow> rows;
  for (std::size_t k = 0; k < model.footings.size(); ++k) {
    const Footing& footing = model.footings[k];
    FootingMeter& meter = state.footings[k];
    if (const Real interval = state.time - meter.since; interval > 0.0) {
      meter.reaction = {meter.impulse[0] / interval, meter.impulse[1] / interval};
      meter.impulse = {0.0, 0.0};
      meter.since = state.time;
      meter.largest = std::max(meter.largest, resistance(footing, meter.reaction));
    }
    const Vec<2> moved = footing.displacement(state.time);
    TableRow row(footings_table(), footing.name);
    row.values = {state.time, moved[0], moved[1], meter.reaction[0], meter.reaction[1], meter.work};
    rows.push_back(std::move(row));
  }
  return rows;
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
