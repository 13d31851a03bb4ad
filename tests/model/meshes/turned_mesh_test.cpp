#include "model/meshes/turned_mesh.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/meshes/gmsh_file.hpp"
#include "support/environment.hpp"
#include "support/meshes.hpp"
#include "support/paths.hpp"
#include "os/process.hpp"

namespace turned_mesh_test {

Case rectangle()
{
  Case c;
  c.mesh.kind = MeshKind::rectangle;
  c.mesh.origin = {1.0, -1.0};
  c.mesh.size = {4.0, 2.0};
  c.mesh.cell = {0.25, 0.25};
  return c;
}

class TurnedMesh : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!run_process({"gmsh", "--version"}, 60.0).found) GTEST_SKIP() << "gmsh is not installed";
  }

  ScratchFolder scratch_;
  Variable cache_{"XDG_CACHE_HOME", scratch_.path()};
};

/// Cells whose sides lie along x and y.
int n_along(const Mesh<2>& mesh)
{
  int n = 0;
  for (Index e = 0; e < mesh.n_cells(); ++e)
    if (std::abs(mesh.geometry(e).map.axis_xi[0] * mesh.geometry(e).map.axis_xi[1]) < 1e-9) ++n;
  return n;
}

TEST_F(TurnedMesh, OfARectangleKeepsItsPlaceAndItsFourSides)
{
  const Mesh<2> mesh = read_gmsh(turned_mesh_file(rectangle(), 30.0));
  EXPECT_NEAR(total_area(mesh), 8.0, 1e-9);
  const auto lengths = lengths_of_sides(mesh);
  EXPECT_EQ(lengths.size(), 4u);
  EXPECT_NEAR(lengths.at("bottom"), 4.0, 1e-9);
  EXPECT_NEAR(lengths.at("left"), 2.0, 1e-9);
  EXPECT_LT(n_along(mesh), mesh.n_cells() / 10);
}

TEST_F(TurnedMesh, OfAPolygonKeepsTheNamesOfItsEdges)
{
  Case c;
  c.mesh.kind = MeshKind::polygon;
  c.mesh.polygon = {{0, 0}, {6, 0}, {6, 1}, {2, 3}, {0, 3}};
  c.mesh.edges = {{"base", {0}}, {"slope", {2}}};
  c.mesh.cell = {0.25, 0.25};
  c.mesh.follow_bodies = false;
  EXPECT_NEAR(lengths_of_sides(read_gmsh(turned_mesh_file(c, 30.0))).at("slope"), std::hypot(4.0, 2.0), 1e-9);
}

TEST_F(TurnedMesh, MustBeKept)
{
  std::ofstream(scratch_.path() + "/file") << "not a folder";
  const Variable cache("XDG_CACHE_HOME", scratch_.path() + "/file");
  EXPECT_THAT([&] { turned_mesh_file(rectangle(), 30.0); }, ThrowsMessage<MeshError>(HasSubstr("cannot be kept")));
}

}  // namespace turned_mesh_test
