// Values as they arrive in the case; those that are refused: wrong_cases/small_case.wrong.
#include "io/case/values.hpp"
#include "io/case/samples.hpp"

namespace values_test {

TEST(Values, AVelocityMayBeAFormulaOfThePlace)
{
  const Case c = read_case_text(replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]",
                                    "box = [[0.0, 0.0], [8.0, 2.0]]\nvelocity = [\"3*x*y\", -2]"),
      "case.toml")
                     .values;
  ASSERT_TRUE(c.bodies[0].velocity_at);
  EXPECT_EQ(c.bodies[0].velocity_at({2.0, 0.5}), (Vec<2>{3.0, -2.0}));
}

TEST(Values, PolygonsAreTurnedCounterClockwise)
{
  const std::string text = replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]", "polygon = [[0, 0], [0, 1], [1, 0]]");
  const auto corners = read_case_text(text, "case.toml").values.bodies[0].polygon;
  EXPECT_THAT(corners, ElementsAre(Vec<2>{1, 0}, Vec<2>{0, 1}, Vec<2>{0, 0}));
}

TEST(Values, ABoxIsKeptAsFourCornersCounterClockwise)
{
  EXPECT_THAT(read_case_text(small_case, "case.toml").values.bodies[0].polygon,
      ElementsAre(Vec<2>{0, 0}, Vec<2>{8, 0}, Vec<2>{8, 2}, Vec<2>{0, 2}));
}

}  // namespace values_test
