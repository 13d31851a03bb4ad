// A study of cell sizes in words; the sentence on each quantity: mesh_study_test.cpp.
#include "io/results/sequences.hpp"
#include "support/test.hpp"

namespace mesh_study_text_test {

TEST(MeshStudyText, AmountsHaveThreeDigitsThatCount)
{
  const RunMeasure share = {.label = "share", .unit = "%", .digits = 1, .value = {}};
  EXPECT_EQ(text_of(share, 96.57), "96.6");
  EXPECT_EQ(text_of(share, 0.0123), "0.0123");
  EXPECT_EQ(text_of(share, 0.0), "0.0");
  EXPECT_EQ(text_of(share, std::nullopt), "-");
}

TEST(MeshStudyText, RemarksOnSizesThatAreTooNear)
{
  EXPECT_THAT(remarks_on({"", {}, runs_with({0.4, 0.22, 0.2}, {1.0, 2.0, 3.0})}),
      ElementsAre(
          "The cells of 0.22 m and 0.2 m are too near in size, ratio 1.1: below 1.3 an order is mostly noise."));
  EXPECT_THAT(remarks_on({"", {}, runs_with({0.8, 0.4, 0.2, 0.1}, {1.0, 2.0, 3.0, 4.0})}),
      ElementsAre("Order, limit and error are of the three smallest sizes."));
}

TEST(MeshStudyText, RemarksOnCellsThatCameOutInAnotherSize)
{
  auto runs = runs_with({1.0, 0.5, 0.25}, {1.0, 2.0, 3.0});
  runs[0].size = 0.866, runs[1].size = 0.49;
  EXPECT_THAT(remarks_on({"", {}, runs}), ElementsAre("The cells of 1 m came out as 0.866 m (root of their mean area), "
                                                      "which is what the formulas take."));
}

TEST(MeshStudyText, RemarksOnSoilThatAWallHolds)
{
  auto runs = runs_with({1.0, 0.5, 0.25}, {15.9, 15.99, 15.99});
  runs[1].results.summary.values.reached_sides = {{"right", 3.214, false}};
  EXPECT_THAT(remarks_on({"", {}, runs}),
      ElementsAre("On cells of 0.5 m soil came to the side `right` of the mesh by t = 3.21 s: what it does there is of "
                  "the side, which may hide that sizes differ."));
}

TEST(MeshStudyText, AnswersForAllQuantitiesInOneSentence)
{
  StudiedSequence s{{"as given", {}, runs_with({0.4, 0.2, 0.1}, {4.1, 3.5, 5.8})}, {}};
  s.quantities = {judged({0.4, 0.2, 0.1}, {4.1, 3.5, 5.8}), judged({0.4, 0.2, 0.1}, {1.0, 1.0, 1.0})};
  EXPECT_EQ(answer_of(s, 0.02), "Depends on the mesh: front. All else changes by less than 2.0 % or its resolution.");
  s.quantities.erase(s.quantities.begin());
  EXPECT_EQ(answer_of(s, 0.02),
      "Nothing that is measured changes by more than 2.0 % or its resolution between the last two sizes.");
  const MeshStudy study{.case_name = "c", .title = "t", .tolerance = 0.02, .sequences = {s}};
  EXPECT_THAT(study_text(study), AllOf(HasSubstr("as given, cells of 0.4, 0.2, 0.1 m\n"),
                                     ContainsRegex("front \\[m\\] +1.00 +1.00 +1.00 +0 % +- +- +-\n")));
}

}  // namespace mesh_study_text_test
