#include "model/meshes/gmsh_file.hpp"
#include "model/meshes/msh_text.hpp"
#include "support/golden.hpp"
#include "support/meshes.hpp"
#include <fmt/format.h>

namespace gmsh_file_test {

const std::string formats[] = {"41", "41_binary"};

Real area_of_region(const Mesh<2>& mesh, const NamedRegion& region)
{
  Real area = 0.0;
  for (const Index cell : region.cells) area += mesh.geometry(cell).volume;
  return area;
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all)
{
  std::vector<std::string> names;
  for (const Named& each : all) names.push_back(each.name);
  return names;
}

TEST(ReadGmsh, GivesTheSameMeshFromTextAndBytes)
{
  const Mesh<2> expected = read_gmsh(two_layers("41"));
  ASSERT_EQ(expected.n_cells(), 8);
  ASSERT_EQ(expected.n_nodes(), 15);
  for (const auto& format : formats) {
    const Mesh<2> mesh = read_gmsh(two_layers(format));
    EXPECT_EQ(mesh.cells, expected.cells) << format;
    ASSERT_EQ(mesh.n_nodes(), expected.n_nodes());
    for (Index i = 0; i < mesh.n_nodes(); ++i)
      for (int d = 0; d < 2; ++d)
        EXPECT_NEAR(mesh.nodes[i][d], expected.nodes[i][d], 1e-15) << format;  // text has 16 digits
    EXPECT_EQ(names_of(mesh.sides), names_of(expected.sides));
    EXPECT_EQ(names_of(mesh.regions), names_of(expected.regions));
    for (std::size_t s = 0; s < mesh.sides.size(); ++s)
      EXPECT_EQ(mesh.sides[s].edges.size(), expected.sides[s].edges.size());
    for (std::size_t r = 0; r < mesh.regions.size(); ++r) EXPECT_EQ(mesh.regions[r].cells, expected.regions[r].cells);
  }
}

TEST(ReadGmsh, NamesSidesAndRegionsAfterThePhysicalGroups)
{
  for (const auto& format : formats) {
    const Mesh<2> mesh = read_gmsh(two_layers(format));
    ASSERT_THAT(names_of(mesh.sides), ElementsAre("bottom", "left", "right", "walls"));
    auto lengths = lengths_of_sides(mesh);
    EXPECT_NEAR(lengths["bottom"], 1.5, 1e-14);
    EXPECT_NEAR(lengths["left"], 1.0, 1e-14);
    EXPECT_NEAR(lengths["right"], 0.5 + std::hypot(0.3, 0.5), 1e-14);
    EXPECT_NEAR(lengths["walls"], 1.5 + std::hypot(0.3, 0.5), 1e-14);  // in two groups: left and right
    ASSERT_THAT(names_of(mesh.regions), ElementsAre("sand layer", "clay", "all"));
    EXPECT_NEAR(area_of_region(mesh, mesh.regions[0]), 0.75, 1e-14);
    EXPECT_NEAR(area_of_region(mesh, mesh.regions[1]), 0.675, 1e-14);
    EXPECT_NEAR(area_of_region(mesh, mesh.regions[2]), 1.425, 1e-14);
  }
}

TEST(ReadGmsh, MatchesEachLineWithTheCellSideItLiesOn)
{
  const Mesh<2> mesh = read_gmsh(two_layers("41"));
  for (const auto& side : mesh.sides)
    for (const CellSide& edge : side.edges) EXPECT_EQ(mesh.neighbours[edge.cell][edge.side], outside);
  for (const CellSide& edge : mesh.sides[0].edges) {
    EXPECT_EQ(mesh.nodes[mesh.cells[edge.cell][edge.side]][1], 0.0);
    EXPECT_EQ(mesh.nodes[mesh.cells[edge.cell][(edge.side + 1) % 4]][1], 0.0);
  }
}

TEST(ReadGmsh, KeepsTheNumbersOfTheFile)
{
  MshText file;
  file.nodes = {"10 0 0 0", "2 1 0 0", "30 2 0 0", "4 0 1 0", "5 1 1 0", "6 2 1 0"};
  file.elements = {"70 3 0 1 10 2 5 4", "8 3 0 1 2 30 6 5"};
  const Mesh<2> mesh = read_gmsh_text("m.msh", file.text());
  EXPECT_THAT(mesh.node_numbers, ElementsAre(10, 2, 30, 4, 5, 6));
  EXPECT_THAT(mesh.cell_numbers, ElementsAre(70, 8));
}

TEST(ReadGmsh, LeavesOutNodesOfNoCell)
{
  MshText file;
  file.nodes.insert(file.nodes.begin() + 1, "99 0.5 0.5 0");
  const Mesh<2> mesh = read_gmsh_text("m.msh", file.text());
  EXPECT_EQ(mesh.n_nodes(), 6);
  EXPECT_THAT(mesh.node_numbers, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(mesh.cells[0], ElementsAre(0, 1, 4, 3));
}

TEST(ReadGmsh, TurnsASurfaceWhoseCellsAllRunClockwise)  // the second one, called 2
{
  MshText file;
  file.elements = {"7 3 0 2 4 5 2 1", "8 3 0 1 2 3 6 5"};
  const Mesh<2> mesh = read_gmsh_text("m.msh", file.text());
  EXPECT_THAT(mesh.cells[0], ElementsAre(3, 0, 1, 4));
  EXPECT_NEAR(mesh.geometry(0).volume, 1.0, 1e-15);
  EXPECT_EQ(mesh.neighbours[0][2], 1);
}

TEST(ReadGmsh, CallsAGroupWithoutNameByItsNumber)
{
  MshText file;
  file.elements.push_back("1 1 5 1 1 2");
  file.elements[0] = "7 3 12 1 1 2 5 4";
  const Mesh<2> mesh = read_gmsh_text("m.msh", file.text());
  EXPECT_THAT(names_of(mesh.sides), ElementsAre("5"));
  EXPECT_THAT(names_of(mesh.regions), ElementsAre("12"));
}

TEST(ReadGmsh, JoinsGroupsOfOneNameAndTakesALineOnce)
{
  MshText file;
  file.names = {"1 5 \"base\"", "1 6 \"base\"", "2 5 \"soil\"", "1 9 \"nothing\""};
  file.elements.insert(file.elements.end(), {"1 1 5 1 1 2", "2 1 6 1 2 3", "3 1 5 1 2 1"});
  const Mesh<2> mesh = read_gmsh_text("m.msh", file.text());
  ASSERT_THAT(names_of(mesh.sides), ElementsAre("base"));
  EXPECT_EQ(mesh.sides[0].edges.size(), 2u);
  EXPECT_TRUE(mesh.regions.empty());
}

TEST(ReadGmsh, TakesAGroupThatTurnsAnEntityRound)  // gmsh writes its number with a minus
{
  MshText file;
  file.names = {"1 5 \"base\""};
  file.elements.push_back("1 1 -5 1 1 2");
  EXPECT_THAT(names_of(read_gmsh_text("m.msh", file.text()).sides), ElementsAre("base"));
}

/// n x n unit cells whose elements stand in the file in random order.
MshText shuffled_square(Index n)
{
  MshText file{{}, {}, {}};
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) file.nodes.push_back(fmt::format("{} {} {} 0", j * (n + 1) + i + 1, i, j));
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i + 1;
      file.elements.push_back(fmt::format("{} 3 0 1 {} {} {} {}", j * n + i + 1, a, a + 1, a + n + 2, a + n + 1));
    }
  Random random(3);
  for (Index k = n * n - 1; k > 0; --k) std::swap(file.elements[k], file.elements[random.below(k + 1)]);
  return file;
}

TEST(ReadGmsh, NumbersCellsSoThatEachLiesBesideTheNext)
{
  const Mesh<2> mesh = read_gmsh_text("m.msh", shuffled_square(16).text());
  ASSERT_EQ(mesh.n_cells(), 256);
  for (Index e = 1; e < mesh.n_cells(); ++e)
    EXPECT_NEAR(std::hypot(mesh.centres[e][0] - mesh.centres[e - 1][0], mesh.centres[e][1] - mesh.centres[e - 1][1]),
        1.0, 1e-12)
        << e;
}

void (*const wrong_meshes[])(MshText&) = {
    [](MshText& file) { file.elements[1] = "8 2 0 1 2 3 6"; },
    [](MshText& file) {
      file.nodes.insert(file.nodes.end(), {"7 0.5 0 0", "8 1 0.5 0", "9 0.5 1 0", "10 0 0.5 0", "11 0.5 0.5 0"});
      file.elements = {"3 10 0 1 1 2 5 4 7 8 9 10 11"};
    },
    [](MshText& file) {
      file.elements.assign({"1 1 5 1 1 2", "2 15 0 1 1"});
    },
    [](MshText& file) { file.elements[0] = "7 3 0 1 4 5 2 1"; },
    [](MshText& file) { file.elements.push_back("9 1 5 1 1 5"); },
    [](MshText& file) { file.elements[1] = "8 3 0 1 2 3 66 5"; },
    [](MshText& file) { file.nodes.push_back("3 0.5 0.5 0"); },
    [](MshText& file) { file.nodes[5] = "6 2 1 0.25"; },
    [](MshText& file) { file.nodes[4] = "5 0.2 0.2 0"; },
    [](MshText& file) { file.elements.push_back("10 3 4 1 1 2 5 4"); },
    [](MshText& file) {
      for (int k = 0; k < 30; ++k) file.elements.push_back(fmt::format("{} 2 0 1 2 3 6", 10 + k));
    },
};

TEST(ReadGmsh, RefusesWhatCannotBeAMeshForTerpInTheWordsOfTheGoldenText)
{
  std::string all;
  for (const auto& change : wrong_meshes) {
    MshText file;
    change(file);
    all += refusal_of(file.text()) + "\n\n";
  }
  expect_golden("tests/model/meshes/no_mesh_for_terp.txt", all);
}

TEST(ReadGmsh, KeepsTheNameOfACurveInsideAsASideThatBoundsNothing)
{
  MshText file;
  file.names = {"1 5 \"weak layer\"", "1 6 \"base\""};
  file.elements.insert(
      file.elements.end(), {"9 1 5 1 2 5", "10 1 5 1 1 2", "11 1 6 1 1 2"});  // the second lies outside
  const Mesh<2> mesh = read_gmsh_text("m.msh", file.text());
  ASSERT_THAT(names_of(mesh.sides), ElementsAre("weak layer", "base"));
  EXPECT_TRUE(mesh.sides[0].edges.empty());
  EXPECT_EQ(mesh.sides[1].edges.size(), 1u);
}

TEST(ReadGmsh, PassesOverLinesInNoGroup)
{
  MshText file;
  file.elements.push_back("9 1 0 1 2 5");
  EXPECT_EQ(refusal_of(file.text()), "");
}

TEST(ReadGmsh, SaysWhyAPathIsNoMeshFile)
{
  const ScratchFolder folder;
  const std::string empty = folder.path() + "/empty.msh", none = folder.path() + "/none.msh";
  std::ofstream(empty).close();
  const std::pair<std::string, std::string> refused[] = {
      {folder.path(),
          "cannot read " + folder.path() + ": a folder is in the place of the file\n  Put the file back there."},
      {none, "cannot read " + none + ": No such file or directory"},
      {empty, empty + ": the file is empty. In gmsh: mesh the section (Mesh, 2D), then save it as MSH 4.1."}};
  for (const auto& [path, why] : refused) EXPECT_EQ(refusal<MeshError>([&] { read_gmsh(path); }), why);
}

}  // namespace gmsh_file_test
