#include "input/check_case.hpp"
#include "simulation/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {

void check_at_strength(const Case& values, std::vector<Problem>& problems)
{
  const Real factor = values.at_strength;
  const auto is_known = [](const MaterialCase& material) { return complete_law(material) != nullptr; };
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

}  // namespace terp
