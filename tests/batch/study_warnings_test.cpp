#include "batch/study_warnings.hpp"

#include "batch/samples.hpp"
#include "batch/study_folder.hpp"
#include "support/problems.hpp"

namespace study_warnings_test {

std::vector<std::string> told_of(const std::string& text)
{
  const ScratchFolder folder;
  const Study study = open_study(write_study(folder.path(), text));
  std::vector<std::string> all;
  for (const Problem& problem : find_warnings_of_cases(study, find_doubts(study)).drawn)
    all.push_back(problem.key + ": " + problem.what);
  return all;
}

std::string on_column(const char* instead_of_random)
{
  const std::size_t begin = column_study.find("[[random]]"), end = column_study.find("[estimator]");
  return column_study.substr(0, begin) + instead_of_random + column_study.substr(end);
}

TEST(StudyWarnings, AreNoneOfASoundStudy) { EXPECT_THAT(told_of(column_study), IsEmpty()); }

TEST(StudyWarnings, OfAMeanInAnotherUnitComeOnceWithTheQuantile)
{
  const auto told = told_of(on_column(
      "[[random]]\nkey = \"material.clay.density\"\ndistribution = \"lognormal\"\nmean = 19.9\ncov = 0.05\n"));
  const auto unusual = [](const std::string& text) { return text.find("is unusual") != std::string::npos; };
  EXPECT_EQ(std::ranges::count_if(told, unusual), 1);
  EXPECT_THAT(told, Contains("random[0].key: with `material.clay.density` = 19.8752 (50 %): `density` = 19.8752 kg/m^3 "
                             "is unusual"));
}

TEST(StudyWarnings, OfATailAloneNameItsQuantile)
{
  const auto told = told_of(on_column(
      "[[random]]\nkey = \"material.clay.poisson_ratio\"\ndistribution = \"uniform\"\nlowest = 0.1\nhighest = "
      "0.49\n"));
  EXPECT_THAT(told, Contains(HasSubstr("random[0].key: with `material.clay.poisson_ratio` = 0.295 (50 %): ")));
}

TEST(StudyWarnings, OfSweepsAndLoadsNameTheValue)
{
  const std::string sweep =
      "case = \"column.toml\"\n[[sweep]]\nkey = \"material.clay.density\"\nvalues = [1900, 19]\n"
      "[estimator]\nkind = \"sweep\"\n";
  EXPECT_THAT(
      told_of(sweep), Contains(StartsWith("sweep[0].values[1]: with `material.clay.density` = 19: `density` = 19")));
  const std::string load = on_column(
      "[fragility]\nlevels = [1800, 19000]\nset = { \"material.clay.density\" = \"h\" }\n[[random]]\nkey = "
      "\"material.clay.su_peak\"\ndistribution = \"lognormal\"\nmean = \"8 kPa\"\ncov = 0.4\n");
  EXPECT_THAT(told_of(load), Contains(HasSubstr("fragility.levels[1]: with h = 19000: `density` = 19000")));
}

TEST(StudyWarnings, OfALoadThatMovesTheWaterAndNotTheRiver)
{
  const auto told = [](const std::string& place, const std::string& more = "") {
    const ScratchFolder folder;
    const std::string wet = column_case + "[flood]\n[water]\nphreatic_line = [[0.0, 2.1], [1.0, 2.1], [4.0, 0.2]]\n" +
                            more +
                            "[[water.situation]]\nname = "
                            "\"high\"\ntime = 0.5\nphreatic_line = [[0.0, 2.2], [1.0, 2.2], [4.0, 0.2]]\n";
    const Study study = open_study(write_study(folder.path(),
        on_column(("[fragility]\nlevels = [2.2, 2.4]\nset = { \"water.situation[0].phreatic_line\" = [[0.0, " + place +
                   "], [1.0, " + place +
                   "], [4.0, \"h/10\"]] }\n[[random]]\nkey = \"material.clay.su_peak\"\ndistribution = "
                   "\"lognormal\"\nmean = \"8 kPa\"\ncov = 0.4\n")
                      .c_str()),
        wet));
    std::vector<std::string> all;
    for (const Problem& problem : find_warnings_of_cases(study, find_doubts(study)).drawn) all.push_back(problem.what);
    return all;
  };
  EXPECT_THAT(told("2.3"), Contains("the river stands at one level, whatever the load"));
  const std::string heads =
      "head_lines = { deep = [[0.0, 1.0]] }\nreference_lines = [{ line = [[0.0, 0.5]], head = \"deep\" }]\n";
  EXPECT_THAT(told("\"h\"", heads), Contains("the river follows the load, and the heads of the layers do not"));
  EXPECT_THAT(told("\"h\""), Not(Contains("the river follows the load, and the heads of the layers do not")));
  EXPECT_THAT(told("\"h\""), Not(Contains("the river stands at one level, whatever the load")));
}

}  // namespace study_warnings_test
