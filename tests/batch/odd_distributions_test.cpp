#include "batch/odd_distributions.hpp"

#include "batch/samples.hpp"
#include "batch/study_folder.hpp"

namespace odd_distributions_test {

std::vector<std::string> doubts_of(const std::string& spread, const std::string& more = "")
{
  const ScratchFolder folder;
  const std::string old = "distribution = \"lognormal\"\nmean = \"8 kPa\"\ncov = 0.4\n";
  std::string text = column_study;
  text.replace(text.find(old), old.size(), spread + more);
  std::vector<Problem> doubts;
  doubt_distributions(open_study(write_study(folder.path(), text)), doubts);
  std::vector<std::string> all;
  for (const Problem& problem : doubts) all.push_back(problem.key + ": " + problem.what);
  return all;
}

TEST(OddDistributions, AStandardDeviationInTheUnitOfACoefficientOfVariation)
{
  EXPECT_THAT(doubts_of("distribution = \"lognormal\"\nmean = \"8 kPa\"\nsd = 0.4\n"),
      ElementsAre("random[0].key: `material.clay.su_peak` hardly varies"));
  EXPECT_THAT(doubts_of("distribution = \"lognormal\"\nmean = \"8 kPa\"\nsd = \"1 kPa\"\n"), IsEmpty());
}

TEST(OddDistributions, NumbersBesideEachOtherAndBesideTheCase)
{
  EXPECT_THAT(doubts_of("distribution = \"lognormal\"\nmean = \"8 kPa\"\ncov = 1.2\n"),
      ElementsAre("random[0].key: the standard deviation of `material.clay.su_peak` is more than its mean"));
  EXPECT_THAT(doubts_of("distribution = \"uniform\"\nlowest = 5\nhighest = \"9 kPa\"\n"),
      ElementsAre("random[0].key: the bounds of `material.clay.su_peak` differ by a factor of 1.8e+03"));
  EXPECT_THAT(doubts_of("distribution = \"lognormal\"\nmean = \"20 kPa\"\ncov = 0.15\n"),
      ElementsAre("random[0].key: `material.clay.su_peak` is hardly drawn where the case has it"));
  EXPECT_THAT(doubts_of("distribution = \"lognormal\"\nmean = \"9 kPa\"\ncov = 0.2\n"), IsEmpty());
}

TEST(OddDistributions, BoundsBesideTheMean)
{
  const std::string cut = "distribution = \"truncated_normal\"\nmean = \"8 kPa\"\ncov = 0.2\nlowest = ";
  EXPECT_THAT(
      doubts_of(cut + "\"9 kPa\"\n"), ElementsAre("random[0].key: the bounds cut off most of `material.clay.su_peak`"));
  EXPECT_THAT(doubts_of(cut + "\"6 kPa\"\n"), IsEmpty());
}

TEST(OddDistributions, LevelsBesideTheLoad)
{
  const std::string good = "distribution = \"lognormal\"\nmean = \"8 kPa\"\ncov = 0.4\n";
  const auto of = [&](const char* location, const char* decimation) {
    return doubts_of(good, std::string("[fragility]\nlevels = [1800, 2400]\nset = { \"material.clay.density\" = \"h\" "
                                       "}\ndistribution = \"gumbel\"\nlocation = ") +
                               location + "\ndecimation_height = " + decimation + "\n");
  };
  EXPECT_THAT(of("1900", "200"), IsEmpty());
  EXPECT_THAT(of("3000", "200"), ElementsAre("fragility.distribution: much of the load lies above the last level"));
  EXPECT_THAT(of("1000", "20"), ElementsAre("fragility.distribution: the load hardly reaches the first level"));
}

TEST(OddDistributions, LevelsThatHardlyDiffer)
{
  const auto doubts = [](std::vector<Real> levels) {
    Study study;
    study.settings.fragility = FragilityLoad{.levels = std::move(levels)};
    std::vector<Problem> found;
    doubt_distributions(study, found);
    return found;
  };
  EXPECT_THAT(doubts({3.0, 3.001, 4.0}),
      ElementsAre(told("fragility.levels", "two levels hardly differ", HasSubstr("Got 3 and 3.001."))));
  EXPECT_THAT(doubts({3.0, 3.1, 4.0}), IsEmpty());
}

TEST(OddDistributions, LayersThatGoAgainstEachOther)
{
  const auto doubts = [](const char* second, double value) {
    Study study;
    study.settings.correlations = {{"material.clay.su_peak", second, "correlation[0]", value}};
    std::vector<Problem> found;
    doubt_distributions(study, found);
    return found;
  };
  EXPECT_THAT(doubts("material.peat.su_peak", -0.5),
      ElementsAre(told("correlation[0].value",
          "`material.clay.su_peak` and `material.peat.su_peak` go against each other", HasSubstr("Got -0.5."))));
  EXPECT_THAT(doubts("material.peat.su_peak", 0.5), IsEmpty());
  EXPECT_THAT(doubts("material.clay.density", -0.5), IsEmpty());
}

}  // namespace odd_distributions_test
