// Small gmsh files made by hand, for tests of the reader.
#pragma once

#include "meshing/gmsh_file.hpp"

#include <cstring>
#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace terp::test {

/// Lines of $Nodes and $Elements of an MSH 2.2 text file: "1 0 0 0", "1 3 2 0 1  1 2 5 4".
struct MshText {
  std::vector<std::string> nodes{"1 0 0 0", "2 1 0 0", "3 2 0 0", "4 0 1 0", "5 1 1 0", "6 2 1 0"};
  std::vector<std::string> elements{"7 3 2 0 1 1 2 5 4", "8 3 2 0 1 2 3 6 5"};
  std::vector<std::string> names{};

  std::string text() const
  {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    if (!names.empty()) text += section("PhysicalNames", names);
    return text + section("Nodes", nodes) + section("Elements", elements);
  }

 private:
  static std::string section(const std::string& name, const std::vector<std::string>& lines)
  {
    std::string text = "$" + name + "\n" + std::to_string(lines.size()) + "\n";
    for (const auto& line : lines) text += line + "\n";
    return text + "$End" + name + "\n";
  }
};

/// What read_gmsh_text() has against a file called m.msh; empty if nothing.
inline std::string refusal_of(const std::string& text)
{
  try {
    read_gmsh_text("m.msh", text);
  } catch (const MeshError& error) {
    return error.what();
  }
  return {};
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
