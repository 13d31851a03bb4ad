// A file without a mesh gets one cell with a body of its first material, behind its own text, so that the lines of
// messages stay those of the file.

#include "io/element/element_case.hpp"

#include "math/closest.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace terp {
namespace {

std::string cell_for(const std::string& text)
{
  Node root;
  try {
    root = parse_toml(text);
  } catch (const SyntaxError&) {
    return {};  // read_case_text says it
  }
  const Node* const materials = find_item(root, "material");
  if (materials == nullptr || materials->items.empty()) return {};
  for (const char* key : {"mesh", "body", "time"})
    if (find_item(root, key) != nullptr) return {};
  return fmt::format(
      "\n\n[time]\nend = 1.0\n\n[mesh]\nsize = [1.0, 1.0]\ncell = 1.0\n\n"
      "[[body]]\nmaterial = \"{}\"\nbox = [[0.0, 0.0], [1.0, 1.0]]\n",
      materials->items.front().name);
}

}  // namespace

CaseFile read_element_case_text(
    const std::string& text, const std::string& path, const std::vector<std::string>& overrides)
{
  return read_case_text(text + cell_for(text), path, overrides);
}

CaseFile read_element_case(const std::string& path, const std::vector<std::string>& overrides)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return read_case(path, overrides);  // which says what is wrong
  return read_element_case_text(read_file(path), path, overrides);
}

std::vector<const MaterialCase*> materials_of_element(const Case& c, const std::vector<std::string>& names)
{
  std::vector<std::string> known;
  for (const MaterialCase& material : c.materials) known.push_back(material.name);
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw InputError(Problem{
          "material", fmt::format("the case has no material `{}`", name), did_you_mean(name, known), "material"});
  std::vector<const MaterialCase*> found;
  for (const MaterialCase& material : c.materials)
    if (names.empty() || std::ranges::find(names, material.name) != names.end()) found.push_back(&material);
  return found;
}

std::array<Real, 4> start_of_element(const Case& c, const MaterialCase& material)
{
  for (const BodyCase& body : c.bodies)
    if (body.material == material.called() && body.stress) return *body.stress;
  return {-100e3, -100e3, -100e3, 0.0};
}

}  // namespace terp
