#include "meshing/gmsh_nodes.hpp"

#include "mesh/mesh_error.hpp"

#include <cstring>
#include <unordered_map>

namespace terp {
namespace {

constexpr int triangle = 2, quadrangle = 3, point = 15;  // element types of the MSH format
constexpr std::size_t nodes_of_type[] = {0, 2, 3, 4};    // by element type up to quadrangle

/// Reads numbers one after another.
class Cursor {
 public:
  Cursor(const std::string& bytes, const std::string& section) : bytes_(bytes)
  {
    const std::size_t start = bytes.find("$" + section + "\n");
    if (start == std::string::npos) throw MeshError("gmsh wrote a file without $" + section);
    at_ = start + section.size() + 2;
  }

  template <class T>
  T next()
  {
    T value;
    if (at_ + sizeof(T) > bytes_.size()) throw MeshError("gmsh's file ends too early");
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  std::size_t at() const { return at_; }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

using Tags = std::unordered_map<std::size_t, Index>;

Tags read_nodes(const std::string& bytes, GmshNodes& file)
{
  Tags tags;
  Cursor cursor(bytes, "Nodes");
  const auto n_blocks = cursor.next<std::size_t>();
  for (int header = 0; header < 3; ++header) cursor.next<std::size_t>();
  for (std::size_t block = 0; block < n_blocks; ++block) {
    const int dimension = cursor.next<int>(), number = cursor.next<int>();
    if (cursor.next<int>() != 0) throw MeshError("gmsh wrote parametric nodes");
    const auto n = cursor.next<std::size_t>();
    for (std::size_t i = 0; i < n; ++i) tags[cursor.next<std::size_t>()] = static_cast<Index>(file.nodes.size() + i);
    for (std::size_t i = 0; i < n; ++i) {
      file.offset.push_back(cursor.at());
      const Real x = cursor.next<Real>(), y = cursor.next<Real>();
      cursor.next<Real>();
      file.nodes.push_back({x, y});
      file.dimension.push_back(dimension);
      file.number.push_back(number);
    }
  }
  return tags;
}

void read_cells(const std::string& bytes, const Tags& tags, GmshNodes& file)
{
  Cursor cursor(bytes, "Elements");
  const auto n_blocks = cursor.next<std::size_t>();
  for (int header = 0; header < 3; ++header) cursor.next<std::size_t>();
  for (std::size_t block = 0; block < n_blocks; ++block) {
    cursor.next<int>();
    cursor.next<int>();
    const int type = cursor.next<int>();
    if (type != point && (type < 1 || type > quadrangle)) throw MeshError("gmsh wrote cells of an unknown type");
    const std::size_t n_nodes = type == point ? 1 : nodes_of_type[type];
    file.all_quads = file.all_quads && type != triangle;
    for (auto left = cursor.next<std::size_t>(); left > 0; --left) {
      std::array<Index, 4> cell{};
      cursor.next<std::size_t>();
      for (std::size_t i = 0; i < n_nodes; ++i) cell[i] = tags.at(cursor.next<std::size_t>());
      if (type == quadrangle) file.cells.push_back(cell);
    }
  }
}

}  // namespace

GmshNodes find_nodes(const std::string& bytes)
{
  GmshNodes file;
  const Tags tags = read_nodes(bytes, file);
  read_cells(bytes, tags, file);
  return file;
}

void put_nodes(const GmshNodes& file, std::string& bytes)
{
  for (std::size_t i = 0; i < file.nodes.size(); ++i)
    std::memcpy(bytes.data() + file.offset[i], file.nodes[i].data(), sizeof(Vec<2>));
}

}  // namespace terp
