// The format: gmsh reference manual, "MSH file format". Sections that Terp does not use are passed over.

#include "meshing/msh_content.hpp"

#include "meshing/msh_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

constexpr std::int64_t most_others = 16;  // kept for the message

const std::string save_again = "Save the mesh as 4.1: `gmsh FILE -save -format msh41 -o NEW.msh`";

struct ElementType {
  int n_nodes;
  const char* name;
};

/// By gmsh's number, manual "Node ordering".
const std::map<int, ElementType> element_types{
    {msh_line, {2, "line"}},
    {2, {3, "triangle"}},
    {msh_quad, {4, "quadrilateral"}},
    {4, {4, "tetrahedron"}},
    {5, {8, "hexahedron"}},
    {6, {6, "prism"}},
    {7, {5, "pyramid"}},
    {8, {3, "line with 3 nodes"}},
    {9, {6, "triangle with 6 nodes"}},
    {10, {9, "quadrilateral with 9 nodes"}},
    {msh_point, {1, "point"}},
    {16, {8, "quadrilateral with 8 nodes"}},
    {20, {9, "triangle with 9 nodes"}},
    {21, {10, "triangle with 10 nodes"}},
    {26, {4, "line with 4 nodes"}},
    {36, {16, "quadrilateral with 16 nodes"}},
};

class MshReader {
 public:
  MshReader(const std::string& path, std::string text) : scan_(path, std::move(text)) {}

  MshContent read()
  {
    read_format();
    for (std::string name = scan_.next_section(); !name.empty(); name = scan_.next_section()) read_section(name);
    if (content_.node_numbers.empty())
      scan_.fail("the file ends without section $Nodes: it is cut off, or holds no mesh");
    if (!has_elements_) scan_.fail("the file ends without section $Elements: it is cut off, or holds no mesh");
    return std::move(content_);
  }

 private:
  void read_format()
  {
    const std::string first = scan_.next_section();
    if (first == "NOD") scan_.fail("MSH version 1 is not read. " + save_again);
    if (first != "MeshFormat")
      scan_.fail(
          "this is not a gmsh mesh: section $MeshFormat is expected first. A .geo file is meshed by `gmsh -2 -format "
          "msh41 FILE.geo`");
    const Real version = scan_.real("the version of the format");
    if (version != 4.1) scan_.fail(fmt::format("MSH version {:g} is not read. {}", version, save_again));
    const std::int64_t form = scan_.integer(Width::four, "0 (text) or 1 (binary)");
    if (form != 0 && form != 1) scan_.fail(fmt::format("0 (text) or 1 (binary) is expected, got {}", form));
    if (scan_.integer(Width::four, "the size of a number") != 8) scan_.fail("numbers of 8 bytes are expected");
    scan_.end_record();
    binary_ = form == 1;
    scan_.set_binary(binary_);
    if (binary_ && scan_.integer(Width::four, "the number 1 as bytes") != 1)
      scan_.fail("the file was written by a machine with another order of bytes. Save it as text (ASCII)");
    scan_.end_section("MeshFormat");
  }

  void read_section(const std::string& name)
  {
    if (name == "PhysicalNames")
      read_names();
    else if (name == "Entities")
      read_entities();
    else if (name == "Nodes" && content_.node_numbers.empty())
      read_nodes();
    else if (name == "Elements" && !has_elements_)
      read_elements();
    else if (name == "PartitionedEntities")
      scan_.fail("the mesh is cut into partitions. Save it in one piece, before it is partitioned");
    else
      return scan_.skip_section(name);
    scan_.end_section(name);
  }

  void read_names()
  {
    scan_.set_binary(false);  // lines of text stand in binary files too
    const std::int64_t n = scan_.count(Width::eight, 3, "the number of names");
    scan_.end_record();
    for (std::int64_t k = 0; k < n; ++k) {
      const auto dimension = static_cast<int>(scan_.integer(Width::four, "a dimension"));
      const auto number = static_cast<int>(scan_.integer(Width::four, "the number of a physical group"));
      content_.group_names[{dimension, number}] = scan_.quoted("the name of a physical group");
      scan_.end_record();
    }
    scan_.set_binary(binary_);
  }

  /// Elements belong to entities, entities to physical groups.
  void read_entities()
  {
    std::array<std::int64_t, 4> n;
    for (auto& count : n) count = scan_.count(Width::eight, 4, "a number of entities");
    scan_.end_record();
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t k = 0; k < n[dimension]; ++k) read_entity(dimension);
  }

  void read_entity(int dimension)
  {
    const auto number = static_cast<int>(scan_.integer(Width::four, "the number of an entity"));
    const int n_reals = dimension == 0 ? 3 : 6;  // a point, or a box
    for (int k = 0; k < n_reals; ++k) scan_.real("a coordinate");
    std::vector<int> groups(scan_.count(Width::eight, 1, "a number of physical groups"));
    for (int& group : groups) group = group_number(scan_.integer(Width::four, "the number of a physical group"));
    if (dimension > 0) {
      const std::int64_t n = scan_.count(Width::eight, 1, "a number of bounding entities");
      for (std::int64_t k = 0; k < n; ++k) scan_.integer(Width::four, "the number of an entity");
    }
    scan_.end_record();
    groups_of_entity_[{dimension, number}] = group_set(std::move(groups));
  }

  /// gmsh writes a negative number where a group turns an entity round.
  static int group_number(std::int64_t number)
  {
    return static_cast<int>(std::min<std::int64_t>(std::abs(number), std::numeric_limits<int>::max()));
  }

  Index group_set(std::vector<int> groups)
  {
    const auto [entry, is_new] = set_numbers_.try_emplace(groups, static_cast<Index>(content_.group_sets.size()));
    if (is_new) content_.group_sets.push_back(std::move(groups));
    return entry->second;
  }

  void read_nodes()
  {
    const std::int64_t n_blocks = scan_.count(Width::eight, 4, "the number of node blocks");
    for (const char* what : {"the number of nodes", "the lowest node number", "the highest node number"})
      scan_.integer(Width::eight, what);
    scan_.end_record();
    for (std::int64_t b = 0; b < n_blocks; ++b) {
      const auto dimension = static_cast<int>(scan_.integer(Width::four, "a dimension"));
      if (dimension < 0 || dimension > 3)
        scan_.fail(fmt::format("a dimension of 0 to 3 is expected, got {}", dimension));
      const auto entity = static_cast<int>(scan_.integer(Width::four, "the number of an entity"));
      const int n_parameters = scan_.integer(Width::four, "0 or 1 (parametric)") != 0 ? dimension : 0;
      const std::int64_t n = scan_.count(Width::eight, 4, "the number of nodes in a block");
      scan_.end_record();
      for (std::int64_t k = 0; k < n; ++k) {
        add_node_number();
        content_.node_entities.push_back({dimension, entity});
      }
      for (std::int64_t k = 0; k < n; ++k) {
        add_place();
        for (int p = 0; p < n_parameters; ++p) scan_.real("a parameter");
        scan_.end_record();
      }
    }
  }

  void add_node_number()
  {
    content_.node_numbers.push_back(scan_.integer(Width::eight, "a node number"));
    if (content_.node_numbers.back() < 1)
      scan_.fail(fmt::format("a node number of at least 1 is expected, got {}", content_.node_numbers.back()));
    scan_.end_record();
  }

  void add_place()
  {
    std::array<Real, 3> place;
    content_.node_bytes.push_back(scan_.at());
    for (Real& x : place) {
      x = scan_.real("a coordinate");
      if (!std::isfinite(x)) scan_.fail("a coordinate is not a finite number");
    }
    content_.places.push_back(place);
  }

  void read_elements()
  {
    const std::int64_t n_blocks = scan_.count(Width::eight, 4, "the number of element blocks");
    for (const char* what : {"the number of elements", "the lowest element number", "the highest element number"})
      scan_.integer(Width::eight, what);
    scan_.end_record();
    for (std::int64_t b = 0; b < n_blocks; ++b) {
      const auto dimension = static_cast<int>(scan_.integer(Width::four, "a dimension"));
      const auto entity = static_cast<int>(scan_.integer(Width::four, "the number of an entity"));
      MshElement element = new_element(static_cast<int>(scan_.integer(Width::four, "an element type")));
      const std::int64_t n = scan_.count(Width::eight, 2, "the number of elements in a block");
      element.entity = entity;
      scan_.end_record();
      const auto groups = groups_of_entity_.find({dimension, entity});
      element.groups = groups == groups_of_entity_.end() ? group_set({}) : groups->second;
      for (std::int64_t k = 0; k < n; ++k) {
        element.number = scan_.integer(Width::eight, "an element number");
        add_element(element);
      }
    }
    has_elements_ = true;
  }

  MshElement new_element(int type)
  {
    const auto known = element_types.find(type);
    if (known == element_types.end())
      scan_.fail(fmt::format("elements of type {} are not read: Terp takes quadrilaterals (type 3)", type));
    return {0, type, known->second.n_nodes, {}, 0, 0};
  }

  void add_element(MshElement element)
  {
    for (int k = 0; k < element.n_nodes; ++k) {
      const std::int64_t node = scan_.integer(Width::eight, "the number of a node of an element");
      if (k < 4) element.nodes[k] = node;
    }
    scan_.end_record();
    if (element.type == msh_quad)
      content_.quads.push_back(element);
    else if (element.type == msh_line)
      content_.lines.push_back(element);
    else if (element.type != msh_point && ++content_.n_others <= most_others)
      content_.others.push_back(element);
  }

  MshScanner scan_;
  MshContent content_;
  bool binary_ = false, has_elements_ = false;
  std::map<MshEntity, Index> groups_of_entity_;
  std::map<std::vector<int>, Index> set_numbers_;  // into group_sets
};

}  // namespace

std::string msh_type_name(int type)
{
  const auto known = element_types.find(type);
  return known == element_types.end() ? std::string{} : known->second.name;
}

MshContent read_msh(const std::string& path, std::string text) { return MshReader(path, std::move(text)).read(); }

}  // namespace terp
