// A formula that does not depend on the place is a field of the case: ratios, ranges and files of the run know it.
#include "free_parameters.hpp"

#include "model/soils/point_parameters.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace terp {

std::map<std::string, std::string> changes_to_vary(const CaseFile& file, const std::vector<std::string>& names)
{
  std::map<std::string, std::string> changes;
  std::set<std::string> known;
  for (const MaterialCase& material : file.values.materials) {
    const MaterialType& law = *material.type();
    for (std::size_t k = 0; k < law.parameters.size(); ++k) {
      const ParameterInfo& parameter = law.parameters[k];
      if (!parameter.may_vary) continue;
      known.emplace(parameter.name);
      if (std::ranges::find(names, parameter.name) == names.end() ||
          std::ranges::find(material.fields, k, &ParameterField::parameter) != material.fields.end())
        continue;
      changes[parameter_key(material, parameter.name)] = fmt::format("{} + 0*x", material.parameters[k]);
    }
  }
  for (const std::string& name : names)
    if (!known.contains(name))
      throw CaseError(fmt::format("vary: no law of the case lets `{}` vary from point to point\n  These may: {}.", name,
          fmt::join(known, ", ")));
  return changes;
}

}  // namespace terp
