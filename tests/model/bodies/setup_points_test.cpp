// What a whole case refuses: setup_test.
#include "model/bodies/setup_points.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"
#include "support/paths.hpp"
#include "support/problems.hpp"

namespace setup_points_test {

/// Clay on the left, rock on the right, 0.5 m x 0.5 m each, 5 x 5 points per cell of 0.25 m.
Case clay_and_rock()
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0});
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies.push_back(body("rock", {1.5, 0.5}, {2.0, 1.0}));
  return c;
}

std::vector<NewPoint> all(const PointBatches& batches)
{
  std::vector<NewPoint> points;
  for (const auto& batch : batches) points.insert(points.end(), batch.begin(), batch.end());
  return points;
}

TEST(SetupPoints, EachLiesInItsCellAtItsLocalPlace)
{
  const Model model = build_model(clay_and_rock(), 1);
  const auto points = all(make_points(model));
  ASSERT_EQ(points.size(), 8u * 25u);
  for (const NewPoint& p : points) {
    const Vec<2> centre = model.mesh->centres[p.key.cell];
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(centre[i] + 0.125 * p.local[i], p.x[i], 1e-12);
    EXPECT_NEAR(p.volume, 0.0625 / 25.0, 1e-15);
    EXPECT_EQ(p.key.material, p.x[0] < 1.5 ? 0 : 1);
    EXPECT_EQ(p.body, p.key.material);
    EXPECT_EQ(p.key.body, 0);
  }
}

TEST(SetupPoints, ShareAreaAndMassAmongTheBodies)
{
  const Model model = build_model(clay_and_rock(), 1);
  const auto shares = shares_of_bodies(model, make_points(model));
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].n_points, 100);
  EXPECT_NEAR(shares[0].area, 0.25, 1e-12);
  EXPECT_NEAR(shares[1].mass, 0.25 * 2500.0, 1e-9);
  EXPECT_EQ(shares[1].material, "rock");
}

TEST(SetupPoints, ThoseOfAFileComeAfterThoseThatAreDrawn)
{
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/more.csv") << "x,y,volume,material\n3.0,1.2,0.01,rock\n0.3,0.4,0.02,clay\n";
  Case c = clay_and_rock();
  c.folder = folder.path();
  BodyCase file;
  file.points_file = "more.csv";
  file.velocity = {0.0, -1.0};
  c.bodies.insert(c.bodies.begin(), file);
  const Model model = build_model(c, 1);
  const auto points = all(make_points(model));
  ASSERT_EQ(points.size(), 202u);
  const NewPoint& last = points.back();
  EXPECT_EQ(last.x, (Vec<2>{0.3, 0.4}));
  EXPECT_EQ(last.body, 0);
  EXPECT_EQ(last.v, (Vec<2>{0.0, -1.0}));
  EXPECT_EQ(points[200].volume, 0.01);
  EXPECT_EQ(shares_of_bodies(model, make_points(model))[0].material, model.materials[0].name + " + rock");
}

TEST(SetupPoints, OutlinesAreThoseOfTheBodiesThatAreDrawn)
{
  const Model model = build_model(clay_and_rock(), 1);
  const auto outlines = outlines_of(model);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_EQ(outlines[1].polygon.front(), (Vec<2>{1.5, 0.5}));
}

TEST(SetupPoints, AMaterialIsFoundByItsName)
{
  const Model model = build_model(clay_and_rock(), 1);
  EXPECT_EQ(material_number(model, "rock"), 1);
  EXPECT_THROW(material_number(model, "peat"), InputError);
}

TEST(SetupPoints, ARegionOfAMeshWithoutNamesSaysHowToNameIt)
{
  Case c = column("mpm_gp");
  c.bodies[0].polygon.clear();
  c.bodies[0].region = "sand";
  Model model = build_model(c, 1);
  EXPECT_THAT(
      problems_of([&] { build_state(model); }), ElementsAre(told(_, "the mesh has no region `sand`",
                                                    "No surface of this mesh has a name. In gmsh: `Physical "
                                                    "Surface(\"sand\") = {1};`, then save. Files .bdf, .nas and "
                                                    ".vtk carry no names of groups: save the mesh as .msh or .unv.")));
}

}  // namespace setup_points_test
