#include "model/bodies/values_csv.hpp"
#include "support/test.hpp"

namespace values_csv_test {

TEST(ValuesCsv, AreBilinearOnAGridInAnyOrderAndConstantBeyondIt)
{
  // 1000 + 100 x + 10 y + x y on x = 0, 2, 6 and y = -1, 1
  const ValueMap map =
      read_values_csv_text("su.csv", "y,x,value\n1,6,1616\n-1,0,990\n-1,2,1188\n1,0,1010\n1,2,1212\n-1,6,1584\n");
  EXPECT_TRUE(map.is_grid());
  EXPECT_DOUBLE_EQ(map.at({1.0, 0.5}), 1105.5);
  EXPECT_DOUBLE_EQ(map.at({4.0, -0.5}), 1393.0);
  EXPECT_EQ(map.at({6.0, 1.0}), 1616.0);
  EXPECT_EQ(map.at({9.0, 5.0}), 1616.0);
  EXPECT_EQ(map.at({-3.0, -9.0}), 990.0);
  EXPECT_EQ(map.low(), (Vec<2>{0.0, -1.0}));
  EXPECT_EQ(map.high(), (Vec<2>{6.0, 1.0}));
}

TEST(ValuesCsv, OfABoringHoldAlongX)
{
  const ValueMap map = read_values_csv_text("su.csv", "x,y,value\n5,0,20\n5,4,10\n");
  EXPECT_TRUE(map.is_grid());
  EXPECT_EQ(map.at({-80.0, 1.0}), 17.5);
  EXPECT_EQ(map.at({90.0, 5.0}), 10.0);
  EXPECT_TRUE(std::isinf(map.low()[0]));
  EXPECT_EQ(map.high()[1], 4.0);
}

TEST(ValuesCsv, OfAGridTellWhichLiesFarOffAllBesideIt)
{
  const auto at = [](const std::string& middle) {
    return read_values_csv_text("su.csv", "x,y,value\n5,0,8e3\n5,1," + middle + "\n5,2,9e3\n").find_far_off();
  };
  ASSERT_TRUE(at("9"));
  EXPECT_EQ(at("9")->x[1], 1.0);
  EXPECT_TRUE(at("72e3"));
  EXPECT_FALSE(at("70e3"));
  EXPECT_FALSE(at("-1"));
}

TEST(ValuesCsv, AlongALineHoldAtAllHeights)
{
  const ValueMap map = read_values_csv_text("su.csv", "x,y,value\n0,-3,20\n4,-3,10\n");
  EXPECT_EQ(map.at({1.0, 50.0}), 17.5);
}

TEST(ValuesCsv, AreWeightedByTheInverseSquareOfTheDistanceElsewhere)
{
  const ValueMap map = read_values_csv_text("su.csv", "x,y,value\n0,0,10\n3,0,40\n0,9,70\n");
  EXPECT_FALSE(map.is_grid());
  EXPECT_EQ(map.at({3.0, 0.0}), 40.0);
  EXPECT_NEAR(map.at({1.0, 0.0}), (10.0 + 40.0 / 4.0 + 70.0 / 82.0) / (1.0 + 1.0 / 4.0 + 1.0 / 82.0), 1e-12);
}

TEST(ValuesCsv, AreThoseOfTheEightNearestPlaces)
{
  std::vector<PlacedValue> values{{{50.0, 0.0}, 1e6}};
  for (int k = 0; k < 8; ++k) values.push_back({{1.0 * k, 0.1 * k * k}, 7.0});
  EXPECT_DOUBLE_EQ(ValueMap(values).at({3.3, 0.2}), 7.0);
}

}  // namespace values_csv_test
