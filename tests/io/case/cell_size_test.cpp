#include "io/case/cell_size.hpp"
#include "io/case/samples.hpp"

namespace cell_size_test {

/// A case with a mesh of this kind. What else it says does not count.
template <class Change>
CaseFile with_mesh(MeshKind kind, Change&& change)
{
  CaseFile file;
  file.path = "case.toml";
  file.values.mesh.kind = kind;
  change(file.values.mesh);
  return file;
}

CaseFile rectangle(Vec<2> cell)
{
  return with_mesh(MeshKind::rectangle, [&](MeshCase& m) { m.size = {16.0, 3.0}, m.cell = cell; });
}

std::string refusal_of(const CaseFile& file, Real cell)
{
  return refusal<CaseError>([&] { changes_to_cell_size(file, cell); });
}

TEST(CellSize, OfARectangleIsItsCell)
{
  EXPECT_THAT(changes_to_cell_size(rectangle({0.1, 0.1}), 0.25), ElementsAre("mesh.cell=0.25"));
  EXPECT_THAT(changes_to_cell_size(rectangle({0.2, 0.1}), 1.0), ElementsAre("mesh.cell=[1, 0.5]"));
}

TEST(CellSize, ThatDoesNotDivideARectangleIsRefusedWithTheNearestThatDo)
{
  const CaseFile square = rectangle({0.1, 0.1});
  EXPECT_EQ(refusal_of(square, 0.3),
      "error: case.toml: cells of 0.3 m: the mesh is not a whole number of such cells\n"
      "  It is 16 m by 3 m. The nearest sizes that fit: 0.333333333, 0.25 m\n");
  EXPECT_EQ(refusal_of(square, 5.0),
      "error: case.toml: cells of 5 m: they are larger than the mesh\n"
      "  It is 3 m high or wide. Give sizes of a tenth of the soil's height and less.\n");
}

TEST(CellSize, OfAGradedGridIsTheRootOfTheMeanArea)
{
  const CaseFile graded = with_mesh(MeshKind::graded, [](MeshCase& m) {
    m.size = {16.0, 4.0}, m.cells = {32, 8}, m.grading = {2.0, 1.0};
  });
  EXPECT_THAT(changes_to_cell_size(graded, 0.25), ElementsAre("mesh.cells=[64, 16]"));
  EXPECT_THAT(changes_to_cell_size(graded, 0.248), ElementsAre("mesh.cells=[65, 16]"));
  EXPECT_EQ(refusal_of(graded, 0.7),
      "error: case.toml: cells of 0.7 m: the grid is not a whole number of such cells\n"
      "  It has 32 by 8 cells of 0.5 m (root of their mean area); 0.7 m would make 22.86 by 5.714.\n"
      "  Sizes that fit: 2, 1, 0.5, 0.25, 0.125 m\n");
}

TEST(CellSize, OfAMappedGridTakesItsAreaFromItsSides)
{
  const CaseFile mapped = with_mesh(MeshKind::mapped, [](MeshCase& m) {
    m.cells = {10, 5};
    m.sides[0] = {{0.0, 0.0}, {10.0, 0.0}}, m.sides[1] = {{10.0, 0.0}, {10.0, 4.0}};
    m.sides[2] = {{0.0, 6.0}, {10.0, 4.0}}, m.sides[3] = {{0.0, 0.0}, {0.0, 6.0}};
  });
  EXPECT_THAT(changes_to_cell_size(mapped, 0.5), ElementsAre("mesh.cells=[20, 10]"));  // 50 m^2, 50 cells
}

TEST(CellSize, OfAPolygonScalesItsRefinements)
{
  const CaseFile polygon = with_mesh(MeshKind::polygon, [](MeshCase& m) {
    m.cell = {0.5, 0.5}, m.polygon = {{0.0, 0.0}, {9.0, 0.0}, {9.0, 3.0}};
    m.refine.resize(2);
    m.refine[0].cell = 0.25, m.refine[1].cell = 0.125;
  });
  EXPECT_THAT(changes_to_cell_size(polygon, 0.25),
      ElementsAre("mesh.cell=0.25", "mesh.refine[0].cell=0.125", "mesh.refine[1].cell=0.0625"));
  EXPECT_THAT(refusal_of(polygon, 4.0), HasSubstr("they are larger than the mesh"));
}

TEST(CellSize, OfAMeshFileCannotBeChosen)
{
  EXPECT_EQ(refusal_of(with_mesh(MeshKind::file, [](MeshCase& m) { m.file = "dike.msh"; }), 0.5),
      "error: case.toml: cells of 0.5 m: the mesh is a file of its own, dike.msh, and has the cells that it has\n"
      "  Let the case describe the mesh (terp explain mesh), as by a polygon; or mesh each size yourself, solve each\n"
      "  with terp run, and set them side by side with terp compare.\n");
}

}  // namespace cell_size_test
