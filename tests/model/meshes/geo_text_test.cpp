#include "model/meshes/geo_text.hpp"
#include "model/meshes/mesh_error.hpp"
#include "support/test.hpp"

namespace geo_text_test {

constexpr Recipe recipe{9, 0, 0, 1.25};

PolygonMesh rectangle()
{
  PolygonMesh mesh;
  mesh.polygon = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
  mesh.cell = 0.5;
  mesh.edges = {{"base", {0}}, {"walls", {1, 3}}};
  return mesh;
}

std::string text_of(const PolygonMesh& mesh, const Recipe& how = recipe)
{
  return geo_text(mesh, cut_polygon(mesh.polygon, mesh.follow, 0.01), how);
}

TEST(GeoText, HasTheGeometryAndItsNames)
{
  const std::string text = text_of(rectangle());
  EXPECT_THAT(text, HasSubstr("Point(3) = {4, 3, 0};\n"));
  EXPECT_THAT(text, HasSubstr("Line(4) = {4, 1};\n"));
  EXPECT_THAT(text, HasSubstr("Curve Loop(1) = {1, 2, 3, 4};\nPlane Surface(1) = {1};\n"));
  EXPECT_THAT(text, HasSubstr("Physical Surface(\"domain\") = {1};\n"));
  EXPECT_THAT(text, HasSubstr("Physical Curve(\"base\") = {1};\nPhysical Curve(\"walls\") = {2, 4};\n"));
  EXPECT_THAT(text, Not(HasSubstr("Field")));
}

TEST(GeoText, AsksForTrianglesOfTwiceTheSize)
{
  EXPECT_THAT(text_of(rectangle()),
      HasSubstr(
          "Mesh.Algorithm = 9;\nMesh.RecombinationAlgorithm = 0;\nMesh.RandomSeed = 1;\nMesh.MeshSizeMax = 1.25;\n"));
}

TEST(GeoText, NamesAllPartsOfAnEdgeThatOutlinesCut)
{
  auto mesh = rectangle();
  mesh.follow = {{{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}};
  EXPECT_THAT(text_of(mesh), HasSubstr("Physical Curve(\"base\") = {1, 2, 3};\n"));
}

TEST(GeoText, WritesFieldsForRefinements)
{
  auto mesh = rectangle();
  mesh.refine = {{{{1.0, 0.0}, {1.0, 0.2}}, {}, {}, 0.2, 0.6}, {{}, {2.0, 0.0}, {3.0, 1.0}, 0.1, 0.5}};
  const std::string text = text_of(mesh);
  EXPECT_THAT(
      text, HasSubstr("Point(7) = {1, 0.20000000000000001, 0};\nField[1] = Distance;\nField[1].PointsList = {5:7};\n"));
  EXPECT_THAT(text, HasSubstr("Field[2].SizeMin = 0.5;\nField[2].SizeMax = 1.25;\n"));
  EXPECT_THAT(
      text, HasSubstr("Field[3] = Box;\nField[3].VIn = 0.25;\nField[3].VOut = 1.25;\nField[3].Thickness = 0.5;\n"));
  EXPECT_THAT(text, HasSubstr("Field[4].FieldsList = {2, 3};\nBackground Field = 4;\n"));
}

TEST(GeoText, WaversDifferentlyInEachVariant)
{
  const std::string one = text_of(rectangle(), {6, 1, 1, 1.0}), two = text_of(rectangle(), {6, 1, 2, 1.0});
  EXPECT_THAT(one, HasSubstr("Field[1] = MathEval;"));
  EXPECT_NE(one, two);
}

TEST(GeoText, NumbersTurnedSquaresBeyondLinesAndFaces)
{
  auto mesh = rectangle();
  mesh.turn = 45.0;
  mesh.cell = 0.2;
  const std::string text = text_of(mesh);
  EXPECT_THAT(text, HasSubstr("Point(5) = {"));
  EXPECT_THAT(text, HasSubstr("Curve Loop(1) = {5, 6, 7, 8};\nPlane Surface(2) = {1};\n"));
  EXPECT_THAT(text, ContainsRegex("Transfinite Curve \\{5:[0-9]+\\} = 2;\nTransfinite Surface \\{2:[0-9]+\\};\n"));
  EXPECT_THAT(text, ContainsRegex("Plane Surface\\(1\\) = \\{[0-9]+, [0-9]+\\};\n"));  // the strip and its hole
  EXPECT_THAT(text, ContainsRegex("Physical Surface\\(\"domain\"\\) = \\{1, 2, "));
}

TEST(GeoText, RefusesATurnedMeshInWhichNoSquareFits)
{
  auto mesh = rectangle();
  mesh.turn = 10.0;
  mesh.cell = 1.5;
  EXPECT_THAT([&] { text_of(mesh); }, ThrowsMessage<MeshError>(HasSubstr("no square of 3 m, two by two cells, fits "
                                                                         "into the mesh at 10 degrees\n  Use smaller "
                                                                         "cells.")));
}

TEST(GeoText, RefusesNamesThatItCannotWrite)
{
  auto mesh = rectangle();
  mesh.edges[0].side = "the \"base\"";
  EXPECT_THROW(text_of(mesh), MeshError);
}

TEST(TargetSize, GrowsFromTheRefinementToTheCellSize)
{
  auto mesh = rectangle();
  mesh.refine = {{{{1.0, 0.0}, {1.0, 1.0}}, {}, {}, 0.1, 0.4}, {{}, {3.0, 0.0}, {4.0, 1.0}, 0.2, 0.0}};
  EXPECT_DOUBLE_EQ(target_size(mesh, {1.0, 0.5}), 0.1);
  EXPECT_NEAR(target_size(mesh, {1.1, 0.5}), 0.1, 1e-15);  // one fine cell beside the line
  EXPECT_NEAR(target_size(mesh, {1.0, 1.3}), 0.3, 1e-15);  // halfway
  EXPECT_DOUBLE_EQ(target_size(mesh, {1.6, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(target_size(mesh, {3.5, 0.5}), 0.2);
  EXPECT_DOUBLE_EQ(target_size(mesh, {3.5, 1.01}), 0.5);
}

}  // namespace geo_text_test
