#include "run/findings/setup_warnings.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"
#include "support/paths.hpp"
#include "support/problems.hpp"

namespace setup_warnings_test {

std::vector<Problem> warnings_of(Case c)
{
  c.forces.gravity = {0.0, -9.81};  // without it nothing would move, which is a warning of its own
  Model model = build_model(c, 1);
  return find_warnings(model, build_state(model));
}

TEST(SetupWarnings, PointsOfAFileWithHardlyAnyVolumeAreTold)
{
  const ScratchFolder folder;
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});  // cells of 0.25 m
  c.folder = folder.path();
  c.bodies.emplace_back().points_file = "points.csv";
  std::ofstream(folder.path() + "/points.csv") << "x,y,volume,material\n3.1,1.1,0.008,clay\n3.2,1.1,0.008,clay\n";
  EXPECT_TRUE(warnings_of(c).empty());
  std::ofstream(folder.path() + "/points.csv") << "x,y,volume,material\n3.1,1.1,0.008,clay\n3.2,1.1,0.007,clay\n";
  const auto warnings = warnings_of(c);
  EXPECT_THAT(
      warnings, ElementsAre(told("body[1].points", _, StartsWith("Their volumes fill 24 % of the fullest cell;"))));
}

TEST(SetupWarnings, SharesOfBodiesAddUp)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies.push_back(body("rock", {1.5, 0.5}, {2.0, 1.0}));
  Model model = build_model(c, 1);
  build_state(model);
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(model.bodies[0].n_points, 4 * 25);
  EXPECT_NEAR(model.bodies[0].area, 0.25, 1e-12);
  EXPECT_EQ(model.bodies[1].material, "rock");
  EXPECT_NEAR(model.bodies[1].mass, 0.25 * 2500.0, 1e-9);
}

}  // namespace setup_warnings_test
