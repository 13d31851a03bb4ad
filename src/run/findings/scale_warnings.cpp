// Each quantity is made dimensionless with another one; H is the height of all soil along gravity. The limits lie a
// factor of 5 or more outside of what soil has, and well within a factor of 1000, the usual mistake of a unit (kPa,
// MPa, mm). What a parameter is (stiffness, strength, angle) follows from the law's own table.

#include "model/soils/overburden.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/soils/point_parameters.hpp"
#include "mpm/features/conditions.hpp"
#include "run/findings/setup_warnings.hpp"
#include "run/findings/soil_size.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr Range stiffness_over_strength = between(4.0, 1e4);  // soil: 20 to 2000
constexpr Range stiffness_over_weight = between(2.0, 1e7);    // soil: 10 to 1e4, rock 1e5
constexpr Real greatest_without_strength = 4e4;               // of G / (rho g H), where no strength is compared with G
constexpr Real greatest_over_friction = 1e5;                  // G over rho g H/2 tan(phi); soil: 50 to 2000
constexpr Real greatest_strength_over_weight = 8.0;           // soil: 0.02 to 5
constexpr Real least_strength_over_weight = 1.0 / 300.0;      // a heap of slurry flows at 0.05
constexpr Real least_with_friction = 0.03;  // of c + rho g H/2 tan(phi) over rho g H; 5 degrees: 0.044
constexpr Real band_over_length = 3.07;     // width of a band (docs/softening_length.md)
constexpr Real little_soil = 1.2;           // density over that of water: pores of 88 % and more
constexpr Real stiff = 3e6;                 // [Pa]; peat, which is as light, hardly has it
constexpr Real greatest_speed = 3.0;        // of a body over sqrt(g H); a fall from H ends at 1.4
constexpr Real greatest_push = 0.1;         // of a side or footing over sqrt(g H); pushes are slow
constexpr Real least_motion = 1e-5;         // of a footing in the whole run, over H

/// What `terp stability` divides, which has no default.
bool is_strength(const ParameterInfo& info)
{
  return info.unit == "Pa" && info.reduction == Reduction::divide && !info.fallback && info.fallback_of.empty();
}

std::string kilopascal(Real stress) { return fmt::format("{:.4g}", 1e-3 * stress); }

std::string number(Real value) { return fmt::format("{:.3g}", value); }

class MaterialScales {
 public:
  MaterialScales(const SoilMaterial& material, const MaterialCase& values, const SoilSize& soil, Problems& warnings)
      : material_(material), values_(values), soil_(soil), warnings_(warnings)
  {
  }

  void check()
  {
    check_stiffness();
    check_friction();
    check_softening();
    for (const ParameterField& field : values_.fields) check_angle(field);
    for (std::size_t k = 0; k < material_.type->parameters.size(); ++k)
      if (is_strength(material_.type->parameters[k]) && values_.parameters[k] > 0.0) {
        check_strength(std::string(material_.type->parameters[k].name), values_.parameters[k]);
        check_ratio(k);
      }
  }

 private:
  Real weight() const { return material_.density * soil_.g * soil_.height; }
  std::string weight_text() const
  {
    return fmt::format("rho g H = {} Pa (H = {} m of soil)", number(weight()), number(soil_.height));
  }
  /// Of the angles of a law, friction is the first; 0 if it has none [deg].
  Real friction_angle() const
  {
    for (std::size_t k = 0; k < values_.parameters.size(); ++k)
      if (material_.type->parameters[k].reduction == Reduction::divide_tangent) return values_.parameters[k];
    return 0.0;
  }

  void warn(const std::string& parameter, std::string what, std::string detail)
  {
    warnings_.push_back({fmt::format("material.\"{}\".{}", values_.name, parameter), std::move(what),
        detail + "\nStiffness and strength are in Pa: 2 MPa is 2.0e6, 8 kPa is 8.0e3.", std::string(values_.model),
        false, {fmt::format("material.\"{}\"", values_.name), "body", "forces.gravity"}});
  }

  bool has_strength() const
  {
    return std::ranges::any_of(
        material_.type->parameters, [](const ParameterInfo& info) { return is_strength(info.reduction); });
  }

  /// G of a solid, K of a fluid, against what it carries.
  void check_stiffness()
  {
    const Real shear = material_.law->shear_modulus(), stiffness = shear > 0.0 ? shear : material_.law->bulk_modulus();
    Range usual = stiffness_over_weight;
    if (shear > 0.0 && !has_strength()) usual.high = greatest_without_strength;
    if (weight() == 0.0 || usual.contains(stiffness / weight())) return;
    const Real ratio = stiffness / weight();
    const char* what = ratio < 1.0 ? "too soft for" : ratio < usual.low ? "very soft beside" : "very stiff beside";
    warn(stiffness_name(), fmt::format("`{}` is {} its own weight", values_.name, what),
        fmt::format("{} = {} Pa is {} times {}. Usual: 10 to {} times.", shear > 0.0 ? "G" : "K", number(stiffness),
            number(ratio), weight_text(), shear > 0.0 ? "1e4" : "1e5"));
  }

  /// Cohesion, of a law with friction [Pa].
  Real cohesion() const
  {
    for (std::size_t k = 0; k < values_.parameters.size(); ++k)
      if (material_.type->parameters[k].reduction == Reduction::divide) return values_.parameters[k];
    return 0.0;
  }

  /// The strength that friction gives at mid-height, against the weight and G.
  void check_friction()
  {
    const Real shear = material_.law->shear_modulus(), angle = friction_angle();
    const Real strength = 0.5 * weight() * std::tan(angle * std::numbers::pi / 180.0);
    if (!(angle > 0.0) || !(strength > 0.0)) return;
    if (const Real share = (strength + cohesion()) / weight(); share < least_with_friction && values_.fields.empty())
      warnings_.push_back({fmt::format("material.\"{}\".friction_angle", values_.name),
          fmt::format("`{}` has hardly any strength", values_.name),
          fmt::format(
              "With {:.3g} degrees and a cohesion of {} Pa it has {:.2g} of {} at mid-height. Usual: 0.1 to 0.5. "
              "Angles are in\ndegrees, neither in radians nor as tangents: 0.52 rad is 30 degrees.",
              angle, number(cohesion()), share, weight_text()),
          std::string(values_.model), false, {fmt::format("material.\"{}\"", values_.name), "body"}});
    if (shear <= greatest_over_friction * strength) return;
    warn(stiffness_name(), fmt::format("`{}` is very stiff beside its friction", values_.name),
        fmt::format("G = {} Pa is {} times rho g H/2 tan(phi) = {} Pa, its strength at mid-height (H = {} m of soil).\n"
                    "Usual: 20 to 2000 times.",
            number(shear), number(shear / strength), number(strength), number(soil_.height)));
  }

  /// An angle that varies: each number of a case is compared with its usual range where it is read, a field is not.
  void check_angle(const ParameterField& field)
  {
    const ParameterInfo& info = material_.type->parameters[field.parameter];
    const Real mean = values_.parameters[field.parameter];
    if (field.follows || info.unit != "deg" || !(mean > 0.0) || !(mean < info.usual.low)) return;
    warnings_.push_back(
        {fmt::format("material.\"{}\".{}", values_.name, info.name), fmt::format("`{}` is unusually small", info.name),
            fmt::format(
                "Its mean over the soil is {} degrees; usual: {} to {}. Angles are in degrees, neither in radians nor "
                "as tangents:\n0.52 rad is 30 degrees.",
                number(mean), info.usual.low, info.usual.high),
            std::string(values_.model), false, {fmt::format("material.\"{}\"", values_.name)}});
  }

  /// A softening length lifts the limit of a point: softening that is done within the elastic strain at the peak.
  void check_brittle(const std::string& name, Real eta)
  {
    for (std::size_t k = 0; k < material_.type->parameters.size(); ++k) {
      const Real strength = values_.parameters[k], elastic = strength / material_.law->shear_modulus();
      if (!is_strength(material_.type->parameters[k]) || !(eta > 0.0) || !(3.0 / eta < elastic)) continue;
      warnings_.push_back({fmt::format("material.\"{}\".{}", values_.name, name),
          fmt::format("`{}` softens within its elastic strain", values_.name),
          fmt::format("95 % of its softening takes a strain of {}, and {} is reached at {}. Such soil snaps, and what "
                      "follows is that\nof the cells. Usual: a strain of 0.03 to 0.6, which is {} = 5 to 100.",
              number(3.0 / eta), material_.type->parameters[k].name, number(elastic), name),
          std::string(values_.model), false, {fmt::format("material.\"{}\"", values_.name)}});
      return;
    }
  }

  /// Softening that takes a slip larger than the section: a shape factor in per cent, or of another strain.
  void check_softening()
  {
    const auto factor = std::ranges::find_if(material_.type->parameters, is_shape_factor);
    const Real slowest = material_.law->softened_strain();
    if (!std::isfinite(slowest) || factor == material_.type->parameters.end()) return;
    const Real eta = values_.parameters[static_cast<std::size_t>(factor - material_.type->parameters.begin())];
    const SofteningOptions& options = values_.softening;
    if (options.is_nonlocal()) check_brittle(std::string(factor->name), eta);
    const Real width = options.is_scaled()     ? options.reference_width
                       : options.is_nonlocal() ? band_over_length * options.length
                                               : soil_.cell,
               band = std::min(width, soil_.height);  // of a length that is too long another warning speaks
    const auto slip_of = [&](Real strain) { return 2.0 * strain * band; };  // half the engineering shear strain
    const Real strain = eta > 0.0 && slip_of(slowest) < 10.0 * soil_.height ? std::min(slowest, 3.0 / eta) : slowest;
    const Real slip = slip_of(strain);
    if (!(slip > soil_.height)) return;
    const std::string name(factor->name);
    warnings_.push_back({fmt::format("material.\"{}\".{}", values_.name, name),
        fmt::format("`{}` softens too slowly to lose any strength", values_.name),
        fmt::format("95 % of its softening takes a strain of {}, which is a slip of {} m; H = {} m of soil. Usual: a "
                    "strain of\n0.03 to 0.6, which is {} = 5 to 100.",
            number(strain), number(slip), number(soil_.height), name),
        std::string(values_.model), false, {fmt::format("material.\"{}\"", values_.name), "body"}});
  }

  std::string stiffness_name() const
  {
    for (const ParameterInfo& info : material_.type->parameters)
      if (info.unit == "Pa" && info.strain_exponent == 1.0) return std::string(info.name);
    return "model";
  }

  void check_strength(const std::string& name, Real strength)
  {
    const Real shear = material_.law->shear_modulus();
    const bool friction = friction_angle() > 0.0;
    const Range usual = friction ? Range{stiffness_over_strength.low} : stiffness_over_strength;
    if (shear > 0.0 && !usual.contains(shear / strength))
      return warn(name, fmt::format("`{}` and the stiffness of `{}` do not fit together", name, values_.name),
          fmt::format("{} = {} Pa, G = {} Pa: G / {} = {}. Usual: 20 to 2000.", name, number(strength), number(shear),
              name, number(shear / strength)));
    if (weight() == 0.0) return;
    const Real share = strength / weight();
    if (share > greatest_strength_over_weight)
      warn(name, fmt::format("`{}` is so strong that its weight does nothing", values_.name),
          fmt::format("{} = {} Pa is {} times {}. Usual: 0.05 to 5 times.", name, number(strength), number(share),
              weight_text()));
    if (share < least_strength_over_weight && !friction)
      warn(name, fmt::format("`{}` is so weak that it flows like a liquid", values_.name),
          fmt::format("{} = {} Pa is {} times {}. Usual: 0.05 to 5 times.", name, number(strength), number(share),
              weight_text()));
  }

  /// Of two strengths of a law, where the case gives both: their ratio, which it could give instead.
  void check_ratio(std::size_t k)
  {
    const ParameterInfo& info = material_.type->parameters[k];
    const RatioInfo& known = info.ratio;
    if (known.name.empty() || known.divides || (k < values_.ratios.size() && values_.ratios[k].is_given())) return;
    const auto of = std::ranges::find(material_.type->parameters, known.of, &ParameterInfo::name);
    const Real strength = values_.parameters[k], other = values_.parameters[of - material_.type->parameters.begin()];
    const Real ratio = strength / other;
    if (!(other > 0.0) || known.usual.contains(ratio)) return;
    warn(std::string(info.name), fmt::format("`{}` and `{}` do not fit together", info.name, known.of),
        fmt::format("{} = {} Pa, {} = {} Pa: {} / {} = {}. Usual: {} to {}. Are they the other way round?", info.name,
            number(strength), known.of, number(other), info.name, known.of, number(ratio), known.usual.low,
            known.usual.high));
  }

  const SoilMaterial& material_;
  const MaterialCase& values_;
  const SoilSize& soil_;
  Problems& warnings_;
};

Real size(Vec<2> v) { return std::hypot(v[0], v[1]); }

/// A body, a side or a footing by its key and its name in a message.
struct Mover {
  std::string key, name;
  Real speed;  ///< [m/s]
};

/// True if it is very fast.
bool warn_of_speed(const Mover& mover, const SoilSize& soil, Problems& warnings)
{
  const bool is_body = mover.key.starts_with("body");
  const Real scale = std::sqrt(soil.g * soil.height);
  if (!(scale > 0.0) || !(mover.speed > (is_body ? greatest_speed : greatest_push) * scale)) return false;
  warnings.push_back({mover.key, fmt::format("{} is very fast", mover.name),
      fmt::format("{:.4g} m/s is {:.3g} times sqrt(g H) = {:.3g} m/s (H = {:.3g} m of soil); {}.\n"
                  "Velocities are in m/s: 5 mm/s is 0.005.",
          mover.speed, mover.speed / scale, scale, soil.height,
          is_body ? "soil that fell from H has 1.4 times" : "usual is a hundredth or less"),
      is_body                            ? "body.velocity"
      : mover.key.starts_with("footing") ? "footing.velocity"
                                         : "boundary.SIDE.velocity"});
  return true;
}

/// The greatest, at its nodes [m/s].
Real speed_of_side(const Model& model, const SideCondition& side)
{
  Real speed = 0.0;
  for (const CellSide& edge : find_side(*model.mesh, side.side).edges)
    for (const int end : {0, 1}) {
      const Index node = model.mesh->cells[edge.cell][(edge.side + end) % Quad4::n_corners];
      speed = std::max(speed, size(velocity_of(side, model.mesh->nodes[node])));
    }
  return speed;
}

/// The greatest velocities that the case gives the points of each body at t = 0 [m/s].
std::vector<Real> speeds_of_bodies(const Model& model)
{
  const std::vector<BodyCase>& bodies = model.description.bodies;
  std::vector<Real> speeds;
  for (const BodyCase& body : bodies) speeds.push_back(body.velocity_at ? 0.0 : size(body.velocity));
  if (std::ranges::none_of(bodies, [](const BodyCase& body) { return bool(body.velocity_at); })) return speeds;
  for (const auto& batch : make_points(model))
    for (const NewPoint& point : batch) {
      const auto b = static_cast<std::size_t>(point.body);
      speeds[b] = std::max(speeds[b], size(velocity_of(bodies[b], point.x)));
    }
  return speeds;
}

void warn_of_no_motion(
    const std::string& key, const FootingCase& footing, const Model& model, const SoilSize& soil, Problems& warnings)
{
  const Real speed = size(footing.velocity), distance = speed * model.description.time.end;
  if (speed == 0.0 || !(distance < least_motion * soil.height)) return;
  warnings.push_back({key, fmt::format("the footing `{}` hardly moves", footing.name),
      fmt::format(
          "{:.3g} m/s for {:.4g} s is {:.3g} m, beside {:.3g} m of soil. Velocities are in m/s: 5 mm/s is 0.005.",
          speed, model.description.time.end, distance, soil.height),
      "footing.velocity", false, {"time.end"}});
}

/// A footing is pushed slowly against the shear waves, or its reaction holds inertia.
void warn_of_inertia(const std::string& key, const FootingCase& footing, const Model& model, Problems& warnings)
{
  constexpr Real quick = 0.02;  // of the shear wave speed
  for (const SoilMaterial& material : model.materials) {
    const Real wave = std::sqrt(material.law->shear_modulus() / material.density), speed = size(footing.velocity);
    if (!(speed > quick * wave) || wave == 0.0 || !is_used(model, material.name)) continue;
    warnings.push_back({key, fmt::format("the footing `{}` is fast: its reaction holds inertia", footing.name),
        fmt::format("{:.3g} m/s is {:.2g} of the shear wave speed of `{}`, {:.3g} m/s. Usual: below a hundredth.\n"
                    "Velocities are in m/s: 5 mm/s is 0.005.",
            speed, speed / wave, material.name, wave),
        "footing.velocity"});
    return;
  }
}

void check_speeds(const Model& model, const SoilSize& soil, Problems& warnings)
{
  const Case& c = model.description;
  const std::vector<Real> speeds = speeds_of_bodies(model);
  const Overburden overburden(model);
  for (std::size_t b = 0; b < c.bodies.size(); ++b)
    warn_of_speed({fmt::format("body[{}].velocity", b), called(c.bodies[b], b), speeds[b]}, soil, warnings);
  for (const SideCondition& side : c.sides)
    warn_of_speed({fmt::format("boundary.\"{}\".velocity", side.side), fmt::format("the side `{}`", side.side),
                      speed_of_side(model, side)},
        soil, warnings);
  for (std::size_t k = 0; k < c.footings.size(); ++k) {
    const FootingCase& f = c.footings[k];
    const std::string key = fmt::format("footing[{}].velocity", k);
    if (warn_of_speed({key, fmt::format("the footing `{}`", f.name), size(f.velocity)}, soil, warnings)) continue;
    warn_of_inertia(key, f, model, warnings);
    const Real middle = 0.5 * (f.low[0] + f.high[0]);
    if (f.velocity[1] > 0.0 && overburden.ground(middle).value_or(-INFINITY) <= f.high[1])
      warnings.push_back({key, fmt::format("the footing `{}` is pulled off the soil", f.name),
          fmt::format(
              "Got {:g} m/s along y, which is upwards, and no soil lies on it. A footing that is pushed down has "
              "a negative one.",
              f.velocity[1]),
          "footing.velocity"});
    if (f.ramp > c.time.end)
      warnings.push_back(
          {fmt::format("footing[{}].ramp", k), fmt::format("the footing `{}` never has its velocity", f.name),
              fmt::format("Its ramp takes {:g} s, the run ends at {:g} s.", f.ramp, c.time.end), "footing.ramp", false,
              {"time.end"}});
    warn_of_no_motion(key, f, model, soil, warnings);
  }
}

/// No gravity, and nothing else that moves the soil.
void find_no_motion(const Model& model, Problems& warnings)
{
  const Case& c = model.description;
  const auto moves = [](const auto& it) { return it.velocity_at || it.velocity != Vec<2>{0.0, 0.0}; };
  const auto footing_moves = [](const FootingCase& footing) { return footing.velocity != Vec<2>{0.0, 0.0}; };
  if (c.forces.gravity != Vec<2>{0.0, 0.0} || std::ranges::any_of(c.bodies, moves) ||
      std::ranges::any_of(c.sides, is_driven) || std::ranges::any_of(c.footings, footing_moves) || !c.loads.empty() ||
      c.forces.body.at || model.with.water)
    return;
  warnings.push_back({"forces.gravity", "there is no gravity, and nothing else moves the soil",
      "All soil stays at rest. Usual: gravity = [0.0, -9.81] in [forces].", "forces.gravity"});
}

struct PastLoad {
  Index n = 0;
  Real daily = 0.0, beyond = 0.0;  ///< sums of sigma'_v,daily, and of sigma'_p above it [Pa]
};

/// Soil under water that is as light as water, though it is no peat: its weight is given less that of the water.
void find_submerged_weights(const Model& model, const State& state, Problems& warnings)
{
  const WaterCase& water = model.description.water;
  const Real g = std::hypot(model.gravity[0], model.gravity[1]);
  if (!model.with.water || g == 0.0) return;
  const Real of_water = water.unit_weight / g;
  const auto is_wet = [&](Vec<2> x) {
    for (std::size_t k = 0; k <= water.situations.size(); ++k)
      if (unlimited_pressure(water, situation_of(water, k), x, 0.0) > 0.0) return true;
    return false;
  };
  std::vector<bool> wet(model.materials.size(), false);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto m = static_cast<std::size_t>(block.material);
    if (!wet[m]) wet[m] = is_wet({block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]});
  });
  for (std::size_t m = 0; m < wet.size(); ++m) {
    const SoilMaterial& soil = model.materials[m];
    const Real shear = soil.law->shear_modulus();
    const bool floats = soil.density < of_water * (1.0 - 1e-3);
    const auto by_stress = [](const ParameterField& field) { return bool(field.needs.yield_stress); };
    const bool is_peat = shear < stiff || std::ranges::any_of(model.description.materials[m].fields, by_stress);
    if (!wet[m] || shear == 0.0 || !(floats || (soil.density < little_soil * of_water && !is_peat))) continue;
    warnings.push_back({parameter_key(model.description.materials[m], "density"),
        fmt::format("`{}` lies under water and is {}", soil.name, floats ? "lighter than water" : "hardly heavier"),
        fmt::format("Got {:.4g} kg/m^3, {:.4g} kN/m^3; water has {:.4g} kg/m^3. Is this a submerged weight? Terp takes "
                    "that of soil with\nthe water in its pores, and lifts it by the water: here {:.4g} kN/m^3?",
            soil.density, 1e-3 * soil.density * g, of_water, 1e-3 * (soil.density * g + water.unit_weight)),
        "material.density", false, {"water"}});
  }
}

/// Soil whose yield stress would need a former load, on top of today's, larger than the largest that any soil with such
/// a strength bears in this section. Yield stress and today's stress, point by point, would doubt the shallow peat of a
/// polder, which bears next to nothing.
void find_large_yield_stress(const Model& model, const State& state, Problems& warnings)
{
  if (!model.ground() || !model.ground()->is_known()) return;
  std::vector<PastLoad> soils(model.materials.size());
  Real largest = 0.0;  // sigma'_v,daily [Pa]
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto m = static_cast<std::size_t>(block.material);
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    for (const ParameterField& field : model.description.materials[m].fields) {
      if (!field.needs.yield_stress) continue;
      const WaterCase& water = model.ground()->water();
      const WaterSituation& of = situation_of(water, situation_number(water, field.needs.daily_water));
      const Real daily = model.ground()->effective(x, of, std::isnan(of.time) ? 0.0 : of.time);
      largest = std::max(largest, daily);
      PastLoad& soil = soils[m];
      soil.n += 1, soil.daily += daily;
      soil.beyond += field.needs.yield_stress({x, model.ground()}) - daily;
      break;
    }
  });
  for (std::size_t m = 0; m < soils.size(); ++m) {
    const Real n = static_cast<Real>(soils[m].n), beyond = soils[m].beyond / n;
    if (soils[m].n == 0 || !(beyond > largest)) continue;
    const MaterialCase& values = model.description.materials[m];
    warnings.push_back({fmt::format("material.\"{}\"", values.name),
        fmt::format("the yield stress of `{}` is far above what it bears", values.name),
        fmt::format(
            "sigma'_p is on average {} kPa above sigma'_v of daily water, which is {} kPa. That is a former load "
            "larger\nthan the {} kPa that soil with such a strength bears at most in this section. A POP of 15 "
            "kPa is \"15 kPa\" or 15e3.",
            kilopascal(beyond), kilopascal(soils[m].daily / n), kilopascal(largest)),
        std::string(values.model), false, {fmt::format("material.\"{}\"", values.name)}});
  }
}

/// A stress at rest that soil with friction cannot bear, neither as active nor as passive earth pressure.
void find_odd_k0(const Model& model, const SoilSize& soil, Problems& warnings)
{
  const Case& c = model.description;
  if (c.initial.stress == InitialStress::none) return;
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const MaterialCase& material = c.materials[m];
    const auto& parameters = model.materials[m].type->parameters;
    Real angle = 0.0, cohesion = 0.0;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      if (parameters[k].name == "friction_angle") angle = material.parameters[k];
      if (parameters[k].name == "cohesion") cohesion = material.parameters[k];
    }
    const bool own = !std::isnan(material.k0);
    const Real k0 = own ? material.k0 : c.initial.k0;
    const Real vertical = 0.5 * model.materials[m].density * soil.g * soil.height;  // of a section without water [Pa]
    if (!is_used(model, material.name) || std::isnan(k0) || !(angle > 0.0) || !(vertical > 0.0)) continue;
    const Real root = std::tan((45.0 + 0.5 * angle) * std::numbers::pi / 180.0), passive = root * root;
    const Real high = passive + 2.0 * cohesion * root / vertical,
               low = 1.0 / passive - 2.0 * cohesion / (root * vertical);
    if (k0 <= high && k0 >= low) continue;
    warnings.push_back({own ? fmt::format("material.\"{}\".k0", material.name) : "initial.k0",
        fmt::format("`{}` cannot bear this k0", material.name),
        fmt::format(
            "Got {:.4g}; with {:.4g} degrees of friction {:.2g} is active and {:.3g} passive earth pressure: it yields "
            "at\nonce. Usual: 1 - sin(phi), here {:.2g}.",
            k0, angle, 1.0 / passive, passive, 1.0 - std::sin(angle * std::numbers::pi / 180.0)),
        "initial.k0", false, {"initial"}});
    return;
  }
}

}  // namespace

void find_odd_scales(const Model& model, const State& state, Problems& warnings)
{
  const SoilSize soil = measure_soil(model, state);
  find_submerged_weights(model, state, warnings);
  for (std::size_t k = 0; k < model.materials.size(); ++k)
    if (is_used(model, model.materials[k].name))
      MaterialScales(model.materials[k], model.description.materials[k], soil, warnings).check();
  find_large_yield_stress(model, state, warnings);
  find_odd_k0(model, soil, warnings);
  check_speeds(model, soil, warnings);
  find_no_motion(model, warnings);
}

}  // namespace terp
