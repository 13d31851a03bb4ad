// Every kind of mesh arrives in the case; keys that are wrong together: wrong_cases/meshes.wrong.
#include "io/case/check_case.hpp"
#include "io/case/samples.hpp"
#include "support/paths.hpp"

namespace check_mesh_test {

MeshCase mesh_of(const std::string& keys) { return read_case_text(small_case_on(keys), "case.toml").values.mesh; }

TEST(CheckMesh, ReadsAGradedRectangle)
{
  const MeshCase mesh = mesh_of(graded);
  EXPECT_EQ(mesh.kind, MeshKind::graded);
  EXPECT_EQ(mesh.origin, (Vec<2>{-1.0, 2.0}));
  EXPECT_EQ(mesh.size, (Vec<2>{16.0, 3.0}));
  EXPECT_EQ(mesh.cells, (std::array<Index, 2>{32, 6}));
  EXPECT_EQ(mesh.grading, (Vec<2>{2.0, 0.5}));
  EXPECT_EQ(mesh_of("size = [16.0, 3.0]\ncells = 6").grading, (Vec<2>{1.0, 1.0}));
  EXPECT_EQ(mesh_of("size = [16.0, 3.0]\ncell = 0.5").kind, MeshKind::rectangle);
}

TEST(CheckMesh, ReadsAGridBetweenFourSides)
{
  const MeshCase mesh = mesh_of(mapped);
  EXPECT_EQ(mesh.kind, MeshKind::mapped);
  EXPECT_EQ(mesh.cells, (std::array<Index, 2>{8, 8}));
  EXPECT_THAT(mesh.sides[0], ElementsAre(Vec<2>{0, 0}, Vec<2>{4, 1}, Vec<2>{8, 0}));
  EXPECT_THAT(mesh.sides[1], ElementsAre(Vec<2>{8, 0}, Vec<2>{8, 3}));
  EXPECT_THAT(mesh.sides[2], ElementsAre(Vec<2>{0, 3}, Vec<2>{8, 3}));
  EXPECT_THAT(mesh.sides[3], ElementsAre(Vec<2>{0, 0}, Vec<2>{0, 3}));
}

TEST(CheckMesh, ReadsAPolygon)
{
  const MeshCase mesh = mesh_of(polygon);
  EXPECT_EQ(mesh.kind, MeshKind::polygon);
  EXPECT_EQ(mesh.cell, (Vec<2>{0.5, 0.5}));
  EXPECT_EQ(mesh.polygon.size(), 5u);
  EXPECT_EQ(mesh.polygon[2], (Vec<2>{8, 1}));
  ASSERT_EQ(mesh.edges.size(), 2u);
  EXPECT_EQ(mesh.edges[1].side, "slope");
  EXPECT_THAT(mesh.edges[1].edges, ElementsAre(2, 3));
  EXPECT_FALSE(mesh.follow_bodies);
  EXPECT_EQ(mesh.variant, 2);
}

TEST(CheckMesh, ReadsRefinements)
{
  const MeshCase mesh = mesh_of(polygon);
  ASSERT_EQ(mesh.refine.size(), 2u);
  EXPECT_THAT(mesh.refine[0].line, ElementsAre(Vec<2>{8, 1}, Vec<2>{4, 3}));
  EXPECT_EQ(mesh.refine[0].cell, 0.125);
  EXPECT_EQ(mesh.refine[0].distance, 0.5);
  EXPECT_TRUE(mesh.refine[1].line.empty());
  EXPECT_EQ(mesh.refine[1].low, (Vec<2>{1, 0}));
  EXPECT_EQ(mesh.refine[1].high, (Vec<2>{2, 1}));
  EXPECT_EQ(mesh.refine[1].distance, 0.0);
}

TEST(CheckMesh, ReadsAMeshFileWithSidesThatOnlyTheFileKnows)
{
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/dike.msh");
  const std::string text = small_case_on("file = \"dike.msh\"") + "[boundary]\n\"outer slope\" = \"open\"\n";
  const Case c = read_case_text(text, folder.path() + "/case.toml").values;
  EXPECT_EQ(c.mesh.kind, MeshKind::file);
  EXPECT_EQ(c.mesh.file, "dike.msh");
  EXPECT_EQ(c.sides.at(0).side, "outer slope");
}

TEST(CheckMesh, TurnsAClockwisePolygonWithItsEdges)
{
  const MeshCase mesh = mesh_of(R"(polygon = [[0, 0], [0, 3], [4, 3], [8, 1], [8, 0]]
cell = 0.5
edges = { left = [0], crest = [1], slope = [2], base = [4], right = [3] })");
  const auto ends = [&](int side) {
    const Index k = mesh.edges[side].edges[0];
    return std::pair(mesh.polygon[k], mesh.polygon[(k + 1) % 5]);
  };
  EXPECT_EQ(ends(0), std::pair(Vec<2>({0, 3}), Vec<2>({0, 0})));
  EXPECT_EQ(ends(1), std::pair(Vec<2>({4, 3}), Vec<2>({0, 3})));
  EXPECT_EQ(ends(2), std::pair(Vec<2>({8, 1}), Vec<2>({4, 3})));
  EXPECT_EQ(ends(3), std::pair(Vec<2>({0, 0}), Vec<2>({8, 0})));
  EXPECT_EQ(ends(4), std::pair(Vec<2>({8, 0}), Vec<2>({8, 1})));
}

TEST(CheckMesh, RecordsWhatReadsTheSame)
{
  for (const std::string& keys : {graded, mapped, polygon}) {
    const CaseFile file = read_case_text(small_case_on(keys), "case.toml", {"time.end=3"});
    const MeshCase mesh = file.values.mesh, again = read_case_text(file.text, "case.toml").values.mesh;
    EXPECT_EQ(again.kind, mesh.kind);
    EXPECT_EQ(again.sides, mesh.sides);
    EXPECT_EQ(again.polygon, mesh.polygon);
    EXPECT_EQ(again.variant, mesh.variant);
    EXPECT_EQ(again.refine.size(), mesh.refine.size());
    EXPECT_EQ(again.edges.size(), mesh.edges.size());
  }
}

TEST(CheckMesh, TakesARefinementBelowItsOwnHeader)
{
  const MeshCase mesh = mesh_of(
      "polygon = [[0, 0], [1, 0], [0, 1]]\ncell = 0.5\n[[mesh.refine]]\nbox = [[0, 0], [0.5, 0.5]]\ncell = 0.1");
  ASSERT_EQ(mesh.refine.size(), 1u);
  EXPECT_EQ(mesh.refine[0].cell, 0.1);
}

}  // namespace check_mesh_test
