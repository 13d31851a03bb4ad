// Checks do not rely on each other. Each looks at the model as it is before the first step, and adds to one list. Small
// checks stand in this file; larger groups have files of their own.

#include "mpm/features/conditions.hpp"
#include "run/findings/setup_warnings.hpp"

#include "model/meshes/mesh_error.hpp"
#include "model/loads/footings.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/reference_width.hpp"
#include "model/soils/settle_fields.hpp"
#include "model/parts/setup_history.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/soils/softening_scales.hpp"
#include "run/findings/contrast_warnings.hpp"
#include "run/findings/field_warnings.hpp"
#include "run/findings/flood_warnings.hpp"
#include "run/findings/library_warnings.hpp"
#include "run/findings/limit_warnings.hpp"
#include "run/findings/missing_soil.hpp"
#include "run/findings/shared_cells.hpp"
#include "run/findings/side_warnings.hpp"
#include "run/findings/time_warnings.hpp"
#include "run/findings/water_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

void find_empty_bodies(const Model& model, std::vector<Problem>& warnings)
{
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].n_points > 0) continue;
    const std::string of = model.bodies[b].material.empty() ? "" : fmt::format(" of `{}`", model.bodies[b].material);
    warnings.push_back({fmt::format("body[{}]", b),
        fmt::format("{}{} has no material points", called(model.description.bodies[b], b), of),
        "Later bodies cover it wholly: where bodies overlap, the last one counts. Change the order of the bodies, or "
        "leave it out.",
        "body"});
  }
}

/// Points that fill no cell by a quarter: a lattice of one point per cell fills whole ones, so their volumes are in
/// another unit, or the cells far too large for them.
void find_thin_points(const Model& model, std::vector<Problem>& warnings)
{
  constexpr Real little = 0.25;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!(model.bodies[b].fullest_cell < little)) continue;
    warnings.push_back({fmt::format("body[{}].points", b), "the points of the file fill no cell by a quarter",
        fmt::format("Their volumes fill {:.2g} % of the fullest cell; inside a body they fill the cells. "
                    "Volumes are in m^2 (per metre of thickness).",
            100.0 * model.bodies[b].fullest_cell),
        "body"});
  }
}

/// What is dug away leaves a face that a few cells over its height hold up, whatever the soil: with 1.5, 3 and 6 cells
/// a face of 1.5 m has factors of 1.10, 0.88 and 0.79 (docs/stages.md).
void find_low_excavations(const Model& model, std::vector<Problem>& warnings)
{
  constexpr Real least = 5.0;  // cells over the height, as of a slope (docs/stability.md)
  const Real cell = typical_cell_size(*model.mesh);
  const Overburden overburden(model);
  const auto& bodies = model.whole().bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].removed == never || bodies[b].polygon.empty()) continue;
    const auto [low, high] = std::ranges::minmax(bodies[b].polygon, {}, [](const Vec<2>& x) { return x[1]; });
    const auto [from, to] = std::ranges::minmax(bodies[b].polygon, {}, [](const Vec<2>& x) { return x[0]; });
    const Real height = high[1] - low[1], middle = 0.5 * (high[1] + low[1]);
    // beside it: a face
    const auto stands = [&, bottom = low[1]](Real x) { return overburden.ground(x).value_or(bottom) > middle; };
    if (!stands(from[0] - 0.5 * cell) && !stands(to[0] + 0.5 * cell)) continue;
    if (height >= least * cell * (1.0 - 1e-9)) continue;
    warnings.push_back({fmt::format("body[{}]", b),
        fmt::format("{} is dug away over {:.2g} cells of height, which hold up a face that soil does not: what becomes "
                    "of the face itself needs cells of at most {:.2g} m (docs/stages.md#bodies-that-come-and-go)",
            called(bodies[b], b), height / cell, height / least),
        "", "", false, {"mesh.cell", "mesh"}});
  }
}

/// A mean over less than a step is the force of that step.
void find_short_averaging(const Model& model, std::vector<Problem>& warnings)
{
  const Real time = model.damping.averaging_time;
  if (!(time > 0.0 && time <= model.dt)) return;
  warnings.push_back({"forces.damping.averaging_time", "the averaging time is not longer than a time step",
      fmt::format("Got {:.4g} s; the step is {:.4g} s: local damping acts on the force of the step alone. Usual: the "
                  "time in which a\ncompression wave crosses the soil once or twice, 0.02 s for 2 m of clay.",
          time, model.dt),
      "forces.damping.averaging_time", false, {"forces.damping"}});
}

/// Frames that do not say which points are soil, of a run in which soil comes or goes.
void find_frames_without_soil(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const auto& names = whole.output.field_names;
  const auto tells = [](const std::string& name) { return name == "material" || name == "cell" || name == "volume"; };
  if (names.empty() || std::ranges::any_of(names, tells)) return;
  if (!std::ranges::any_of(whole.bodies, comes_or_goes) &&
      std::ranges::find(whole.sides, SideKind::open, &SideCondition::kind) == whole.sides.end())
    return;
  warnings.push_back({"output.fields.names", "the frames do not say of which points there is soil",
      "Pictures, page and exports show points of bodies that are not there, and points that left through an open side. "
      "Add \"material\".",
      "output.fields.names"});
}

}  // namespace

std::vector<Problem> find_warnings(const Model& model, const State& state)
{
  std::vector<Problem> warnings = find_far_history_points(model, state);
  find_empty_bodies(model, warnings);
  std::ranges::move(find_flood_warnings(model, state), std::back_inserter(warnings));
  find_thin_points(model, warnings);
  find_low_excavations(model, warnings);
  find_frames_without_soil(model, warnings);
  find_odd_sides(model, state, warnings);
  find_missing_soil(model, state, warnings);
  find_odd_places(model, warnings);
  find_odd_water(model, state, warnings);
  find_odd_seepage(model, warnings);
  find_odd_scales(model, state, warnings);
  find_odd_contrasts(model, state, warnings);
  find_odd_softening_lengths(model, state, warnings);
  find_shared_layers(model, state, warnings);
  find_known_limits(model, state, warnings);
  find_odd_libraries(model, state, warnings);
  find_wide_cells(model, state, warnings);
  find_short_averaging(model, warnings);
  find_odd_times(model, state, warnings);
  find_odd_fields(model, state, warnings);
  find_uncovered_soil(model, state, warnings);
  for (Problem& problem : find_idle_footings(model, state)) warnings.push_back(std::move(problem));
  return warnings;
}

}  // namespace terp
