#include "model/meshes/geo_text.hpp"
#include "model/meshes/mesh_error.hpp"
#include "support/golden.hpp"

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

std::string geo_of(const PolygonMesh& mesh, const Recipe& how = recipe)
{
  return geo_text(mesh, cut_polygon(mesh.polygon, mesh.follow, 0.01), how);
}

TEST(GeoText, IsTheGoldenText)
{
  auto cut = rectangle(), refined = rectangle(), turned = rectangle();
  cut.follow = {{{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}};
  refined.refine = {{{{1.0, 0.0}, {1.0, 0.2}}, {}, {}, 0.2, 0.6}, {{}, {2.0, 0.0}, {3.0, 1.0}, 0.1, 0.5}};
  turned.turn = 45.0, turned.cell = 0.3;
  expect_golden("tests/model/meshes/geo.txt",
      "== a rectangle\n" + geo_of(rectangle()) + "== an outline cuts its base\n" + geo_of(cut) + "== refined\n" +
          geo_of(refined) + "== squares turned by 45 degrees\n" + geo_of(turned) + "== two variants\n" +
          geo_of(rectangle(), {6, 1, 1, 1.0}) + geo_of(rectangle(), {6, 1, 2, 1.0}));
}

TEST(GeoText, RefusesNamesThatItCannotWrite)
{
  auto mesh = rectangle();
  mesh.edges[0].side = "the \"base\"";
  EXPECT_THROW(geo_of(mesh), MeshError);
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
