// Keys of computed water, and what does not go together. The flow itself: tests/model/seepage.
#include "io/case/samples.hpp"
#include "io/case/reader.hpp"

namespace seepage_keys_test {

std::string with_water(const std::string& water, const std::string& soil = "permeability = 1e-6\n")
{
  return replaced(small_case, "[material.clay]\n", "[material.clay]\n" + soil) + "[water]\nmodel = \"seepage\"\n" +
         water;
}

TEST(SeepageKeys, ArriveWithTheirUnits)
{
  const Case c =
      read_case_text(with_water(R"(
river    = { side = "right", level = "45 dm" }
ponds    = [{ name = "ditch", from = 1.0, to = 2.0, level = -0.3 }]
boundary = [
  { name = "aquifer", side = "left", from = -8.5, to = -6.5, head = 0.4, leakage_length = "0.3 km" },
  { side = "bottom", head = [[0, 3], [10, 1]] }]
[[water.situation]]
name  = "flood"
river = { side = "right", level = 6 }
)",
                         "permeability = { horizontal = \"8.64 m/d\", vertical = 1e-5 }\nspecific_yield = 0.15\n"),
          "case.toml")
          .values;
  EXPECT_EQ(c.water.kind, WaterKind::seepage);
  EXPECT_NEAR(c.materials[0].permeability.horizontal, 1e-4, 1e-18);
  EXPECT_EQ(c.materials[0].permeability.vertical, 1e-5);
  EXPECT_EQ(c.materials[0].storage.yield, 0.15);
  const SeepageCase& s = c.water.start.seepage;
  EXPECT_EQ(*s.river, (RiverCase{SectionSide::right, 4.5}));
  ASSERT_EQ(s.boundary.size(), 2u);
  EXPECT_EQ(s.boundary[0].leakage_length, 300.0);
  EXPECT_EQ(s.boundary[1].side, SectionSide::bottom);
  EXPECT_THAT(s.boundary[1].head, ElementsAre(Vec<2>{0.0, 3.0}, Vec<2>{10.0, 1.0}));
  // What a situation leaves out is that of the start.
  const SeepageCase& flood = c.water.situations[0].seepage;
  EXPECT_EQ(flood.river->level, 6.0);
  EXPECT_EQ(flood.ponds, s.ponds);
  EXPECT_EQ(flood.boundary, s.boundary);
}

TEST(SeepageKeys, WhatCannotBeIsRefusedWithTheCure)
{
  const auto message = [](const std::string& water, const std::string& soil = "permeability = 1e-6\n") {
    return message_for(with_water(water, soil));
  };
  const std::string river = "river = { side = \"left\", level = 1.0 }\n";
  EXPECT_THAT(message(river + "phreatic_line = [[0, 1]]\n"), HasSubstr("does not go with computed water"));
  EXPECT_THAT(message_for(small_case + "[water]\nphreatic_line = [[0, 1]]\n" + river),
      HasSubstr("`river` is for computed water"));
  EXPECT_THAT(message(river, "permeability = 8.64\n"), HasSubstr("no soil has such a permeability"));
  EXPECT_THAT(message(river, "permeability = \"8 kPa\"\n"), HasSubstr("must be a number in m/s"));
  EXPECT_THAT(message("river = { side = \"top\", level = 1.0 }\n"), HasSubstr("`side` must be one of"));
  EXPECT_THAT(message("river = { side = \"left\" }\n"), HasSubstr("`river` has no `level`"));
  EXPECT_THAT(message("river = { side = \"left\", lvel = 1.0 }\n"), HasSubstr("Did you mean"));
  EXPECT_THAT(message("ponds = [{ from = 2, to = 1, level = 0 }]\n"), HasSubstr("from a smaller to a larger"));
  EXPECT_THAT(message("ponds = [{ from = 1, to = 3, level = 0 }, { from = 2, to = 4, level = 0 }]\n"),
      HasSubstr("two ponds lie at one place"));
  EXPECT_THAT(message("boundary = [{ side = \"left\", head = 1 }, { side = \"left\", from = 0, to = 1, head = 2 }]\n"),
      HasSubstr("two heads are given at one place"));
  EXPECT_THAT(message("boundary = [{ side = \"left\", head = [[0, 1], [1, 2]] }]\n"), HasSubstr("is for the bottom"));
  EXPECT_THAT(message(river + "ponds = [{ name = \"river\", from = 9, to = 10, level = 0.5 }]\n"),
      HasSubstr("the name `river` is taken"));
  EXPECT_THAT(message(""), HasSubstr("no water enters the soil"));
  EXPECT_THAT(message(river, "permeability = { horizontal = 1e-6, vertical = 1e-5 }\n"),
      HasSubstr("the vertical permeability is unusual"));
}

}  // namespace seepage_keys_test
