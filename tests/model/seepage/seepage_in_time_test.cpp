#include "model/seepage/seepage_in_time.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"

namespace seepage_in_time_test {

LevelWave wave() { return {{"river", "aquifer"}, {0.0, 3600.0, 10800.0}, {{1.0, 0.5}, {3.0, 1.0}, {1.0, 0.5}}}; }

SeepageCase conditions()
{
  SeepageCase of;
  of.river = RiverCase{SectionSide::left, 9.0};
  of.boundary = {{"aquifer", SectionSide::left, -8.0, -6.0, {{0.0, 9.0}}, 0.0}};
  return of;
}

TEST(SeepageInTime, LevelsRunLinearlyBetweenTheTimesOfTheWave)
{
  EXPECT_EQ(conditions_at(conditions(), wave(), 1800.0).river->level, 2.0);
  EXPECT_EQ(conditions_at(conditions(), wave(), 1800.0).boundary[0].head[0][1], 0.75);
  EXPECT_EQ(conditions_at(conditions(), wave(), 1e9).river->level, 1.0);
  EXPECT_EQ(conditions_at(conditions(), wave(), 3600.0).river->level, 3.0);
}

TEST(SeepageInTime, RowsAtOtherTimesHaveTheLevelsOfTheWave)
{
  const LevelWave more = with_times(wave(), {1800.0, 3600.0});
  EXPECT_THAT(more.times, ElementsAre(0.0, 1800.0, 3600.0, 10800.0));
  EXPECT_THAT(more.levels[1], ElementsAre(2.0, 0.75));
}

TEST(SeepageInTime, StepsEndAtTheTimesOfTheWave)
{
  EXPECT_THAT(times_of_steps(wave(), 3000.0), ElementsAre(0.0, 1800.0, 3600.0, 6000.0, 8400.0, 10800.0));
}

TEST(SeepageInTime, ALevelThatTheCaseDoesNotHaveIsRefused)
{
  LevelWave other = wave();
  other.names[1] = "aquifr";
  EXPECT_THAT(test::refusal<InputError>([&] { conditions_at(conditions(), other, 0.0); }),
      AllOf(HasSubstr("no level `aquifr`"), HasSubstr("Did you mean `aquifer`")));
}

}  // namespace seepage_in_time_test
