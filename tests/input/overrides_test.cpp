#include "input/overrides.hpp"

#include "input/samples.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::HasSubstr;
using namespace test;

Case with(const std::vector<std::string>& overrides)
{
  return read_case_text(small_case, "case.toml", overrides).values;
}

TEST(Overrides, ChangeAKeyThatIsThere) { EXPECT_EQ(with({"mesh.cell=0.25"}).mesh.cell, (Vec<2>{0.25, 0.25})); }

TEST(Overrides, RefuseAKeyOfVeryManyParts)
{
  std::string key = "a";
  for (int k = 1; k < 50000; ++k) key += ".a";
  try {
    with({key + "=1"});
    ADD_FAILURE();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a key has at most 100 parts"));
  }
}

TEST(Overrides, TakeTextWithAndWithoutQuotes)
{
  EXPECT_EQ(with({"scheme=mpm_mixed"}).scheme, "mpm_mixed");
  EXPECT_EQ(with({"scheme=\"mpm_mixed\""}).scheme, "mpm_mixed");
  EXPECT_EQ(with({"title=two words"}).title, "two words");
}

TEST(Overrides, TakeBlanksAroundKeyAndValue)
{
  EXPECT_EQ(with({" time.end = 2.5 "}).time.end, 2.5);
  EXPECT_EQ(with({"scheme = mpm_mixed "}).scheme, "mpm_mixed");
  EXPECT_EQ(with({"title\t= two  words"}).title, "two  words");
  EXPECT_THAT(message_for(small_case, {"  = 3"}), HasSubstr("a change has the form KEY=VALUE"));
  EXPECT_THAT(message_for(small_case, {"time.end = "}), HasSubstr("`end` must be a number\n  Got the text \"\";"));
}

TEST(Overrides, CreateTablesThatAreMissing)
{
  EXPECT_EQ(with({"forces.damping.local=0.25"}).forces.local_damping, 0.25);
  EXPECT_EQ(with({"output.history.points.A=[1.5,2]"}).output.history_points.front().second, (Vec<2>{1.5, 2.0}));
  EXPECT_EQ(
      with({"boundary.bottom={contact=\"separating\",adhesion=50}"}).sides.front().kind, SideKind::contact_separating);
}

TEST(Overrides, ReachEntriesOfLists)
{
  using Counts = std::array<Index, 2>;
  EXPECT_EQ(with({"body.0.points_per_cell=[3,4]"}).bodies[0].points_per_cell, (Counts{3, 4}));
  EXPECT_EQ(with({"body[0].points_per_cell=2"}).bodies[0].points_per_cell, (Counts{2, 2}));
  EXPECT_EQ(with({"body[0].box[1][0]=4"}).bodies[0].polygon[2], (Vec<2>{4.0, 2.0}));
}

TEST(Overrides, AddAnEntryBehindTheLast)
{
  const Case both = with({"body[1].material=clay", "body[1].box=[[9,0],[10,1]]"});
  ASSERT_EQ(both.bodies.size(), 2u);
  EXPECT_EQ(both.bodies[1].polygon[0], (Vec<2>{9.0, 0.0}));
}

TEST(Overrides, MakeTheFirstEntryOfAList)
{
  const std::string no_body =
      replaced(small_case, "[[body]]\nmaterial = \"clay\"\nbox = [[0.0, 0.0], [8.0, 2.0]]\n", "");
  const auto file = read_case_text(no_body, "case.toml", {"body.0.material=clay", "body.0.box=[[0,0],[1,1]]"});
  EXPECT_EQ(file.values.bodies.size(), 1u);
}

TEST(Overrides, AreAppliedInOrder) { EXPECT_EQ(with({"time.end=1", "time.end=2"}).time.end, 2.0); }

TEST(Overrides, DoNotSmuggleInASecondKey)
{
  EXPECT_THAT(message_for(small_case, {"time.end=1\nfoo=2"}), HasSubstr("`end` must be a number"));
}

TEST(Overrides, AreNamedInErrors)
{
  EXPECT_EQ(message_for(small_case, {"time.end=-1"}),
      "error: --set time.end=-1: `end` is out of range\n"
      "  Got -1 s; allowed: more than 0 s.\n"
      "  More: terp explain time.end\n\n"
      "1 error; nothing was run.\n");
  EXPECT_THAT(message_for(small_case, {"time.ende=1"}),
      HasSubstr("error: --set time.ende=1: unknown key `ende`\n  Did you mean `end`?"));
  EXPECT_THAT(message_for(small_case, {"material.clay.eta=800"}),
      HasSubstr("error: --set material.clay.eta=800: softening is too steep"));
}

TEST(Overrides, AreNamedWhereTheyDoNotGoWithTheFile)
{
  EXPECT_THAT(message_for(small_case, {"material.clay.su_peak=1e6"}),
      HasSubstr("error: --set material.clay.su_peak=1e6: softening is too steep"));
  EXPECT_THAT(message_for(small_case, {"mesh.size=[16.2, 3.0]"}),
      HasSubstr("error: --set mesh.size=[16.2, 3.0]: the width of the mesh is not a whole number of cells"));
}

TEST(Overrides, OfTheWrongFormAreRefused)
{
  EXPECT_THAT(
      message_for(small_case, {"time.end"}), HasSubstr("error: --set time.end: a change has the form KEY=VALUE"));
  EXPECT_THAT(message_for(small_case, {"=3"}), HasSubstr("a change has the form KEY=VALUE"));
}

TEST(Overrides, ThatLeadNowhereAreRefused)
{
  EXPECT_THAT(message_for(small_case, {"body[4].box=3"}),
      HasSubstr("there is no entry `[4]`\n  The list `body` has 1 entries; count from 0."));
  EXPECT_THAT(message_for(small_case, {"mesh.cell.x=3"}),
      HasSubstr("`mesh.cell` is a single value and holds no keys. Set it as a whole: --set mesh.cell=..."));
  EXPECT_THAT(message_for(small_case, {"mesh[0]=3"}), HasSubstr("`mesh` is a table, not a list."));
}

}  // namespace
}  // namespace terp
