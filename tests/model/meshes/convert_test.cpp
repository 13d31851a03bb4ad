#include "model/meshes/msh_content.hpp"
#include "model/meshes/msh_text.hpp"
#include "os/process.hpp"
#include "support/environment.hpp"
#include "support/process.hpp"

namespace convert_test {

std::string reading_refusal(const std::string& path)
{
  return refusal<MeshError>([&] { read_gmsh(path); });
}

class Convert : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!run_process({"gmsh", "--version"}, 60.0).found) GTEST_SKIP() << "gmsh is not installed";
  }
  /// The two layers as gmsh writes them in another format.
  std::string converted(const std::string& name, std::vector<std::string> options) const
  {
    std::vector<std::string> words{"gmsh", two_layers("41"), "-save", "-v", "2", "-o", scratch_.path() + '/' + name};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_TRUE(run_process(words, 60.0).succeeded()) << name;
    return words[6];
  }
  ScratchFolder scratch_;
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
  for (const std::string& file :
      {converted("22.msh", {"-format", "msh22"}), converted("22_binary.msh", {"-format", "msh22", "-bin"})}) {
    const Mesh<2> mesh = read_gmsh(file);
    EXPECT_EQ(shapes(mesh), shapes(expected)) << file;
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
  const Mesh<2> mesh = read_gmsh(converted("layers.unv", {"-format", "unv"})), expected = read_gmsh(two_layers("41"));
  EXPECT_EQ(shapes(mesh), shapes(expected));
  ASSERT_EQ(mesh.regions.size(), 3u);
  EXPECT_EQ(mesh.regions[0].name, "sand_layer");  // .unv has no blanks in names
  EXPECT_EQ(mesh.sides.size(), expected.sides.size());
}

TEST_F(Convert, ADamagedFileIsRefusedWithItsOwnName)
{
  const std::string file = scratch_.path() + "/cut off.msh";
  std::ofstream(file) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0";
  EXPECT_THAT(reading_refusal(file), StartsWith(file + ": this is not MSH 4.1, and gmsh cannot convert it: Error"));
  EXPECT_THAT(reading_refusal(file), Not(HasSubstr("terp-mesh")));
  const std::string other = scratch_.path() + "/words.unv";
  std::ofstream(other) << "nothing of the kind\n";
  EXPECT_THAT(reading_refusal(other), StartsWith(other + ": this is not MSH 4.1, and gmsh finds no mesh in it\n"));
}

TEST_F(Convert, LooksAtNoOptionsBesideTheFileAndRunsNoCommands)
{
  const std::string file = converted("m.msh", {"-format", "msh22"});
  std::ofstream(file + ".opt") << "SystemCall \"touch " << scratch_.path() << "/called\";\n";
  EXPECT_EQ(read_gmsh(file).n_cells(), 8);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() + "/called"));
}

TEST(ConvertWithoutGmsh, ReadsMsh41AndSaysHowToSaveTheOthers)
{
  const ScratchFolder empty;
  const Variable path("PATH", empty.path());
  EXPECT_EQ(read_gmsh(two_layers("41")).n_cells(), 8);
  EXPECT_EQ(read_gmsh(two_layers("41_binary")).n_cells(), 8);
  const std::string older = empty.path() + "/older.msh";
  write_text(older, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
  EXPECT_EQ(reading_refusal(older),
      older +
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

}  // namespace convert_test
