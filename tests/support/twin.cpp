#include "mpm/features/overlap.hpp"
#include "mpm/features/sides.hpp"
#include "support/twin.hpp"

#include "soil/laws/material.hpp"
#include "model/parts/setup.hpp"
#include "support/paths.hpp"

#include <nlohmann/json.hpp>

namespace terp::test {
namespace {

using Json = nlohmann::json;

const Json& scenarios()
{
  static const Json all = Json::parse(std::ifstream(source_path("tests/reference/one_step.json"))).at("scenarios");
  return all;
}

const Json& find_scenario(const std::string& name)
{
  for (const Json& s : scenarios())
    if (s.at("name") == name) return s;
  throw std::runtime_error("no scenario " + name);
}

/// All sides of cells on the mesh's boundary with both nodes chosen.
template <class Chosen>
NamedSide side_of(const Mesh<2>& mesh, const char* name, Chosen&& chosen)
{
  NamedSide side{name, {}};
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < 4; ++s)
      if (mesh.neighbours[e][s] == outside && chosen(mesh.cells[e][s]) && chosen(mesh.cells[e][(s + 1) % 4]))
        side.edges.push_back({e, s});
  return side;
}

Mesh<2> make_mesh(const Json& j)
{
  Mesh<2> mesh;
  mesh.nodes = j.at("nodes").get<std::vector<Vec<2>>>();
  mesh.cells = j.at("cells").get<std::vector<std::array<Index, 4>>>();
  connect(mesh);
  const auto fixed = j.at("fixed").get<std::vector<std::array<int, 2>>>();
  const auto contact = j.at("contact").at("nodes").get<std::vector<Index>>();
  mesh.sides.push_back(side_of(mesh, "wall", [&](Index i) { return fixed[i][0] == 1; }));
  mesh.sides.push_back(side_of(mesh, "base", [&](Index i) { return fixed[i][1] == 1; }));
  mesh.sides.push_back(
      side_of(mesh, "slab", [&](Index i) { return std::count(contact.begin(), contact.end(), i) == 1; }));
  return mesh;
}

/// One number for all nodes of the contact; 0 without contact.
Real common_value(const Json& list) { return list.empty() ? 0.0 : list.at(0).get<Real>(); }

MaterialCase make_material(const Json& j)
{
  const MaterialType* type = find_material(j.at("law").get<std::string>());
  std::vector<Real> values;
  for (const ParameterInfo& p : type->parameters)
    values.push_back(j.value(std::string(p.name), std::numeric_limits<Real>::quiet_NaN()));  // what it does not have
  return {"soil", std::string(type->name), j.at("density"), type->complete(values)};
}

/// The scenario's points are no body of the case: make_state has them.
Case make_case(const Json& j)
{
  const Json &o = j.at("options"), &contact = j.at("mesh").at("contact");
  Case c;
  c.scheme = j.at("scheme");
  c.method.filled_fraction = o.at("filled_fraction");
  c.method.b_bar = o.at("force_operator") == "b_bar";
  c.method.objective_rate = o.at("objective_rate") == "jaumann" ? ObjectiveRate::jaumann : ObjectiveRate::none;
  c.method.shares = o.at("shares") == "overlap" ? Shares::overlap : Shares::point;
  c.method.strain_shares = StrainShares::plain;  // the twin is written from the paper
  c.method.volume_change = VolumeChange::centre;
  c.method.pressure = Pressure::constant;
  c.forces.gravity = o.at("gravity").get<Vec<2>>();
  c.forces.local_damping = o.at("local_damping");
  c.materials = {make_material(j.at("material"))};
  c.bodies = {body("soil", {0.0, 0.0}, {1.0, 1.0})};
  c.sides = {side("wall", SideKind::roller), side("base", SideKind::roller), side("slab", SideKind::contact_bilateral)};
  c.sides[2].adhesion = common_value(contact.at("adhesion")),
  c.sides[2].friction = common_value(contact.at("friction"));
  return c;
}

void put_row(const Json& value, int row, std::vector<Real>& values)
{
  if (value.is_number()) {
    values[row] = value;
    return;
  }
  for (std::size_t k = 0; k < value.size(); ++k) values[row + static_cast<int>(k)] = value[k];
}

State make_state(const Model& model, const Json& points)
{
  State state;
  state.points = PointBlocks<2>(model.mesh->n_cells(), model.rows);
  const std::size_t n = points.at("x").size();
  for (std::size_t p = 0; p < n; ++p) {
    std::vector<Real> values(state.points.n_rows(), 0.0);
    const Index cell = points.at("cell")[p];
    put_row(points.at("x")[p], Rows::x, values);
    put_row(points.at("v")[p], Rows::v, values);
    put_row(points.at("mass")[p], Rows::mass, values);
    put_row(points.at("volume")[p], Rows::volume, values);
    put_row(points.at("sigma")[p], Rows::sigma, values);
    put_row(points.at("strain")[p], Rows::strain, values);
    if (!model.rows.added().empty()) put_row(points.at("eps_eq_p")[p], Rows::state, values);
    if (model.with.overlap) values[model.with.overlap->inverse_extent] = 1.0 / std::sqrt(values[Rows::volume]);
    values[Rows::id] = static_cast<Real>(p);
    const Vec<2> centre = model.mesh->centres[cell];
    const auto local = Quad4::local_coordinates(
        model.mesh->geometry(cell).map, Vec<2>{values[Rows::x] - centre[0], values[Rows::x + 1] - centre[1]});
    for (int d = 0; d < 2; ++d) values[Rows::xi + d] = local[d];
    state.points.add({cell, 0}, values);
  }
  state.points.update_occupied();
  state.x_initial.resize(2 * n);
  state.put_back.resize(n);
  return state;
}

std::vector<Real> flat(const Json& rows)
{
  std::vector<Real> values;
  for (const Json& row : rows) {
    const std::vector<Real> numbers =
        row.is_number() ? std::vector<Real>{row.get<Real>()} : row.get<std::vector<Real>>();
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  return values;
}

}  // namespace

std::vector<std::string> scenario_names()
{
  std::vector<std::string> names;
  for (const Json& s : scenarios()) names.push_back(s.at("name"));
  return names;
}

Scenario load_scenario(const std::string& name)
{
  const Json& j = find_scenario(name);
  Scenario s{.name = name,
      .n_steps = j.at("n_steps"),
      .model = build_model(make_case(j), std::make_shared<const Mesh<2>>(make_mesh(j.at("mesh"))), 1),
      .state = {},
      .expected = {}};
  s.model.dt = j.at("dt");
  s.state = make_state(s.model, j.at("points"));
  for (const char* field : {"x", "v", "volume", "sigma", "strain", "eps_eq_p"})
    s.expected.push_back({field, flat(j.at("expected").at(field))});
  return s;
}

Scenario load_free_scenario(const std::string& name)
{
  Scenario s = load_scenario(name);
  s.model.with.sides =
      std::make_shared<const SidesModel>(SidesModel{Boundary(*s.model.mesh, {}), s.model.with.sides->open});
  s.model.damping.local = 0.0;
  return s;
}

std::vector<Real> field_values(const State& state, const std::string& name)
{
  std::vector<Real> values;
  const auto put = [&](const auto& numbers) { values.insert(values.end(), numbers.begin(), numbers.end()); };
  for (const Point& p : points_by_id(state)) {
    if (name == "x") put(p.x);
    if (name == "v") put(p.v);
    if (name == "volume") values.push_back(p.volume);
    if (name == "sigma") put(p.sigma);
    if (name == "strain") put(p.strain);
    if (name == "eps_eq_p") values.push_back(p.eps_eq_p());
  }
  return values;
}

}  // namespace terp::test
