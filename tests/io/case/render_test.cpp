#include "io/case/render.hpp"
#include "io/case/samples.hpp"

namespace render_test {

std::string shown(const Problem& problem, const std::vector<std::string>& overrides = {})
{
  return render({problem}, read_case_text(small_case, "case.toml", overrides));
}

TEST(Render, ShowsFileLineColumnAndTheUnderlinedText)
{
  EXPECT_EQ(shown({"body[0].box", "the body lies outside the mesh", "first line\nsecond line", "body"}),
      "error: case.toml:8:7: the body lies outside the mesh\n"
      "\n"
      "    8 | box = [[0.0, 0.0], [8.0, 2.0]]\n"
      "      |       ^^^^^^^^^^^^^^^^^^^^^^^^\n"
      "  first line\n"
      "  second line\n"
      "  More: terp explain body\n"
      "\n"
      "1 error; nothing was run.\n");
}

TEST(Render, PointsAtTheKeyWhenAsked)
{
  EXPECT_THAT(shown({"material.clay.eta", "w", "", "", true}),
      HasSubstr("case.toml:16:1: w\n\n   16 | eta = 50.0\n      | ^^^\n"));
}

// A name that is wrong in one place is missed in many.
TEST(Render, SaysOnceWhatHoldsOfSeveralPlaces)
{
  const Problem first{"body[0].box", "there is no water `flood`", "Water of this case: start", ""};
  Problem same = first, another = first;
  same.key = "material.clay.eta", another.key = "mesh.cell", another.detail = "Another reason.";
  const std::string text = render({same, first, another}, read_case_text(small_case, "case.toml"));
  EXPECT_THAT(text, HasSubstr("error: case.toml:8:7: there is no water `flood`\n"));
  EXPECT_THAT(text, HasSubstr("  The same at case.toml:16:7\n  Water of this case: start\n"));
  EXPECT_THAT(text, HasSubstr("2 errors; nothing was run.\n"));
}

TEST(Render, FallsBackToTheNearestTableAbove)
{
  EXPECT_THAT(
      shown({"mesh.origin", "w", "", ""}), StartsWith("error: case.toml:3:2: w\n\n    3 | [mesh]\n      |  ^^^^\n"));
  EXPECT_THAT(shown({"body[0].velocity", "w", "", ""}),
      StartsWith("error: case.toml:6:1: w\n\n    6 | [[body]]\n      | ^^^^^^^^\n"));
  EXPECT_THAT(shown({"body[7].box", "w", "", ""}), StartsWith("error: case.toml:6:3: w\n"));
}

TEST(Render, SaysTheDefaultOfAKeyThatIsNotThere)
{
  EXPECT_THAT(shown({"method.flip", "w", "", ""}),
      StartsWith("error: case.toml: w\n  `method.flip` is not given; its default is 1; of fluids 0.95.\n"));
}

TEST(Render, NamesTheOverrideThatSetTheValue)
{
  EXPECT_THAT(shown({"mesh.cell", "too small", "d", ""}, {"mesh.cell=0.25"}),
      StartsWith("error: --set mesh.cell=0.25: too small\n  d\n"));
  EXPECT_THAT(shown({"mesh.size", "w", "", ""}, {"mesh.cell=0.25"}), StartsWith("error: case.toml:4:8: w\n"));
  EXPECT_THAT(
      shown({"initial.k0", "w", "", ""}, {"initial.stress=none"}), StartsWith("error: --set initial.stress=none: w\n"));
}

TEST(Render, NamesTheOverrideOfAnotherKeyThatDoesNotGoWithThisOne)
{
  const Problem outside{"body[0]", "outside", "", "", false, {"body[0].box", "mesh.size"}};
  EXPECT_THAT(shown(outside), StartsWith("error: case.toml:6:1: outside\n"));
  EXPECT_THAT(shown(outside, {"mesh.size=[6.0,3.0]"}), StartsWith("error: --set mesh.size=[6.0,3.0]: outside\n"));
  EXPECT_THAT(shown(outside, {"body[0].box[1][0]=20"}), StartsWith("error: --set body[0].box[1][0]=20: outside\n"));
  EXPECT_THAT(shown(outside, {"mesh.cell=0.25"}), StartsWith("error: case.toml:6:1: outside\n"));
}

TEST(Render, CountsTheRestBeyondTen)
{
  std::string text;
  for (int k = 0; k < 12; ++k) text += "wrong_" + std::to_string(k) + " = 1\n";
  const std::string seen = message_for(text + small_case);
  EXPECT_THAT(seen, AllOf(HasSubstr("unknown key `wrong_9`"), Not(HasSubstr("unknown key `wrong_10`")),
                        HasSubstr("and 2 more\n\n12 errors; nothing was run.\n")));
}

TEST(Render, GoesInTheOrderOfTheFile)
{
  const std::string seen = render({{"time.end", "third", "", ""}, {"", "last", "", ""}, {"time", "first", "", ""}},
      read_case_text(small_case, "case.toml"));
  EXPECT_LT(seen.find("first"), seen.find("third"));
  EXPECT_LT(seen.find("third"), seen.find("last"));
}

TEST(Render, UnderlinesCharactersNotBytes)
{
  EXPECT_THAT(message_for("title = \"äöü\"; x\n" + small_case),
      HasSubstr("\n    1 | title = \"äöü\"; x\n      |              ^\n"));
  EXPECT_THAT(message_for(replaced(small_case, "end = 4.0", "end\t=\t-4.0")),
      HasSubstr("    2 | end\t=\t-4.0\n      |    \t \t^^^^\n"));
}

TEST(Render, UnderlinesTheFirstLineOfALongValue)
{
  EXPECT_THAT(message_for(replaced(small_case, "size = [16.0, 3.0]", "size = [16.0,\n3.0, 1.0]")),
      HasSubstr("    4 | size = [16.0,\n      |        ^^^^^^\n"));
}

TEST(Render, LeavesOutCarriageReturns)
{
  EXPECT_THAT(message_for(replaced(small_case, "end = 4.0", "end = -4.0\r")), HasSubstr("    2 | end = -4.0\n"));
}

TEST(Render, ShowsWarningsBesideErrors)
{
  const std::string seen = message_for(replaced(small_case, "shear_modulus = 2.0e6", "shear_modulus = 2.0e3"));
  EXPECT_THAT(seen, StartsWith("warning: case.toml:12:17: `shear_modulus` = 2000 Pa is unusual\n"));
  EXPECT_THAT(seen, HasSubstr("error: case.toml:16:7: softening is too steep\n"));
}

TEST(Render, AWarningThatSaysAllInItsFirstLineHasNoOther)
{
  EXPECT_EQ(render_warnings(
                {{"body[0].box", "the box is wide; give half of it", "", ""}}, read_case_text(small_case, "case.toml")),
      "warning: case.toml:8:7: the box is wide; give half of it\n");
}

}  // namespace render_test
