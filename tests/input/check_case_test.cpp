// Keys that are each right and together wrong.

#include "input/check_case.hpp"

#include "input/samples.hpp"

#include <gmock/gmock.h>

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
     "error: case.toml:6:1: the body has no shape\n\n    6 | [[body]]\n      | ^^^^^^^^\n  Give box = [[x0, y0], [x1, "
     "y1]] or polygon = "},
    {"material = \"clay\"", "material = \"caly\"",
     "error: case.toml:7:12: there is no material `caly`\n\n    7 | material = \"caly\"\n      |            ^^^^^^\n  "
     "Did you mean `clay`?\n  Materials of this case: clay\n"},
    {"eta = 50.0", "eta = 800.0",
     "error: case.toml:16:7: softening is too steep\n\n   16 | eta = 800.0\n      |       ^^^^^\n  eta (su_peak - "
     "su_residual) = 4.8e+06 Pa, at most 1.5 G = 3e+06 Pa\n"},
    {"su_residual = 2.0e3", "su_residual = 9.0e3",
     "error: case.toml:15:15: the residual strength exceeds the peak strength\n"},
    {"cell = 0.5", "cell = [0.7, 0.5]",
     "error: case.toml:5:8: the width of the mesh is not a whole number of cells\n\n    5 | cell = [0.7, 0.5]\n      | "
     "       ^^^^^^^^^^\n  16 m / 0.7 m = 22.8571; the nearest width that fits is 0.695652 m.\n"},
    {"cell = 0.5", "cell = [0.5, 4.0]", "the height of the mesh is not a whole number of cells"},
    {"[time]", "[boundary]\nbottom = { adhesion = 8e3 }\n[time]",
     "error: case.toml:2:12: `adhesion` needs a contact\n\n    2 | bottom = { adhesion = 8e3 }\n      |            "
     "^^^^^^^^\n  Free, roller and fixed sides do not slide with resistance. Write bottom = { contact = \"bilateral\", "
     "adhesion = ... }, or \"separating\".\n"},
    {"[time]", "[boundary]\nbottom = { contact = \"bilateral\", velocity = [1, 0] }\n[time]",
     "a side has either a contact or a velocity, not both"},
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

TEST(CheckCase, DoesNotBlameMissingGravityOnAWrongOne)
{
  const std::string text = small_case + "[forces]\ngravity = \"down\"\n[initial]\nstress = \"equilibrium\"\n";
  EXPECT_THAT(message_for(text), HasSubstr("1 error; nothing was run."));
}

}  // namespace
}  // namespace terp
