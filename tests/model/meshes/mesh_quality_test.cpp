#include "model/meshes/mesh_quality.hpp"
#include "support/test.hpp"

namespace mesh_quality_test {

Mesh<2> columns(const std::vector<Real>& widths)
{
  Mesh<2> mesh;
  Real x = 0.0;
  mesh.nodes = {{0.0, 0.0}, {0.0, 1.0}};
  for (std::size_t k = 0; k < widths.size(); ++k) {
    x += widths[k];
    mesh.nodes.insert(mesh.nodes.end(), {{x, 0.0}, {x, 1.0}});
    const auto a = static_cast<Index>(2 * k);
    mesh.cells.push_back({a, a + 2, a + 3, a + 1});
  }
  connect(mesh);
  return mesh;
}

TEST(MeshQuality, IsPerfectForSquares)
{
  const MeshQuality quality = measure_quality(make_rectangle({0.0, 0.0}, {3.0, 2.0}, {6, 4}));
  EXPECT_EQ(quality.n_cells, 24);
  EXPECT_EQ(quality.n_nodes, 35);
  EXPECT_EQ(quality.n_parts, 1);
  EXPECT_DOUBLE_EQ(quality.smallest_altitude.value, 0.5);
  EXPECT_DOUBLE_EQ(quality.smallest_jacobian.value, 1.0);
  EXPECT_DOUBLE_EQ(quality.largest_aspect.value, 1.0);
  EXPECT_DOUBLE_EQ(quality.median_altitude, 0.5);
  EXPECT_DOUBLE_EQ(quality.cost, 1.0);
}

TEST(MeshQuality, FindsTheCellThatCosts)
{
  const MeshQuality quality = measure_quality(columns({1.0, 0.5, 0.02, 1.0, 0.8}));
  EXPECT_EQ(quality.smallest_altitude.cell, 2);
  EXPECT_NEAR(quality.smallest_altitude.value, 0.02, 1e-15);
  EXPECT_NEAR(quality.median_altitude, 0.8, 1e-15);
  EXPECT_NEAR(quality.cost, 40.0, 1e-11);
  EXPECT_EQ(quality.largest_aspect.cell, 2);
  EXPECT_NEAR(quality.largest_aspect.value, 50.0, 1e-11);
}

TEST(MeshQuality, TakesTheSineOfTheSharpestCorner)
{
  Mesh<2> mesh;
  const Real angle = std::numbers::pi / 6.0;
  mesh.nodes = {{0.0, 0.0}, {2.0, 0.0}, {2.0 + std::cos(angle), std::sin(angle)}, {std::cos(angle), std::sin(angle)}};
  mesh.cells = {{0, 1, 2, 3}};
  connect(mesh);
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_NEAR(quality.smallest_jacobian.value, 0.5, 1e-15);
  EXPECT_NEAR(quality.smallest_altitude.value, 0.5, 1e-15);
  EXPECT_NEAR(quality.largest_aspect.value, 4.0, 1e-14);
}

TEST(MeshQuality, CountsParts)
{
  Mesh<2> mesh;
  mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  mesh.cells = {{0, 1, 2, 3}, {2, 4, 5, 6}};
  connect(mesh);
  EXPECT_EQ(measure_quality(mesh).n_parts, 2);
}

TEST(DescribeQuality, WarnsOfOneCellThatCostsMoreThanAFactorThree)
{
  EXPECT_EQ(describe(measure_quality(columns({1.0, 0.5, 0.02, 1.0, 0.8}))),
      "  mesh           5 cells, 12 nodes\n"
      "  smallest cell  0.02 m high, cell 2 at x=1.51 y=0.5; median 0.8 m\n"
      "  sharpest cell  scaled Jacobian 1.000, cell 0 at x=0.5 y=0.5\n"
      "  slimmest cell  aspect ratio 50, cell 2 at x=1.51 y=0.5\n"
      "  mesh cost      40x the time steps of the median cell\n"
      "  warning: dt is set by cell 2 at x=1.51 y=0.5: 40x smaller than the median\n");
  EXPECT_THAT(describe(measure_quality(columns({1.0, 1.0, 0.32}))), HasSubstr("warning: dt is set by cell 2"));
  EXPECT_THAT(describe(measure_quality(columns({1.0, 1.0, 0.35}))), Not(HasSubstr("warning")));
}

TEST(DescribeQuality, NamesTheFilesElement)
{
  Mesh<2> mesh = columns({1.0, 1.0, 0.1});
  mesh.cell_numbers = {7, 8, 1033};
  EXPECT_THAT(describe(measure_quality(mesh)),
      HasSubstr("dt is set by cell 2 (element 1033 of the file) at x=2.05 y=0.5: 10x smaller"));
}

TEST(DescribeQuality, WarnsOfParts)
{
  MeshQuality quality;
  quality.n_parts = 3;
  EXPECT_THAT(describe(quality),
      HasSubstr("warning: the mesh has 3 parts that share no side; soil cannot pass from one to the other"));
}

}  // namespace mesh_quality_test
