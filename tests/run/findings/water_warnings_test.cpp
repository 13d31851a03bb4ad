// Grids: input/water_keys_test.cpp; dry and lifted soil: setup_warnings_test.cpp.
#include "run/findings/water_warnings.hpp"

#include "support/simulations.hpp"
#include "support/stages.hpp"

namespace water_warnings_test {

using Line = std::vector<Vec<2>>;

/// Elastic soil of 4 m x 1 m whose points lie from x = 0.025 to 3.975 m, cells of 0.25 m.
Case wet(const Line& phreatic_line)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -9.81};
  c.water.start.phreatic_line = phreatic_line;
  return c;
}

std::vector<Problem> warnings_of(const Case& c) { return warnings_from(find_odd_water, c); }

TEST(WaterWarnings, AreSilentWhereLinesReachOverTheSoilOrAreLevelAtTheirEnds)
{
  for (const Line& line : {Line{{0.0, 0.8}, {4.0, 0.6}}, Line{{-1.0, 0.8}, {5.0, 0.6}}, Line{{2.0, 0.8}},
           Line{{1.0, 0.8}, {1.5, 0.8}, {2.0, 0.6}, {3.0, 0.6}}, Line{{0.2, 0.8}, {3.8, 0.6}}})
    EXPECT_THAT(warnings_of(wet(line)), IsEmpty());
}

TEST(WaterWarnings, ALineBesideTheSoilIsTold)
{
  EXPECT_THAT(warnings_of(wet({{-9.0, 0.8}, {-1.0, 0.7}})),
      ElementsAre(told("water.phreatic_line", "the phreatic line lies beside the soil",
          "It runs from x = -9 to -1 m, the soil from 0.025 to 3.975 m. Beyond its ends a line keeps its level: 0.7 m "
          "in "
          "all of the soil.\nx is in m, in the frame of the mesh. For a level line one place is enough.")));
  EXPECT_THAT(warnings_of(wet({{5.0, 0.6}, {9.0, 0.7}})),
      ElementsAre(told("water.phreatic_line", "the phreatic line lies beside the soil", HasSubstr("level: 0.6 m in"))));
}

/// The clay of a stage with the water `high`, whose S_u follows from another.
std::vector<Problem> warnings_on_strength_of(const std::string& water, const std::string& stage_water = "high")
{
  Case c = wet({{0.0, 0.8}});
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 0.9}}}};
  c.materials[0] = clay({.su_residual = 8e3});
  c.bodies[0].material = c.materials[0].name;
  ParameterField field{.parameter = 2, .value_at = [](const PlaceInSoil&) { return 8e3; }, .text = "{ shansep = { } }"};
  field.needs.stress_water = water;
  c.materials[0].fields = {field};
  StageCase low = stage("low", 0.1), high = stage("high", 0.1);
  high.water = stage_water;
  return warnings_from(find_odd_water, staged(c, {{low, {}}, {high, {}}}));
}

TEST(WaterWarnings, AStrengthOfOtherWaterThanThatOfItsStageIsTold)
{
  EXPECT_THAT(warnings_on_strength_of("start"),
      Contains(told("material.clay.su_peak", "it follows from the water `start`, and the stage `high` has `high`",
          HasSubstr("Give material.clay.su_peak.shansep.water = \"high\" in [material]"))));
  for (const auto& found : {warnings_on_strength_of("high"), warnings_on_strength_of("start", "start")})
    for (const Problem& warning : found) EXPECT_NE(warning.key, "material.clay.su_peak") << warning.what;
}

TEST(WaterWarnings, WaterThatNeverComesIsTold)
{
  Case c = wet({{0.0, 0.8}});
  c.time.end = 1.0;
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 0.9}}}};
  EXPECT_THAT(warnings_of(c), ElementsAre(told("water.situation[0]", "nothing asks for the water `high`",
                                  "Give water = \"high\" in a stage, or time = T in s.")));
  c.water.situations[0].time = 2.0;
  EXPECT_THAT(
      warnings_of(c), ElementsAre(told("water.situation[0].time", "the run ends before the water `high` is reached",
                          "It is reached at 2 s, and the run ends at 1 s at the latest.")));
  c.time.end = 2.0;
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(WaterWarnings, ALineThatEndsWithinTheSoilIsTold)
{
  EXPECT_THAT(warnings_of(wet({{0.0, 0.8}, {2.0, 0.6}})),
      ElementsAre(told("water.phreatic_line", "the phreatic line ends within the soil",
          "It runs from x = 0 to 2 m, the soil from 0.025 to 3.975 m. From x = 2 m on to the right it keeps the level "
          "0.6 "
          "m.\nContinue the line to the end of the soil; a level part at its end says that this is meant.")));
  Case c = wet({{0.0, 0.8}});
  c.water.situations = {{.name = "high", .time = 0.0, .phreatic_line = {{1.0, 0.9}, {4.0, 0.6}}}};
  EXPECT_THAT(warnings_of(c),
      ElementsAre(told("water.situation[0].phreatic_line", "the phreatic line of `high` ends within the soil",
          HasSubstr("From x = 1 m on to the left it keeps the level 0.9 m."))));
}

TEST(WaterWarnings, WaterAboveAllOfTheSoilIsTold)
{
  EXPECT_THAT(warnings_of(wet({{0.0, 0.9}, {2.0, 0.9}, {2.0, 1.5}, {4.0, 1.5}})), IsEmpty()) << "land on the left";
  EXPECT_THAT(warnings_of(wet({{0.0, 8.0}})),
      ElementsAre(told("water.phreatic_line", "the water stands above all of the soil",
          "It is 7 m above the highest ground, at x = 0.125 m, y = 1 m. Terp then computes soil under still water:\n"
          "water that flows over the ground is not simulated. Elevations are in m, in the frame of the mesh.")));
}

TEST(WaterWarnings, FreeWaterThatSlopesIsTold)
{
  EXPECT_THAT(warnings_of(wet({{0.0, 1.6}, {2.0, 0.8}, {4.0, 0.8}})),
      ElementsAre(told("water.phreatic_line", "free water slopes",
          AllOf(HasSubstr("From x = 0.125 to 1.375 m the line lies up to 0.55 m above the ground, and falls by 0.5 m."),
              HasSubstr("would run off")))))
      << "the drawn ground is level, at 1 m";
  EXPECT_THAT(warnings_of(wet({{0.0, 1.2}, {2.0, 0.8}, {4.0, 0.8}})), IsEmpty()) << "by less than a cell";
  EXPECT_THAT(warnings_of(wet({{0.0, 1.5}, {2.0, 1.5}, {2.0, 0.8}, {4.0, 0.8}})), IsEmpty()) << "level";
}

TEST(WaterWarnings, ALoadUnderFreeWaterIsTold)
{
  Case c = wet({{0.0, 1.3}, {2.0, 1.3}, {2.0, 0.8}, {4.0, 0.8}});
  c.loads = {{.name = "crane", .from = 0.5, .to = 1.0, .pressure = 5e3}};
  EXPECT_THAT(warnings_of(c), ElementsAre(told("load[0].from", "the load `crane` stands under free water",
                                  "At x = 0.75 m the ground is at 1 m, 0.3 m below the water.")));
  c.loads[0].from = 3.0, c.loads[0].to = 3.5;
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(WaterWarnings, StagesThatTakeNoWaterWhereAStrengthAsksForSomeAreTold)
{
  Case c = wet({{0.0, 0.8}});
  c.materials[0] = clay();
  c.bodies[0].material = c.materials[0].name;
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 0.9}}}};
  c.materials[0].fields = {{2, [](const PlaceInSoil&) { return 1e4; }}};
  c.materials[0].fields[0].needs.situations = {"high"};
  EXPECT_THAT(warnings_of(c), IsEmpty()) << "a run without stages has the water of the start";
  const auto nothing = [](Case&) {};
  EXPECT_THAT(warnings_of(staged(c, {{stage("daily", 1.0), nothing}, {stage("flood", 1.0), nothing}})),
      ElementsAre(told("water.situation[0]", "no stage takes the water `high`", HasSubstr("all 2 stages"))));
  StageCase flood = stage("flood", 1.0);
  flood.water = "high";
  EXPECT_THAT(warnings_of(staged(c, {{stage("daily", 1.0), nothing}, {flood, nothing}})), IsEmpty());
}

TEST(WaterWarnings, HeadsThatLookSwappedAreTold)
{
  Case c = wet({{0.0, 0.8}});
  c.water.start.head_lines = {{"aquifer", {{0.0, 0.9}}}};
  const ReferenceLine phreatic{.places = {{0.0, 0.6}}, .head = "phreatic", .head_bottom = "phreatic"};
  const ReferenceLine aquifer{.places = {{0.0, 0.2}}, .head = "aquifer", .head_bottom = "aquifer"};
  c.water.start.reference_lines = {phreatic, aquifer};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  std::swap(c.water.start.reference_lines[0].places, c.water.start.reference_lines[1].places);
  EXPECT_THAT(
      warnings_of(c), ElementsAre(told("water.reference_lines[0]",
                          "the heads of the reference lines 1 and 0 look swapped", HasSubstr("the head `aquifer`"))));
  c.water.start.reference_lines[0].head_bottom = "aquifer";
  EXPECT_THAT(warnings_of(c), IsEmpty()) << "the aquifer again below it";
}

TEST(WaterWarnings, AReferenceLineBelowTheSoilIsTold)
{
  Case c = wet({{0.0, 0.8}});
  c.water.start.head_lines = {{"aquifer", {{0.0, 0.7}}}};
  c.water.start.reference_lines = {{.places = {{0.0, -0.2}}, .head = "aquifer", .head_bottom = "aquifer"}};
  EXPECT_THAT(warnings_of(c), IsEmpty()) << "by less than a cell";
  c.water.start.reference_lines[0].places = {{0.0, -3.0}, {4.0, -2.0}};
  EXPECT_THAT(
      warnings_of(c), ElementsAre(told("water.reference_lines[0]", "the reference line 0 lies below all of the soil",
                          HasSubstr("It lies at -2 m, the soil ends at 0.025 m"))));
}

/// Warnings of two waters over the soil of wet(), whose ground is at y = 1 m.
std::vector<Problem> from_to(const Line& start, const Line& later)
{
  Case c = wet(start);
  c.water.situations = {{.name = "flood", .time = 0.0, .phreatic_line = later}};
  return warnings_of(c);
}

TEST(WaterWarnings, ARiverThatChangesItsSideIsTold)
{
  EXPECT_THAT(from_to({{0.0, 0.8}, {4.0, 0.4}}, {{0.0, 0.4}, {4.0, 1.2}}),
      ElementsAre(told("water.situation[0].phreatic_line",
          "the river changes its side: in the water `flood` it stands on the right",
          AllOf(HasSubstr("At the start the water stands at 0.7975 m on the left and at 0.4025 m on the right; here at "
                          "0.405 m and 1.195 m."),
              HasSubstr("Turn the line about, if the river is on the left.")))));
  EXPECT_THAT(from_to({{0.0, 0.4}, {4.0, 0.8}}, {{0.0, 1.2}, {4.0, 0.4}}),
      ElementsAre(told(_, HasSubstr("stands on the left"))));
  EXPECT_THAT(from_to({{0.0, 1.1}, {4.0, 0.4}}, {{0.0, 1.1}, {2.0, 0.9}, {4.0, 1.2}}), SizeIs(1))
      << "free water at the start says where the river is";
}

TEST(WaterWarnings, ARiverThatKeepsItsSideIsNotDoubted)
{
  EXPECT_THAT(from_to({{0.0, 0.8}, {4.0, 0.4}}, {{0.0, 1.2}, {4.0, 0.5}}), IsEmpty());
  EXPECT_THAT(from_to({{0.0, 1.2}, {4.0, 0.4}}, {{0.0, 0.2}, {4.0, 0.4}}), IsEmpty()) << "drawdown below the polder";
  EXPECT_THAT(from_to({{0.0, 0.4}, {4.0, 0.6}}, {{0.0, 1.2}, {4.0, 0.7}}), IsEmpty()) << "a rise from low tide";
}

TEST(WaterWarnings, AHeadBelowTheLineAtWhichItActsIsTold)
{
  const auto with_head = [](const Line& head) {
    Case c = wet({{0.0, 0.8}});
    c.water.start.reference_lines = {{.places = {{0.0, 0.5}}, .head = "aquifer", .head_bottom = "aquifer"}};
    c.water.start.head_lines = {{"aquifer", {{0.0, 0.7}}}};
    c.water.situations = {{.name = "flood", .time = 0.0, .phreatic_line = {{0.0, 0.9}}}};
    c.water.situations[0].reference_lines = c.water.start.reference_lines;
    c.water.situations[0].head_lines = {{"aquifer", head}};
    return warnings_of(c);
  };
  EXPECT_THAT(with_head({{0.0, 0.8}, {4.0, 0.505}}), IsEmpty());
  EXPECT_THAT(with_head({{0.0, 0.8}, {4.0, -10.0}}),
      Contains(told("water.situation[0].head_lines.\"aquifer\"",
          "the head `aquifer` of `flood` lies below the line at which it acts",
          HasSubstr("m below the reference line at 0.5 m: the pore pressure there is "
                    "zero."))));
}

}  // namespace water_warnings_test
