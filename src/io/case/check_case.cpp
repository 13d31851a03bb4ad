// All checks run, whatever others found, so that a user sees all problems at once. Each must therefore bear values that
// could not be read: they have their defaults, and parameters that are missing are NaN (complete_type). Whether a key
// was written shows in the tree alone: in the case a default looks like a written value.

#include "io/case/check_case.hpp"

#include "math/closest.hpp"
#include "io/case/key_text.hpp"
#include "io/case/other_files.hpp"
#include "io/case/side_kinds.hpp"
#include "run/report/frame_fields.hpp"
#include "mpm/features/footing.hpp"
#include "model/parts/initial.hpp"
#include "model/parts/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr const char* shapes[] = {"box", "polygon", "region", "points"};

void check_shape(const Node& body, const std::string& path, Problems& problems)
{
  std::vector<std::string> given;
  for (const char* shape : shapes)
    if (find_item(body, shape) != nullptr) given.emplace_back(shape);
  if (given.empty())
    problems.push_back({path, "the body has no shape",
        "Give box = [[x0, y0], [x1, y1]] or polygon = [[x, y], [x, y], [x, y], ...] in m,\nor region = "
        "\"NAME\" of a mesh file, or points = \"FILE.csv\".",
        "body", true});
  for (std::size_t k = 1; k < given.size(); ++k)
    problems.push_back(
        {path + '.' + given[k], fmt::format("a body has either `{}` or `{}`, not both", given[0], given[k]),
            "Remove one of the two.", "body", true});
}

void check_body_keys(const Node& body, const std::string& path, MeshKind mesh, Findings& findings)
{
  const auto has = [&](const char* name) { return find_item(body, name) != nullptr; };
  if (has("holes") && (has("region") || has("points")))
    findings.problems.push_back({path + ".holes", "`holes` belongs to a box or polygon",
        fmt::format("Leave it out with `{}`.", has("region") ? "region" : "points"), "body.holes", true});
  if (has("region") && mesh != MeshKind::file)
    findings.problems.push_back({path + ".region", "a region needs a mesh from a file",
        "Regions are physical groups of [mesh] file = \"NAME.msh\". Give box or polygon here.", "body.region", true});
  if (!has("points")) return;
  if (has("points_per_cell"))
    findings.problems.push_back({path + ".points_per_cell", "`points_per_cell` does not go with `points`",
        "The file holds every material point. Remove one of the two.", "body.points", true});
  if (has("material"))
    findings.warnings.push_back({path + ".material", "`material` has no effect",
        "The file of points names the material of each one.", "body.points", true});
}

/// A hole that cuts nothing out: the boxes about hole and body do not overlap.
void check_holes(const BodyCase& body, const std::string& path, Problems& warnings)
{
  for (std::size_t k = 0; k < body.holes.size() && !body.polygon.empty(); ++k)
    for (int axis = 0; axis < 2 && !body.holes[k].empty(); ++axis) {
      const BoundingBox whole = box_around(body.polygon), hole = box_around(body.holes[k]);
      if (hole.low[axis] < whole.high[axis] && hole.high[axis] > whole.low[axis]) continue;
      warnings.push_back({fmt::format("{}.holes[{}]", path, k), "the hole lies outside the body",
          fmt::format("It covers {0} = {1} to {2} m, the body {0} = {3} to {4} m.", axis == 0 ? 'x' : 'y',
              hole.low[axis], hole.high[axis], whole.low[axis], whole.high[axis]),
          "body.holes"});
      break;
    }
}

/// Whether the name stands in a section that Terp does not know, as that of a soil in [materials.clay].
bool is_in_unknown_section(const Node& root, const std::string& name, const Problems& problems)
{
  return std::ranges::any_of(root.items, [&](const Node& section) {
    return section.kind == NodeKind::table && find_item(section, name) != nullptr &&
           std::ranges::any_of(problems, [&](const Problem& problem) {
             return problem.key == section.name && problem.what.starts_with("unknown key");
           });
  });
}

void check_bodies(const Node& root, const Case& values, Findings& findings)
{
  Problems& problems = findings.problems;
  std::vector<std::string> names;
  for (const MaterialCase& material : values.materials)
    if (material.zone != Zone::above) names.push_back(material.called());
  const Node* list = find_item(root, "body");
  for (std::size_t k = 0; k < values.bodies.size(); ++k) {
    const std::string path = fmt::format("body[{}]", k), &name = values.bodies[k].material;
    if (list->items[k].kind == NodeKind::table) {
      check_shape(list->items[k], path, problems);
      check_body_keys(list->items[k], path, values.mesh.kind, findings);
    }
    check_holes(values.bodies[k], path, findings.warnings);
    const auto same_name = [&](const BodyCase& other) { return other.name == values.bodies[k].name; };
    if (const auto here = values.bodies.begin() + static_cast<std::ptrdiff_t>(k);
        !values.bodies[k].name.empty() && std::any_of(values.bodies.begin(), here, same_name))
      problems.push_back({path + ".name", fmt::format("two bodies have the name `{}`", values.bodies[k].name),
          "Give each its own, as in name = \"berm\".", "body.name"});
    if (const std::string& own = values.bodies[k].name;
        !own.empty() && own.find_first_not_of("0123456789") == std::string::npos)
      problems.push_back({path + ".name", fmt::format("`{}` is no name of a body, but a number of one", own),
          fmt::format("`--set body.{}.material=...` changes the body of that number. Give a name with a letter.", own),
          "body.name"});
    const bool named = !name.empty() && values.bodies[k].points_file.empty();
    if (!named || names.empty() || std::ranges::find(names, name) != names.end()) continue;
    if (is_in_unknown_section(root, name, problems)) continue;
    const std::string hint = did_you_mean(name, names);
    problems.push_back({path + ".material", fmt::format("there is no material `{}`", name),
        hint + fmt::format("Materials of this case: {}", plain_list(names)), "body.material"});
  }
  if (list != nullptr && list->kind == NodeKind::list && list->items.empty())
    problems.push_back({"body", "the case has no body", "Write at least one [[body]].", "body", true});
}

/// The law's own limits, where every parameter is there and in range; of parameters that vary: where there are points.
void check_parameters(const Case& values, Problems& problems)
{
  for (const MaterialCase& material : values.materials) {
    const MaterialType* law = material.complete_type();
    if (law == nullptr || !material.fields.empty()) continue;
    const std::string path = material_path(material);
    for (const ParameterProblem& problem : law->check(material.parameters))
      problems.push_back(
          {join_path(path, problem.parameter), problem.what, problem.detail, std::string(law->name), false, {path}});
  }
}

/// Of parameters that vary: where there are points (limit_warnings.cpp).
void check_cutoff(const Case& values, Problems& warnings)
{
  for (const MaterialCase& material : values.materials) {
    const MaterialType* law = material.complete_type();
    if (law == nullptr || !material.fields.empty()) continue;
    const auto k = std::ranges::find(law->parameters, tension_cutoff, &ParameterInfo::name) - law->parameters.begin();
    if (k == std::ssize(law->parameters) || law->parameters[static_cast<std::size_t>(k)].reduction != Reduction::divide)
      continue;
    const Real cutoff = material.parameters[static_cast<std::size_t>(k)],
               most = largest_tension(*law, material.parameters);
    if (std::isfinite(cutoff) && cutoff > most) warnings.push_back(idle_cutoff(material, cutoff, most));
  }
}

void check_unused_materials(const Case& values, Problems& warnings)
{
  for (const MaterialCase& material : values.materials) {
    const auto uses = [&](const BodyCase& body) {
      return body.material.empty() || !body.points_file.empty() || body.material == material.called();
    };
    if (std::ranges::none_of(values.bodies, uses))
      warnings.push_back({material_path(material), fmt::format("no body uses the material `{}`", material.name), "",
          "body.material", true});
  }
}

void check_sides(const Node& root, const Case& values, Findings& findings)
{
  const Node* boundary = find_item(root, "boundary");
  if (boundary == nullptr || boundary->kind != NodeKind::table) return;
  for (const Node& side : boundary->items) check_side(side, join_path("boundary", side.name), findings.problems);
  for (const SideCondition& side : values.sides) check_doubts(side, findings.warnings);
}

void check_footings(const Node& root, const Case& values, Problems& problems)
{
  const std::vector<FootingCase>& footings = values.footings;
  if (footings.size() > most_footings)
    problems.push_back({fmt::format("footing[{}]", most_footings),
        fmt::format("a case has at most {} footings", most_footings), "", "footing", true});
  for (std::size_t k = 0; k < footings.size(); ++k) {
    const std::string path = fmt::format("footing[{}]", k);
    const auto same_name = [&](const FootingCase& other) { return other.name == footings[k].name; };
    if (std::any_of(footings.begin(), footings.begin() + static_cast<std::ptrdiff_t>(k), same_name))
      problems.push_back({path + ".name", fmt::format("two footings have the name `{}`", footings[k].name),
          "Give each its own, as in name = \"left\".", "footing.name", false, {path}});
    if (footings[k].contact == FootingContact::smooth && footings[k].velocity == Vec<2>{0.0, 0.0} &&
        find_node(root, path + ".velocity") != nullptr)
      problems.push_back({path + ".velocity", "a smooth footing needs a velocity",
          "It holds its nodes along its velocity only, which is zero. Give a velocity, or contact = \"rough\".",
          "footing.velocity"});
  }
}

/// The slope of the pressure follows gravity and the water, and knows nothing of other forces on the points.
void check_body_force(const Case& values, Findings& findings)
{
  if (!values.forces.body.at || values.method.pressure != Pressure::balanced ||
      values.forces.gravity == Vec<2>{0.0, 0.0})
    return;
  findings.problems.push_back({"forces.body", "`body` needs method.pressure = \"constant\" where there is gravity",
      "The slope of the pressure in a cell follows the weight, and does not know this force.\n"
      "Give pressure = \"constant\" in [method], or gravity into `by`: \"-9.81 + ...\".",
      "forces.body", false, {"method.pressure", "forces.gravity"}});
}

void check_initial(const Node& root, const Case& values, Findings& findings)
{
  const InitialStress stress = values.initial.stress;
  const bool weightless = values.forces.gravity == Vec<2>{0.0, 0.0};
  const auto about_forces = [](const Problem& problem) { return problem.key.starts_with("forces"); };
  const bool forces_read = std::ranges::none_of(findings.problems, about_forces);
  if (stress != InitialStress::none && weightless && forces_read)
    findings.problems.push_back({"initial.stress", "an initial stress needs gravity",
        "Set gravity = [0.0, -9.81] in [forces], or stress = \"none\".", "initial"});
  for (std::size_t k = 0; k < values.bodies.size() && stress == InitialStress::k0; ++k)
    if (!values.bodies[k].points_file.empty())
      findings.problems.push_back({fmt::format("body[{}].points", k), "`k0` needs the outline of every body",
          "A file of points has none, so the weight of the soil above a place is not known. Use "
          "initial.stress = \"equilibrium\",\nor give the body as box, polygon or region.",
          "initial", true, {"initial.stress"}});
  bool is_given = false;
  for (std::size_t k = 0; k < values.bodies.size(); ++k) {
    if (!values.bodies[k].stress) continue;
    is_given = true;
    if (stress != InitialStress::none)
      findings.problems.push_back({fmt::format("body[{}].stress", k), "two stresses are given for t = 0",
          "`stress` of a body counts with initial.stress = \"none\". Remove one of the two.", "body.stress", true,
          {"initial.stress"}});
  }
  if (stress == InitialStress::none && !weightless && !is_given && values.water.is_given())
    findings.warnings.push_back({"water", "the soil carries nothing at the start",
        "initial.stress is none: gravity and water fall at once on soil without stress. Give stress = \"equilibrium\" "
        "in [initial],\nor \"k0\" where the ground is level.",
        "initial.stress", true, {"initial.stress"}});
  const auto warn_unless = [&](const char* key, InitialStress used, const char* word) {
    const std::string path = std::string("initial.") + key;
    if (stress != used && find_node(root, path) != nullptr)
      findings.warnings.push_back({path, fmt::format("`{}` has no effect", key),
          fmt::format("It counts with stress = \"{}\" only.", word), path, true});
  };
  const bool takes_k0 = begins_with_k0(values);
  if (!takes_k0) warn_unless("k0", InitialStress::k0, "k0");
  for (const MaterialCase& material : values.materials)
    if (!takes_k0 && !std::isnan(material.k0))
      findings.warnings.push_back({join_path(material_path(material), "k0"), "`k0` has no effect",
          "It counts with initial.stress = \"k0\" or \"equilibrium\" only.", "material.k0", true});
  for (const char* key : {"damping", "limit", "max_steps"}) warn_unless(key, InitialStress::equilibrium, "equilibrium");
  for (std::size_t k = 0; k < values.bodies.size() && stress == InitialStress::equilibrium; ++k)
    if (values.bodies[k].velocity != Vec<2>{0.0, 0.0} || values.bodies[k].velocity_at)
      findings.warnings.push_back({fmt::format("body[{}].velocity", k), "`velocity` has no effect",
          "With initial.stress = \"equilibrium\" all soil is at rest at t = 0.\nUse stress = \"k0\" or \"none\" for a "
          "body that moves.",
          "body.velocity", true, {"initial.stress"}});
}

/// A fluid at rest has the same stress in all directions.
void check_hydrostatic(const Case& values, Problems& problems)
{
  if (values.initial.stress != InitialStress::k0 || std::isnan(values.initial.k0) || values.initial.k0 == 1.0) return;
  for (const MaterialCase& material : values.materials)
    if (material.is_fluid())
      problems.push_back({"initial.k0", fmt::format("the fluid `{}` carries no shear stress at rest", material.name),
          fmt::format(
              "k0 = {}; a fluid needs k0 = 1. Start with stress = \"equilibrium\" where soil beside it needs another.",
              values.initial.k0),
          "initial", false, {material_path(material)}});
}

/// [flood] without any ground that could hold the water; a fluid that is called ground.
void check_flood(const Node& root, const Case& values, Problems& problems)
{
  std::vector<std::string> others;
  for (const MaterialCase& material : values.materials) {
    const std::string path = join_path("material", material.called());
    const bool fluid = material.is_fluid();
    if (fluid && material.ground && find_node(root, path + ".ground") != nullptr)
      problems.push_back({path + ".ground", fmt::format("the fluid `{}` is no ground", material.called()),
          "It holds no slope and no water. Leave `ground` out.", "material.ground"});
    if (fluid || !material.ground) others.push_back(material.called());
  }
  const auto is_of_profile = [](const Problem& p) { return p.key.starts_with("flood.smallest_profile"); };
  if (find_node(root, "flood.smallest_profile") != nullptr && !values.flood.asks_profile() &&
      std::ranges::none_of(problems, is_of_profile))
    problems.push_back({"flood.smallest_profile", "a profile needs `width` and `slope`",
        "As in smallest_profile = { width = 3.0, slope = 2.0 }: 3 m at the water level, with slopes of 1:2.", ""});
  const bool some = !values.materials.empty() && others.size() == values.materials.size();
  if (const Node* flood = find_item(root, "flood"); flood != nullptr && some)
    problems.push_back({"flood", "no material of this case is ground",
        fmt::format("Of {}, each is a fluid or has ground = false. [flood] asks whether ground holds the water.",
            plain_list(others)),
        "material.ground", true});
}

/// at_strength where a law has no strength that could be divided, or no material any.
void check_at_strength(const Case& values, Problems& problems)
{
  const Real factor = values.at_strength;
  const auto is_known = [](const MaterialCase& material) { return material.complete_type() != nullptr; };
  if (factor == 1.0 || !(factor > 0.0) || !std::ranges::all_of(values.materials, is_known)) return;
  if (const MaterialCase* material = find_not_judged(values))
    problems.push_back({"at_strength", fmt::format("the strength of `{}` cannot be divided", material->called()),
        fmt::format("Got at_strength = {:g}. Soil of the law {} has none that a factor could divide: {}.\n"
                    "Give `{}` another law, or leave `at_strength` out.",
            factor, material->model, find_material(material->model)->not_judged, material->called()),
        "at_strength", true, {material_path(*material)}});
  else if (strengths_of(values).empty())
    problems.push_back({"at_strength", "no material of this case has a strength to divide",
        fmt::format("Got at_strength = {:g}. Elastic soil does not fail. `terp list` names the laws.", factor),
        "at_strength", true});
  for (const std::string& fault : check_reduced(reduce_strength(values, factor)))
    problems.push_back({"at_strength", fmt::format("with strengths divided by {:g} a law is not usable", factor),
        fault + "\nChoose a factor nearer to 1.", "at_strength", true});
}

void check_times(const LoadCase& load, const std::string& path, Real end_of_run, Findings& findings)
{
  const bool ends = std::isfinite(load.end);
  if (load.ramp > 0.0 && std::isinf(load.start) && !ends)
    findings.problems.push_back({path + ".ramp", "a load that was always there does not grow",
        "Give `start`, the time from which on it grows, or leave `ramp` out.", "load.ramp", true});
  if (std::isfinite(load.start) && ends && load.end < load.start + load.ramp)
    findings.problems.push_back({path + ".end", fmt::format("the load `{}` ends before it is there in full", load.name),
        fmt::format("Got end = {:g} s; allowed: at least start + ramp = {:g} s.", load.end, load.start + load.ramp),
        "load.end", false, {path + ".start", path + ".ramp"}});
  if (std::isfinite(load.start) && end_of_run > 0.0 && load.start >= end_of_run)
    findings.warnings.push_back({path + ".start", fmt::format("the load `{}` is never put on", load.name),
        fmt::format("It begins at {:g} s, the run ends at {:g} s.", load.start, end_of_run), "load.start", false,
        {"time.end"}});
  else if (std::isfinite(load.start) && end_of_run > 0.0 && load.start + load.ramp > end_of_run * (1.0 + 1e-9))
    findings.warnings.push_back({path + ".ramp", fmt::format("the load `{}` is never there in full", load.name),
        fmt::format("It grows until {:g} s, the run ends at {:g} s.", load.start + load.ramp, end_of_run), "load.ramp",
        false, {"time.end", path + ".start"}});
}

void check_loads(const Node& root, const Case& values, Findings& findings)
{
  const std::vector<LoadCase>& loads = values.loads;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const std::string path = fmt::format("load[{}]", k);
    const auto has = [&](const char* key) { return find_node(root, path + '.' + key) != nullptr; };
    if (has("from") && has("to") && !(loads[k].to > loads[k].from))
      findings.problems.push_back({path + ".to", fmt::format("the load `{}` has no width", loads[k].name),
          fmt::format("Got from = {:g} m, to = {:g} m; `to` is the right end.", loads[k].from, loads[k].to), "load.to",
          false, {path + ".from"}});
    const auto same_name = [&](const LoadCase& other) { return other.name == loads[k].name; };
    if (std::any_of(loads.begin(), loads.begin() + static_cast<std::ptrdiff_t>(k), same_name))
      findings.problems.push_back({path + ".name", fmt::format("two loads have the name `{}`", loads[k].name),
          "Give each its own, as in name = \"traffic\".", "load.name", false, {path}});
    check_times(loads[k], path, values.time.end, findings);
  }
}

bool is_among(const std::vector<FrameField>& fields, const std::string& name)
{
  return std::ranges::find(fields, name, &FrameField::name) != fields.end();
}

/// True if points of the material have the field; a parameter is one where it varies from point to point.
bool has_field(const MaterialCase& material, const MaterialType& law, const std::string& name)
{
  const auto is_it = [&](const ParameterInfo& info) { return row_of_parameter(info).name == name; };
  const auto parameter = std::ranges::find_if(law.parameters, is_it);
  if (parameter == law.parameters.end()) return is_among(frame_fields_of(law), name);
  const auto number = static_cast<std::size_t>(parameter - law.parameters.begin());
  return std::ranges::find(material.fields, number, &ParameterField::parameter) != material.fields.end();
}

const MaterialType* law_with_fields(const MaterialCase& material)
{
  return material.from_library != nullptr ? material.from_library.get() : find_material(material.model);
}

/// Fields that nothing has, and fields of laws that no material of this case has.
void check_output_fields(const Case& values, Findings& findings)
{
  std::vector<std::string> names = output_field_names();
  for (const MaterialCase& material : values.materials)
    if (material.from_library != nullptr)
      for (const FrameField& field : frame_fields_of(*material.from_library)) names.push_back(field.name);
  for (std::size_t k = 0; k < values.output.field_names.size(); ++k) {
    const std::string &field = values.output.field_names[k], path = fmt::format("output.fields.names[{}]", k);
    bool of_a_law = false, given = false;
    for (const MaterialType* law : all_materials()) of_a_law = of_a_law || is_among(frame_fields_of(*law), field);
    for (const MaterialCase& material : values.materials)
      if (const MaterialType* law = law_with_fields(material)) given = given || has_field(material, *law, field);
    if (std::ranges::find(names, field) == names.end()) {
      findings.problems.push_back({path, fmt::format("`names` cannot be \"{}\"", field),
          did_you_mean(field, names) + "Allowed: " + quoted_list(names), "output.fields.names"});
    } else if (of_a_law && !given) {
      findings.warnings.push_back(
          {path, fmt::format("no material of this case has `{}`", field), "", "output.fields.names"});
    }
  }
}

}  // namespace

void set_start(const Node& root, Case& values, Findings& findings)
{
  const bool weighs = values.forces.gravity != Vec<2>{0.0, 0.0};
  const bool is_dike = values.water.is_given() || values.flood.given;
  const bool is_given =
      std::ranges::any_of(values.bodies, [](const BodyCase& body) { return body.stress.has_value(); });
  if (!weighs || !is_dike || is_given || find_node(root, "initial.stress") != nullptr) return;
  values.initial.stress = InitialStress::equilibrium;
  findings.notes.push_back(fmt::format("initial.stress: not given; \"equilibrium\", since the case has {}",
      values.water.is_given() ? "water" : "[flood]"));
}

void check_case(const Node& root, const Case& values, Findings& findings)
{
  check_mesh(root, values.mesh, findings);
  check_bodies(root, values, findings);
  check_files(root, values.folder, findings.problems);
  check_parameters(values, findings.problems);
  check_sides(root, values, findings);
  check_footings(root, values, findings.problems);
  check_stages(root, values, findings);
  check_loads(root, values, findings);
  check_body_force(values, findings);
  check_initial(root, values, findings);
  check_hydrostatic(values, findings.problems);
  check_flood(root, values, findings.problems);
  check_method(root, values, findings.warnings);
  check_physics(root, values, findings.warnings);
  check_softening(root, values, findings);
  check_water(root, values, findings);
  check_fields(values, findings.problems);
  check_at_strength(values, findings.problems);
  check_cutoff(values, findings.warnings);
  check_unused_materials(values, findings.warnings);
  check_output_fields(values, findings);
}

}  // namespace terp
