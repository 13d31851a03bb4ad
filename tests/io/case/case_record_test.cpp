#include "io/case/case_record.hpp"
#include "math/errors.hpp"
#include "io/case/samples.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "support/paths.hpp"

namespace case_record_test {

CaseRecord record_of(const std::string& text, const std::string& folder = ".")
{
  const CaseFile file = read_case_text(text, folder + "/small.toml");
  return make_case_record(file, build_mesh(file.values));
}

/// What a run that began with `before` says of `now`.
std::vector<std::string> changes(const std::string& before, const std::string& now, const std::string& folder = ".")
{
  std::vector<std::string> texts;
  for (const ChangedValue& change : changes_since(record_text(record_of(before, folder)), record_of(now, folder)))
    texts.push_back(change.text());
  return texts;
}

TEST(CaseRecord, CommentsOrderSpellingAndDefaultsThatAreWrittenOutLeaveNoTrace)
{
  std::string other =
      replaced(small_case, "su_peak = 8.0e3\nsu_residual = 2.0e3\n", "su_residual = 2_000.0 # Pa\nsu_peak = 8000\n");
  other = replaced(other, "[time]\nend = 4.0\n", "scheme = \"mpm_gp\"\ntime = { courant = 0.98, end = 4 }\n");
  other = replaced(
      other, "box = [[0.0, 0.0], [8.0, 2.0]]", "polygon = [[0, 0], [8, 0], [8, 2], [0, 2]]\npoints_per_cell = 5");
  EXPECT_THAT(changes(small_case, other), IsEmpty());
}

TEST(CaseRecord, SaysWhichValuesChangedAndWhatTheyWere)
{
  const std::string other =
      replaced(replaced(small_case, "su_peak = 8.0e3", "su_peak = 9.0e3"), "cell = 0.5", "cell = [0.5, 0.25]");
  EXPECT_THAT(changes(small_case, other),
      ElementsAre("mesh.cell ([0.5, 0.5], now [0.5, 0.25])", "material.clay.su_peak (8000, now 9000)"));
  const std::string longer = replaced(small_case, "[8.0, 2.0]]", "[8.123456789012345, 2.123456789012345]]");
  EXPECT_THAT(changes(small_case, longer), ElementsAre("body[0] (outline)"));
}

TEST(CaseRecord, SeesSidesFormulasAndLists)
{
  const std::string sides =
      small_case + "[boundary]\nleft = \"roller\"\nright = { contact = \"bilateral\", adhesion = 100 }\n";
  EXPECT_THAT(changes(sides, replaced(sides, "\"roller\"", "\"fixed\"")),
      ElementsAre("boundary.left (\"roller\", now \"fixed\")"));
  EXPECT_THAT(changes(sides, replaced(sides, "adhesion = 100", "adhesion = 200")),
      ElementsAre("boundary.right.adhesion (100, now 200)"));
  EXPECT_THAT(changes(small_case, sides), Contains("boundary.left (not set, now \"roller\")"));
  const std::string formula =
      replaced(small_case, "material = \"clay\"\n", "material = \"clay\"\nvelocity = [\"0.1*y\", 0]\n");
  EXPECT_THAT(changes(formula, replaced(formula, "0.1*y", "0.2*y")),
      ElementsAre("body[0].velocity ([\"0.1*y\", 0], now [\"0.2*y\", 0])"));
  const std::string points = small_case + "[output.history]\npoints = { A = [1, 1] }\n";
  EXPECT_THAT(changes(points, replaced(points, "[1, 1]", "[1, 2]")),
      ElementsAre("output.history.points (A = [1, 1], now A = [1, 2])"));
}

TEST(CaseRecord, TheOrderOfMaterialsCountsAsPointsAreNumberedByIt)
{
  const std::string sand =
      "[material.sand]\nmodel = \"linear_elastic\"\ndensity = 2e3\nshear_modulus = 1e6\npoisson_ratio = 0.3\n";
  const std::string after = small_case + sand,
                    before = replaced(small_case, "[material.clay]", sand + "[material.clay]");
  EXPECT_THAT(changes(after, before), ElementsAre("material (in order) (clay, sand, now sand, clay)"));
}

TEST(CaseRecord, FilesCountByWhatIsInThem)
{
  const ScratchFolder scratch;
  const auto write = [&](const std::string& name, const std::string& volume) {
    std::ofstream(scratch.path() + '/' + name) << "x,y,volume,material\n0.25,0.25," + volume + ",clay\n";
  };
  write("a.csv", "0.01"), write("b.csv", "0.01"), write("c.csv", "0.02");
  const std::string text =
      replaced(small_case, "material = \"clay\"\nbox = [[0.0, 0.0], [8.0, 2.0]]", "points = \"a.csv\"");
  EXPECT_THAT(changes(text, replaced(text, "a.csv", "b.csv"), scratch.path()), IsEmpty());
  EXPECT_THAT(changes(text, replaced(text, "a.csv", "c.csv"), scratch.path()),
      ElementsAre(HasSubstr("body[0].points (content) (")));
  std::ofstream(scratch.path() + "/d.csv")
      << "# surveyed in May\nmaterial, x, y, volume\n\nclay, 2.5e-1, 0.25, 0.010\n";
  EXPECT_THAT(changes(text, replaced(text, "a.csv", "d.csv"), scratch.path()), IsEmpty());
}

TEST(CaseRecord, OfAnOlderTerpMayLackKeysThatHaveTheirDefault)
{
  const CaseRecord now = record_of(small_case);
  std::string older;
  for (const RecordedValue& value : now)
    if (value.key != "method.flip") older += value.key + " = " + value.value + '\n';
  EXPECT_THAT(changes_since(older, now), IsEmpty());
  const CaseRecord other = record_of(small_case + "[method]\nflip = 0.9\n");
  ASSERT_EQ(changes_since(older, other).size(), 1u);
  EXPECT_EQ(changes_since(older, other)[0].text(), "method.flip (not set, now 0.9)");
}

TEST(CaseRecord, NamesOfAnyKindAreNoLinesOfTheirOwn)
{
  const std::string odd = replaced(replaced(small_case, "material = \"clay\"", "material = \"a = b = c\""),
      "[material.clay]", "[material.\"a = b = c\"]");
  const std::string text = "title = \"two\\nlines = 3\"\n" + odd;
  EXPECT_THAT(changes(text, text), IsEmpty());
  EXPECT_THAT(changes(text, replaced(text, "lines = 3", "lines = 4")).size(), 1u);
}

TEST(CaseRecord, WhatMayChangeOnResume)
{
  for (const char* key :
      {"title", "time.end", "output.fields.every", "output.checkpoint.every", "output.checkpoint.keep"})
    EXPECT_TRUE(may_change_on_resume(key));
  for (const char* key :
      {"time.courant", "scheme", "output.history.every", "output.ledger.every", "output.fields.names", "output.mesh"})
    EXPECT_FALSE(may_change_on_resume(key));
  EXPECT_EQ(value_in_record(record_text(record_of(small_case)), "time.end"), "4");
  EXPECT_EQ(value_in_record("", "time.end"), "");
}

}  // namespace case_record_test
