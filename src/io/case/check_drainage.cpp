// Parameters are compared by their value at the peak in the case. One that is missing, or that varies over the soil, is
// NaN here, so every comparison with it is false and nothing is reported. Whether the water is softer than the soil
// needs the elastic moduli. That check therefore runs only where the law accepts all its parameters.

#include "io/case/check_case.hpp"
#include "io/case/key_text.hpp"
#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/material_axes.hpp"
#include "model/soils/point_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terp {
namespace {

bool gives(const Node& root, const MaterialCase& material, const char* key)
{
  return find_node(root, join_path(material_path(material), key)) != nullptr ||
         find_node(root, join_path(join_path("material", material.called()), key)) != nullptr;
}

bool a_stage_changes_drainage(const Case& values)
{
  return std::ranges::any_of(values.stages, [](const StageCase& stage) {
    return std::ranges::any_of(stage.changes, [](const auto& change) { return change.first.ends_with("drainage"); });
  });
}

void check_law(const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  if (law.stiffness_by_stress && material.drainage == Drainage::undrained)
    findings.problems.push_back({join_path(material_path(material), "drainage"),
        fmt::format("soil of the law {} needs effective stress", law.name),
        "Its strength and stiffness follow from it. Give drainage = \"undrained_effective\", or \"drained\".",
        "material.drainage", false, {material_path(material)}});
  const bool effective = material.drainage == Drainage::drained || material.has_excess_pressure();
  if (!law.total_stress || !effective) return;
  const bool drained = material.drainage == Drainage::drained;
  findings.problems.push_back({join_path(material_path(material), "drainage"),
      drained ? fmt::format("soil of the law {} cannot be drained", law.name)
              : fmt::format("soil of the law {} has no effective stress", law.name),
      "Its strength is one of total stress. Leave drainage out, or give the soil a law of effective stress: "
      "mohr_coulomb, modified_cam_clay.",
      "material.drainage", false, {material_path(material)}});
}

/// A strength of total stress with moduli of the skeleton alone: undrained soil hardly changes its volume.
void check_volume_change(const Case& values, const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  const Vec<2> g = values.forces.gravity;
  constexpr Real least = 0.4;
  const Real nu = parameter_of(material, law, "poisson_ratio");
  const bool yields = std::ranges::any_of(law.parameters, [](const auto& info) { return is_strength(info.reduction); });
  if (!(nu < least) || !yields || !(-g[1] > std::abs(g[0])) ||
      !(law.total_stress || material.drainage == Drainage::undrained))
    return;
  findings.warnings.push_back({join_path(material_path(material), "poisson_ratio"),
      fmt::format("`{}` is undrained, and its weight changes its volume much", material.name),
      fmt::format("poisson_ratio = {:g} makes K = {:.2g} G. Undrained soil: 0.45 to 0.495, where K is 10 to 100 G.", nu,
          bulk_from_poisson(1.0, nu)),
      std::string(law.name), false, {material_path(material)}});
}

/// Soil whose skeleton hardly changes its volume, as only pore water that cannot leave makes it; and K far beyond that.
void check_compression(const Case& values, const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  constexpr Real most_drained = 10.0, most = 1000.0;  // K over G
  const Real nu = parameter_of(material, law, "poisson_ratio"), stiffness = bulk_from_poisson(1.0, nu);
  const bool drained = values.water.is_given() && parameter_of(material, law, "friction_angle") > 0.0 &&
                       material.drainage != Drainage::undrained;
  if (!(stiffness > (drained ? most_drained : most))) return;
  findings.warnings.push_back({join_path(material_path(material), "poisson_ratio"),
      drained ? fmt::format("`{}` is drained, and hardly changes its volume", material.name)
              : fmt::format("`{}` takes far shorter steps than its results need", material.name),
      fmt::format("poisson_ratio = {:g} makes K = {:.3g} G. {}", nu, stiffness,
          drained ? "Drained soil: 0.2 to 0.35, where K is 1.3 to 3 G."
                  : "Undrained soil: 0.45 to 0.495, where K is 10 to 100 G."),
      std::string(law.name), false, {material_path(material)}});
}

void check_water_stiffness(
    const Node& root, const Case& values, const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  const std::string path = material_path(material);
  const bool has_ratio = gives(root, material, "undrained_poisson_ratio"),
             has_stiffness = gives(root, material, "water_stiffness");
  if (!material.has_excess_pressure()) {
    for (const char* key : {"undrained_poisson_ratio", "water_stiffness"})
      if (gives(root, material, key) && !a_stage_changes_drainage(values))
        findings.warnings.push_back({join_path(path, key), fmt::format("`{}` has no effect", key),
            "It counts with drainage = \"undrained_effective\" only.", "material.drainage", true, {path}});
    return;
  }
  if (has_ratio && has_stiffness)
    findings.problems.push_back(
        {join_path(path, "water_stiffness"), "`water_stiffness` does not go with `undrained_poisson_ratio`",
            "Each gives K_w/n, the stiffness of the pore water. Remove one of the two.", "material.water_stiffness",
            true, {path}});
  if (const Real psi = parameter_of(material, law, "dilatancy_angle"); psi > 0.0)
    findings.warnings.push_back({join_path(path, "dilatancy_angle"),
        fmt::format("`{}` is undrained and dilates, which strengthens it without end", material.name),
        fmt::format("Got {:g} deg: shearing takes pressure from the pore water for as long as it lasts. Undrained soil "
                    "is most\noften given dilatancy_angle = 0.",
            psi),
        "material.drainage", false, {path}});
  else if (psi < 0.0 && parameter_of(material, law, "dilatancy_angle_residual") == psi)
    findings.warnings.push_back({join_path(path, "dilatancy_angle"),
        fmt::format("`{}` is undrained and contracts for ever: it loses all of its friction", material.name),
        fmt::format("Got {:g} deg, and no `dilatancy_angle_residual`: shearing gives pressure to the pore water for as "
                    "long as it lasts.\nGive dilatancy_angle_residual = 0, the critical state, and eta.",
            psi),
        "material.drainage", false, {path}});
  const bool known =
      material.fields.empty() && material.complete_type() != nullptr && law.check(material.parameters).empty();
  if (!known || !std::isnan(material.water_stiffness)) return;
  if (const Real nu = poisson_ratio_of(law.make(material.parameters)->moduli());
      !(material.undrained_poisson_ratio > nu))
    findings.problems.push_back(
        {join_path(path, has_ratio ? "undrained_poisson_ratio" : "poisson_ratio"), less_compressible_than_soil,
            fmt::format("undrained_poisson_ratio = {:g} with the pore water, {:.4g} of the soil without it. Give "
                        "poisson_ratio of the\ndrained soil, 0.2 to 0.35 most often.",
                material.undrained_poisson_ratio, nu),
            "material.undrained_poisson_ratio", false, {path}});
}

/// The axes of soil whose strength depends on the direction of shearing are turned against gravity.
void check_axes(const Case& values, const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  const Vec<2> g = values.forces.gravity;
  const Real angle = parameter_of(material, law, axis_angle_info.name), degree = std::numbers::pi / 180.0;
  const Real upright = std::atan2(g[0], -g[1]) / degree;
  if (std::isnan(angle) || g == Vec<2>{0.0, 0.0} || std::abs(angle - upright) < 1.0) return;
  findings.warnings.push_back({join_path(material_path(material), axis_angle_info.name),
      fmt::format("the axes of `{}` are turned against gravity", material.name),
      fmt::format("Got {:g} deg; gravity acts along [{:g}, {:g}], of which the vertical is at {:.4g} deg. Strengths "
                  "are active, direct and\npassive in the axes of the soil.",
          angle, g[0], g[1], upright),
      std::string(law.name), false, {"forces.gravity", material_path(material)}});
}

void check_friction(const Case& values, const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  if (!values.water.is_given()) return;
  if (const Real phi = parameter_of(material, law, "friction_angle");
      material.drainage == Drainage::undrained && phi > 0.0)
    findings.warnings.push_back({join_path(material_path(material), "drainage"),
        fmt::format("the friction of `{}` carries the weight of the water, too", material.name),
        fmt::format("It is undrained in total stress with friction_angle = {:g} deg: too strong where there is water. "
                    "Give\ndrainage = \"undrained_effective\", or a strength without friction.",
            phi),
        "material.drainage", false, {material_path(material)}});
  if (material.drainage != Drainage::by_law) return;
  if (parameter_of(material, law, "friction_angle") != 0.0) return;
  findings.warnings.push_back({join_path(material_path(material), "friction_angle"),
      fmt::format("`{}` is drained, and has no friction", material.name),
      "A cohesion without friction is most often an undrained strength. Give drainage = \"undrained\" if it is; "
      "with\ndrainage = \"drained\" this warning goes.",
      "material.drainage", false, {material_path(material)}});
}

}  // namespace

void check_drainage(const Node& root, const Case& values, Findings& findings)
{
  for (const MaterialCase& material : values.materials) {
    const MaterialType* law = find_material(material.model);
    if (law == nullptr) continue;
    check_law(material, *law, findings);
    if (!law->total_stress) check_water_stiffness(root, values, material, *law, findings);
    check_volume_change(values, material, *law, findings);
    check_compression(values, material, *law, findings);
    check_friction(values, material, *law, findings);
    check_axes(values, material, *law, findings);
  }
}

}  // namespace terp
