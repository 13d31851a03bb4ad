// The order in build() counts. The ground comes before settle_laws, as fields take the stress of the soil above from
// it. The time step needs the stiffness of all laws, and set_stage needs the time step. Rows, time step and ground are
// those of all stages: what decides them asks every stage (in_any_stage), not this one. seed_soil makes all points,
// also those of bodies that come later, so that a point has one number in all stages.

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
#include "mpm/kernels/time_step.hpp"
#include "model/meshes/mesh_error.hpp"
#include "mpm/features/patch_rows.hpp"
#include "model/ground/flood_level.hpp"
#include "model/parts/initial.hpp"
#include "mpm/step/kernels.hpp"
#include "model/loads/loads.hpp"
#include "model/seepage/computed_water.hpp"
#include "model/water/nodal_water.hpp"
#include "model/soils/overburden.hpp"
#include "model/loads/check_placed_bodies.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/parts/reduce.hpp"
#include "model/soils/reference_width.hpp"
#include "model/soils/settle_fields.hpp"
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

/// Steps to the end; the tolerance is round-off of an end that is a whole number of steps.
Real steps_to(Real end, Real step) { return std::ceil(end / step * (1.0 - 1e-12)); }

/// The strength of the law does, or that of its parameters: all of its angles are zero at all points.
bool ignores_pressure(const MaterialCase& m, const MaterialType& type)
{
  if (type.ignores_pressure) return true;
  const std::vector<int> varying = varying_parameters(m, type);
  bool has_angle = false, has_friction = false;
  for (int k = 0; k < static_cast<int>(type.parameters.size()); ++k) {
    if (type.parameters[k].reduction != Reduction::divide_tangent) continue;
    has_angle = true;
    has_friction |= m.parameters[k] != 0.0 || std::ranges::find(varying, k) != varying.end();
  }
  return has_angle && !has_friction;
}

/// Whether of(its case) holds in any stage.
template <class Of>
bool in_any_stage(const Case& whole, Of&& of)
{
  bool any = of(case_of_stage(whole, 0));
  for (std::size_t k = 1; k < whole.stages.size(); ++k) any = any || of(case_of_stage(whole, k));
  return any;
}

/// whole: a law that tears in any stage has its opening in all of them, as the rows are those of the whole run.
std::vector<SoilMaterial> make_materials(const Case& c, const Case& whole)
{
  std::vector<SoilMaterial> materials;
  for (const MaterialCase& m : c.materials) {
    const bool tears = in_any_stage(whole, [k = materials.size()](const Case& s) { return s.materials[k].tears(); });
    const MaterialType* type = m.type(tears);
    if (type == nullptr)
      throw InputError(Problem{"material." + m.name + ".model", "no such material model", "", "material"});
    materials.push_back({m.name, type, type->make_varying(m.parameters, varying_parameters(m, *type)), m.density, {},
        m.softening, m.stores_effective()});
    SoilMaterial& material = materials.back();
    material.ignores_pressure = ignores_pressure(m, *type);
    material.is_ground = m.ground && !m.is_fluid();
  }
  return materials;
}

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

/// Numbers of the materials that points may have, in any stage: those of the bodies, or all of them if a file of points
/// names its own.
std::vector<Index> used_materials(const Case& whole)
{
  std::vector<Index> used;
  for (Index m = 0; m < static_cast<Index>(whole.materials.size()); ++m) {
    bool is_used = false;
    for (std::size_t k = 0; k < std::max<std::size_t>(1, whole.stages.size()); ++k)
      for (const BodyCase& body : case_of_stage(whole, k).bodies)
        is_used = is_used || !body.points_file.empty() || body.material == whole.materials[m].called();
    if (is_used) used.push_back(m);
  }
  return used;
}

/// The rows are those of the whole run, whatever soil is in the stage: the state goes through all of them.
void add_rows_of_materials(const Case& whole, const std::vector<Index>& used, Model& model)
{
  const bool any_excess = in_any_stage(
      whole, [](const Case& c) { return std::ranges::any_of(c.materials, &MaterialCase::has_excess_pressure); });
  for (const Index m : used) {
    add_rows(m, model.materials[m], model.rows);
    if (any_excess && in_any_stage(whole, [m](const Case& c) { return c.materials[m].stores_effective(); }))
      add_excess_row(m, model.materials[m], model.rows);
  }
}

/// The case with its strengths divided by the factor that it asks for.
Case as_solved(const Case& c) { return c.at_strength == 1.0 ? c : reduce_strength(c, c.at_strength); }

/// What limits the time step in any stage.
struct StepLimit {
  Real stable = std::numeric_limits<Real>::infinity(), fastest = 0.0, largest_density = 0.0;

  void enter(const Model& model, const std::vector<Index>& used, const FieldsOfPoints& fields)
  {
    for (const Stiffness& s : list_stiffness(model, used, fields)) {
      const Real density = model.materials[s.material].density;
      fastest = std::max(fastest, wave_speed(s.moduli.p_wave(), density));
      stable = std::min(stable, stable_step(model, s));
      largest_density = std::max(largest_density, density);
    }
  }
};

FieldsOfPoints settle_laws(const Case& whole, const std::vector<Index>& used, Model& model)
{
  FieldsOfPoints fields = settle_fields(model);
  add_rows_of_materials(whole, used, model);
  set_water_stiffness(model, used, fields);
  return fields;
}

StepLimit find_step_limit(
    const Case& whole, const Model& model, const std::vector<Index>& used, const FieldsOfPoints& fields)
{
  StepLimit limit;
  limit.enter(model, used, fields);
  for (std::size_t k = 0; k < whole.stages.size(); ++k) {
    if (k == model.stage.number) continue;
    Model other;
    other.mesh = model.mesh;
    other.method = model.method;
    other.description = as_solved(case_of_stage(whole, k));
    other.materials = make_materials(other.description, whole);
    other.ground = model.ground;
    other.later_ground = model.later_ground;
    limit.enter(other, used, settle_laws(whole, used, other));
  }
  return limit;
}

/// dt is the stable step, shortened so that the end is a whole number of steps (decision 0024).
void set_time_step(const Case& whole, const std::vector<Index>& used, const FieldsOfPoints& fields, Model& model)
{
  const TimeCase& time = whole.time;
  const StepLimit limit = find_step_limit(whole, model, used, fields);
  model.largest_density = limit.largest_density;
  const Real stable = limit.stable, n = steps_to(time.end, stable);
  if (!(n < most_steps))
    throw InputError(Problem{"time.end", "the time step has collapsed",
        fmt::format("{:.3g} s need {:.3g} steps of {:.3g} s (smallest cell altitude {:.3g} m, wave speed {:.4g} m/s).",
            time.end, n, stable, model.mesh->smallest_altitude, limit.fastest),
        "time", false, {"mesh", "material", "time"}});
  model.n_steps = static_cast<std::int64_t>(n);
  model.dt = time.end / n;
}

/// What lies above places in a stage: its soil with its gravity in full. Loads do not count: whether undrained soil has
/// settled under one, as under a road, or not, as under traffic, the case does not say, and strength that it may not
/// have is not on the safe side.
std::shared_ptr<const Overburden> ground_in(const Case& whole, std::size_t number, const SharedMesh& mesh)
{
  Model model;
  model.mesh = mesh;
  model.description = case_of_stage(whole, number);
  model.materials = make_materials(model.description, whole);
  set_ramp(whole, number, model);
  model.with.loads = nullptr;
  return std::make_shared<const Overburden>(model);
}

/// The ground at t = 0, and in each stage that places bodies. Where no parameter varies, none is needed.
void set_ground(const Case& whole, Model& model)
{
  const auto has_field = [](const MaterialCase& m) { return !m.fields.empty(); };
  if (!in_any_stage(whole, [&](const Case& c) { return std::ranges::any_of(c.materials, has_field); })) return;
  const Case& of = whole.ground_of ? *whole.ground_of : whole;
  model.ground = ground_in(of, 0, model.mesh);
  for (const BodyCase& body : of.bodies)
    if (body.placed > 0 && !model.later_ground.contains(body.placed))
      model.later_ground.emplace(body.placed, ground_in(of, body.placed - 1, model.mesh));
}

/// of_run: another stage of the same run; nullptr: this is the first model of it.
Model build(const Case& whole, SharedMesh mesh, int threads, std::size_t number, const Model* of_run)
{
  if (threads < 1)
    throw InputError(Problem{"threads", "a run needs at least one thread", fmt::format("Got {}.", threads), ""});
  Model model;
  const Case description = as_solved(case_of_stage(whole, number));
  model.stage.number = number;
  model.description = description;
  if (!whole.stages.empty()) {
    model.whole = std::make_shared<const Case>(whole);
    model.description.stages = whole.stages;
    model.description.ground_of = whole.ground_of ? whole.ground_of : model.whole;
  }
  model.mesh = std::move(mesh);
  model.materials = make_materials(description, whole);
  model.method = description.method;
  check_velocities(description, *model.mesh);
  if (description.flood.asks()) check_least_depth(description.flood, *model.mesh);
  model.with.sides = std::make_shared<const SidesModel>(
      SidesModel{Boundary(*model.mesh, description.sides), make_open_sides(description, *model.mesh)});
  model.with.footings = make_footings(description);
  set_ramp(whole, number, model);
  model.damping = {.local = description.forces.local_damping,
      .averaging_time = description.forces.averaging_time,
      .viscous = description.forces.viscous_damping};
  if (const Real g = std::hypot(model.gravity[0], model.gravity[1]); g > 0.0)
    model.damping.down = {model.gravity[0] / g, model.gravity[1] / g};
  model.scheme = find_scheme(description.scheme);
  model.step = kernels().step, model.find_forces = kernels().find_forces, model.strain = kernels().strain;
  if (model.scheme == nullptr) throw InputError(Problem{"scheme", "no such scheme", "", "scheme"});
  model.threads = threads;
  if (of_run != nullptr)
    model.ground = of_run->ground, model.later_ground = of_run->later_ground;
  else
    set_ground(whole, model);
  const std::vector<Index> used = used_materials(whole);
  const FieldsOfPoints fields = settle_laws(whole, used, model);
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
  model.with.bodies = make_bodies(description, number, model.rows);
  Real length = 0.0;  // the largest of those in use
  for (const Index m : used)
    if (model.materials[m].increment_row >= 0) length = std::max(length, model.materials[m].softening.length);
  for (const Index m : used) model.materials[m].softening_scale = scale_by_cell(*model.mesh, model.materials[m]);
  check_cells_in_length(model, used);
  if (length > 0.0)
    model.with.softening =
        std::make_shared<const SofteningModel>(SofteningModel{make_node_diffusion(*model.mesh, length)});
  if (of_run != nullptr)
    model.largest_density = of_run->largest_density, model.n_steps = of_run->n_steps, model.dt = of_run->dt;
  else
    set_time_step(whole, used, fields, model);
  if (description.water.is_given()) model.with.water = model.nodal_water = std::make_shared<const NodalWater>(model);
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
  return build(with_computed_water(description, mesh), mesh, threads, 0, nullptr);
}

Model build_stage(const Model& of_run, std::size_t number)
{
  Model model = build(*of_run.whole, of_run.mesh, of_run.threads, number, &of_run);
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
