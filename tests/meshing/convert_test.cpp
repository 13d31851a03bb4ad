// Files in other formats, converted by gmsh: the same mesh, and what is said where that is not possible.

#include "meshing/convert.hpp"

#include "meshing/gmsh_file.hpp"
#include "meshing/process.hpp"
#include "support/environment.hpp"
#include "support/paths.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::HasSubstr;

std::string two_layers(const std::string& format)
{
  return test::source_path("tests/meshing/data/two_layers_" + format + ".msh");
}

std::string refusal_of(const std::string& path)
{
  try {
    read_gmsh(path);
  } catch (const MeshError& error) {
    return error.what();
  }
  return {};
}

class Convert : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!run_process({"gmsh", "--version"}, 60.0).found) GTEST_SKIP() << "gmsh is not installed";
  }
  test::ScratchFolder scratch_;
};

/// Coordinates of the corners of all cells, each cell from its lowest corner on, sorted: free of all numbers.
std::vector<std::vector<Vec<2>>> shapes(const Mesh<2>& mesh)
{
  std::vector<std::vector<Vec<2>>> all;
  for (const auto& cell : mesh.cells) {
    std::vector<Vec<2>> corners;
    for (const Index i : cell) {
      corners.push_back(mesh.nodes[i]);
      for (Real& x : corners.back()) x = std::round(x * 1e9) * 1e-9;  // .unv has fewer digits
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST_F(Convert, OlderFilesOfGmshGiveTheSameCellsSidesAndRegions)
{
  const Mesh<2> expected = read_gmsh(two_layers("41"));
  for (const char* format : {"22", "22_binary"}) {
    const Mesh<2> mesh = read_gmsh(two_layers(format));
    EXPECT_EQ(shapes(mesh), shapes(expected)) << format;
    ASSERT_EQ(mesh.sides.size(), expected.sides.size());
    for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
      EXPECT_EQ(mesh.sides[s].name, expected.sides[s].name);
      EXPECT_EQ(mesh.sides[s].edges.size(), expected.sides[s].edges.size());
    }
    ASSERT_EQ(mesh.regions.size(), expected.regions.size());
    for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
      EXPECT_EQ(mesh.regions[r].name, expected.regions[r].name);
      EXPECT_EQ(mesh.regions[r].cells.size(), expected.regions[r].cells.size());
    }
  }
}

TEST_F(Convert, FilesOfOthersKeepTheirNames)
{
  const std::string file = scratch_.path() + "/layers.unv";
  ASSERT_TRUE(
      run_process({"gmsh", two_layers("41"), "-save", "-format", "unv", "-o", file, "-v", "2"}, 60.0).succeeded());
  const Mesh<2> mesh = read_gmsh(file), expected = read_gmsh(two_layers("41"));
  EXPECT_EQ(shapes(mesh), shapes(expected));
  ASSERT_EQ(mesh.regions.size(), 3u);
  EXPECT_EQ(mesh.regions[0].name, "sand_layer");  // .unv has no blanks in names
  EXPECT_EQ(mesh.sides.size(), expected.sides.size());
}

TEST_F(Convert, ADamagedFileIsRefusedWithItsOwnName)
{
  const std::string file = scratch_.path() + "/cut off.msh";
  std::ofstream(file) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0";
  EXPECT_THAT(refusal_of(file), testing::StartsWith(file + ": this is not MSH 4.1, and gmsh cannot convert it: Error"));
  EXPECT_THAT(refusal_of(file), testing::Not(HasSubstr("terp-mesh")));
  const std::string other = scratch_.path() + "/words.unv";
  std::ofstream(other) << "nothing of the kind\n";
  EXPECT_THAT(refusal_of(other), testing::StartsWith(other + ": this is not MSH 4.1, and gmsh finds no mesh in it\n"));
}

TEST_F(Convert, LooksAtNoOptionsBesideTheFileAndRunsNoCommands)
{
  const std::string file = scratch_.path() + "/m.msh";
  std::filesystem::copy_file(two_layers("22"), file);
  std::ofstream(file + ".opt") << "SystemCall \"touch " << scratch_.path() << "/called\";\n";
  EXPECT_EQ(read_gmsh(file).n_cells(), 32);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() + "/called"));
}

TEST(ConvertWithoutGmsh, ReadsMsh41AndSaysHowToSaveTheOthers)
{
  const test::ScratchFolder empty;
  const test::Variable path("PATH", empty.path());
  EXPECT_EQ(read_gmsh(two_layers("41")).n_cells(), 32);
  EXPECT_EQ(read_gmsh(two_layers("41_binary")).n_cells(), 32);
  EXPECT_EQ(refusal_of(two_layers("22")),
      two_layers("22") +
          ": this is not MSH 4.1, and gmsh, which would convert it, is not installed: apt-get install gmsh\n"
          "  Save the mesh as MSH 4.1; in gmsh: `gmsh FILE -save -format msh41 -o NEW.msh`");
}

TEST(NeedsConversion, LooksAtTheFirstWordsAndTheEnding)
{
  EXPECT_FALSE(needs_conversion("m.msh", "$MeshFormat\n4.1 0 8\n"));
  EXPECT_FALSE(needs_conversion("m.geo", "Point(1) = {0, 0, 0};\n"));  // a script is not run
  EXPECT_TRUE(needs_conversion("m.msh", "$MeshFormat\n2.2 0 8\n"));
  EXPECT_TRUE(needs_conversion("m.msh", "$MeshFormat\n4 0 8\n"));
  EXPECT_TRUE(needs_conversion("m.msh", "$NOD\n4\n"));
  EXPECT_TRUE(needs_conversion("m.unv", "    -1\n"));
}

}  // namespace
}  // namespace terp
