// Small gmsh files made by hand, for tests of the reader.
#pragma once

#include "model/meshes/gmsh_file.hpp"
#include "support/paths.hpp"
#include <cstring>
#include <fmt/format.h>

namespace terp::test {

/// An MSH 4.1 text file from short lines. Nodes: "number x y z". Elements: "number type group surface nodes...", group
/// 0 for none, the surface being any entity; each group has entities of its own. Names: "dimension group "name"".
struct MshText {
  std::vector<std::string> nodes{"1 0 0 0", "2 1 0 0", "3 2 0 0", "4 0 1 0", "5 1 1 0", "6 2 1 0"};
  std::vector<std::string> elements{"7 3 0 1 1 2 5 4", "8 3 0 1 2 3 6 5"};
  std::vector<std::string> names{};

  std::string text() const
  {
    std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    if (!names.empty()) text += section("PhysicalNames", std::to_string(names.size()) + "\n" + lines(names));
    std::array<std::map<int, int>, 3> group_of_entity;
    std::string blocks;
    for (const std::string& element : elements) {
      std::istringstream in(element);
      int number = 0, type = 0, group = 0, surface = 0;
      in >> number >> type >> group >> surface;
      const int dimension = type == 15 ? 0 : type == 1 ? 1 : 2, entity = surface + 1000 * std::abs(group);
      if (group != 0) group_of_entity[dimension][entity] = group;
      std::string rest;
      std::getline(in, rest);
      blocks += fmt::format("{} {} {} 1\n{}{}\n", dimension, entity, type, number, rest);
    }
    std::string entities =
        fmt::format("{} {} {} 0\n", group_of_entity[0].size(), group_of_entity[1].size(), group_of_entity[2].size());
    for (int dimension = 0; dimension < 3; ++dimension)
      for (const auto& [entity, group] : group_of_entity[dimension])
        entities += fmt::format(
            "{} {} 1 {}{}\n", entity, dimension == 0 ? "0 0 0" : "0 0 0 1 1 0", group, dimension == 0 ? "" : " 0");
    std::string numbers, places;
    for (const std::string& node : nodes) {
      numbers += node.substr(0, node.find(' ')) + "\n";
      places += node.substr(node.find(' ') + 1) + "\n";
    }
    return text + section("Entities", entities) +
           section("Nodes", fmt::format("1 {0} 1 {0}\n2 1 0 {0}\n", nodes.size()) + numbers + places) +
           section("Elements", fmt::format("{0} {0} 1 {0}\n", elements.size()) + blocks);
  }

 private:
  static std::string lines(const std::vector<std::string>& all)
  {
    std::string text;
    for (const std::string& line : all) text += line + "\n";
    return text;
  }
  static std::string section(const std::string& name, const std::string& content)
  {
    return "$" + name + "\n" + content + "$End" + name + "\n";
  }
};

/// What read_gmsh_text() has against a file called m.msh; empty if nothing.
inline std::string refusal_of(const std::string& text)
{
  return refusal<MeshError>([&] { read_gmsh_text("m.msh", text); });
}

/// The same two layers as MSH 4.1, "41" as text or "41_binary".
inline std::string two_layers(const std::string& format)
{
  return source_path("tests/model/meshes/data/two_layers_" + format + ".msh");
}

/// The bytes of a number, as they stand in a binary file of this machine.
template <class T>
std::string bytes_of(T value)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

}  // namespace terp::test
