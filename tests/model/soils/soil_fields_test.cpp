// Kinds of fields, by hand: a column of 4 m of soil of 2000 kg/m^3 with the water table 1 m below the ground.
#include "model/soils/soil_fields.hpp"
#include "model/soils/overburden.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"

namespace soil_fields_test {

constexpr Real g = 9.81, water = 9810.0;

Case wet_column()
{
  Case c = column("mpm_gp");
  c.mesh.size = {8.0, 5.0};
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 4.0})};
  c.materials[0].density = 2000.0;
  c.forces.gravity = {0.0, -g};
  c.water.start.phreatic_line = {{0.0, 3.0}};
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 6.0}}}};
  return c;
}

class SoilFields : public testing::Test {
 protected:
  SoilFields() : model_(build_model(wet_column(), 1)), ground_(model_) {}
  Real at(const FieldValue& value, Real y) const { return value({{2.5, y}, &ground_}); }
  static FieldValue number(Real value)
  {
    return [value](const PlaceInSoil&) { return value; };
  }

  Model model_;
  Overburden ground_;
};

TEST_F(SoilFields, DepthIsBelowTheGroundAndElevationIsY)
{
  const std::vector<Vec<2>> line{{1.0, 10e3}, {2.0, 14e3}, {2.0, 20e3}, {3.0, 21e3}};
  const FieldValue depth = by_depth(line), elevation = by_elevation(line);
  EXPECT_DOUBLE_EQ(at(depth, 2.75), 11e3);
  EXPECT_DOUBLE_EQ(at(depth, 1.5), 20.5e3);
  EXPECT_DOUBLE_EQ(at(depth, 3.9), 10e3) << "constant above";
  EXPECT_DOUBLE_EQ(at(depth, 0.1), 21e3) << "constant below";
  EXPECT_DOUBLE_EQ(at(elevation, 1.25), 11e3);
  EXPECT_TRUE(std::isnan(depth({{60.0, 1.0}, &ground_}))) << "no soil there";
}

TEST_F(SoilFields, ATableFollowsTheEffectiveStressOfItsWater)
{
  const Real stress = 2000.0 * g * 3.0 - water * 2.0, high = 2000.0 * g * 3.0 - water * 3.0;  // free water cancels
  const std::vector<Vec<2>> line{{0.0, 1e3}, {100e3, 21e3}};
  EXPECT_NEAR(at(by_stress(line, ""), 1.0), 1e3 + 0.2 * stress, 1e-9);
  EXPECT_NEAR(at(by_stress(line, "high"), 1.0), 1e3 + 0.2 * high, 1e-9);
}

TEST_F(SoilFields, ShansepTakesSigmaPOfDailyWaterAndSigmaVOfTheAnalysedOne)
{
  const Real daily = 2000.0 * g * 3.0 - water * 2.0, high = 2000.0 * g * 3.0 - water * 3.0;
  Shansep soil{.S = number(0.23), .m = number(0.9), .pop = number(15e3)};
  EXPECT_NEAR(at(by_shansep(soil), 1.0), 0.23 * daily * std::pow((daily + 15e3) / daily, 0.9), 1e-9);
  soil.water = "high";
  EXPECT_NEAR(at(by_shansep(soil), 1.0), 0.23 * high * std::pow((daily + 15e3) / high, 0.9), 1e-9);
  soil.pop = {};
  soil.ocr = number(1.8);
  EXPECT_NEAR(at(by_shansep(soil), 1.0), 0.23 * high * std::pow(1.8 * daily / high, 0.9), 1e-9);
  soil.ocr = {};
  soil.yield_stress = number(70e3);
  EXPECT_NEAR(at(by_shansep(soil), 1.0), 0.23 * high * std::pow(70e3 / high, 0.9), 1e-9);
  soil.pop = number(5e3);
  EXPECT_NEAR(at(by_shansep(soil), 1.0), 0.23 * high * std::pow(75e3 / high, 0.9), 1e-9) << "added to it";
  soil.minimum = number(40e3);
  EXPECT_EQ(at(by_shansep(soil), 1.0), 40e3);
}

TEST_F(SoilFields, ShansepIsZeroWhereNothingWeighsAndWhatItIsMadeOfMayVary)
{
  const Shansep soil{.S = number(0.3), .m = by_elevation({{0.0, 0.8}, {4.0, 1.0}}), .pop = number(0.0)};
  EXPECT_EQ(at(by_shansep(soil), 4.0), 0.0);
  EXPECT_NEAR(at(by_shansep(soil), 3.0), 0.3 * 2000.0 * g, 1e-9);
  EXPECT_TRUE(std::isnan(at(within(between(0.85, 1.0), soil.m), 0.5)));
  EXPECT_DOUBLE_EQ(at(within(between(0.85, 1.0), soil.m), 2.0), 0.9);
}

}  // namespace soil_fields_test
