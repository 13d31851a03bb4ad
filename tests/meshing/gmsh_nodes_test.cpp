// Nodes and quadrilaterals in the bytes that gmsh writes; here written by hand.

#include "meshing/gmsh_nodes.hpp"

#include "mesh/mesh_error.hpp"

#include <cstring>
#include <gmock/gmock.h>

namespace terp {
namespace {

class Bytes {
 public:
  template <class T>
  Bytes& operator<<(T number)
  {
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
    return *this;
  }
  Bytes& operator<<(const char* words)
  {
    text += words;
    return *this;
  }
  std::string text;
};

std::size_t n(std::size_t number) { return number; }

/// One cell 7 9 4 2; its base is a line.
std::string one_cell(int type_of_cell = 3)
{
  Bytes bytes;
  bytes << "$MeshFormat\n4.1 1 8\n" << 1 << "\n$EndMeshFormat\n$Nodes\n" << n(3) << n(4) << n(2) << n(9);
  bytes << 0 << 5 << 0 << n(2) << n(7) << n(2) << 0.0 << 0.0 << 0.0 << 0.0 << 1.0 << 0.0;
  bytes << 1 << 3 << 0 << n(1) << n(9) << 1.0 << 0.0 << 0.0;
  bytes << 2 << 1 << 0 << n(1) << n(4) << 1.5 << 1.25 << 0.0;
  bytes << "\n$EndNodes\n$Elements\n" << n(2) << n(2) << n(1) << n(2);
  bytes << 1 << 3 << 1 << n(1) << n(1) << n(7) << n(9);
  bytes << 2 << 1 << type_of_cell << n(1) << n(2) << n(7) << n(9) << n(4) << n(2);
  return bytes.text + "\n$EndElements\n";
}

TEST(GmshNodes, AreFoundWithWhatTheyLieOn)
{
  const auto file = find_nodes(one_cell());
  EXPECT_THAT(
      file.nodes, testing::ElementsAre(Vec<2>{0.0, 0.0}, Vec<2>{0.0, 1.0}, Vec<2>{1.0, 0.0}, Vec<2>{1.5, 1.25}));
  EXPECT_THAT(file.dimension, testing::ElementsAre(0, 0, 1, 2));
  EXPECT_THAT(file.number, testing::ElementsAre(5, 5, 3, 1));
  EXPECT_TRUE(file.all_quads);
}

TEST(GmshNodes, AreTheCornersOfCellsInGmshsOrder)
{
  EXPECT_THAT(find_nodes(one_cell()).cells, testing::ElementsAre(std::array<Index, 4>{0, 2, 3, 1}));
}

TEST(GmshNodes, AreWrittenBackInPlace)
{
  std::string bytes = one_cell();
  auto file = find_nodes(bytes);
  file.nodes[3] = {1.75, 1.0};
  put_nodes(file, bytes);
  EXPECT_EQ(bytes.size(), one_cell().size());
  EXPECT_EQ(find_nodes(bytes).nodes, file.nodes);
  file.nodes[3] = {1.5, 1.25};
  put_nodes(file, bytes);
  EXPECT_EQ(bytes, one_cell());
}

TEST(GmshNodes, NoticeWhatIsNotAQuadrilateral)
{
  EXPECT_FALSE(find_nodes(one_cell(2)).all_quads);
  EXPECT_THROW(find_nodes(one_cell(16)), MeshError);
}

TEST(GmshNodes, RefuseBytesThatEndTooEarly)
{
  EXPECT_THROW(find_nodes(one_cell().substr(0, 150)), MeshError);
  EXPECT_THROW(find_nodes("$Nodes\n"), MeshError);
  EXPECT_THROW(find_nodes(""), MeshError);
}

}  // namespace
}  // namespace terp
