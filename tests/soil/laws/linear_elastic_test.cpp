#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/probe.hpp"

namespace linear_elastic_test {

Probe soil() { return {*find_material("linear_elastic"), {2e6, 0.48}}; }

TEST(LinearElastic, BulkModulusOfThePaperIs49Point33Megapascal)  // reading R16
{
  EXPECT_NEAR(bulk_from_poisson(2e6, 0.48), 49.333e6, 0.001e6);
  EXPECT_DOUBLE_EQ(soil().law().bulk_modulus(), bulk_from_poisson(2e6, 0.48));
  EXPECT_DOUBLE_EQ(soil().law().shear_modulus(), 2e6);
}

TEST(LinearElastic, NeverYieldsAndComesBackWhenTheStrainDoes)
{
  auto point = soil();
  point.sigma = {{-4e4, -6e4, -5e4, 3e3}};
  point.strain({{0.1, -0.1, 0.0, 0.02}});
  EXPECT_DOUBLE_EQ(point.sigma[0], 4e5 - 4e4);
  EXPECT_DOUBLE_EQ(point.sigma[3], 8e4 + 3e3);
  EXPECT_EQ(point.plastic_work, 0.0);
  point.strain({{-0.1, 0.1, 0.0, -0.02}});
  const Real expected[] = {-4e4, -6e4, -5e4, 3e3};
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(point.sigma[c], expected[c], 1e-10);
  EXPECT_TRUE(point.state.empty());
}

}  // namespace linear_elastic_test
