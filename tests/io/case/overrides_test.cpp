// Changes from the command line; those that are refused: wrong_cases/small_case.wrong.
#include "io/case/overrides.hpp"
#include "io/case/samples.hpp"

namespace overrides_test {

Case with(const std::vector<std::string>& overrides)
{
  return read_case_text(small_case, "case.toml", overrides).values;
}

TEST(Overrides, ChangeAKeyThatIsThere) { EXPECT_EQ(with({"mesh.cell=0.25"}).mesh.cell, (Vec<2>{0.25, 0.25})); }

TEST(Overrides, OfOneKeyTwiceAreDoubtedWhateverItsName)
{
  const std::string doubt = "it has no effect: a later --set gives the same key another value";
  EXPECT_THAT(
      message_for(small_case, {"mesh.cell=0.25", "mesh.cell=0.5"}), HasSubstr("--set mesh.cell=0.25: " + doubt));
  EXPECT_THAT(message_for(small_case, {"body[0].points_per_cell=4", "body.*.points_per_cell=3"}), HasSubstr(doubt));
  EXPECT_EQ(message_for(small_case, {"material.*.density=1800", "mesh.cell=0.5"}), "accepted\n");
}

TEST(Overrides, RefuseAKeyOfVeryManyParts)
{
  std::string key = "a";
  for (int k = 1; k < 50000; ++k) key += ".a";
  EXPECT_THAT(message_for(small_case, {key + "=1"}), HasSubstr("a key has at most 100 parts"));
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

std::vector<Real> etas_or_ratios(const std::vector<std::string>& changes)
{
  std::vector<Real> found;
  for (const MaterialCase& m : read_case_text(two_clays, "case.toml", changes).values.materials)
    found.push_back(m.parameters.size() > 2 ? m.parameters[4] : m.parameters[1]);
  return found;
}

TEST(Overrides, APatternSetsEveryMaterialThatHasTheKey)
{
  EXPECT_THAT(etas_or_ratios({}), ElementsAre(50.0, 0.3, 10.0));
  EXPECT_THAT(etas_or_ratios({"material.*.eta=40"}), ElementsAre(40.0, 0.3, 40.0));  // sand has none
  EXPECT_THAT(etas_or_ratios({"material.p*t.eta=40"}), ElementsAre(50.0, 0.3, 40.0));
  EXPECT_THAT(etas_or_ratios({"material.*.poisson_ratio=0.2", "material.c*.eta=7"}), ElementsAre(7.0, 0.2, 10.0));
}

TEST(Overrides, APatternOfAPartOfAKeySetsEveryMaterialThatHasTheKey)
{
  const std::vector<std::string> changes{
      "material.*.su_peak={random={mean=1e4,cov=0.1,theta=[4,4],box=[[0,0],[9,2]],seed=1}}",
      "material.*.su_peak.random.cov=0.2"};
  int n = 0;  // sand has no su_peak
  for (const MaterialCase& m : read_case_text(two_clays, "case.toml", changes).values.materials)
    n += static_cast<int>(m.fields.size());
  EXPECT_EQ(n, 2);
}

TEST(Overrides, APatternSetsEveryEntryOfAList)
{
  const std::string two_bodies = small_case + "[[body]]\nmaterial = \"clay\"\nbox = [[8.0, 0.0], [9.0, 1.0]]\n";
  for (const char* change : {"body.*.points_per_cell=3", "body[*].points_per_cell=3"})
    for (const BodyCase& body : read_case_text(two_bodies, "case.toml", {change}).values.bodies)
      EXPECT_EQ(body.points_per_cell[0], 3) << change;
}

TEST(Overrides, APatternOfVeryManyStarsIsRefusedInNoTime)
{
  EXPECT_THAT(message_for(two_clays, {"material." + std::string(200, '*') + "x.eta=40"}),
      HasSubstr("the pattern fits nothing"));
}

TEST(Overrides, TakeThePlaceOfWhatSaysTheSameInAnotherWay)
{
  constexpr std::size_t su_peak = 2, su_residual = 3;
  const MaterialCase by_depth = with({"material.clay.su_peak.depth=[[0,8000],[3,9000]]"}).materials[0];
  ASSERT_EQ(by_depth.fields.size(), 1u);
  EXPECT_EQ(by_depth.fields[0].parameter, su_peak);
  const MaterialCase by_height =
      with({"material.clay.su_peak.depth=[[0,8000],[3,9000]]", "material.clay.su_peak.elevation=[[0,9000],[3,8000]]"})
          .materials[0];
  ASSERT_EQ(by_height.fields.size(), 1u);
  EXPECT_EQ(with({"material.clay.sensitivity=4"}).materials[0].parameters[su_residual], 2e3);
  EXPECT_EQ(
      with({"material.clay.sensitivity=4", "material.clay.su_residual=1e3"}).materials[0].parameters[su_residual], 1e3);
}

TEST(Overrides, AreAppliedInOrder) { EXPECT_EQ(with({"time.end=1", "time.end=2"}).time.end, 2.0); }

}  // namespace overrides_test
