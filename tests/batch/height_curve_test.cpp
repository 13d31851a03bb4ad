#include "batch/height_curve.hpp"

#include "batch/samples.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_text.hpp"

#include <nlohmann/json.hpp>

namespace height_curve_test {

/// Realisations that slide, whose ground remains at these heights [m]; NaN: not known; the rest stands.
Realisations slides_that_leave(const Study& study, const std::vector<Real>& heights)
{
  Realisations rows = rows_without_runs(study, [](Real) { return 0.0; });
  for (auto& [number, r] : rows) {
    r.judges_flood = true;
    if (number >= std::ssize(heights)) continue;
    r.slid = true;
    r.outcomes[outcome_number("residual_height")] = heights[static_cast<std::size_t>(number)];
  }
  return rows;
}

TEST(HeightCurve, IsTheShareOfSlidesThatLeaveLessGround)
{
  const Study study = study_of(column_study);
  const auto curve = flood_after_slide_over_level(study, slides_that_leave(study, {3.0, 4.0, 3.5, 3.2, std::nan("")}));
  ASSERT_FALSE(curve.empty());
  for (const HeightPlace& at : curve) {
    const int below = (at.level > 3.0) + (at.level > 4.0) + (at.level > 3.5) + (at.level > 3.2);
    EXPECT_DOUBLE_EQ(at.event.probability().value(), below / 4.0) << at.level;
    EXPECT_DOUBLE_EQ(at.event.bounds.low, clopper_pearson(below, 5, 0.95).low) << "the unknown one stands";
    EXPECT_DOUBLE_EQ(at.event.bounds.high, clopper_pearson(below + 1, 5, 0.95).high) << "the unknown one floods";
  }
  EXPECT_LT(curve.front().level, 3.0);
  EXPECT_GT(curve.back().level, 4.0);
  EXPECT_THAT(height_curve_text(curve), MatchesRegex(".*: 0.1 at 3.0. m, 0.5 at 3.2. m, 0.9 at 4.0. m\n"));
  EXPECT_THAT(height_curve_csv(curve), StartsWith("level,P,low,high\n2.95,0,0,"));
}

TEST(HeightCurve, GoesFromTheSlidesOfALevelToThoseOfTheNext)
{
  const Study study = study_of(changed(column_study, "number = 12", "number = 2") + R"([fragility]
name = "level"
unit = "m"
levels = [2.0, 4.0]
[fragility.set]
"flood.water_level" = "h"
)");
  // Numbers 0 and 2 are samples of the first level, 1 and 3 of the second.
  const auto curve = flood_after_slide_over_level(study, slides_that_leave(study, {1.0, 3.5, 5.0, 3.5}));
  ASSERT_FALSE(curve.empty());
  EXPECT_EQ(curve.front().level, 2.0);
  EXPECT_EQ(curve.back().level, 4.0);
  for (const HeightPlace& at : curve) {
    const Real w = (at.level - 2.0) / 2.0, of_first = 0.5, of_second = at.level > 3.5 ? 1.0 : 0.0;
    EXPECT_NEAR(at.event.probability().value(), (1.0 - w) * of_first + w * of_second, 1e-14) << at.level;
  }
}

TEST(HeightCurve, IsInTheResultsOrNotThere)
{
  const Study study = study_of(column_study);
  const auto json = [&](const Realisations& rows) {
    return nlohmann::json::parse(study_json(study, rows))["flood_after_slide_over_level"];
  };
  const Realisations slides = slides_that_leave(study, {3.0, 4.0}), none = slides_that_leave(study, {});
  EXPECT_EQ(json(slides).size(), 61u);
  EXPECT_EQ(json(slides).back()[1], 1.0);
  EXPECT_EQ(json(none).size(), 0u);
  EXPECT_THAT(study_text(study, slides), HasSubstr("P(F|I) by the ground that slides leave"));
  EXPECT_THAT(study_text(study, none), Not(HasSubstr("by the ground")));
  const ScratchFolder folder;
  const auto there = [&](const Realisations& rows) {
    const StudyPlace place(folder.path(), "report");
    write_results(study, place, rows, "");
    return std::filesystem::exists(folder.path() + "/flood_after_slide.csv");
  };
  EXPECT_FALSE(there(none));
  EXPECT_TRUE(there(slides));
}

}  // namespace height_curve_test
