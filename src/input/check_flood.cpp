#include "input/check_case.hpp"
#include "input/key_text.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

bool is_fluid(const MaterialCase& material)
{
  const MaterialType* law = complete_law(material);
  return law != nullptr && law->make(material.parameters)->shear_modulus() == 0.0;
}

}  // namespace

void check_flood(const Node& root, const Case& values, std::vector<Problem>& problems)
{
  std::vector<std::string> others;
  for (const MaterialCase& material : values.materials) {
    const std::string path = join_path("material", material.called());
    const bool fluid = is_fluid(material);
    if (fluid && material.ground && find_node(root, path + ".ground") != nullptr)
      problems.push_back({path + ".ground", fmt::format("the fluid `{}` is no ground", material.called()),
          "It holds no slope and no water. Leave `ground` out.", "material.ground"});
    if (fluid || !material.ground) others.push_back(material.called());
  }
  const bool some = !values.materials.empty() && others.size() == values.materials.size();
  if (const Node* flood = find_item(root, "flood"); flood != nullptr && some)
    problems.push_back({"flood", "no material of this case is ground",
        fmt::format("Of {}, each is a fluid or has ground = false. [flood] asks whether ground holds the water.",
            plain_list(others)),
        "material.ground", true});
}

}  // namespace terp
