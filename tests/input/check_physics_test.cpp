// Input that can be computed and is hardly meant; and that sound input is not warned of.
#include "input/check_physics.hpp"

#include "input/samples.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using namespace test;

std::string seen_with(const std::vector<std::string>& changes) { return message_for(small_case, changes); }

TEST(CheckPhysics, WarnsOfGravityThatDoesNotPointDown)
{
  EXPECT_THAT(seen_with({"forces.gravity=[0, 9.81]"}),
      HasSubstr("warning: --set forces.gravity=[0, 9.81]: gravity points upward\n  Got [0, 9.81] m/s^2. The y axis "
                "points up: usual is [0.0, -9.81].\n"));
  EXPECT_THAT(seen_with({"forces.gravity=[-9.81, 0]"}), HasSubstr("gravity acts more to the side than down\n"));
  EXPECT_EQ(seen_with({"forces.gravity=[3.36, -9.22]"}), "accepted\n");  // a slope of 20 degrees
}

TEST(CheckPhysics, WarnsOfGravityInAnotherUnit)
{
  EXPECT_THAT(seen_with({"forces.gravity=[0, -981]"}),
      HasSubstr(
          "gravity of 981 m/s^2 is unusual\n  Usual: [0.0, -9.81] m/s^2. A centrifuge at 50 g has [0.0, -490.5].\n"));
  EXPECT_THAT(seen_with({"forces.gravity=[0, -0.00981]"}), HasSubstr("gravity of 0.00981 m/s^2 is unusual\n"));
  for (const char* sound : {"forces.gravity=[0, -9.81]", "forces.gravity=[0, -1.62]", "forces.gravity=[0, 0]"})
    EXPECT_EQ(seen_with({sound}), "accepted\n");
}

TEST(CheckPhysics, WarnsOfDampingThatSlowsEverything)
{
  EXPECT_THAT(seen_with({"forces.damping.local=0.9"}),
      AllOf(HasSubstr("local damping of 0.9 slows all motion\n  Soil falls with 0.1 of gravity, and a failure is as "
                      "much too slow."),
          HasSubstr("initial.stress = \"equilibrium\"")));
  EXPECT_EQ(seen_with({"forces.damping.local=0.5"}), "accepted\n");
}

TEST(CheckPhysics, WarnsOfAResidualStrengthThatIsNeverReached)
{
  EXPECT_THAT(seen_with({"material.clay.eta=0"}),
      HasSubstr("warning: --set material.clay.eta=0: `su_residual` has no effect: eta is 0\n  The strength stays at "
                "su_peak = 8000 Pa. Give eta, more than 0, or su_residual = 8000.\n"));
  EXPECT_EQ(seen_with({"material.clay.eta=0", "material.clay.su_residual=8.0e3"}), "accepted\n");
}

const std::string sand = R"(model = "mohr_coulomb"
density = 1990.0
shear_modulus = 2.0e6
poisson_ratio = 0.3
cohesion = 1.0e3
friction_angle = 30.0
)";

std::string sand_with(const std::vector<std::string>& changes)
{
  const std::string head = small_case.substr(0, small_case.find("model"));
  return message_for(head + sand, changes);
}

TEST(CheckPhysics, WarnsOfSofteningFrictionWithoutARate)
{
  EXPECT_THAT(sand_with({"material.clay.friction_angle_residual=25"}),
      HasSubstr("`friction_angle_residual` has no effect: eta is 0\n  The strength stays at friction_angle = 30 deg."));
  EXPECT_EQ(sand_with({"material.clay.friction_angle_residual=25", "material.clay.eta=20"}), "accepted\n");
}

TEST(CheckPhysics, WarnsOfAnglesInRadiansOrAsTangents)
{
  EXPECT_THAT(sand_with({"material.clay.friction_angle=0.5236"}),
      HasSubstr("`friction_angle` = 0.5236 deg is unusual\n  Usual: 2 to 60 deg. Angles are in degrees: 0.5236 rad are "
                "30.0 deg, and 0.5236 is the tangent of 27.6 deg.\n"));
  EXPECT_THAT(
      sand_with({"material.clay.dilatancy_angle=0.0873"}), HasSubstr("`dilatancy_angle` = 0.0873 deg is unusual"));
  for (const char* sound : {"material.clay.dilatancy_angle=1", "material.clay.friction_angle=0"})
    EXPECT_EQ(sand_with({sound}), "accepted\n") << sound;
}

}  // namespace
}  // namespace terp
