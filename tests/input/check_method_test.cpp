#include "input/check_method.hpp"

#include "input/samples.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::HasSubstr;
using namespace test;

std::string seen_with(const std::string& scheme, const std::string& options)
{
  return message_for("scheme = \"" + scheme + "\"\n[method]\n" + options + '\n' + small_case,
      {"material.clay.poisson_ratio=0.3"});  // locks with no scheme
}

TEST(CheckMethod, WarnsOfSoilThatLocksInASchemeWithoutBBar)
{
  EXPECT_THAT(message_for(small_case, {"scheme=standard_mpm"}),
      HasSubstr("warning: --set scheme=standard_mpm: `clay` locks: Poisson's ratio 0.48 with the scheme standard_mpm\n"
                "  It answers far too stiffly, with pressures that jump from cell to cell. Schemes with B-bar: "
                "mpm_mixed, mpm_gp.\n  More: terp explain scheme\n"));
  EXPECT_THAT(message_for(small_case, {"method.b_bar=false", "method.force_operator=b"}),
      HasSubstr("`clay` locks: Poisson's ratio 0.48 without B-bar\n  It answers far too stiffly, with pressures that "
                "jump from cell to cell. Leave method.b_bar at true.\n"));
  EXPECT_EQ(message_for(small_case), "accepted\n");
  EXPECT_EQ(message_for(small_case, {"scheme=standard_mpm", "material.clay.poisson_ratio=0.3"}), "accepted\n");
}

TEST(CheckMethod, WarnsOfAnOptionThatTheSchemeDoesNotLookAt)
{
  EXPECT_EQ(seen_with("standard_mpm", "b_bar = true"),
      "accepted\nwarning: case.toml:3:1: `b_bar` has no effect\n\n    3 | b_bar = true\n      | ^^^^^\n"
      "  The scheme standard_mpm does not look at it.\n  More: terp explain method.b_bar\n\n");
  EXPECT_THAT(
      seen_with("mpm_mixed", "point_pressure = \"own\""), HasSubstr("The scheme mpm_mixed does not look at it."));
  EXPECT_THAT(seen_with("mpm_gp", "state_averaging = \"cell\""), HasSubstr("`state_averaging` has no effect"));
  EXPECT_EQ(seen_with("mpm_mixed", "state_averaging = \"cell\""), "accepted\n");
  EXPECT_EQ(seen_with("standard_mpm", "flip = 0.9"), "accepted\n");
}

TEST(CheckMethod, PointsAtTheChangeThatMadeAnOptionUseless)
{
  EXPECT_THAT(message_for(small_case + "[method]\nb_bar = true\n", {"scheme=standard_mpm"}),
      HasSubstr("warning: --set scheme=standard_mpm: `b_bar` has no effect\n"));
}

TEST(CheckMethod, WarnsOfAForceThatDoesNotFitTheStrain)
{
  EXPECT_EQ(seen_with("mpm_gp", "b_bar = false"),
      "accepted\nwarning: case.toml:3:9: `force_operator` and `b_bar` do not fit together\n\n    3 | b_bar = false\n"
      "      |         ^^^^^\n  The force takes B-bar, the strain B: energy is made or lost. Use b_bar = true with "
      "force_operator = \"b_bar\",\n  or false with \"b\" (docs/methods.md, section 7).\n  More: terp explain "
      "method\n\n");
  EXPECT_THAT(seen_with("mpm_mixed", "force_operator = \"b\""), HasSubstr("The force takes B, the strain B-bar"));
  EXPECT_EQ(seen_with("mpm_gp", "b_bar = false\nforce_operator = \"b\""), "accepted\n");
  EXPECT_EQ(seen_with("mpm_gp", "b_bar = true\nforce_operator = \"b_bar\""), "accepted\n");
}

TEST(CheckMethod, WarnsOfARelaxationThatIsNotAskedFor)
{
  EXPECT_THAT(
      seen_with("mpm_gp", "pressure_relaxation = 0.2"), HasSubstr("It counts with point_pressure = \"relax\" only."));
  EXPECT_EQ(seen_with("mpm_gp", "pressure_relaxation = 0.2\npoint_pressure = \"relax\""), "accepted\n");
}

}  // namespace
}  // namespace terp
