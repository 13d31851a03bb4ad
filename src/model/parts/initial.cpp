// Only a start with the K0 stress itself must suit the laws, as a search for equilibrium changes it. The water is one
// situation: the one towards which the ramp has begun, else the one that it leaves.

#include "model/parts/initial.hpp"

#include "model/meshes/mesh_error.hpp"
#include "model/water/nodal_water.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace terp {
namespace {

/// The first problem of a point that a stress of its law has.
std::optional<Problem> find_problem(
    const Model& model, const StepState& state, const std::function<bool(std::size_t, const ParameterProblem&)>& counts)
{
  std::optional<Problem> found;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    if (found) return;
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    for (const ParameterProblem& problem :
        material.law->check_start(material.view(block, lane), stress_at(block, lane)))
      if (counts(id, problem))
        found = Problem{parameter_key(model.description.materials[block.material], problem.parameter), problem.what,
            fmt::format("At the point at {} m: {}", place_text(x), problem.detail), "material", false,
            {"initial.stress", "initial.k0"}};
  });
  return found;
}

}  // namespace

std::optional<Problem> find_wrong_start(
    const Model& model, const StepState& state, const std::function<bool(std::size_t)>& look)
{
  return find_problem(model, state, [&](std::size_t id, const ParameterProblem&) { return look(id); });
}

std::string describe_overload(const Model& model, const StepState& state)
{
  const auto found = find_problem(model, state,
      [](std::size_t, const ParameterProblem& problem) { return problem.parameter == "largest_mean_stress"; });
  if (!found) return {};
  return fmt::format("at t = {:.4g} s soil carries more than `{}`, beyond which the law grows no stiffer. {}",
      state.time, found->key, found->detail);
}

void start_soil(const Model& model, StepState& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    material.law->start(material.view(block, lane), stress_at(block, lane));
  });
}

namespace {

/// A parameter of a material by its name at a place; nothing: its law does not have it.
std::optional<Real> parameter_at(const MaterialCase& material, std::string_view name, const PlaceInSoil& place)
{
  const MaterialType* law = find_material(material.model);
  if (law == nullptr) return std::nullopt;
  const auto found = std::ranges::find(law->parameters, name, &ParameterInfo::name);
  if (found == law->parameters.end()) return std::nullopt;
  const auto k = static_cast<std::size_t>(found - law->parameters.begin());
  const auto field = std::ranges::find(material.fields, k, &ParameterField::parameter);
  return field != material.fields.end() ? field->value_at(place) : material.parameters[k];
}

}  // namespace

Real k0_at(const Case& c, const MaterialCase& material, const PlaceInSoil& place, Real vertical)
{
  if (!std::isnan(material.k0)) return material.k0;
  if (!std::isnan(c.initial.k0)) return c.initial.k0;
  const auto angle = parameter_at(material, "friction_angle", place),
             yield_stress = parameter_at(material, "yield_stress", place);
  if (!angle || !yield_stress) return 1.0;
  const Real sine = std::sin(*angle * std::numbers::pi / 180.0);
  const Real ocr = std::max(1.0, *yield_stress / vertical), passive = (1.0 + sine) / (1.0 - sine);
  return std::min((1.0 - sine) * std::pow(ocr, sine), passive);
}

bool begins_with_k0(const Case& c)
{
  const auto asks_for_it = [](const MaterialCase& material) {
    const MaterialType* law = find_material(material.model);
    return !std::isnan(material.k0) || (law != nullptr && law->stiffness_by_stress);
  };
  return c.initial.stress == InitialStress::k0 ||
         (c.initial.stress == InitialStress::equilibrium &&
             (c.water.is_given() || std::ranges::any_of(c.materials, asks_for_it)));
}

namespace {

[[noreturn]] void refuse_placed(std::size_t body)
{
  throw InputError(Problem{fmt::format("body[{}].stress", body), "a body that a stage places has no stress at t = 0",
      "It is placed without stress. Remove `stress`.", "body.stress"});
}

/// Whether any body gives its stress.
bool set_given_stress(const Model& model, std::span<const Index> bodies, StepState& state)
{
  const std::vector<BodyCase>& cases = model.description.bodies;
  for (std::size_t b = 0; b < cases.size(); ++b)
    if (cases[b].stress && cases[b].placed > 0) refuse_placed(b);
  if (std::ranges::none_of(cases, [](const BodyCase& body) { return body.stress.has_value(); })) return false;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const BodyCase& body = cases[static_cast<std::size_t>(bodies[id])];
    if (!body.stress) return;
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::sigma + k)[lane] = (*body.stress)[static_cast<std::size_t>(k)];
  });
  return true;
}

void refuse_wrong_start(const Model& model, const StepState& state, const std::function<bool(std::size_t)>& look)
{
  if (std::optional<Problem> wrong = find_wrong_start(model, state, look)) throw InputError(std::move(*wrong));
}

}  // namespace

void set_initial_stress(const Model& model, std::span<const Index> bodies, StepState& state)
{
  const Case& c = model.description;
  if (set_given_stress(model, bodies, state))
    return refuse_wrong_start(model, state,
        [&](std::size_t id) { return c.bodies[static_cast<std::size_t>(bodies[id])].stress.has_value(); });
  if (!begins_with_k0(c)) return;
  const bool first_guess = c.initial.stress == InitialStress::equilibrium;
  const Overburden overburden(model, -model.gravity_at(0.0)[1]);
  if (first_guess && !overburden.is_known()) return;
  const WaterWay way = model.with.water ? first_way(model) : WaterWay{};
  const WaterSituation& water = situation_of(c.water, way.share > 0.0 ? way.to : way.from);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const MaterialCase& material = c.materials[block.material];
    const Real vertical = -overburden.effective(x, water), k0 = k0_at(c, material, {x, &overburden}, -vertical),
               stored = material.stores_effective() ? 0.0 : overburden.pore_pressure(x, water);
    block.row(Rows::sigma)[lane] = k0 * vertical - stored;
    block.row(Rows::sigma + 1)[lane] = vertical - stored;
    block.row(Rows::sigma + 2)[lane] = k0 * vertical - stored;
  });
  if (first_guess) return;
  refuse_wrong_start(model, state, [](std::size_t) { return true; });
}

}  // namespace terp
