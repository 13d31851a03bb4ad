// Keys that are each right and together wrong.

#include "input/check_case.hpp"

#include "input/samples.hpp"
#include "support/paths.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace terp {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace test;

class Contradiction : public testing::TestWithParam<Change> {};

TEST_P(Contradiction, IsRefused)
{
  const auto& [line, instead, message] = GetParam();
  const std::string seen = message_for(replaced(small_case, line, instead));
  EXPECT_THAT(seen, HasSubstr(message));
  EXPECT_THAT(seen, HasSubstr("1 error; nothing was run.\n"));
}

const Change contradictions[] = {
    {"material = \"clay\"", "material = \"clay\"\npolygon = [[0, 0], [1, 0], [0, 1]]",
        "error: case.toml:8:1: a body has either `box` or `polygon`, not both\n"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]\n", "",
        "error: case.toml:6:1: the body has no shape\n\n    6 | [[body]]\n      | ^^^^^^^^\n  Give box = [[x0, y0], "
        "[x1, "
        "y1]] or polygon = [[x, y], [x, y], [x, y], ...] in m,\n  or region = \"NAME\" of a mesh file, or points = "
        "\"FILE.csv\".\n"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]\n", "region = \"core\"\n",
        "error: case.toml:8:1: a region needs a mesh from a file\n\n    8 | region = \"core\"\n      | ^^^^^^\n  "
        "Regions "
        "are "
        "physical groups of [mesh] file = \"NAME.msh\". Give box or polygon here.\n  More: terp explain body.region\n"},
    {"material = \"clay\"", "material = \"caly\"",
        "error: case.toml:7:12: there is no material `caly`\n\n    7 | material = \"caly\"\n      |            "
        "^^^^^^\n  "
        "Did you mean `clay`?\n  Materials of this case: clay\n"},
    {"eta = 50.0", "eta = 800.0",
        "error: case.toml:16:7: softening is too steep\n\n   16 | eta = 800.0\n      |       ^^^^^\n  eta (su_peak - "
        "su_residual) = 4.8e+06 Pa, at most 1.5 G = 3e+06 Pa\n"},
    {"su_residual = 2.0e3", "su_residual = 9.0e3",
        "error: case.toml:15:15: the residual strength exceeds the peak strength\n"},
    {"cell = 0.5", "cell = [0.7, 0.5]",
        "error: case.toml:5:8: the width of the mesh is not a whole number of cells\n\n    5 | cell = [0.7, 0.5]\n     "
        " | "
        "       ^^^^^^^^^^\n  16 m / 0.7 m = 22.8571; the nearest width that fits is 0.695652 m.\n"},
    {"cell = 0.5", "cell = [0.5, 4.0]", "the height of the mesh is not a whole number of cells"},
    {"model = \"tresca_softening\"\ndensity = 1990.0\nshear_modulus = 2.0e6\npoisson_ratio = 0.48\nsu_peak = "
     "8.0e3\nsu_residual = 2.0e3\neta = 50.0\n",
        "model = \"newtonian_fluid\"\ndensity = 1000.0\nbulk_modulus = 1e6\n[forces]\ngravity = [0, "
        "-9.81]\n[initial]\nstress = \"k0\"\nk0 = 0.5\n",
        "the fluid `clay` carries no shear stress at rest\n\n   17 | k0 = 0.5\n      |      ^^^\n  k0 = 0.5; a fluid "
        "needs k0 = 1. Start with stress = "
        "\"equilibrium\" where soil beside it needs another.\n"},
    {"[time]", "[boundary]\nbottom = { slip = true }\n[time]",
        "`slip` needs `velocity` beside it\n\n    2 | bottom = { slip = true }\n      |            ^^^^\n  As in "
        "bottom = { velocity "
        "= ..., slip = ... }. Conditions that stand alone: \"free\", \"open\", \"roller\", \"fixed\".\n"},
    {"[time]", "[boundary]\nbottom = { adhesion = 8e3 }\n[time]",
        "error: case.toml:2:12: `adhesion` needs `contact` beside it\n\n    2 | bottom = { adhesion = 8e3 }\n      |   "
        "   "
        "      ^^^^^^^^\n  As in bottom = { contact = \"bilateral\", adhesion = ... }. Conditions that stand alone: "
        "\"free\", \"open\", \"roller\", \"fixed\".\n"},
    {"[time]", "[boundary]\nbottom = { contact = \"bilateral\", velocity = [1, 0] }\n[time]",
        "a side has either `contact` or `velocity`, not both"},
    {"[time]", "[boundary]\nbottom = {}\n[time]", "`bottom` is empty"},
    {"[time]", "[initial]\nstress = \"equilibrium\"\n[time]",
        "error: case.toml:2:10: an initial stress needs gravity\n"},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, Contradiction, testing::ValuesIn(contradictions));

class Doubt : public testing::TestWithParam<Change> {};

TEST_P(Doubt, IsAWarning)
{
  const auto& [line, instead, message] = GetParam();
  const std::string seen = message_for(replaced(small_case, line, instead));
  EXPECT_THAT(seen, StartsWith("accepted\nwarning: "));
  EXPECT_THAT(seen, HasSubstr(message));
}

const Change doubts[] = {
    {"[time]", "[initial]\nk0 = 0.5\n[time]",
        "case.toml:2:1: `k0` has no effect\n\n    2 | k0 = 0.5\n      | ^^\n  It counts with stress = \"k0\" only.\n"},
    {"material = \"clay\"", "material = \"clay\"\nholes = [[[0, 2.5], [1, 2.5], [1, 3]]]",
        "case.toml:8:10: the hole lies outside the body\n\n    8 | holes = [[[0, 2.5], [1, 2.5], [1, 3]]]\n      |     "
        "   "
        "  "
        "^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n  It covers y = 2.5 to 3 m, the body y = 0 to 2 m.\n"},
    {"[material.clay]",
        "velocity = [1.0, 0.0]\n[initial]\nstress = \"equilibrium\"\n[forces]\ngravity = [0.0, -9.81]\n[material.clay]",
        "case.toml:9:1: `velocity` has no effect\n\n    9 | velocity = [1.0, 0.0]\n      | ^^^^^^^^\n  With "
        "initial.stress = "
        "\"equilibrium\" all soil is at rest at t = 0;"},
    {"[time]", "[boundary]\nbottom = { contact = \"bilateral\", friction = 0.3 }\n[time]",
        "case.toml:2:35: a bilateral contact meets only pushes with friction and forgets pulls\n\n    2 | bottom = { "
        "contact = "
        "\"bilateral\", friction = 0.3 }\n      |                                   ^^^^^^^^\n  Friction wants contact "
        "= "
        "\"separating\" (docs/decisions/0015-contact-at-the-base.md).\n"},
    {"[time]", "[initial]\nlimit = 0.5\n[time]", "It counts with stress = \"equilibrium\" only."},
    {"[time]",
        "[material.rock]\nmodel = \"linear_elastic\"\ndensity = 2000\nshear_modulus = 1e7\npoisson_ratio = 0.3\n[time]",
        "no body uses the material `rock`"},
    {"model = \"tresca_softening\"\ndensity = 1990.0\nshear_modulus = 2.0e6\npoisson_ratio = 0.48\nsu_peak = "
     "8.0e3\nsu_residual = 2.0e3\neta = 50.0\n",
        "model = \"linear_elastic\"\ndensity = 1990.0\nshear_modulus = 2.0e6\npoisson_ratio = "
        "0.48\n[output.fields]\nnames = [\"stress\", \"su\"]\n",
        "case.toml:15:20: no material of this case has `su`"},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, Doubt, testing::ValuesIn(doubts));

TEST(CheckCase, TakesCellsThatFitUpToRoundOff)
{
  EXPECT_THAT(message_for(replaced(small_case, "cell = 0.5", "cell = 0.1")), StartsWith("accepted"));
}

/// small_case with its body's two lines replaced, on a mesh and with points from files that exist.
class BodyFromAFile : public testing::Test {
 protected:
  BodyFromAFile() { std::ofstream(folder_.path() + "/a.msh"), std::ofstream(folder_.path() + "/a.csv"); }
  std::string seen_with(const std::string& mesh, const std::string& body) const
  {
    const std::string text = replaced(small_case_on(mesh), "material = \"clay\"\nbox = [[0.0, 0.0], [8.0, 2.0]]", body);
    try {
      return "accepted\n" + render_warnings(read_case_text(text, folder_.path() + "/case.toml"));
    } catch (const CaseError& error) {
      return error.what();
    }
  }
  const ScratchFolder folder_;
};

const char* const rectangle = "size = [16.0, 3.0]\ncell = 0.5";
const char* const from_file = "file = \"a.msh\"";

TEST_F(BodyFromAFile, MayBeARegionOfAMeshFile)
{
  EXPECT_EQ(seen_with(from_file, "material = \"clay\"\nregion = \"core\""), "accepted\n");
}

TEST_F(BodyFromAFile, MayBeAFileOfPointsWithoutAMaterial)
{
  EXPECT_EQ(seen_with(rectangle, "points = \"a.csv\"\nvelocity = [1.0, 0.0]"), "accepted\n");
}

TEST_F(BodyFromAFile, OfPointsTakesNoPointsPerCell)
{
  EXPECT_THAT(seen_with(rectangle, "points = \"a.csv\"\npoints_per_cell = 3"),
      HasSubstr(":8:1: `points_per_cell` does not go with `points`\n\n    8 | points_per_cell = 3\n      | "
                "^^^^^^^^^^^^^^^\n  The file holds every material point. Remove one of the two.\n"));
}

TEST_F(BodyFromAFile, OfPointsTakesNoMaterial)
{
  EXPECT_THAT(seen_with(rectangle, "points = \"a.csv\"\nmaterial = \"caly\""), HasSubstr("`material` has no effect"));
}

TEST_F(BodyFromAFile, HasOneShapeOnly)
{
  const std::string seen = seen_with(from_file, "points = \"a.csv\"\nregion = \"core\"\nbox = [[0, 0], [1, 1]]");
  EXPECT_THAT(seen, HasSubstr(":7:1: a body has either `box` or `region`, not both"));
  EXPECT_THAT(seen, HasSubstr(":6:1: a body has either `box` or `points`, not both"));
}

TEST_F(BodyFromAFile, HasNoHoles)
{
  const std::string holes = "\nholes = [[[0, 0], [1, 0], [0, 1]]]";
  EXPECT_THAT(
      seen_with(rectangle, "points = \"a.csv\"" + holes), HasSubstr(":8:1: `holes` belongs to a box or polygon"));
  EXPECT_THAT(
      seen_with(from_file, "material = \"clay\"\nregion = \"core\"" + holes), HasSubstr("Leave it out with `region`."));
}

TEST(CheckCase, DoesNotWarnOfFrictionOnASeparatingContactNorOfNone)
{
  for (const char* contact : {"contact = \"separating\", friction = 0.3", "contact = \"bilateral\", friction = 0.0"})
    EXPECT_EQ(
        message_for(replaced(small_case, "[time]", std::string("[boundary]\nbottom = { ") + contact + " }\n[time]")),
        "accepted\n");
}

TEST_F(BodyFromAFile, OfPointsHasNoOutlineForK0)
{
  const std::string rest = "\n[forces]\ngravity = [0.0, -9.81]\n[initial]\nstress = \"k0\"";
  EXPECT_THAT(seen_with(rectangle, "points = \"a.csv\"" + rest),
      HasSubstr(":7:1: `k0` needs the outline of every body\n\n    7 | points = \"a.csv\"\n      | ^^^^^^\n  A file of "
                "points has "
                "none, so the weight of the soil above a place is not known. Use initial.stress = "
                "\"equilibrium\",\n  or give the body as box, polygon or region.\n"));
  EXPECT_EQ(seen_with(from_file, "material = \"clay\"\nregion = \"core\"" + rest), "accepted\n");
}

TEST(CheckCase, DoesNotBlameMissingGravityOnAWrongOne)
{
  const std::string text = small_case + "[forces]\ngravity = \"down\"\n[initial]\nstress = \"equilibrium\"\n";
  EXPECT_THAT(message_for(text), HasSubstr("1 error; nothing was run."));
}

std::string with_footing(const std::string& keys) { return message_for(small_case + "[[footing]]\n" + keys); }

TEST(CheckCase, TakesAFooting)
{
  EXPECT_EQ(with_footing("box = [[1.0, 2.0], [2.0, 2.5]]\nvelocity = [0.0, -0.1]\nramp = 0.2\ncontact = "
                         "\"smooth\"\nname = \"plate\"\n"),
      "accepted\n");
}

TEST(CheckCase, AFootingNeedsPlaceAndVelocity)
{
  const std::string seen = with_footing("contact = \"sticky\"\n");
  EXPECT_THAT(seen, HasSubstr("the key `box` is missing from [[footing]]"));
  EXPECT_THAT(seen, HasSubstr("the key `velocity` is missing from [[footing]]"));
  EXPECT_THAT(seen, HasSubstr("`contact` cannot be \"sticky\""));
  EXPECT_THAT(seen, HasSubstr("Allowed: \"rough\", \"smooth\"\n"));
}

TEST(CheckCase, ASmoothFootingAtRestIsRefused)
{
  EXPECT_THAT(with_footing("box = [[1.0, 2.0], [2.0, 2.5]]\nvelocity = [0.0, 0.0]\ncontact = \"smooth\"\n"),
      HasSubstr(":19:12: a smooth footing needs a velocity\n\n   19 | velocity = [0.0, 0.0]\n      |            "
                "^^^^^^^^^^\n  It holds its nodes along its velocity "
                "only, which is zero. Give a velocity, or contact = \"rough\".\n"));
}

TEST(CheckCase, FootingsHaveNamesOfTheirOwnAndAreNotTooMany)
{
  const std::string one = "box = [[1.0, 2.0], [2.0, 2.5]]\nvelocity = [0.0, -0.1]\n";
  EXPECT_THAT(with_footing(one + "[[footing]]\n" + one), HasSubstr("two footings have the name `footing`"));
  std::string nine;
  for (int k = 0; k < 9; ++k)
    nine += (k == 0 ? "" : "[[footing]]\n") + one + "name = \"" + std::string(1, static_cast<char>('a' + k)) + "\"\n";
  EXPECT_THAT(with_footing(nine), HasSubstr("a case has at most 8 footings"));
}

}  // namespace
}  // namespace terp
