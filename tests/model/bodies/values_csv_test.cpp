#include "model/bodies/values_csv.hpp"
#include "support/test.hpp"

namespace values_csv_test {

std::string message_for(const std::string& text)
{
  return refusal<CsvError>([&] { read_values_csv_text("su.csv", text); });
}

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

TEST(ValuesCsv, NameTheLinesOfTheirFaults)
{
  EXPECT_THAT(message_for("x,y,value\n1,2,3\n1,2,4\n2,2\n3,x,5\n"),
      AllOf(StartsWith("the table of values has 3 faults:\n"),
          HasSubstr("su.csv:3: the place (1, 2) m is in line 2 too\n"),
          HasSubstr("su.csv:4: 2 values, and 3 columns\n"), HasSubstr("su.csv:5: y is `x`, which is not a number\n"),
          EndsWith("It has the columns x, y, value: m, m, and the unit of the key in SI.")));
  EXPECT_THAT(message_for("x;y;value\n"), HasSubstr("the values are separated by semicolons"));
  EXPECT_THAT(message_for("x,y,su\n"), HasSubstr("no column `value`"));
  EXPECT_THAT(message_for("0,1,8.5\n"),
      AllOf(HasSubstr("has 1 fault:"),
          HasSubstr("su.csv:1: the first row holds numbers; above it stand the names of the columns: x,y,value\n")));
  using namespace std::string_literals;
  EXPECT_THAT(message_for("\xFF\xFEx\0,\0y\0"s),
      AllOf(HasSubstr("has 1 fault:"), HasSubstr("more likely in UTF-16: save it as CSV in UTF-8\n")));
  EXPECT_THAT(message_for("x,y,value\n0,5,1,5,8,5\n0,5,2,5,8,5\n"), HasSubstr("has 1 fault:"));
  EXPECT_THAT(message_for("x,y,value\n0,5,1,5,8,5\n"), HasSubstr("numbers have a decimal point, no comma"));
}

}  // namespace values_csv_test
