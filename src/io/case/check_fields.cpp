// Each field recorded what it needs when it was read, so no kind of field is known here. Missing water or gravity is a
// fault of the case and is reported once, at the first strength that follows from the stress. Outlines and names of
// situations are faults of the single field. Where [water] or [forces] could not be read, their absence is not
// reported.

#include "math/closest.hpp"
#include "io/case/check_case.hpp"
#include "io/case/key_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

void check_situations(const ParameterField& field, const std::string& path, const WaterCase& water, Problems& problems)
{
  std::vector<std::string> names;
  for (const WaterSituation& situation : water.situations)
    if (!situation.name.empty()) names.push_back(situation.name);
  for (const std::string& name : field.needs.situations) {
    if (std::ranges::find(names, name) != names.end()) continue;
    problems.push_back({path, fmt::format("there is no water situation `{}`", name),
        did_you_mean(name, names) +
            (names.empty()
                    ? "Give a [[water.situation]] that name, or leave it out: then the water at the start counts."
                    : fmt::format(
                          "Situations of this case: start, {}. Left out: that at the start.", plain_list(names))),
        "field", false, {"water"}});
  }
}

/// What stress needs of the case, reported at the first strength that follows from it. Water or gravity that could not
/// be read are reported there.
void check_stress(const Case& values, Problems& problems)
{
  const auto is_wrong = [&](std::string_view section) {
    return std::ranges::any_of(problems, [&](const Problem& problem) { return problem.key.starts_with(section); });
  };
  const bool no_water = !values.water.is_given() && !is_wrong("water"),
             no_gravity = !(values.forces.gravity[1] < 0.0) && !is_wrong("forces");
  for (const MaterialCase& material : values.materials)
    for (const ParameterField& field : material.fields) {
      const MaterialType* law = find_material(material.model);
      if (law == nullptr || !field.needs.stress) continue;
      const std::string path = join_path(material_path(material), law->parameters[field.parameter].name);
      if (no_water)
        problems.push_back({path, "a strength that follows from the effective stress needs water",
            "Give [water] with phreatic_line = [[x, y], ...] in m; a line below all soil if it is dry.", "field", false,
            {"water"}});
      if (no_gravity)
        problems.push_back({path, "a strength that follows from the effective stress needs gravity",
            "Without it nothing weighs on the soil. Give gravity = [0.0, -9.81] in [forces].", "field", false,
            {"forces"}});
      return;
    }
}

void check_field(const ParameterField& field, const std::string& path, const MaterialCase& material, const Case& values,
    Problems& problems)
{
  const FieldNeeds& needs = field.needs;
  if (needs.stress || needs.outlines)
    for (std::size_t b = 0; b < values.bodies.size(); ++b)
      if (!values.bodies[b].points_file.empty()) {
        problems.push_back({path,
            fmt::format("`{}` needs the outline of every body", needs.stress ? "stress" : "depth"),
            fmt::format("The {} comes as points, so the ground above `{}` is not known. Give a formula, `elevation` or "
                        "`csv`,\nor the body as box, polygon or region.",
                called(values.bodies[b], b), material.name),
            "field", false, {fmt::format("body[{}].points", b)}});
        break;
      }
  check_situations(field, path, values.water, problems);
}

}  // namespace

void check_fields(const Case& values, Problems& problems)
{
  check_stress(values, problems);
  for (const MaterialCase& material : values.materials) {
    const MaterialType* law = find_material(material.model);
    if (law == nullptr) continue;
    for (const ParameterField& field : material.fields)
      check_field(
          field, join_path(material_path(material), law->parameters[field.parameter].name), material, values, problems);
  }
}

}  // namespace terp
