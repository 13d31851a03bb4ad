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
  EXPECT_THAT(message_for(small_case, {"time.end = "}), HasSubstr("a change has a value after the equals sign\n"));
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

const std::string two_soils =
    test::small_case +
    "[material.sand]\nmodel = \"linear_elastic\"\ndensity = 1800.0\nshear_modulus = 5.0e6\n"
    "poisson_ratio = 0.3\n[material.peat]\nmodel = \"tresca_softening\"\ndensity = 1100.0\n"
    "shear_modulus = 1.0e6\npoisson_ratio = 0.45\nsu_peak = 4.0e3\nsu_residual = 2.0e3\neta = 10.0\n";

std::vector<Real> last_parameters(const std::vector<std::string>& changes)
{
  std::vector<Real> found;
  for (const MaterialCase& m : read_case_text(two_soils, "case.toml", changes).values.materials)
    found.push_back(m.parameters.back());
  return found;
}

TEST(Overrides, APatternSetsEveryMaterialThatHasTheKey)
{
  using testing::ElementsAre;
  EXPECT_THAT(last_parameters({}), ElementsAre(50.0, 0.3, 10.0));
  EXPECT_THAT(last_parameters({"material.*.eta=40"}), ElementsAre(40.0, 0.3, 40.0));  // sand has none
  EXPECT_THAT(last_parameters({"material.p*t.eta=40"}), ElementsAre(50.0, 0.3, 40.0));
  EXPECT_THAT(last_parameters({"material.*.poisson_ratio=0.2", "material.c*.eta=7"}), ElementsAre(7.0, 0.2, 10.0));
}

TEST(Overrides, APatternSetsEveryEntryOfAList)
{
  const std::string two_bodies = test::small_case + "[[body]]\nmaterial = \"clay\"\nbox = [[8.0, 0.0], [9.0, 1.0]]\n";
  for (const char* change : {"body.*.points_per_cell=3", "body[*].points_per_cell=3"})
    for (const BodyCase& body : read_case_text(two_bodies, "case.toml", {change}).values.bodies)
      EXPECT_EQ(body.points_per_cell[0], 3) << change;
}

TEST(Overrides, APatternThatFitsNothingIsRefused)
{
  EXPECT_THAT(message_for(two_soils, {"material.x*.eta=40"}),
      HasSubstr(
          "error: --set material.x*.eta=40: the pattern fits nothing\n  There are: clay, sand, peat. In [material], "
          "those count whose model has the key.\n"));
  EXPECT_THAT(message_for(two_soils, {"material.*.etta=40"}), HasSubstr("the pattern fits nothing"));
  EXPECT_THAT(message_for(two_soils, {"material." + std::string(200, '*') + "x.eta=40"}),  // in no time
      HasSubstr("the pattern fits nothing"));
}

TEST(Overrides, OfAMaterialThatTheCaseDoesNotHaveNameTheNearest)
{
  EXPECT_THAT(message_for(small_case, {"material.Clay.eta=40"}),
      HasSubstr("error: --set material.Clay.eta=40: there is no material `Clay`\n  Did you mean `material.clay.eta`?\n"
                "  Materials of this case: clay\n"));
  EXPECT_THAT(
      message_for(small_case, {"material.basalt.eta=40"}), HasSubstr("there is no material `basalt`\n  Materials"));
}

TEST(Overrides, OfAKeyInTheWrongPlaceNameTheRightOne)
{
  EXPECT_THAT(message_for(small_case, {"gravity=-5"}),
      HasSubstr("error: --set gravity=-5: unknown key `gravity`\n  Did you mean `forces.gravity`, in [forces]?\n"));
  EXPECT_THAT(message_for(small_case, {"body.box=3"}),
      HasSubstr(
          "there is no entry `box`\n  `body` is a list: write body[0].box, counted from 0, or body.*.box for all 1 "
          "entries.\n"));
  EXPECT_THAT(message_for(small_case, {"body[0].box="}),
      HasSubstr(
          "a change has a value after the equals sign\n  An empty text is written with quotes: --set 'title=\"\"'\n"));
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
