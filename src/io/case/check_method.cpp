// Nothing here stops a run: an option without effect and a cell that locks are warnings. Each scheme names the options
// that it does not use, so a new scheme needs no change here. Locking is judged by Poisson's ratio at the moduli of the
// law, and only where every parameter is given.

#include "io/case/check_case.hpp"

#include "soil/laws/material.hpp"
#include "mpm/schemes/scheme.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

Problem no_effect(const std::string& option, std::string why)
{
  const std::string path = "method." + option;
  return {path, fmt::format("`{}` has no effect", option), std::move(why), path, true, {"scheme"}};
}

void check_unused(const Node& method, const Scheme& scheme, Problems& warnings)
{
  for (const Node& option : method.items)
    if (!looks_at(scheme, option.name))
      warnings.push_back(no_effect(option.name, fmt::format("The scheme {} does not look at it.", scheme.name)));
}

/// Options whose effect another one takes away.
void check_beside(const Node& method, const Case& values, Problems& warnings)
{
  const MethodOptions& options = values.method;
  const auto warn_if = [&](bool useless, const char* option, const char* why) {
    if (useless && find_item(method, option) != nullptr) warnings.push_back(no_effect(option, why));
  };
  const bool summed = options.weights == Weights::summed;
  warn_if(summed, "filled_fraction", "With weights = \"summed\" no cell counts as filled.");
  warn_if(summed && options.strain_shares == StrainShares::transposed, "strain_shares",
      "With weights = \"summed\" the weights of the force are those of the points: both ways are the same.");
  warn_if(!options.b_bar, "volume_change", "It is the volume change of B-bar, and b_bar = false.");
  const bool weightless = values.forces.gravity == Vec<2>{0.0, 0.0} && values.stages.empty();
  warn_if(weightless && options.pressure == Pressure::balanced, "pressure",
      "Without gravity no weight is balanced. Set gravity = [0.0, -9.81] in [forces].");
}

/// No side has a contact plane, in no stage that is known here.
void check_contact(const Node& method, const Case& values, Problems& warnings)
{
  const auto is_contact = [](const SideCondition& side) { return info_of(side.kind).key == "contact"; };
  if (find_item(method, "remap_contact") != nullptr && values.stages.empty() &&
      std::ranges::none_of(values.sides, is_contact))
    warnings.push_back(no_effect("remap_contact", "No side is a contact plane: give one `contact` in [boundary]."));
}

std::string schemes_with_b_bar()
{
  std::string names;
  for (const Scheme* scheme : all_schemes())
    if (looks_at(*scheme, "b_bar")) names += (names.empty() ? "" : ", ") + std::string(scheme->name);
  return names;
}

/// Nearly incompressible soil with the volume strain of each point: it locks, far too stiff.
void check_locking(const Scheme& scheme, const Case& values, Problems& warnings)
{
  constexpr Real locks = 0.45;  // Poisson's ratio
  const bool has_b_bar = looks_at(scheme, "b_bar");
  if (!scheme.locks && (!has_b_bar || values.method.b_bar)) return;
  for (const MaterialCase& material : values.materials) {
    const MaterialType* law = material.complete_type();
    if (law == nullptr) continue;
    const auto soil = law->make(material.parameters);
    const Real K = soil->bulk_modulus(), G = soil->shear_modulus();
    const Real poisson = (3.0 * K - 2.0 * G) / (2.0 * (3.0 * K + G));
    if (!(poisson > locks) || G == 0.0) continue;
    warnings.push_back({material_path(material),
        fmt::format("`{}` locks: Poisson's ratio {:.3g} {}", material.name, poisson,
            has_b_bar ? "without B-bar" : fmt::format("with the scheme {}", scheme.name)),
        fmt::format("It answers far too stiffly, with pressures that jump from cell to cell. {}",
            has_b_bar ? "Leave method.b_bar at true." : fmt::format("Schemes with B-bar: {}.", schemes_with_b_bar())),
        has_b_bar ? "method.b_bar" : "scheme", true, {"scheme", "method.b_bar"}});
  }
}

}  // namespace

void check_method(const Node& root, const Case& values, Problems& warnings)
{
  const Node* method = find_item(root, "method");
  const Scheme* scheme = find_scheme(values.scheme);
  if (scheme == nullptr) return;
  check_locking(*scheme, values, warnings);
  if (method == nullptr || method->kind != NodeKind::table) return;
  check_unused(*method, *scheme, warnings);
  check_beside(*method, values, warnings);
  check_contact(*method, values, warnings);
}

}  // namespace terp
