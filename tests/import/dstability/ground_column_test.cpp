#include "model/bodies/polygon.hpp"
#include "sections.hpp"

#include <random>

namespace ground_column_test {

TEST(GroundColumn, GivesTheLayersFromTheTopDown)
{
  const auto bands = soil_bands(clay_on_sand(), 7.0);
  ASSERT_THAT(bands, SizeIs(2));
  EXPECT_EQ(bands[0].top, 0.0);
  EXPECT_EQ(bands[0].bottom, -6.0);
  EXPECT_EQ(bands[0].layer, 0U);
  EXPECT_EQ(bands[1].bottom, -10.0);
  EXPECT_EQ(bands[1].layer, 1U);
}

TEST(GroundColumn, LetsTheInnerOfNestedLayersHoldInAnyOrder)
{
  for (const bool inner_first : {false, true}) {
    StixStage stage = clay_on_sand();
    const StixLayer lens = box_layer("lens", {5.0, -4.0}, {10.0, -2.0}, 0);
    stage.layers.insert(inner_first ? stage.layers.begin() : stage.layers.end(), lens);
    const auto bands = soil_bands(stage, 6.0);
    ASSERT_THAT(bands, SizeIs(4));
    EXPECT_EQ(stage.layers[bands[1].layer].id, "lens");
    EXPECT_EQ(bands[1].top, -2.0);
    EXPECT_EQ(bands[2].top, -4.0);
    EXPECT_EQ(stage.layers[bands[2].layer].id, "clay");
    EXPECT_THAT(soil_bands(stage, 11.0), SizeIs(2));
  }
}

TEST(GroundColumn, TakesAwayWhatAnExcavationRemovesBetweenItsEnds)
{
  StixStage stage = clay_on_sand();
  stage.excavations = {{{4.0, 0.0}, {6.0, -2.0}, {6.0, -3.0}, {8.0, -7.0}, {8.0, 0.0}}};
  EXPECT_EQ(soil_bands(stage, 5.0).front().top, -1.0);
  EXPECT_EQ(soil_bands(stage, 7.0).front().top, -5.0);
  const auto deep = soil_bands(stage, 7.75);  // below the clay
  ASSERT_THAT(deep, SizeIs(1));
  EXPECT_EQ(deep[0].top, -6.5);
  EXPECT_EQ(soil_bands(stage, 3.9).front().top, 0.0);
  EXPECT_EQ(soil_bands(stage, 8.1).front().top, 0.0);
}

TEST(GroundColumn, AgreesWithTheOutlinesAtRandomPlaces)
{
  std::mt19937 random(7);
  const auto real = [&](Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(random); };
  for (int section = 0; section < 50; ++section) {
    StixStage stage;
    stage.layers = {box_layer("all", {-10.0, -10.0}, {10.0, 10.0}, 0)};
    for (int n = 0; n < 4; ++n) {  // stars about the middle, each inside the one before
      StixLayer star{.id = std::to_string(n), .label = "", .outline = {}, .soil = 1};
      const Real largest = 8.0 / (1 << n);
      for (int k = 0; k < 12; ++k) {
        const Real angle = std::numbers::pi * k / 6.0, r = real(0.55, 0.95) * largest;
        star.outline.push_back({r * std::cos(angle), r * std::sin(angle)});
      }
      stage.layers.insert(stage.layers.begin() + static_cast<int>(random() % stage.layers.size()), star);
    }
    for (int k = 0; k < 20; ++k) {
      const Vec<2> place{real(-10.0, 10.0), real(-10.0, 10.0)};
      const StixLayer* expected = nullptr;
      for (const StixLayer& layer : stage.layers)
        if (contains(layer.outline, place) &&
            (expected == nullptr || std::abs(signed_area(layer.outline)) < std::abs(signed_area(expected->outline))))
          expected = &layer;
      EXPECT_EQ(&stage.layers[band_at(soil_bands(stage, place[0]), place[1])->layer], expected);
    }
  }
}

TEST(GroundColumn, HasSoilAtBothEndsAndBeyond)
{
  for (const Real x : {-5.0, 0.0, 20.0, 25.0}) EXPECT_THAT(soil_bands(clay_on_sand(), x), SizeIs(2)) << x;
}

TEST(GroundColumn, FindsTheNearestBandInAGapAndNoneAboveTheGround)
{
  StixStage stage = clay_on_sand();
  stage.layers[1] = box_layer("sand", {0.0, -10.0}, {20.0, -6.01}, 0);
  const auto bands = soil_bands(stage, 7.0);
  EXPECT_EQ(band_at(bands, -6.002)->layer, 0U);
  EXPECT_EQ(band_at(bands, -6.008)->layer, 1U);
  EXPECT_EQ(band_at(bands, 0.001), nullptr);
  EXPECT_EQ(band_at(bands, -99.0)->layer, 1U);
}

}  // namespace ground_column_test
