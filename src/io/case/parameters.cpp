// The order is ratios, then defaults that are fields, then defaults that are numbers. A ratio to a field makes a field,
// and a later parameter may take that as its default. A default is always that of an earlier parameter of the table, so
// one pass in its order suffices. The list of fields stays sorted by the number of the parameter.

#include "io/case/reader.hpp"

#include "io/case/document.hpp"
#include "io/case/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

std::size_t number_of(const MaterialType& law, std::string_view name)
{
  return static_cast<std::size_t>(
      std::ranges::find(law.parameters, name, &ParameterInfo::name) - law.parameters.begin());
}

const ParameterField* field_of(const MaterialCase& material, std::size_t k)
{
  const auto found = std::ranges::find(material.fields, k, &ParameterField::parameter);
  return found == material.fields.end() ? nullptr : &*found;
}

/// The needs of the field are those that it has beside another one, whose needs are checked with that.
void add_field(MaterialCase& material, ParameterField field)
{
  const auto at = std::ranges::lower_bound(material.fields, field.parameter, {}, &ParameterField::parameter);
  material.fields.insert(at, std::move(field));
}

FieldValue value_of(const ParameterField* field, Real number)
{
  if (field != nullptr) return field->value_at;
  return [number](const PlaceInSoil&) { return number; };
}

void follow_ratio(const MaterialType& law, std::size_t k, MaterialCase& material)
{
  const RatioInfo& info = law.parameters[k].ratio;
  const RatioCase& ratio = material.ratios[k];
  const std::size_t of = number_of(law, info.of);
  const ParameterField *other = field_of(material, of), *factor = ratio.field ? &*ratio.field : nullptr;
  const auto found = [divides = info.divides](Real base, Real by) { return divides ? base / by : base * by; };
  if (other == nullptr && factor == nullptr) {
    material.parameters[k] = found(material.parameters[of], ratio.value);
    return;
  }
  material.parameters[k] = law.parameters[k].typical;
  add_field(material, {.parameter = k,
                          .value_at =
                              [found, a = value_of(other, material.parameters[of]), b = value_of(factor, ratio.value),
                                  range = info.range](const PlaceInSoil& at) {
                                const Real by = b(at);
                                return range.contains(by) ? found(a(at), by) : std::numeric_limits<Real>::quiet_NaN();
                              },
                          .text = fmt::format("{} {} {}", info.of, info.divides ? '/' : '*', info.name),
                          .needs = factor != nullptr ? factor->needs : FieldNeeds{},
                          .follows = other != nullptr ? std::optional(of) : std::nullopt});
}

}  // namespace

std::vector<Problem> complete_parameters(const MaterialType& law, MaterialCase& material)
{
  std::vector<Problem> problems;
  const auto is_given = [&](std::size_t k) {
    return !std::isnan(material.parameters[k]) || field_of(material, k) != nullptr;
  };
  for (std::size_t k = 0; k < law.parameters.size(); ++k) {
    const ParameterInfo& info = law.parameters[k];
    if (!material.ratios[k].is_given()) continue;
    if (is_given(k))
      problems.push_back({join_path(material_path(material), info.ratio.name),
          fmt::format("`{}` and `{}` are both given", info.ratio.name, info.name),
          fmt::format("{} = {} {} {}. Remove one of the two.", info.name, info.ratio.of, info.ratio.divides ? '/' : '*',
              info.ratio.name),
          std::string(law.name), true, {join_path(material_path(material), info.name)}});
    else if (is_given(number_of(law, info.ratio.of)))
      follow_ratio(law, k, material);
  }
  for (std::size_t k = 0; k < law.parameters.size(); ++k) {
    const std::string_view from = law.parameters[k].fallback_of;
    if (from.empty() || is_given(k) || !law.parameters[k].may_vary) continue;
    if (const ParameterField* other = field_of(material, number_of(law, from)))
      add_field(material, {.parameter = k,
                              .value_at = FieldValue(other->value_at),
                              .text = std::string(from),
                              .follows = number_of(law, from)});
  }
  material.parameters = law.complete(material.parameters);
  return problems;
}

}  // namespace terp
