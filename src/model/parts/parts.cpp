// Each part is made once for all stages. The ground comes before the fields, which take the stress of the soil above
// from it; the time step is that of the stiffest soil of any stage. Rows are the same in all stages, whatever soil is
// there: the state goes through all of them.

#include "model/parts/parts.hpp"

#include "math/errors.hpp"
#include "mpm/features/excess.hpp"
#include "mpm/kernels/time_step.hpp"
#include "model/parts/reduce.hpp"
#include "model/parts/stage_case.hpp"
#include "model/seepage/computed_water.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/soils/settle_fields.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

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

std::size_t n_cases(const Case& whole) { return std::max<std::size_t>(1, whole.stages.size()); }

/// Whether of(its case) holds in any stage.
template <class Of>
bool in_any_stage(const Case& whole, Of&& of)
{
  for (std::size_t k = 0; k < n_cases(whole); ++k)
    if (of(case_of_stage(whole, k))) return true;
  return false;
}

/// whole: a law that tears in any stage has its opening in all of them.
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

/// Those of the bodies, or all of them if a file of points names its own.
std::vector<Index> used_materials(const Case& whole)
{
  std::vector<Index> used;
  for (Index m = 0; m < static_cast<Index>(whole.materials.size()); ++m) {
    const auto is_used = [&](const BodyCase& body) {
      return !body.points_file.empty() || body.material == whole.materials[m].called();
    };
    if (in_any_stage(whole, [&](const Case& c) { return std::ranges::any_of(c.bodies, is_used); })) used.push_back(m);
  }
  return used;
}

/// Where no parameter varies, none is needed.
Grounds make_grounds(const Parts& parts)
{
  const auto has_field = [](const MaterialCase& m) { return !m.fields.empty(); };
  if (!in_any_stage(*parts.whole, [&](const Case& c) { return std::ranges::any_of(c.materials, has_field); }))
    return {};
  const Case& of = parts.whole->ground_of ? *parts.whole->ground_of : *parts.whole;
  const auto ground_in = [&](std::size_t number) {
    const Case& c = case_of_stage(of, number);
    const Soils soils{c, make_materials(c, of), {}};
    return std::make_shared<const Overburden>(Overburden::without_loads({parts, soils}));
  };
  Grounds grounds{.first = ground_in(0)};
  for (const BodyCase& body : of.bodies)
    if (body.placed > 0 && !grounds.placed.contains(body.placed))
      grounds.placed.emplace(body.placed, ground_in(body.placed - 1));
  return grounds;
}

void add_rows_of_laws(const Parts& parts, Soils& soils)
{
  const Case& whole = *parts.whole;
  const bool any_excess = in_any_stage(
      whole, [](const Case& c) { return std::ranges::any_of(c.materials, &MaterialCase::has_excess_pressure); });
  for (const Index m : parts.used) {
    add_rows(m, soils.materials[m], soils.rows);
    if (any_excess && in_any_stage(whole, [m](const Case& c) { return c.materials[m].stores_effective(); }))
      add_excess_row(m, soils.materials[m], soils.rows);
  }
}

/// What limits the time step in any stage.
struct StepLimit {
  Real stable = std::numeric_limits<Real>::infinity(), fastest = 0.0, largest_density = 0.0;

  void enter(const StageSoil& soil, std::span<const Index> used, const FieldsOfPoints& fields)
  {
    for (const Stiffness& s : list_stiffness(soil, used, fields)) {
      const Real density = soil.materials[s.material].density;
      fastest = std::max(fastest, wave_speed(s.moduli.p_wave(), density));
      stable = std::min(stable, stable_step(soil, s));
      largest_density = std::max(largest_density, density);
    }
  }
};

/// dt is the stable step, shortened so that the end is a whole number of steps (decision 0024).
void set_clock(const StepLimit& limit, Parts& parts)
{
  const TimeCase& time = parts.whole->time;
  const Real n = steps_to(time.end, limit.stable);
  if (!(n < most_steps))
    throw InputError(Problem{"time.end", "the time step has collapsed",
        fmt::format("{:.3g} s need {:.3g} steps of {:.3g} s (smallest cell altitude {:.3g} m, wave speed {:.4g} m/s).",
            time.end, n, limit.stable, parts.mesh->smallest_altitude, limit.fastest),
        "time", false, {"mesh", "material", "time"}});
  parts.largest_density = limit.largest_density;
  parts.n_steps = static_cast<std::int64_t>(n);
  parts.dt = time.end / n;
}

}  // namespace

Real steps_to(Real end, Real step) { return std::ceil(end / step * (1.0 - 1e-12)); }

std::shared_ptr<const Parts> parts_of(const Case& whole, const SharedMesh& mesh)
{
  auto parts = std::make_shared<Parts>();
  parts->whole = std::make_shared<const Case>(with_computed_water(whole, mesh));
  parts->mesh = mesh;
  for (std::size_t k = 0; k < n_cases(whole); ++k) {
    const Case& c = case_of_stage(*parts->whole, k);
    Soils& soils = parts->soils.emplace_back();
    soils.description = c.at_strength == 1.0 ? c : reduce_strength(c, c.at_strength);
    soils.materials = make_materials(soils.description, *parts->whole);
  }
  parts->used = used_materials(*parts->whole);
  parts->grounds = make_grounds(*parts);
  StepLimit limit;
  for (Soils& soils : parts->soils) {
    const FieldsOfPoints fields = settle_fields(*parts, soils);
    add_rows_of_laws(*parts, soils);
    set_water_stiffness(*parts, fields, soils);
    limit.enter({*parts, soils}, parts->used, fields);
  }
  set_clock(limit, *parts);
  return parts;
}

}  // namespace terp
