// The order in model_of counts: rows of the points in their order, and `set_stage` needs the time step. seed_soil makes
// all points, also those of bodies that come later, so that a point has one number in all stages.

#include "model/parts/setup.hpp"
#include "mpm/features/bodies.hpp"
#include "mpm/features/excess.hpp"
#include "mpm/features/footings.hpp"
#include "mpm/features/loads.hpp"
#include "mpm/features/mean_force.hpp"
#include "mpm/features/overlap.hpp"
#include "mpm/features/sides.hpp"
#include "mpm/features/slip.hpp"
#include "mpm/features/softening.hpp"

#include "math/errors.hpp"
#include "model/meshes/mesh_error.hpp"
#include "mpm/features/patch_rows.hpp"
#include "model/ground/flood_level.hpp"
#include "model/parts/initial.hpp"
#include "model/parts/parts.hpp"
#include "mpm/step/kernels.hpp"
#include "model/loads/loads.hpp"
#include "model/water/nodal_water.hpp"
#include "model/loads/check_placed_bodies.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/soils/reference_width.hpp"
#include "model/parts/setup_history.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/soils/softening_scales.hpp"
#include "model/parts/stage_case.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// What cells take from their neighbours has room for so many numbers of a law.
void check_room_for_state(const Model& model, const std::vector<Index>& used)
{
  if (!model.scheme->keeps_gauss_values || model.method.shares != Shares::overlap) return;
  const int others = HistoryRows::end + (model.with.slip ? 1 : 0) + (has_excess_pressure(model) ? 1 : 0);
  const int room = PatchView::most_rows - others;
  for (const Index m : used) {
    const SoilMaterial& material = model.materials[m];
    if (material.n_rows() <= room) continue;
    throw InputError(Problem{"material." + material.name, "the law has too many state variables for this scheme",
        fmt::format("{} numbers of each point; {} has room for {} with method.shares = \"overlap\".\n"
                    "Use scheme = \"mpm_gp\", or method.shares = \"point\".",
            material.n_rows(), model.scheme->name, room),
        "method.shares", false, {"scheme", "method.shares"}});
  }
}

bool is_fluid(const SoilMaterial& material) { return material.law->shear_modulus() == 0.0; }

/// With which still water stays still (decision 0074).
constexpr Real flip_of_fluids = 0.95;

/// What the method leaves to the laws. Water that breaks up stops itself with shares that overlap (decision 0042).
void set_method_by_law(const std::vector<Index>& used, Model& model)
{
  const bool any_fluid = std::ranges::any_of(used, [&](Index m) { return is_fluid(model.materials[m]); });
  MethodOptions& method = model.method;
  if (method.shares == Shares::by_law) method.shares = any_fluid ? Shares::point : Shares::overlap;
  const Real given = method.flip;
  for (SoilMaterial& material : model.materials)
    material.flip = !std::isnan(given) ? given : is_fluid(material) ? flip_of_fluids : 1.0;
  if (std::isnan(given)) method.flip = any_fluid ? flip_of_fluids : 1.0;
}

/// Elastic soil does not slip.
bool slips_in_cut_cells(const Model& model, const std::vector<Index>& used)
{
  return model.method.cut_cells == CutCells::slip && looks_at(*model.scheme, "cut_cells") && used.size() > 1 &&
         std::ranges::any_of(used, [&](Index m) { return can_yield(model.materials[m]); });
}

int add_slip_row(RowTable& rows)
{
  return rows.add({.name = "last_plastic_work",
      .unit = "J/m^3",
      .meaning = "plastic work of the last step per volume, after which soils slip in the cells that they share",
      .owner = "slip"});
}

int add_extent_row(RowTable& rows)
{
  return rows.add({.name = "inverse_extent",
      .unit = "1/m",
      .meaning = "1 / side of the square by which the point counts in sub-cells",
      .owner = "method"});
}

/// A formula may give no number at some place.
void check_velocities(const Case& c, const Mesh<2>& mesh)
{
  for (const SideCondition& side : c.sides) {
    if (!side.velocity_at) continue;
    for (const CellSide& edge : find_side(mesh, side.side).edges) {
      const Vec<2> x = mesh.nodes[mesh.cells[edge.cell][edge.side]], v = side.velocity_at(x);
      if (!std::isfinite(v[0] + v[1]))
        throw InputError(Problem{fmt::format("boundary.\"{}\".velocity", side.side),
            "the velocity is not a finite number everywhere on the side",
            fmt::format("It is [{}, {}] m/s at {} m.", v[0], v[1], place_text(x)), "boundary.SIDE.velocity"});
    }
  }
}

void check_least_depth(const FloodCase& flood, const Mesh<2>& mesh)
{
  const auto [low, high] = std::ranges::minmax(mesh.nodes, {}, [](const Vec<2>& x) { return x[1]; });
  if (flood.least_depth < high[1] - low[1]) return;
  throw InputError(Problem{"flood.least_depth", "the least depth is deeper than the section",
      fmt::format("Got {:g} m; the mesh is {:g} m high. No soil could slide. Give less, 0.5 to 2 m for a dike.",
          flood.least_depth, high[1] - low[1]),
      "flood.least_depth", false, {"mesh"}});
}

std::shared_ptr<const FootingsModel> make_footings(const Case& c)
{
  FootingsModel footings;
  for (const FootingCase& f : c.footings)
    footings.all.push_back({f.name, f.low, f.high, f.velocity, f.ramp, f.contact == FootingContact::rough});
  return footings.all.empty() ? nullptr : std::make_shared<const FootingsModel>(std::move(footings));
}

/// Of a stage: the bodies that it places or digs away; null: no stage does.
std::shared_ptr<const BodiesModel> make_bodies(const Case& c, std::size_t number, RowTable& rows)
{
  if (std::ranges::none_of(c.bodies, comes_or_goes)) return nullptr;
  BodiesModel bodies{.held_row = add_held_row(rows)};
  for (const BodyCase& body : c.bodies) {
    bodies.places |= body.placed == number + 1;
    bodies.removes |= body.removed == number + 1;
  }
  return std::make_shared<const BodiesModel>(bodies);
}

OpenSides make_open_sides(const Case& c, const Mesh<2>& mesh)
{
  OpenSides open(mesh.cells.size(), 0);
  for (const SideCondition& s : c.sides)
    if (info_of(s.kind).soil_leaves)
      for (const CellSide& edge : find_side(mesh, s.side).edges)
        open[edge.cell] |= static_cast<std::uint8_t>(1u << edge.side);
  return open;
}

void set_damping(const ForcesCase& forces, Model& model)
{
  model.damping = {
      .local = forces.local_damping, .averaging_time = forces.averaging_time, .viscous = forces.viscous_damping};
  if (const Real g = std::hypot(model.gravity[0], model.gravity[1]); g > 0.0)
    model.damping.down = {model.gravity[0] / g, model.gravity[1] / g};
}

void set_softening(const std::vector<Index>& used, Model& model)
{
  Real length = 0.0;  // the largest of those in use
  for (const Index m : used)
    if (model.materials[m].increment_row >= 0) length = std::max(length, model.materials[m].softening.length);
  for (const Index m : used) model.materials[m].softening_scale = scale_by_cell(*model.mesh, model.materials[m]);
  check_cells_in_length(model, used);
  if (length > 0.0)
    model.with.softening =
        std::make_shared<const SofteningModel>(SofteningModel{make_node_diffusion(*model.mesh, length)});
}

/// n_steps: to the end of the run.
Model model_of(std::shared_ptr<const Parts> parts, std::size_t number, std::int64_t n_steps, int threads)
{
  const Case& whole = *parts->whole;
  const Soils& soils = parts->soils[number];
  const std::vector<Index>& used = parts->used;
  Model model;
  model.stage.number = number;
  model.description = soils.description;
  if (!whole.stages.empty()) {
    model.description.stages = whole.stages;
    model.description.ground_of = whole.ground_of ? whole.ground_of : parts->whole;
  }
  const Case& c = model.description;
  model.mesh = parts->mesh;
  model.materials = soils.materials;
  model.rows = soils.rows;
  model.largest_density = parts->largest_density, model.n_steps = n_steps, model.dt = parts->dt;
  model.threads = threads;
  model.method = c.method;
  model.parts = std::move(parts);
  check_velocities(c, *model.mesh);
  if (c.flood.asks()) check_least_depth(c.flood, *model.mesh);
  model.with.sides =
      std::make_shared<const SidesModel>(SidesModel{Boundary(*model.mesh, c.sides), make_open_sides(c, *model.mesh)});
  model.with.footings = make_footings(c);
  set_ramp(whole, number, model);
  set_damping(c.forces, model);
  model.scheme = find_scheme(c.scheme);
  model.step = kernels().step, model.find_forces = kernels().find_forces, model.strain = kernels().strain;
  if (model.scheme == nullptr) throw InputError(Problem{"scheme", "no such scheme", "", "scheme"});
  set_method_by_law(used, model);
  if (slips_in_cut_cells(model, used))
    model.with.slip = std::make_shared<const SlipModel>(SlipModel{add_slip_row(model.rows)});
  check_room_for_state(model, used);
  if (model.scheme->uses_patches(model.method.shares))
    model.with.overlap = std::make_shared<const OverlapModel>(OverlapModel{add_extent_row(model.rows)});
  if (model.with.loads) {
    LoadsModel loads = *model.with.loads;
    add_rows_of_loads(loads.all, model.rows);
    model.with.loads = std::make_shared<const LoadsModel>(std::move(loads));
  }
  model.with.bodies = make_bodies(c, number, model.rows);
  set_softening(used, model);
  if (c.water.is_given()) model.with.water = model.nodal_water = std::make_shared<const NodalWater>(model);
  model.flood_level = find_flood_level(whole, model);
  set_stage(whole, number, model);
  return model;
}

}  // namespace

Model build_model(const Case& description, int threads)
{
  return build_model(description, std::make_shared<const Mesh<2>>(build_mesh(description)), threads);
}

Model build_model(const Case& description, SharedMesh mesh, int threads)
{
  if (threads < 1)
    throw InputError(Problem{"threads", "a run needs at least one thread", fmt::format("Got {}.", threads), ""});
  const std::shared_ptr<const Parts> parts = parts_of(description, mesh);
  return model_of(parts, 0, parts->n_steps, threads);
}

Model build_stage(const Model& of_run, std::size_t number)
{
  Model model = model_of(of_run.parts, number, of_run.n_steps, of_run.threads);
  TERP_ASSERT(model.rows == of_run.rows);
  return model;
}

void move_end(Model& model, Real end)
{
  const Real n = steps_to(end, model.dt);
  if (!(n < most_steps))
    throw InputError(Problem{"time.end", "the end is too far",
        fmt::format("{:.3g} s need {:.3g} steps of {:.3g} s.", end, n, model.dt), "time"});
  model.stage.steps += static_cast<std::int64_t>(n) - model.n_steps;
  model.n_steps = static_cast<std::int64_t>(n);
  model.description.time.end = n * model.dt;
}

StepState seed_soil(Model& model)
{
  PointBatches points = make_points(model);
  model.bodies = shares_of_bodies(model, points);
  StepState state;
  state.points = PointBlocks<2>(model.mesh->n_cells(), model.rows);
  const Seeds seeds = seeds_of(points);
  state.x_initial = seeds.places;
  const auto n = static_cast<std::size_t>(state.n_ids());
  state.put_back.assign(n, false);
  check_placed_bodies(model, points);
  add_points(
      model, std::move(points), [](const BodyCase& body) { return body.is_there; }, state);
  state.points.update_occupied();
  check_softening_lengths(model, state);
  check_reference_widths(model, state);
  state.points.reserve(static_cast<std::int64_t>(n / 4));
  if (model.damping.averaging_time > 0.0) state.with.mean_force.set({std::vector<Vec<2>>(model.mesh->nodes.size())});
  set_point_parameters(model, seeds, state);
  place_first_loads(model, state);
  set_initial_stress(model, seeds.bodies, state);
  follow_history_points(model, state);
  return state;
}

}  // namespace terp
