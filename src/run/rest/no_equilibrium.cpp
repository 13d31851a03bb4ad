// Both messages have the same parts: what was found, where, what is likely, what to try. The force out of balance at a
// node comes from its mass and its change of velocity in the last step. The search uses soil made stiffer by a factor,
// so the largest distance moved is multiplied by that factor before it is reported.

#include "run/rest/no_equilibrium.hpp"

#include "model/meshes/mesh_error.hpp"
#include "model/parts/model.hpp"
#include "model/parts/reduce.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real depth_of_face = 1.5;  // of what may have raveled below the ground [m]

Real distance_moved(const State& state, const PointBlock<2>& block, Index lane)
{
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  return std::hypot(
      block.row(Rows::x)[lane] - state.x_initial[2 * id], block.row(Rows::x + 1)[lane] - state.x_initial[2 * id + 1]);
}

/// Name of the material that most soil around a node is of.
std::string soil_at(const Model& model, const State& state, Index node)
{
  std::vector<Real> volume(model.materials.size(), 0.0);
  for (Index k = model.mesh->first_cell_of_node[node]; k < model.mesh->first_cell_of_node[node + 1]; ++k)
    for_each_block(state.points, model.mesh->cells_of_node[k].cell, [&](const PointBlock<2>& block, Index) {
      for (Index lane = 0; lane < block.n; ++lane) volume[block.material] += block.row(Rows::volume)[lane];
    });
  return model.materials[static_cast<std::size_t>(std::ranges::max_element(volume) - volume.begin())].name;
}

/// The node with the largest force out of balance, and how far around it half of all of them lies.
std::string describe_unbalanced(const Model& model, const State& state, const Workspace& work)
{
  const auto force_of = [&](Index i) {
    return work.node[i].mass * std::hypot(work.node[i].dv[0], work.node[i].dv[1]) / model.dt;
  };
  const Index largest = *std::ranges::max_element(work.active_nodes, {}, force_of);
  const Vec<2> at = model.mesh->nodes[largest];
  std::vector<std::pair<Real, Real>> around;  // distance [m], force [N per m]
  Real all = 0.0;
  for (const Index i : work.active_nodes) {
    const Vec<2> x = model.mesh->nodes[i];
    around.emplace_back(std::hypot(x[0] - at[0], x[1] - at[1]), force_of(i));
    all += around.back().second;
  }
  std::ranges::sort(around);
  Real sum = 0.0;
  const auto half = std::ranges::find_if(around, [&](const auto& node) { return 2.0 * (sum += node.second) >= all; });
  return fmt::format("the largest force is at {} m, in `{}`; half of all lies within {:.3g} m of it", place_text(at),
      soil_at(model, state, largest), half == around.end() ? 0.0 : half->first);
}

struct Furthest {
  Real moved = -1.0;  ///< [m]
  Vec<2> from{};      ///< [m]
  Index material = 0;
};

Vec<2> place_at_start(const State& state, const PointBlock<2>& block, Index lane)
{
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  return {state.x_initial[2 * id], state.x_initial[2 * id + 1]};
}

Furthest furthest_of(const State& state)
{
  Furthest found;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (const Real moved = distance_moved(state, block, lane); moved > found.moved)
      found = {moved, place_at_start(state, block, lane), block.material};
  });
  return found;
}

std::string describe_moved(const Model& model, const Furthest& furthest, Real stiffening)
{
  return fmt::format("soil moved furthest from {} m, in `{}`: by {:.3g} m", place_text(furthest.from),
      model.materials[furthest.material].name, stiffening * furthest.moved);
}

/// What holds a face of soil without cohesion that ravels, a line of the list of cures; empty: something else moved.
std::string cure_for_face(const Model& model, const State& state, const Furthest& furthest)
{
  const MaterialCase& soil = model.description.materials[furthest.material];
  Real ground = furthest.from[1];
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x = place_at_start(state, block, lane);
    if (std::abs(x[0] - furthest.from[0]) < 0.5 * depth_of_face) ground = std::max(ground, x[1]);
  });
  if (!is_sand(soil) || ground - furthest.from[1] > depth_of_face) return "";
  return fmt::format(
      "\n           if only its face ravels, 2 kPa in the outer metre (docs/dstability.md#faces-without-cohesion): "
      "material.{}.cohesion = "
      "{{ depth = [[0, \"2 kPa\"], [1, \"2 kPa\"], [1, 0], [50, 0]] }}",
      soil.name);
}

}  // namespace

std::string describe_failure(const Model& model, const State& state, Real moved, Real stiffening)
{
  const Furthest furthest = furthest_of(state);
  return fmt::format(
      "no equilibrium: the soil fails in the section as it is drawn; after {} steps a hundredth of it had moved by "
      "more than {:.2g} m, ever faster\n\n"
      "  where    {}\n"
      "  likely   it cannot stand under its weight, its water and its loads\n"
      "  try      initial.stress = \"k0\", to see it fail; a stronger soil; or at_strength below 1 in a first stage, "
      "as `terp import --held` writes it (docs/troubleshooting.md#no-equilibrium){}",
      state.equilibrium_steps, moved, describe_moved(model, furthest, stiffening),
      cure_for_face(model, state, furthest));
}

std::string describe_no_equilibrium(const Model& model, const State& state, const Workspace& work, Real stiffening)
{
  const InitialCase& initial = model.description.initial;
  const Furthest furthest = furthest_of(state);
  return fmt::format(
      "no equilibrium: after {} steps the out-of-balance force is {:.2e} of the weight, limit {:.2e}\n\n"
      "  where    {}\n"
      "           {}\n"
      "  likely   the body cannot stand under its own weight, or needs more steps\n"
      "  try      initial.stress = \"none\" or \"k0\", a stronger soil, a larger initial.max_steps, or at_strength "
      "below 1 in a first stage, as `terp import --held` writes it (docs/troubleshooting.md#no-equilibrium){}",
      initial.max_steps, work.unbalanced_ratio, initial.limit, describe_unbalanced(model, state, work),
      describe_moved(model, furthest, stiffening), cure_for_face(model, state, furthest));
}

}  // namespace terp
