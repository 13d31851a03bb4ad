// What a whole case refuses: setup_test.
#include "model/meshes/setup_mesh.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

namespace setup_mesh_test {

Case case_of(MeshKind kind)
{
  Case c;
  c.mesh.kind = kind;
  c.mesh.origin = {1.0, -1.0};
  c.mesh.size = {4.0, 2.0};
  c.mesh.cell = {0.5, 0.25};
  c.mesh.cells = {8, 4};
  return c;
}

TEST(SetupMesh, ARectangleHasCellsOfTheSizeThatIsAskedFor)
{
  const Mesh<2> mesh = build_mesh(case_of(MeshKind::rectangle));
  EXPECT_EQ(mesh.n_cells(), 8 * 8);
  EXPECT_NEAR(mesh.geometry(0).volume, 0.5 * 0.25, 1e-15);
  EXPECT_EQ(mesh.nodes.front(), (Vec<2>{1.0, -1.0}));
}

TEST(SetupMesh, AGradedRectangleFillsTheSamePlace)
{
  Case c = case_of(MeshKind::graded);
  c.mesh.grading = {3.0, 1.0};
  const Mesh<2> mesh = build_mesh(c);
  EXPECT_EQ(mesh.n_cells(), 8 * 4);
  EXPECT_EQ(extent_in_x(mesh), (Vec<2>{1.0, 5.0}));
  EXPECT_NEAR(mesh.geometry(7).volume / mesh.geometry(0).volume, 3.0, 1e-9);
}

TEST(SetupMesh, AMappedGridFollowsItsSides)
{
  Case c = case_of(MeshKind::mapped);
  c.mesh.sides = {{{{0.0, 0.0}, {4.0, 0.0}}, {{4.0, 0.0}, {5.0, 2.0}}, {{1.0, 2.0}, {5.0, 2.0}},
      {{0.0, 0.0}, {1.0, 2.0}}}};  // a parallelogram
  const Mesh<2> mesh = build_mesh(c);
  EXPECT_EQ(mesh.n_cells(), 8 * 4);
  EXPECT_NEAR(typical_cell_size(mesh), 0.5, 1e-12);  // 4 m x 2 m in 32 cells, sheared
  EXPECT_EQ(extent_in_x(mesh), (Vec<2>{0.0, 5.0}));
}

TEST(SetupMesh, AFileThatIsNotThereIsAFaultOfItsKey)
{
  Case c = case_of(MeshKind::file);
  c.mesh.file = "/no/such.msh";
  EXPECT_THAT(problems_of([&] { build_mesh(c); }), ElementsAre(told("mesh.file", _, HasSubstr("/no/such.msh"))));
}

TEST(SetupMesh, TheTypicalSizeIsTheSideOfASquareOfTheMeanArea)
{
  EXPECT_NEAR(typical_cell_size(build_mesh(case_of(MeshKind::rectangle))), std::sqrt(0.125), 1e-15);
}

}  // namespace setup_mesh_test
