#include "simulation/setup.hpp"

#include "base/errors.hpp"
#include "forces/time_step.hpp"
#include "simulation/initial.hpp"
#include "simulation/step.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::int64_t most_steps = 1'000'000'000;  // beyond: a time step that has collapsed, not a case

Index whole_cells(Real size, Real cell)
{
  const Real n = size / cell;
  if (std::abs(n - std::round(n)) > 1e-6 * n || n < 0.5)
    throw InputError(Problem{"mesh.cell", "the mesh is not a whole number of cells",
                             fmt::format("size {} m over cell {} m is {:.6g} cells. Use {:.6g} m.", size, cell, n,
                                         size / std::max<Real>(1.0, std::round(n))),
                             "mesh"});
  if (n > 1e5) throw InputError(Problem{"mesh.cell", "the mesh has too many cells", fmt::format("{:.3g} cells in one direction, at most 100000.", n), "mesh"});
  return static_cast<Index>(std::round(n));
}

std::vector<SoilMaterial> make_materials(const Case& c)
{
  std::vector<SoilMaterial> materials;
  for (const MaterialCase& m : c.materials) {
    const MaterialType* type = find_material(m.model);
    if (type == nullptr) throw InputError(Problem{"material." + m.name + ".model", "no such material model", "", "material"});
    materials.push_back({m.name, type, type->make(m.parameters), m.density});
  }
  return materials;
}

std::vector<SideCondition> make_sides(const Case& c)
{
  std::vector<SideCondition> sides;
  for (const SideCase& s : c.sides) {
    const auto add = [&](Hold hold) { sides.push_back({s.side, hold, s.adhesion, s.friction, s.velocity}); };
    switch (s.kind) {
      case SideKind::free: break;
      case SideKind::open: break;
      case SideKind::roller: add(Hold::normal); break;
      case SideKind::fixed: add(Hold::all); break;
      case SideKind::velocity: add(Hold::all); break;
      case SideKind::contact_bilateral: add(Hold::contact); break;
      case SideKind::contact_separating: add(Hold::separating); break;
    }
  }
  return sides;
}

/// Sides that the case calls "open".
OpenSides make_open_sides(const Case& c, const Mesh<2>& mesh)
{
  OpenSides open(mesh.cells.size(), 0);
  for (const SideCase& s : c.sides)
    if (s.kind == SideKind::open)
      for (const CellSide& edge : find_side(mesh, s.side).edges) open[edge.cell] |= static_cast<std::uint8_t>(1u << edge.side);
  return open;
}

Index material_number(const Model& model, const std::string& name)
{
  for (std::size_t k = 0; k < model.materials.size(); ++k)
    if (model.materials[k].name == name) return static_cast<Index>(k);
  throw InputError(Problem{"body", "no material `" + name + "`", "", "body"});
}

/// Only materials that a body uses decide the time step.
void set_time_step(Model& model)
{
  Real fastest = 0.0;
  for (const BodyCase& body : model.description.bodies) {
    const SoilMaterial& m = model.materials[material_number(model, body.material)];
    fastest = std::max(fastest, wave_speed(m.law->p_wave_modulus(), m.density));
    model.largest_density = std::max(model.largest_density, m.density);
    model.n_state = std::max(model.n_state, m.n_state());
  }
  const TimeCase& time = model.description.time;
  const Real stable = stable_time_step(time.courant, model.mesh.smallest_altitude, fastest);
  const Real n = std::ceil(time.end / stable * (1.0 - 1e-12));
  if (!(n < most_steps))
    throw InputError(Problem{"time.end", "the time step has collapsed",
                             fmt::format("{:.3g} s need {:.3g} steps of {:.3g} s (smallest cell altitude {:.3g} m, wave speed {:.4g} m/s).",
                                         time.end, n, stable, model.mesh.smallest_altitude, fastest),
                             "time"});
  model.n_steps = static_cast<std::int64_t>(n);
  model.dt = time.end / n;
}

/// Every corner of every body must lie in the mesh.
void check_bodies_in_mesh(const Case& c)
{
  const Vec<2> low = c.mesh.origin, high{low[0] + c.mesh.size[0], low[1] + c.mesh.size[1]};
  for (std::size_t b = 0; b < c.bodies.size(); ++b)
    for (const auto& x : c.bodies[b].polygon)
      for (int d = 0; d < 2; ++d) {
        const Real slack = 1e-9 * c.mesh.size[d];
        if (x[d] >= low[d] - slack && x[d] <= high[d] + slack) continue;
        throw InputError(Problem{fmt::format("body[{}]", b), "the body lies outside the mesh",
                                 fmt::format("corner ({}, {}) m; the mesh covers x = {} to {} m, y = {} to {} m.\nEnlarge mesh.size or move the body.",
                                             x[0], x[1], low[0], high[0], low[1], high[1]),
                                 "mesh"});
      }
}

void add_points(const Model& model, const std::vector<Seed>& seeds, State& state)
{
  using Rows = PointRows<2>;
  std::vector<Real> values(state.points.n_rows());
  std::vector<Index> materials;
  for (const BodyCase& body : model.description.bodies) materials.push_back(material_number(model, body.material));
  for (std::size_t k = 0, end = 0; k < seeds.size(); k = end) {
    while (end < seeds.size() && seeds[end].cell == seeds[k].cell && seeds[end].body == seeds[k].body) ++end;
    state.points.expect(seeds[k].cell, materials[seeds[k].body], static_cast<Index>(end - k));
  }
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    const Seed& seed = seeds[k];
    const Index material = materials[seed.body];
    std::fill(values.begin(), values.end(), 0.0);
    const auto local = local_coordinates(model.mesh.geometry(seed.cell), seed.x[0] - model.mesh.centres[seed.cell][0],
                                         seed.x[1] - model.mesh.centres[seed.cell][1]);
    for (int d = 0; d < 2; ++d) {
      values[Rows::x + d] = seed.x[d];
      values[Rows::xi + d] = local[d];
      values[Rows::v + d] = model.description.bodies[seed.body].velocity[d];
      state.x_initial[2 * k + d] = seed.x[d];
    }
    values[Rows::mass] = seed.volume * model.materials[material].density;
    values[Rows::volume] = seed.volume;
    values[Rows::id] = static_cast<Real>(k);
    state.points.add(seed.cell, material, values);
  }
}

/// The point nearest to a place; of equals the one with lower x, then lower y (reading R21).
std::int64_t nearest_point(const std::vector<Real>& x, Vec<2> place)
{
  const auto key = [&](std::size_t k) {
    const Real distance = std::hypot(x[2 * k] - place[0], x[2 * k + 1] - place[1]);
    return std::array<Real, 3>{std::round(distance * 1e9), x[2 * k], x[2 * k + 1]};  // equal to a nanometre: a tie
  };
  std::size_t best = 0;
  for (std::size_t k = 1; 2 * k < x.size(); ++k)
    if (key(k) < key(best)) best = k;
  return static_cast<std::int64_t>(best);
}

}  // namespace

Model build_model(const Case& description, int threads)
{
  Model model;
  model.description = description;
  const MeshCase& mesh = description.mesh;
  check_bodies_in_mesh(description);
  model.mesh = make_rectangle(mesh.origin, mesh.size, {whole_cells(mesh.size[0], mesh.cell[0]), whole_cells(mesh.size[1], mesh.cell[1])});
  model.materials = make_materials(description);
  model.method = description.method;
  model.boundary = Boundary(model.mesh, make_sides(description));
  model.open_sides = make_open_sides(description, model.mesh);
  model.gravity = description.forces.gravity;
  model.damping = {description.forces.local_damping, description.forces.viscous_damping};
  model.step = find_step(description.scheme);
  if (model.step == nullptr) throw InputError(Problem{"scheme", "no such scheme", "", "scheme"});
  model.threads = threads;
  set_time_step(model);
  return model;
}

std::vector<Seed> seed_bodies(const Model& model)
{
  std::vector<BodyOutline> outlines;
  for (const BodyCase& body : model.description.bodies) outlines.push_back({body.polygon, body.points_per_cell});
  return seed_points(model.mesh, outlines);
}

State build_state(Model& model)
{
  const auto seeds = seed_bodies(model);
  if (seeds.empty())
    throw InputError(Problem{"body[0]", "no material points",
                             "The bodies hold no point of the seeding lattice. Use a larger body, smaller cells or more points per cell.", "body"});
  State state;
  state.points = PointBlocks<2>(model.mesh.n_cells(), model.n_state);
  state.x_initial.resize(2 * seeds.size());
  state.put_back.assign(seeds.size(), 0);
  add_points(model, seeds, state);
  state.points.update_occupied();
  state.points.reserve(static_cast<std::int64_t>(seeds.size() / 4));
  set_initial_stress(model, state);
  for (const auto& [name, place] : model.description.output.history_points) model.history_ids.push_back(nearest_point(state.x_initial, place));
  const MeshCase& mesh = model.description.mesh;
  state.crest = start_crest_history(state.points, mesh.origin[0], mesh.origin[0] + mesh.size[0], mesh.cell[0]);
  return state;
}

}  // namespace terp
