#include "import/dstability/river_level.hpp"

#include "math/errors.hpp"
#include "import/dstability/case_folder.hpp"
#include "river_dike.hpp"

namespace river_level_test {

/// The dike in so many stages, the first with a POP of 10 kPa.
StixProject dike(std::size_t n_stages)
{
  StixStage stage = river_dike();
  stage.state_points = {{.label = "SP", .layer = "clay", .place = {0.0, -2.0}, .preload = {.pop = {.value = 10e3}}}};
  std::vector<StixStage> stages(n_stages, stage);
  for (std::size_t k = 1; k < n_stages; ++k) stages[k].state_points.clear(), stages[k].label = "high";
  StixProject project = project_of(stages);
  StixCalculation c{.label = "Bishop", .method = "Bishop", .stage = n_stages - 1};
  c.result = StixResult{.name = "b", .factor_of_safety = 1.25};
  c.result->slip_plane = {{2, 3}, {10, -5}, {18, 0}};
  project.scenarios[0].calculations = {c};
  return project;
}

RiverLevel moved_to(Real level, const StixProject& project, std::size_t stage)
{
  return with_river_level(project, 0, stage, StixBasis::deterministic, level);
}

TEST(RiverLevel, IsThatOfTheLaterStageAndItsHistoryStays)
{
  const RiverLevel moved = moved_to(0.5, dike(2), 1);
  EXPECT_EQ(moved.stage, 1u);
  const auto& stages = moved.project.scenarios[0].stages;
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].water.head_lines[0].line[0], (Vec<2>{-20.0, 2.0}));
  EXPECT_EQ(stages[1].label, "high, river at 0.50 m");
  EXPECT_EQ(stages[1].water.head_lines[0].line[0], (Vec<2>{-20.0, 0.5}));
  // The river falls by 1.5 m of the 3 m that it stands over the land: an aquifer 2 m over it by 1 m, 1.5 m by 0.75 m.
  EXPECT_NEAR(stages[1].water.head_lines[1].line[0][1], 0.0, 1e-12);
  EXPECT_NEAR(stages[1].water.head_lines[1].line[1][1], -0.25, 1e-12);
  EXPECT_EQ(moved.sentence.en,
      "The river stands at 0.50 m instead of the 2.00 m of the file (--river). The heads in the ground move in "
      "proportion to their height over the phreatic line at the land's end (-1.00 m), as in a steady state. After a "
      "fast fall the pressures in the outer slope would be higher. Undrained strengths are those of this water.");
}

TEST(RiverLevel, OfAFirstStageIsAStageAfterItWithoutStatesOfItsOwn)
{
  const RiverLevel moved = moved_to(0.5, dike(1), 0);
  EXPECT_EQ(moved.stage, 1u);
  const auto& stages = moved.project.scenarios[0].stages;
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].state_points.size(), 1u);
  EXPECT_TRUE(stages[1].state_points.empty());
  // Lower water: the soil carries more than before, and no more than that beyond what it carried with its POP.
  const Vec<2> place{3.0, -2.0};
  const auto before = StixSection(moved.project, 0, 0, StixBasis::deterministic).at(place);
  const auto after = StixSection(moved.project, 0, 1, StixBasis::deterministic).at(place);
  EXPECT_GT(after->effective_stress, before->effective_stress);
  EXPECT_DOUBLE_EQ(after->yield_stress, std::max(before->yield_stress, after->effective_stress));
}

TEST(RiverLevel, LeavesStoredPlanesWithoutFactorsOfAnotherWater)
{
  const RiverLevel moved = moved_to(3.0, dike(2), 1);
  const StixCalculation& c = moved.project.scenarios[0].calculations[0];
  EXPECT_EQ(c.label, "Bishop (river at 2.00 m, factor 1.2500)");
  EXPECT_TRUE(std::isnan(c.result->factor_of_safety));
  EXPECT_EQ(c.result->slip_plane.size(), 3u);
  EXPECT_EQ(moved_to(3.0, dike(1), 0).project.scenarios[0].calculations[0].stage, 1u);
}

TEST(RiverLevel, OfTheFileChangesNothing)
{
  for (const std::size_t stage : {0u, 1u}) {
    const RiverLevel moved = moved_to(2.004, dike(2), stage);
    EXPECT_EQ(moved.stage, stage);
    EXPECT_EQ(moved.sentence.en, "The river stands at 2.00 m in the file already: --river changes nothing.");
    EXPECT_EQ(moved.project.scenarios[0].stages.size(), 2u);
    EXPECT_EQ(moved.project.scenarios[0].stages[1].label, "high");
    EXPECT_EQ(moved.project.scenarios[0].calculations[0].result->factor_of_safety, 1.25);
  }
  EXPECT_NE(moved_to(2.006, dike(2), 1).project.scenarios[0].stages[1].label, "high");
}

TEST(RiverLevel, NeedsARiverAndGroundThatHoldsIt)
{
  EXPECT_THAT(refusal<InputError>([] { moved_to(4.5, dike(2), 1); }), HasSubstr("would flood the whole section"));
  EXPECT_THAT(refusal<InputError>([] { moved_to(-50.0, dike(2), 1); }),
      HasSubstr("no river stands at -50.00 m: the lowest ground of the section is at 0.00 m"));
  EXPECT_THAT(refusal<InputError>([] { moved_to(-0.02, dike(1), 0); }), HasSubstr("no river stands at -0.02 m"));
  StixProject none = dike(1);
  none.scenarios[0].stages[0].water.head_lines[0].line = {{0.0, -2.0}};
  EXPECT_THAT(refusal<InputError>([&] { moved_to(1.0, none, 0); }),
      HasSubstr("there is no river whose level could be changed"));
}

}  // namespace river_level_test
