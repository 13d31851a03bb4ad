// There are two independent checks: parameters of the law that act only together, and the section on the softening
// length. The first runs for every soil and names one parameter at most. The second needs the section in the file. Its
// last step makes the law, so it runs only where no parameter is missing.

#include "io/case/check_case.hpp"
#include "io/case/key_text.hpp"
#include "model/soils/point_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

/// A parameter that does nothing, because one that it acts with has its default: a residual strength without a shape
/// factor, a reference rate without a gain.
void check_lone_parameters(const MaterialCase& material, const MaterialType& law, Problems& warnings)
{
  const auto number_of = [&](std::string_view name) {
    const auto at = std::ranges::find(law.parameters, name, &ParameterInfo::name);
    return static_cast<std::size_t>(at - law.parameters.begin());
  };
  const auto value_of = [&](std::string_view name) { return material.parameters[number_of(name)]; };
  const auto is_default = [&](const ParameterInfo& info) {
    return value_of(info.name) == (info.fallback ? *info.fallback : value_of(info.fallback_of));
  };
  for (const ParameterInfo& info : law.parameters) {
    if (info.acts_with.empty() || is_default(info)) continue;
    const ParameterInfo& other = law.parameters[number_of(info.acts_with)];
    if (!is_default(other)) continue;
    if (!info.fallback && std::isnan(value_of(info.fallback_of))) continue;  // missing, which is reported
    const std::size_t k = number_of(info.name);
    const bool by_ratio = k < material.ratios.size() && material.ratios[k].is_given();
    if (by_ratio && material.ratios[k].value == 1.0) continue;       // the whole of the other, said by a ratio
    const std::string name(by_ratio ? info.ratio.name : info.name);  // as the case says it
    const std::string path = material_path(material);
    const std::string is = other.fallback ? fmt::format("{:g}", *other.fallback) : std::string(other.fallback_of);
    const std::string detail =
        info.fallback
            ? fmt::format("Give {}, or leave {} out.", other.name, name)
            : fmt::format("The strength stays at {} = {} {}. Give {}, more than 0, or {} = {}.", info.fallback_of,
                  value_of(info.fallback_of), info.unit, other.name, name, by_ratio ? 1.0 : value_of(info.fallback_of));
    warnings.push_back({join_path(path, name), fmt::format("`{}` has no effect: {} is {}", name, other.name, is),
        detail, std::string(law.name), true, {join_path(path, other.name)}});
    return;
  }
}

/// The second fall of strength before the first.
void check_remoulding(const MaterialCase& material, const MaterialType& law, Problems& warnings)
{
  const Real first = parameter_of(material, law, "eta"), second = parameter_of(material, law, "eta_remoulding");
  if (!(first > 0.0 && second > first)) return;
  warnings.push_back({join_path(material_path(material), "eta_remoulding"),
      fmt::format("`{}` is remoulded before it has softened", material.name),
      fmt::format(
          "eta_remoulding = {:g} is more than eta = {:g}: the second fall takes less strain than the first. Usual: "
          "a tenth of eta or less.",
          second, first),
      std::string(law.name), false, {join_path(material_path(material), "eta")}});
}

std::string laws_that_soften()
{
  std::vector<std::string> names;
  for (const MaterialType* law : all_materials())
    if (law->nonlocal != nullptr) names.emplace_back(law->name);
  return plain_list(names);
}

void check_length(const Node& table, const MaterialCase& material, const MaterialType& law, Findings& findings)
{
  const std::string path = join_path(material_path(material), "softening");
  const SofteningOptions& options = material.softening;
  const auto key = [&](const char* name) { return path + '.' + name; };
  if (law.nonlocal == nullptr) {
    findings.problems.push_back({path, fmt::format("soil of the law {} does not soften", law.name),
        fmt::format("Leave [{}] out. Laws that soften: {}.", path, laws_that_soften()), "material.softening", true});
    return;
  }
  if (!options.is_nonlocal()) {
    for (const char* name : {"m", "halo"})
      if (find_item(table, name) != nullptr)
        findings.warnings.push_back({key(name), fmt::format("`{}` has no effect", name),
            "It belongs to a softening length: give length, in m, too.", "material.softening", true});
    if (!options.is_scaled()) return;
  }
  if (options.is_nonlocal() && !options.halo && options.over_nonlocal > 1.0)
    findings.problems.push_back(
        {find_item(table, "m") != nullptr ? key("m") : key("halo"), "`halo = false` needs m = 1",
            fmt::format("Got m = {}: a band would lock above the residual strength. Give m = 1, or leave halo out.",
                options.over_nonlocal),
            "material.softening", false, {key("halo")}});
  if (options.is_nonlocal() && options.is_scaled() && options.over_nonlocal != 1.0 && options.over_nonlocal != 1.5)
    findings.problems.push_back({key("m"), "the width of the band is not known for this m",
        fmt::format("Got m = {}. With a reference width: m = 1.5, its default, or m = 1.", options.over_nonlocal),
        "material.softening", false, {key("reference_width")}});
  const MaterialType* complete = material.complete_type();
  if (complete != nullptr && !std::isfinite(complete->make(material.parameters)->softened_strain())) {
    const char* name = options.is_nonlocal() ? "length" : "reference_width";
    findings.warnings.push_back({key(name), fmt::format("`{}` has no effect: the soil does not soften", name),
        "Its rate of softening is 0, or its residual strength is the peak.", std::string(law.name), false,
        {material_path(material)}});
  }
}

}  // namespace

void check_softening(const Node& root, const Case& values, Findings& findings)
{
  for (const MaterialCase& material : values.materials) {
    const MaterialType* law = find_material(material.model);
    if (law == nullptr) continue;
    check_lone_parameters(material, *law, findings.warnings);
    check_remoulding(material, *law, findings.warnings);
    const Node* table = find_node(root, join_path(material_path(material), "softening"));
    if (table != nullptr && table->kind == NodeKind::table) check_length(*table, material, *law, findings);
  }
}

}  // namespace terp
