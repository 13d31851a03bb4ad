#include "model/bodies/drawn_columns.hpp"

#include "support/test.hpp"

#include <random>

namespace drawn_columns_test {

std::vector<Side> sides_of(const Polygon& polygon)
{
  std::vector<Side> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k) sides.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  return sides;
}

int body_at(const DrawnColumns& columns, Vec<2> x)
{
  int body = DrawnColumns::nothing;
  for (const DrawnLayer& layer : columns.at(x[0])) {
    if (!(height_at(layer.top, x[0]) > x[1])) break;
    body = layer.body;
  }
  return body;
}

TEST(DrawnColumns, TheLastOfTwoBodiesIsThereWhereTheyOverlap)
{
  const DrawnColumns columns({sides_of({{0, 0}, {4, 0}, {4, 2}, {0, 2}}), sides_of({{1, 1}, {3, 1}, {3, 3}, {1, 3}})});
  EXPECT_EQ(body_at(columns, {0.5, 1.5}), 0);
  EXPECT_EQ(body_at(columns, {2.0, 0.5}), 0);
  EXPECT_EQ(body_at(columns, {2.0, 1.5}), 1);
  EXPECT_EQ(body_at(columns, {2.0, 3.5}), DrawnColumns::nothing);
  EXPECT_TRUE(columns.at(-0.1).empty());
  EXPECT_TRUE(columns.at(4.0).empty());
  EXPECT_DOUBLE_EQ(height_at(columns.at(2.0).front().top, 2.0), 3.0);
}

TEST(DrawnColumns, AgreesWithTheOutlinesOfBodiesThatCrossEachOther)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> place(0.0, 10.0);
  std::vector<std::vector<Side>> bodies;
  for (int b = 0; b < 6; ++b) {
    Polygon polygon;  // a triangle crosses no side of its own
    for (int k = 0; k < 3; ++k) polygon.push_back({place(random), place(random)});
    bodies.push_back(sides_of(polygon));
  }
  const DrawnColumns columns(bodies);
  for (int k = 0; k < 5000; ++k) {
    const Vec<2> x{place(random), place(random)};
    int last = DrawnColumns::nothing;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (encloses(bodies[b], x)) last = static_cast<int>(b);
    ASSERT_EQ(body_at(columns, x), last) << x[0] << ", " << x[1];
  }
}

}  // namespace drawn_columns_test
