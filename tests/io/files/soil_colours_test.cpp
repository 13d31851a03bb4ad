#include "io/files/soil_colours.hpp"
#include "support/test.hpp"

namespace soil_colours_test {

MaterialCase soil(const std::string& name, const std::string& color = "")
{
  MaterialCase material;
  material.name = name, material.color = color;
  return material;
}

TEST(SoilColours, FollowTheCaseThenTheName)
{
  const auto colours = soil_colours({soil("Zand, los"), soil("peat"), soil("hollandveen"), soil("x", "#123456")});
  EXPECT_THAT(colours, ElementsAre("#ead592", "#9a6d47", "#845d3d", "#123456"));  // a second peat is darker
}

TEST(SoilColours, OtherNamesHaveColoursOfTheirOwn)
{
  const auto colours = soil_colours({soil("a"), soil("b")});
  EXPECT_NE(colours[0], colours[1]);
}

TEST(SoilColours, SoilAboveTheWaterIsLighter)
{
  MaterialCase below = soil("clay below"), above = soil("clay above");
  below.soil = above.soil = "clay";
  below.zone = Zone::below, above.zone = Zone::above;
  EXPECT_THAT(soil_colours({below, above}), ElementsAre("#a3c293", "#bed4b3"));
}

}  // namespace soil_colours_test
