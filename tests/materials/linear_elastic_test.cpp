#include "materials/elastic_constants.hpp"
#include "materials/probe.hpp"

namespace linear_elastic_test {

Probe soil() { return {*find_material("linear_elastic"), {2e6, 0.48}}; }

TEST(LinearElastic, BulkModulusOfThePaperIs49Point33Megapascal)  // reading R16
{
  EXPECT_NEAR(bulk_from_poisson(2e6, 0.48), 49.333e6, 0.001e6);
  EXPECT_DOUBLE_EQ(soil().law().bulk_modulus(), bulk_from_poisson(2e6, 0.48));
  EXPECT_DOUBLE_EQ(soil().law().shear_modulus(), 2e6);
}

TEST(LinearElastic, UniaxialStrainGivesThePWaveModulusAndTheSidePressure)
{
  auto point = soil();
  point.strain({{0.0, -1e-3, 0.0, 0.0}});
  const Real K = 148e6 / 3.0, G = 2e6;  // 2 G (1.48) / (3 x 0.04)
  EXPECT_NEAR(point.sigma[1], -(K + 4.0 / 3.0 * G) * 1e-3, 1e-9);
  EXPECT_NEAR(point.sigma[0], point.sigma[1] * 0.48 / 0.52, 1e-9) << "K0 = nu / (1 - nu)";
  EXPECT_EQ(point.sigma[2], point.sigma[0]);
  EXPECT_EQ(point.plastic_work, 0.0);
}

TEST(LinearElastic, ShearStressIsTwiceGTimesTheTensorialShear)
{
  auto point = soil();
  point.strain({{0.0, 0.0, 0.0, 0.25e-3}});
  EXPECT_DOUBLE_EQ(point.sigma[3], 1e3);
  EXPECT_EQ(point.sigma[0], 0.0);
}

TEST(LinearElastic, ComesBackWhenTheStrainDoes)
{
  auto point = soil();
  point.sigma = {{-4e4, -6e4, -5e4, 3e3}};
  point.strain({{1e-3, -2e-3, 5e-4, 1e-3}});
  point.strain({{-1e-3, 2e-3, -5e-4, -1e-3}});
  const Real expected[] = {-4e4, -6e4, -5e4, 3e3};
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(point.sigma[c], expected[c], 1e-10);
}

TEST(LinearElastic, NeverYields)
{
  auto point = soil();
  point.strain({{0.1, -0.1, 0.0, 0.0}});
  EXPECT_DOUBLE_EQ(point.sigma[0], 4e5);
}

TEST(LinearElastic, HasNoStateAndNothingToCheck)
{
  EXPECT_TRUE(find_material("linear_elastic")->state.empty());
  EXPECT_TRUE(find_material("linear_elastic")->check(std::vector<Real>{2e6, 0.48}).empty());
}

}  // namespace linear_elastic_test
