#include "archives.hpp"

namespace read_parts_test {

TEST(ReadParts, StraightensTheEndsOfASection)
{
  const std::string corner = R"({"X":90.0,"Z":-10.0})";
  const StixProject near = read_changed("geometries/geometry.json", corner, R"({"X":89.996,"Z":-10.0})");
  EXPECT_EQ(near.scenarios[0].stages[0].layers[1].outline[4], (Vec<2>{90.0, -10.0}));
  EXPECT_THAT(remarks_of(near), ElementsAre("geometries/geometry.json: The ends of this section are not upright: 1 "
                                            "corners were moved onto them, by up to 4.0 mm."));
  EXPECT_TRUE(near.remarks[0].is_of_format) << "it puts nothing in doubt";
  const StixProject far = read_changed("geometries/geometry.json", corner, R"({"X":89.98,"Z":-10.0})");
  EXPECT_EQ(far.scenarios[0].stages[0].layers[1].outline[4], (Vec<2>{89.98, -10.0}));
  EXPECT_THAT(remarks_of(far), IsEmpty());
}

TEST(ReadParts, TakesAStateWithoutTypeAsNone)
{
  const StixProject project = read_changed("states/states.json", "\"StateType\":\"Pop\"", "\"StateType\":null");
  EXPECT_EQ(project.scenarios[0].stages[0].state_points[0].preload.pop.value, 0.0);
  EXPECT_THAT(remarks_of(project), Contains(HasSubstr("StatePoints[0].Stress: There is no StateType here.")));
}

TEST(ReadParts, TurnsLinesThatRunToTheLeft)
{
  Members members = compact_sample(berm);
  for (auto& [name, text] : members)
    if (name == "waternets/waternets.json") {
      auto water = nlohmann::ordered_json::parse(text);
      auto& points = water["HeadLines"][0]["Points"];
      std::reverse(points.begin(), points.end());
      text = water.dump();
    }
  const auto line = [](const StixProject& p) { return p.scenarios[0].stages[0].water.head_lines[0].line; };
  EXPECT_EQ(line(read_stix_bytes(zip_of(members), "x.stix")), line(read_stix(sample_path(berm))));
}

TEST(ReadParts, GivesLoadsWithTheirConsolidation)
{
  const StixProject project = read_stix(sample_path("tutorial-2026.01"));
  const StixUniformLoad& traffic = project.scenarios[1].stages[1].loads.at(0);
  EXPECT_EQ(traffic.magnitude, 13e3);
  EXPECT_EQ(traffic.consolidation.size(), project.scenarios[1].stages[1].layers.size());
  EXPECT_THAT(traffic.consolidation, Each(testing::Pair(_, AnyOf(10.0, 100.0))));
}

TEST(ReadParts, ResolvesTheHeadsOfReferenceLines)
{
  const StixWater water = read_stix(sample_path("tutorial-2026.01")).scenarios[1].stages[1].water;
  ASSERT_THAT(water.reference_lines, SizeIs(2));
  EXPECT_EQ(water.head_lines[*water.phreatic].label, "Freatic high");
  EXPECT_EQ(water.reference_lines[0].top_head, *water.phreatic);
  EXPECT_EQ(water.head_lines[water.reference_lines[1].bottom_head].label, "Pressure aquifer");
}

}  // namespace read_parts_test
