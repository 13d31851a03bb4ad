// The format: gmsh reference manual, "MSH file format". Sections that Terp does not use are passed over. A count is
// compared with what the rest of the file can hold before memory is asked for.

#include "model/meshes/msh_content.hpp"

#include "math/number_from.hpp"
#include "model/meshes/mesh_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
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

constexpr std::size_t most_quoted = 40;  // characters of the file in a message

/// Part of the file as it may be printed: short, no control characters.
std::string printable(std::string_view text)
{
  std::string out(text.substr(0, most_quoted));
  for (char& c : out)
    if (c < 32 || c > 126) c = '?';
  return text.size() > most_quoted ? out + "..." : out;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view without_end_blanks(std::string_view text)
{
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Bytes of a whole number in the binary form.
enum class Width { four = 4, eight = 8 };

/// Reads the numbers of the file one after the other, text and bytes by the same calls.
class MshScanner {
 public:
  /// path: for messages. text: the whole file.
  MshScanner(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}

  /// From here on numbers are bytes in this machine's order (true), or text (false).
  void set_binary(bool binary) { binary_ = binary; }

  /// Where the next number begins, in bytes from the start of the file.
  std::size_t at() const { return at_; }

  /// Name of the next line "$Name", empty at the end of the file. Text between sections is passed over.
  std::string next_section()
  {
    for (; at_ < text_.size(); at_ = std::min(text_.size(), at_ + rest_of_line().size() + 1)) {
      skip_blanks();
      const std::string_view line = without_end_blanks(rest_of_line());
      if (!line.starts_with('$')) continue;
      last_ = at_;
      at_ = std::min(text_.size(), at_ + rest_of_line().size() + 1);
      return printable(line.substr(1));
    }
    return {};
  }

  /// Expects "$EndName".
  void end_section(const std::string& name)
  {
    while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n')) ++at_;
    last_ = at_;
    const std::string expected = "$End" + name;
    if (at_ == text_.size()) fail(fmt::format("the file ends before `{}`: it is cut off", expected));
    if (without_end_blanks(rest_of_line()) != expected)
      fail(fmt::format("`{}` is expected, got `{}`", expected, printable(rest_of_line())));
    at_ += rest_of_line().size();
  }

  /// Goes on behind "$EndName", whatever the section holds.
  void skip_section(const std::string& name)
  {
    const std::size_t end = text_.find("\n$End" + name, at_ == 0 ? 0 : at_ - 1);
    if (end == std::string::npos) fail(fmt::format("section ${0} has no `$End{0}`: the file is cut off", name));
    at_ = end + 1;
    end_section(name);
  }

  /// what: of the number, for messages, e.g. "a node number".
  std::int64_t integer(Width width, const char* what)
  {
    if (binary_) return width == Width::four ? bytes<std::int32_t>(what) : bytes<std::int64_t>(what);
    const std::string_view text = token(what);
    const auto value = number_from<std::int64_t>(text);
    if (!value) fail(fmt::format("{} is expected, got `{}`", what, printable(text)));
    if (width == Width::four && *value != static_cast<std::int32_t>(*value))
      fail(fmt::format("{} is out of range: {}", what, *value));
    return *value;
  }

  Real real(const char* what)
  {
    if (binary_) return bytes<double>(what);
    const std::string_view text = token(what);
    Real value = 0.0;
    const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
    const bool too_small = error == std::errc::result_out_of_range &&
                           std::abs(std::strtod(std::string(text).c_str(), nullptr)) < 1.0;  // a zero
    if ((error != std::errc{} && !too_small) || end != text.data() + text.size())
      fail(fmt::format("{} is expected, got `{}`", what, printable(text)));
    return value;
  }

  /// Text in quotes on the current line.
  std::string quoted(const char* what)
  {
    skip_blanks();
    last_ = at_;
    const std::string_view line = without_end_blanks(rest_of_line());
    if (line.size() < 2 || line.front() != '"' || line.back() != '"')
      fail(fmt::format("{} in double quotes is expected, got `{}`", what, printable(line)));
    at_ += line.size();
    return std::string(line.substr(1, line.size() - 2));
  }

  /// How many items follow, refused when they cannot be in the rest of the file. numbers: least numbers per item.
  std::int64_t count(Width width, int numbers, const char* what)
  {
    const std::int64_t n = integer(width, what);
    const auto bytes_left = static_cast<std::int64_t>(rest().size()) + 1;
    const std::int64_t least_bytes = 2 * std::int64_t{numbers};  // a digit and a blank; bytes take more
    if (n < 0 || n > bytes_left / least_bytes)
      fail(fmt::format("{} is {}, more than the rest of the file can hold", what, n));
    return n;
  }

  /// In text the line must end here; bytes have no lines.
  void end_record()
  {
    if (binary_) return;
    skip_blanks();
    last_ = at_;
    if (at_ < text_.size() && text_[at_] != '\n')
      fail(fmt::format("the end of the line is expected, got `{}`", printable(rest_of_line())));
    if (at_ < text_.size()) ++at_;
  }

  /// Throws MeshError with path and line or byte of the number read last.
  [[noreturn]] void fail(const std::string& what) const
  {
    if (binary_) throw MeshError(fmt::format("{}: byte {}: {}", path_, last_, what));
    const auto line =
        1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(last_, text_.size())), '\n');
    throw MeshError(fmt::format("{}:{}: {}", path_, line, what));
  }

 private:
  std::string_view rest() const { return std::string_view(text_).substr(at_); }
  std::string_view rest_of_line() const { return rest().substr(0, rest().find('\n')); }

  void skip_blanks()
  {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  template <class T>
  T bytes(const char* what)
  {
    last_ = at_;
    if (rest().size() < sizeof(T)) fail(fmt::format("the file ends where {} is expected: it is cut off", what));
    T value;
    std::memcpy(&value, text_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  std::string_view token(const char* what)
  {
    skip_blanks();
    last_ = at_;
    if (at_ == text_.size()) fail(fmt::format("the file ends where {} is expected: it is cut off", what));
    if (text_[at_] == '\n') fail(fmt::format("the line ends where {} is expected", what));
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
    const std::string_view found = std::string_view(text_).substr(at_, end - at_);
    at_ = end;
    return found;
  }

  std::string path_, text_;
  std::size_t at_ = 0;    ///< next byte to read
  std::size_t last_ = 0;  ///< first byte of the number read last: faults point there
  bool binary_ = false;
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
          "msh41 FILE.geo`. Of other formats .unv is read with the names of its groups, .bdf, .nas and .vtk without; "
          "save any other, as .inp, as .msh or .unv");
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
