// Wrong values and what the user reads about them.

#include "input/values.hpp"

#include "input/samples.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::HasSubstr;
using namespace test;

class WrongValue : public testing::TestWithParam<Change> {};

TEST_P(WrongValue, IsRefusedWithWhatIsAllowed)
{
  const auto& [line, instead, message] = GetParam();
  EXPECT_THAT(message_for(replaced(small_case, line, instead)), HasSubstr(message));
}

const Change wrong_values[] = {
    {"end = 4.0", "end = 0",
        "error: case.toml:2:7: `end` is out of range\n\n    2 | end = 0\n      |       ^\n  Got 0 s; allowed: more "
        "than 0 "
        "s.\n  More: terp explain time.end\n"},
    {"end = 4.0", "end = \"4\"",
        "`end` must be a number\n\n    2 | end = \"4\"\n      |       ^^^\n  Got the text \"4\"; allowed: a number, "
        "more "
        "than 0 s.\n"},
    {"end = 4.0", "end = nan",
        "error: case.toml:2:7: `end` must be a finite number\n\n    2 | end = nan\n      |       ^^^\n"
        "  Got nan s; allowed: a finite number, more than 0 s.\n  More: terp explain time.end\n"},
    {"end = 4.0", "end = inf", "Got inf s; allowed: a finite number, more than 0 s."},
    {"end = 4.0", "end = -inf", "Got -inf s; allowed: a finite number, more than 0 s."},
    {"end = 4.0", "end = 2024-01-01", "Got a date or time; allowed: a number, more than 0 s."},
    {"end = 4.0", "end = 4.0\ncourant = 1.5", "Got 1.5; allowed: more than 0 and at most 1."},
    {"size = [16.0, 3.0]", "size = 16.0", "Got the number 16; allowed: two numbers [x, y], more than 0 m."},
    {"size = [16.0, 3.0]", "size = [16.0, 3.0, 1.0]", "Got a list of 3; allowed: two numbers [x, y]"},
    {"size = [16.0, 3.0]", "size = [16.0, \"a\"]", "error: case.toml:4:15: `size` must be two numbers [x, y]"},
    {"size = [16.0, 3.0]", "size = [16.0, -3.0]",
        "error: case.toml:4:15: `size` is out of range\n\n    4 | size = [16.0, -3.0]\n      |               ^^^^\n"},
    {"cell = 0.5", "cell = [0.5, true]", "Got true; allowed: a number or two numbers [x, y], more than 0 m."},
    {"cell = 0.5", "cell = 0.5\norigin = [nan, 0.0]", "Got nan m; allowed: a finite number in m."},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "box = [[8.0, 0.0], [0.0, 2.0]]", "`box` has no area"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "box = [[0.0, 0.0], [8.0, 2.0]]\nvelocity = [\"2*z\", 0]",
        "`velocity` is not a formula of x and y\n\n    9 | velocity = [\"2*z\", 0]\n      |             ^^^^^\n  `z` "
        "is not known here. Names: x, y\n"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "box = [[0.0, 0.0], [8.0, 2.0]]\nvelocity = \"x\"",
        "`velocity` must be two numbers or formulas [x, y]"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "box = [[8.0, 0.0]]", "`box` must be two corners [[x0, y0], [x1, y1]]"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "polygon = [[0, 0], [1, 0]]", "`polygon` must be at least three corners"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "polygon = [[0, 0], [1, 1], [2, 2]]", "`polygon` has no area"},
    {"box = [[0.0, 0.0], [8.0, 2.0]]", "polygon = [[0, 0], [2, 2], [2, 0], [0, 1]]",
        "error: case.toml:8:11: `polygon` crosses itself\n\n    8 | polygon = [[0, 0], [2, 2], [2, 0], [0, 1]]\n      "
        "|  "
        "         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n  The edge from (0, 0) to (2, 2) m crosses that from (2, 0) to (0, "
        "1) "
        "m.\n  Give the corners in order along the outline.\n"},
    {"material = \"clay\"", "material = \"clay\"\nholes = [[1, 1], [2, 1], [2, 2]]",
        "error: case.toml:8:11: `holes` must be a list of polygons [[[x, y], [x, y], [x, y]], ...]"},
    {"material = \"clay\"", "material = \"clay\"\nholes = [[[1, 1], [2, 1], [2, 2]], [[1, 1], [2, 1]]]",
        "error: case.toml:8:36: `holes` must be a list of polygons"},
    {"material = \"clay\"", "material = \"clay\"\nholes = [[[1, 1], [2, 1], [3, 1]]]", "`holes[0]` has no area"},
    {"material = \"clay\"", "material = \"clay\"\nholes = 3", "Got the integer 3; allowed: a list of polygons"},
    {"[time]", "[boundary]\nleft = \"opne\"\n[time]", "Did you mean `open`?"},
    {"material = \"clay\"", "material = \"clay\"\npoints_per_cell = 5.5",
        "`points_per_cell` must be an integer or two integers [nx, ny]\n\n    8 | points_per_cell = 5.5\n"},
    {"material = \"clay\"", "material = \"clay\"\npoints_per_cell = 0", "Got 0; allowed: at least 1 and at most 100."},
    {"material = \"clay\"", "material = \"clay\"\npoints_per_cell = 99999999999",
        "Got 99999999999; allowed: at least 1 and at most 100."},
    {"material = \"clay\"", "material = 3", "Got the integer 3; allowed: text."},
    {"model = \"tresca_softening\"", "model = \"tresca\"", "`model` cannot be \"tresca\"\n"},
    {"model = \"tresca_softening\"", "model = \"tresca_softning\"",
        "Did you mean `tresca_softening`?\n  Allowed: \"linear_elastic\", \"tresca_softening\""},
    {"poisson_ratio = 0.48", "poisson_ratio = 0.5", "Got 0.5; allowed: at least 0 and less than 0.5."},
    {"density = 1990.0", "density = -1990.0", "Got -1990 kg/m^3; allowed: more than 0 kg/m^3."},
    {"[time]", "scheme = \"mpm_pg\"\n[time]",
        "`scheme` cannot be \"mpm_pg\"\n\n    1 | scheme = \"mpm_pg\"\n      |          ^^^^^^^^\n  Did you mean "
        "`mpm_gp`?\n  Allowed: \"standard_mpm\", \"mpm_mixed\", \"mpm_gp\"\n  More: terp explain scheme\n"},
    {"[time]", "[method]\nb_bar = 1\n[time]", "`b_bar` must be true or false"},
    {"[time]", "[method]\nflip = nan\n[time]", "`flip` must be a finite number"},
    {"[time]", "[output]\nfields = { names = [\"su\", \"stres\"] }\n[time]",
        "error: case.toml:2:27: `names` cannot be \"stres\"\n"},
    {"[time]", "[output]\nfields = { names = \"su\" }\n[time]", "`names` must be a list of names"},
    {"[time]", "[output]\nhistory = { points = { A = 3 } }\n[time]", "`points` must be a table { NAME = [x, y] }"},
    {"[time]", "[output]\nhistory = { points = [1, 2] }\n[time]",
        "Got a list of 2; allowed: a table { NAME = [x, y] } in m."},
    {"[time]", "[output]\nhistory = { every = 0 }\n[time]", "`every` is out of range"},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, WrongValue, testing::ValuesIn(wrong_values));

class UnusualValue : public testing::TestWithParam<Change> {};

TEST_P(UnusualValue, IsReadWithAWarning)
{
  const auto& [line, instead, message] = GetParam();
  const std::string seen = message_for(replaced(small_case, line, instead));
  EXPECT_THAT(seen, testing::StartsWith("accepted\nwarning: case.toml:"));
  EXPECT_THAT(seen, HasSubstr(message));
}

const Change unusual_values[] = {
    {"density = 1990.0", "density = 1.99",
        "`density` = 1.99 kg/m^3 is unusual\n\n   11 | density = 1.99\n      |           ^^^^\n  Usual: 500 to 5000 "
        "kg/m^3. Terp reads SI units: m, kg, s, Pa.\n"},
    {"shear_modulus = 2.0e6\npoisson_ratio = 0.48\nsu_peak = 8.0e3\nsu_residual = 2.0e3",
        "shear_modulus = 2000\npoisson_ratio = 0.48\nsu_peak = 8\nsu_residual = 2",
        "`shear_modulus` = 2000 Pa is unusual"},
    {"[time]", "[forces]\ngravity = [0, -9810]\n[time]", "gravity of 9810 m/s^2 is unusual"},
    {"[time]", "[boundary]\nbottom = { contact = \"bilateral\", adhesion = 8 }\n[time]",
        "`adhesion` = 8 Pa is unusual"},
    {"[time]", "[boundary]\nbottom = { contact = \"bilateral\", friction = 30 }\n[time]", "`friction` = 30 is unusual"},
    {"end = 4.0", "end = 40000", "`end` = 40000 s is unusual"},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, UnusualValue, testing::ValuesIn(unusual_values));

TEST(Values, InTheUsualRangeGiveNoWarning) { EXPECT_EQ(message_for(small_case), "accepted\n"); }

TEST(Values, AVelocityMayBeAFormulaOfThePlace)
{
  const Case c = read_case_text(replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]",
                                    "box = [[0.0, 0.0], [8.0, 2.0]]\nvelocity = [\"3*x*y\", -2]"),
      "case.toml")
                     .values;
  ASSERT_TRUE(c.bodies[0].velocity_at);
  EXPECT_EQ(c.bodies[0].velocity_at({2.0, 0.5}), (Vec<2>{3.0, -2.0}));
}

TEST(Values, PolygonsAreTurnedCounterClockwise)
{
  const std::string text = replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]", "polygon = [[0, 0], [0, 1], [1, 0]]");
  const auto corners = read_case_text(text, "case.toml").values.bodies[0].polygon;
  EXPECT_THAT(corners, testing::ElementsAre(Vec<2>{1, 0}, Vec<2>{0, 1}, Vec<2>{0, 0}));
}

TEST(Values, APolygonMayTouchItself)
{
  const std::string slit = "polygon = [[0, 0], [3, 0], [3, 3], [1, 1], [2, 1], [1, 1], [3, 3], [0, 3]]";
  EXPECT_EQ(message_for(replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]", slit)), "accepted\n");
}

TEST(Values, ABoxIsKeptAsFourCornersCounterClockwise)
{
  EXPECT_THAT(read_case_text(small_case, "case.toml").values.bodies[0].polygon,
      testing::ElementsAre(Vec<2>{0, 0}, Vec<2>{8, 0}, Vec<2>{8, 2}, Vec<2>{0, 2}));
}

}  // namespace
}  // namespace terp
