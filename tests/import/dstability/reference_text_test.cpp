#include "import/dstability/reference_text.hpp"

#include "sections.hpp"

namespace reference_text_test {

StixProject with_plane(const StixLine& plane)
{
  StixProject project = listed_project();
  project.scenarios[0].calculations[0].result->slip_plane = plane;
  return project;
}

TEST(ReferenceText, HasTheSlipPlanesOfTheStage)
{
  const auto tables = reference_texts(with_plane({{2, 0}, {10, -5}, {18, 0}}), 0, 0, StixBasis::deterministic);
  ASSERT_EQ(tables.size(), 1u);  // the other calculation has no result
  EXPECT_EQ(tables[0].header, "[[reference.slip_planes]]");
  const auto& lines = tables[0].lines;
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].value, "\"Bishop \xC3\xA9\xC3\xA9n\"");
  EXPECT_EQ(lines[1].value, "\"Bishop\"");
  EXPECT_EQ(lines[2].value, "1.2346");
  EXPECT_EQ(lines[3].value, "[[2.0, 0.0], [10.0, -5.0], [18.0, 0.0]]");
}

TEST(ReferenceText, LeavesOutWhatHasNoPlaceOrFactor)
{
  EXPECT_TRUE(reference_texts(with_plane({{2, 0}}), 0, 0, StixBasis::deterministic).empty());
  StixProject project = with_plane({{2, 0}, {18, 0}});
  EXPECT_TRUE(reference_texts(project, 0, 1, StixBasis::deterministic).empty());  // of another stage
  project.scenarios[0].calculations[0].result->factor_of_safety = not_given;
  EXPECT_EQ(reference_texts(project, 0, 0, StixBasis::deterministic)[0].lines.size(), 3u);
}

TEST(ReferenceText, LeavesOutAFactorOfOtherStrengths)
{
  StixProject project = with_plane({{2, 0}, {18, 0}});
  project.scenarios[0].calculations[0].kind = StixCalculationKind::design;
  const auto lines = reference_texts(project, 0, 0, StixBasis::deterministic)[0].lines;
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_THAT(lines[0].value, HasSubstr(" (design strengths)"));
  EXPECT_EQ(lines[1].comment, "factor 1.2346 with its design strengths");
  EXPECT_EQ(reference_texts(project, 0, 0, StixBasis::design)[0].lines[2].value, "1.2346");
}

TEST(ReferenceText, HasTheStrengthAtTheSlicesOfTheSameBasis)
{
  StixProject project = with_plane({{2, 0}, {18, 0}});
  StixCalculation& calculation = project.scenarios[0].calculations[0];
  StixSlice slice{.bottom_left = {9.0, -4.0}, .bottom_right = {11.0, -4.0}};
  slice.total_stress = 15e3 + 3.0 * 16e3;
  slice.su = 12345.4;
  calculation.result->slices = {slice, slice};
  calculation.result->slices[1].su = 0.0;  // drained
  const auto tables = reference_texts(project, 0, 0, basis_of(calculation.kind));
  ASSERT_EQ(tables[0].lines.size(), 5u);
  EXPECT_EQ(tables[0].lines[4].key, "su");
  EXPECT_EQ(tables[0].lines[4].value, "[[10.0, -4.0, 12345.0]]");
  EXPECT_EQ(reference_texts(project, 0, 0, StixBasis::mean)[0].lines.size(), 3u);
  EXPECT_THAT(
      slices_in_words(project, 0, 0), ElementsAre(HasSubstr("2 slices: largest differences: total stress 0.000")));
  calculation.result->slices[0].total_stress += 5e3;
  EXPECT_EQ(reference_texts(project, 0, 0, basis_of(calculation.kind))[0].lines.size(), 4u);
  EXPECT_THAT(slices_in_words(project, 0, 0), ElementsAre(HasSubstr("other section")));
}

TEST(ReferenceText, SaysThatAPlaneIsOfAnotherSection)
{
  StixProject project = with_plane({{2, 0}, {18, 0}});
  StixSlice slice{.bottom_left = {9.0, -4.0}, .bottom_right = {11.0, -4.0}};
  slice.total_stress = 15e3 + 3.0 * 16e3;  // of the section
  project.scenarios[0].calculations[0].result->slices = {slice};
  EXPECT_THAT(reference_texts(project, 0, 0, StixBasis::deterministic)[0].lines[0].value, Not(HasSubstr("section")));
  project.scenarios[0].calculations[0].result->slices[0].total_stress += 5e3;
  EXPECT_THAT(
      reference_texts(project, 0, 0, StixBasis::deterministic)[0].lines[0].value, HasSubstr("(of another section)"));
}

}  // namespace reference_text_test
