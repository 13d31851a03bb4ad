#include "verify/series.hpp"
#include "support/test.hpp"

namespace series_test {

/// A sine of this period [s], from 0 to 4 s.
Series wave(Real period)
{
  Series s;
  for (int k = 0; k <= 400; ++k) {
    s.time.push_back(0.01 * k);
    s.value.push_back(3.0 * std::sin(2.0 * std::numbers::pi * (s.time.back() - 0.1) / period));
  }
  return s;
}

TEST(Series, ThePeriodIsTheMeanTimeBetweenUpwardCrossings)
{
  EXPECT_NEAR(period_of(wave(0.7)), 0.7, 1e-4);
  EXPECT_TRUE(std::isnan(period_of(wave(10.0))));
}

TEST(Series, TheArrivalIsInterpolatedAndLooksAtTheMagnitude)
{
  const Series s{.time = {0.0, 1.0, 2.0}, .value = {0.0, -1.0, -5.0}, .reference = {}};
  EXPECT_DOUBLE_EQ(arrival_of(s, 2.0), 1.25);
  EXPECT_TRUE(std::isnan(arrival_of(s, 6.0)));
  EXPECT_DOUBLE_EQ(arrival_of(s, 0.0), 0.0);
}

TEST(Series, AValueIsLinearBetweenSamplesAndNoneOutside)
{
  const Series s{.time = {0.0, 1.0, 3.0}, .value = {2.0, 4.0, 0.0}, .reference = {}};
  EXPECT_DOUBLE_EQ(value_at(s, 0.25), 2.5);
  EXPECT_DOUBLE_EQ(value_at(s, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(value_at(s, 3.0), 0.0);
  EXPECT_TRUE(std::isnan(value_at(s, 3.1)));
}

TEST(Series, ACutKeepsItsEnds)
{
  const Series part =
      cut({.time = {0.0, 1.0, 2.0, 3.0}, .value = {5.0, 6.0, 7.0, 8.0}, .reference = {1.0, 2.0, 3.0, 4.0}}, 1.0, 2.0);
  EXPECT_THAT(part.value, ElementsAre(6.0, 7.0));
  EXPECT_THAT(part.reference, ElementsAre(2.0, 3.0));
}

TEST(Series, ErrorsAreMeasuredInTheScale)
{
  const std::vector<Real> value{1.0, 2.0, 3.0}, reference{1.0, 5.0, -1.0};
  EXPECT_DOUBLE_EQ(reduce_values(value, reference, Reduce::max_error, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(reduce_values(value, reference, Reduce::rms_error, 2.0), std::sqrt((2.25 + 4.0) / 3.0));
  EXPECT_DOUBLE_EQ(reduce_values(value, {}, Reduce::mean, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(reduce_values(value, {}, Reduce::sum, 2.0), 6.0);
  EXPECT_DOUBLE_EQ(reduce_values(value, {}, Reduce::min, 2.0), 1.0);
}

TEST(Series, ANumberThatIsNoneSpoilsTheError)
{
  EXPECT_TRUE(std::isnan(reduce_values({1.0, NAN, 3.0}, {1.0, 2.0, 9.0}, Reduce::rms_error, 1.0)));
  EXPECT_TRUE(std::isnan(reduce_values({NAN, 2.0}, {1.0, 2.0}, Reduce::max_error, 1.0)));
}

}  // namespace series_test
