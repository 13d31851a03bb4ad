#include "batch/points.hpp"

#include "batch/samples.hpp"
#include "batch/study.hpp"

#include <fmt/format.h>

namespace points_test {

StudySettings settings_of(const std::string& kind, Index n, int seed = 3)
{
  const std::string text =
      changed(changed(column_study, "monte_carlo", kind), "number = 12", fmt::format("number = {}", n));
  return read_study_text(changed(text, "seed = 3", fmt::format("seed = {}", seed)) + R"([[random]]
key = "material.clay.eta"
distribution = "uniform"
lowest = 2.0
highest = 8.0
)",
      "demo.toml");
}

// The first two coordinates are a (0, 2)-sequence in base 2: of 2^m points each box of 2^-a x 2^-(m - a) has one.
TEST(Points, SobolPointsHaveOneInEachBox)
{
  constexpr int m = 6, n = 1 << m;
  for (const int seed : {3, 4}) {
    const auto points = make_points(settings_of("sobol", n, seed));
    ASSERT_EQ(points.size(), 2u);
    for (int a = 0; a <= m; ++a) {
      std::set<std::pair<int, int>> boxes;
      for (std::size_t k = 0; k < n; ++k)
        boxes.insert({static_cast<int>(points[0][k] * (1 << a)), static_cast<int>(points[1][k] * (1 << (m - a)))});
      EXPECT_EQ(boxes.size(), static_cast<std::size_t>(n)) << "seed " << seed << ", " << (1 << a) << " columns";
    }
  }
  EXPECT_NE(make_points(settings_of("sobol", n, 3))[0], make_points(settings_of("sobol", n, 4))[0]);
  const auto few = make_points(settings_of("sobol", 16)), many = make_points(settings_of("sobol", 64));
  for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(few[1][k], many[1][k]) << "a larger number goes on";
}

TEST(Points, AShiftMakesEachPointUniform)
{
  Real sum = 0.0, squares = 0.0;
  constexpr int n = 2000;
  for (int seed = 0; seed < n; ++seed) {
    const Real u = make_points(settings_of("sobol", 4, seed))[1][2];
    EXPECT_GT(u, 0.0);
    EXPECT_LT(u, 1.0);
    sum += u, squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 4.0 * std::sqrt(4.0 / 45.0 / n));
}

TEST(Points, ANumberThatIsNoPowerOfTwoIsDoubted)
{
  const std::string sobol = changed(column_study, "monte_carlo", "sobol");
  const auto doubts = [&](const char* number) { return find_doubts(study_of(changed(sobol, "number = 12", number))); };
  EXPECT_TRUE(doubts("number = 16").empty());
  ASSERT_EQ(doubts("number = 12").size(), 1u);
  EXPECT_EQ(doubts("number = 12")[0].what, "Sobol points are even in powers of two");
  EXPECT_EQ(doubts("number = 12")[0].detail, "Got 12. Take 8 or 16.");
}

}  // namespace points_test
