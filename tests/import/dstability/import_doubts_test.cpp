#include "import/dstability/import_doubts.hpp"

#include "import/dstability/case_folder.hpp"
#include "io/case/case_file.hpp"
#include "io/case/document.hpp"
#include "sections.hpp"
#include "support/paths.hpp"

namespace import_doubts_test {

CaseFolder folder_of(const StixProject& project)
{
  return case_folder_of(project, {.stage = project.scenarios[0].stages.size() - 1, .cell = 1.0, .kinds = kinds()});
}

std::vector<std::string> notes_of(const StixProject& project) { return in_english(folder_of(project).notes); }

StixStatePoint state_of(const std::string& layer, const StixPreload& preload)
{
  return {.id = "9", .label = "SP", .layer = layer, .place = {10.0, -4.0}, .preload = preload};
}

StixStage with_state(const StixPreload& preload)
{
  StixStage stage = clay_on_sand();
  stage.state_points = {state_of("clay", preload)};
  return stage;
}

const StixPreload pop_10{.kind = StixPreload::Kind::pop, .pop = {.value = 10e3}};

TEST(ImportDoubts, AreNoneOfASoundSection)
{
  const CaseFolder folder = folder_of(project_of({with_state(pop_10)}));
  EXPECT_THAT(in_english(folder.notes), IsEmpty());
  EXPECT_THAT(folder.files.front().second, testing::Not(HasSubstr("doubts")));
  EXPECT_THAT(folder.files.back().second, HasSubstr("## In doubt\n\n- nothing\n"));
}

TEST(ImportDoubts, SayWhichLayerHasNoPop)
{
  const char* const weakest =
      "The layer `clay (clay)` has SHANSEP strength, but no state point or state line of any stage gives it a POP "
      "above zero: it counts as normally consolidated, the weakest that it can be.";
  EXPECT_THAT(notes_of(project_of({clay_on_sand()})), ElementsAre(weakest));
  const StixPreload none{.kind = StixPreload::Kind::pop, .pop = {.value = 0.0}};
  EXPECT_THAT(notes_of(project_of({with_state(none)})), ElementsAre(weakest));
  EXPECT_THAT(notes_of(project_of({with_state(pop_10), clay_on_sand()})), IsEmpty()) << "an earlier stage has it";
}

TEST(ImportDoubts, SayWhichStateIsBelowWhatTheSoilCarries)
{
  EXPECT_THAT(notes_of(project_of({with_state(StixPreload{.kind = StixPreload::Kind::ocr, .ocr = 0.5})})),
      Contains("Stage `daily`, state `SP` of the layer `clay (clay)`: its OCR is 0.5, below 1: it counts as 1, "
               "normally consolidated."));
  const StixPreload low{.kind = StixPreload::Kind::yield_stress, .yield_stress = 20e3};
  EXPECT_THAT(notes_of(project_of({with_state(low)})),
      Contains("Stage `daily`, state `SP` of the layer `clay (clay)`: its yield stress of 20.0 kPa is below the "
               "effective stress there, 33.0 kPa: the soil counts as normally consolidated."));
}

TEST(ImportDoubts, SayWhichStateIsTooLargeOrOutsideOfItsLayer)
{
  EXPECT_THAT(notes_of(project_of({with_state(StixPreload{.kind = StixPreload::Kind::pop, .pop = {.value = 10e6}})})),
      ElementsAre("Stage `daily`, state `SP` of the layer `clay (clay)`: its POP is 10000 kPa; soft soil has tens of "
                  "kPa."));
  StixStage outside = with_state(pop_10);
  outside.state_points[0].place = {10.0, 1.0};
  EXPECT_THAT(notes_of(project_of({outside})),
      ElementsAre("Stage `daily`, state `SP` of the layer `clay (clay)`: it lies at 10.00, 1.00 m, outside of that "
                  "layer. Its POP holds there all the same."));
  outside.state_points[0].place = {10.0, -7.0};
  EXPECT_THAT(notes_of(project_of({outside})), ElementsAre(HasSubstr("outside of that layer"))) << "in the sand";
  outside.state_points[0].place = {25.0, -3.0};
  EXPECT_THAT(notes_of(project_of({outside})), ElementsAre(HasSubstr("outside of that layer"))) << "beyond the end";
  for (const Vec<2> edge : {Vec<2>{10.0, 0.02}, {10.0, -6.0}, {-0.02, -3.0}, {20.0, -3.0}}) {
    outside.state_points[0].place = edge;
    EXPECT_THAT(notes_of(project_of({outside})), IsEmpty()) << edge[0] << ", " << edge[1];
  }
}

TEST(ImportDoubts, SayWhereALayerIsMissing)
{
  StixStage stage = with_state(pop_10);
  stage.layers[1] = box_layer("sand", {0.0, -10.0}, {8.0, -6.0}, 0);
  EXPECT_THAT(notes_of(project_of({stage})), ElementsAre("Below the layer `clay (clay)` the file has no soil, down to "
                                                         "4.00 m under it: 48.0 m2 were filled with that "
                                                         "layer. Is a layer missing?"));
}

TEST(ImportDoubts, SayWhichLayersLeaveAGapOrOverlap)
{
  StixStage gap = with_state(pop_10);
  gap.layers.push_back(box_layer("left", {5.0, -10.0}, {8.0, -6.0}, 0));
  gap.layers[1] = box_layer("sand", {0.0, -10.0}, {5.0, -6.0}, 0);
  gap.layers.push_back(box_layer("right", {9.0, -10.0}, {20.0, -6.0}, 0));
  gap.layers.push_back(box_layer("bottom", {8.0, -10.0}, {9.0, -9.0}, 0));
  EXPECT_THAT(notes_of(project_of({gap})),
      ElementsAre("Below the layer `clay (clay)` no layer covers 3 m2, up to 3.00 m high, between x = 8.00 and "
                  "9.00 m: it is empty. Is a layer missing?"));
  StixStage both = with_state(pop_10);
  both.layers[1] = box_layer("sand", {0.0, -10.0}, {20.0, -5.0}, 0);
  EXPECT_THAT(notes_of(project_of({both})),
      ElementsAre(ContainsRegex("^The layers `clay [(]clay[)]`, `sand [(]sand[)]` overlap by 20 m2 at .*: the one "
                                "with the smaller outline")));
}

TEST(ImportDoubts, SayWhereAMissingLayerLeavesAGapThatIsOpenAtTheEnds)
{
  StixStage open = with_state(pop_10);
  open.layers[1] = box_layer("sand", {0.0, -10.0}, {20.0, -7.0}, 0);
  EXPECT_THAT(notes_of(project_of({open})),
      ElementsAre("Below the layer `clay (clay)` no layer covers 20 m2, up to 1.00 m high, between x = 0.00 and "
                  "20.00 m: it is empty. Is a layer missing?"));
  open.layers.push_back(box_layer("left", {0.0, -7.0}, {11.0, -6.0}, 0));
  EXPECT_THAT(notes_of(project_of({open})),
      ElementsAre("Below the layer `clay (clay)` no layer covers 9 m2, up to 1.00 m high, between x = 11.00 and "
                  "20.00 m: it is empty. Is a layer missing?"));
}

TEST(ImportDoubts, SayWhichPointOfTheEmbankmentIsWrong)
{
  StixStage stage = with_state(pop_10);
  stage.embankment.toe_land = 99.0;
  const auto doubts = [](const StixStage& of) {
    return in_english(doubts_of_embankment(StixSection(project_of({of}), 0, 0, StixBasis::deterministic), "", {}));
  };
  EXPECT_THAT(
      doubts(stage), ElementsAre("The file has the toe at the land side of its embankment at x = 99.00 m, where "
                                 "there is no ground."));
  stage.embankment = {.toe_water = 2.0, .top_water = 6.0, .top_land = 8.0, .toe_land = 7.0};
  EXPECT_THAT(
      doubts(stage), ElementsAre("The points of the embankment of the file are in no order: the top at the land "
                                 "side is at x = 8.00 m, the toe at the land side at x = 7.00 m."));
  stage.embankment = {.toe_water = 18.0, .top_water = 12.0, .top_land = 8.0, .toe_land = 7.0};
  EXPECT_THAT(doubts(stage), IsEmpty()) << "a river at the right";
}

TEST(ImportDoubts, RepeatWhatTheReaderSaidOfTheStagesButNotOfTheFormat)
{
  StixProject project = project_of({with_state(pop_10), clay_on_sand()});
  project.remarks = {{"scenario 1, stage 1", "Nails: `N`. Left out."}, {"scenario 1, stage 3", "Of a later stage."},
      {"results/bishop/a", "3 slices have no foot."}, {"x.json", "Not known.", true}};
  EXPECT_THAT(notes_of(project), ElementsAre("scenario 1, stage 1: Nails: `N`. Left out."));
}

TEST(ImportDoubts, SayWhichStageHasNoWater)
{
  StixProject project = project_of({with_state(pop_10), clay_on_sand()});
  StixScenario& of = project.scenarios[0];
  of.stages[0].label = "before";
  of.stages[1].water.phreatic.reset();
  EXPECT_THAT(notes_of(project), ElementsAre("Stage `daily` has no phreatic line: all of its soil counts as dry."));
  std::swap(of.stages[0].water, of.stages[1].water);
  EXPECT_THAT(in_english(doubts_of_water(of, 1, true)),
      ElementsAre("Stage `before` has no phreatic line: all of its soil counts as "
                  "dry, and yield stresses are at least what it carries then."));
  EXPECT_THAT(doubts_of_water(of, 1, false), IsEmpty());
}

TEST(ImportDoubts, SayWhichNumbersAreMostLikelyOfAnotherUnit)
{
  StixProject project = project_of({with_state(pop_10)});
  StixStage& stage = project.scenarios[0].stages[0];
  EXPECT_THAT(doubts_of_numbers(StixSection(project, 0, 0, StixBasis::deterministic)), IsEmpty());
  stage.water.unit_weight = 1e3;
  project.soils[0].weight_below = 2e3;
  stage.loads = {{.label = "traffic", .start = 2.0, .end = 4.0, .magnitude = 13e6}};
  EXPECT_THAT(in_english(doubts_of_numbers(StixSection(project, 0, 0, StixBasis::deterministic))),
      ElementsAre("The water of the stage weighs 1 kN/m3: 9.5 to 10.5 kN/m3 are usual. Is it in another unit?",
          "The soil `sand` below the phreatic line weighs 2 kN/m3: 8 to 25 kN/m3 are usual. Is it in another unit?",
          "The load `traffic` is 13000 kPa, as much as 722 m of soil. Is it in another unit?"));
}

/// Sand of 4 m on clay_on_sand between x = 8 and 12 m, its crest at x = 10 m; the river at the left.
StixStage dike()
{
  StixStage stage = with_state(pop_10);
  stage.label = "high water";
  stage.layers.push_back(
      {.id = "dike", .label = "dike", .outline = {{4.0, 0.0}, {9.0, 4.0}, {11.0, 4.0}, {16.0, 0.0}}, .soil = 0});
  stage.water.head_lines[0].line = {{0.0, 2.0}, {6.5, 2.0}, {16.0, -1.0}, {20.0, -1.0}};
  return stage;
}

TEST(ImportDoubts, SayWhichPointOfTheEmbankmentIsOnTheWrongSideOfTheCrest)
{
  StixStage stage = dike();
  EXPECT_THAT(notes_of(project_of({stage})), IsEmpty());
  stage.embankment.toe_land = 5.0;
  EXPECT_THAT(notes_of(project_of({stage})),
      ElementsAre(ContainsRegex("^The file has the toe at the land side of its embankment at x = 5[.]00 m, but the "
                                "crest is at x = (9|10|11)[.]00 m and the river at the left end: it lies on the wrong "
                                "side of the crest[.]$")));
  stage.embankment = {.toe_water = 15.0};
  EXPECT_THAT(
      notes_of(project_of({stage})), ElementsAre(HasSubstr("the toe at the water side of its embankment at x")));
  stage.embankment = {.top_water = 3.0};
  EXPECT_THAT(notes_of(project_of({stage})), IsEmpty()) << "a top may lie beside the highest ground";
  stage.embankment = {.top_land = 3.0};
  EXPECT_THAT(notes_of(project_of({stage})), ElementsAre(HasSubstr("the top at the land side")));
  for (StixLayer& layer : stage.layers)  // the same, with the river at the right
    for (Vec<2>& x : layer.outline) x[0] = 20.0 - x[0];
  stage.water.head_lines[0].line = {{0.0, -1.0}, {4.0, -1.0}, {13.5, 2.0}, {20.0, 2.0}};
  stage.embankment = {.toe_land = 15.0};
  EXPECT_THAT(notes_of(project_of({stage})), ElementsAre(HasSubstr("and the river at the right end")));
  stage.embankment = {.toe_land = 4.0};
  EXPECT_THAT(notes_of(project_of({stage})), IsEmpty());
}

TEST(ImportDoubts, SayWhichWaterIsMostLikelyOfAnotherDatum)
{
  StixStage high = dike(), daily = dike();
  daily.label = "daily";
  const auto moved = [](StixStage stage, Real down) {
    for (Vec<2>& x : stage.water.head_lines[0].line) x[1] -= down;
    return stage;
  };
  const auto doubts = [](const std::vector<StixStage>& stages) { return notes_of(project_of(stages)); };
  EXPECT_THAT(doubts({moved(high, 100.0)}),
      Contains("The phreatic line of stage `high water` is at most at -98.00 m, below all of its soil, which ends at "
               "-10.00 m: all soil counts as dry. Is the water of another datum?"));
  EXPECT_THAT(
      doubts({moved(daily, 100.0), high}), Contains(StartsWith("The phreatic line of stage `daily` is at most")));
  EXPECT_THAT(doubts({moved(high, 10.9)}),
      Contains(
          ContainsRegex("^The phreatic line of stage `high water` lies 8[.]9 m or more below the ground, more than "
                        "twice the height of the dike [(]4[.]0 m[)][.] Is the water of another datum[?]$")));
  EXPECT_THAT(doubts({moved(high, 9.0)}), testing::Not(Contains(HasSubstr("datum")))) << "deep, yet it may be so";
}

TEST(ImportDoubts, SayWhichLayerHasThePopOfAStateLineThatDoesNotTouchIt)
{
  StixStage stage = clay_on_sand();
  stage.layers.push_back(box_layer("crust", {0.0, 0.0}, {20.0, 2.0}, 1));
  stage.water.head_lines[0].line = {{0.0, 2.0}, {20.0, 2.0}};
  const auto with_line = [&](Real z) {
    StixStage with = stage;
    with.state_lines = {{.line = {{0.0, z}, {20.0, z}},
        .values = {{.id = "1", .label = "", .x = 5.0, .above = pop_10, .below = pop_10}}}};
    return with;
  };
  EXPECT_THAT(notes_of(project_of({with_line(-2.0)})),
      ElementsAre(StartsWith("The layer `clay (crust)` has no state point in any stage, and no state line touches it: "
                             "its POP of 10.0 kPa is that of a state line 2.00 m below it, at x = ")));
  EXPECT_THAT(notes_of(project_of({with_line(-0.04)})), IsEmpty()) << "along it";
  EXPECT_THAT(
      notes_of(project_of({with_line(1.0)})), ElementsAre(ContainsRegex("`clay [(]clay[)]` .* 1[.]00 m above it")));
  StixStage point = with_line(-2.0);
  point.state_points = {{.id = "9", .label = "SP", .layer = "crust", .place = {10.0, 1.0}, .preload = pop_10}};
  EXPECT_THAT(notes_of(project_of({point})), IsEmpty());
  EXPECT_THAT(notes_of(project_of({point, stage})), IsEmpty()) << "an earlier stage has it";
}

TEST(ImportDoubts, AreInDutchTooWithDecimalCommas)
{
  StixStage stage = dike();
  stage.embankment.toe_land = 5.0;
  stage.line_loads = 1;
  StixProject project = project_of({stage});
  project.remarks = {{"scenario 1, stage 1", "Line loads: 1. Left out.", false, {}, "Lijnlasten: 1. Weggelaten."}};
  const CaseFolder folder = folder_of(project);
  ASSERT_EQ(folder.notes.size(), 2u);
  EXPECT_EQ(folder.notes[0].nl, "scenario 1, fase 1: Lijnlasten: 1. Weggelaten.");
  EXPECT_THAT(folder.notes[1].nl, StartsWith("Het bestand heeft de teen aan de landzijde van de dijk bij x = 5,00 m"));
  const Node document = parse_toml(folder.files.front().second);
  const Node* const dutch = find_node(document, "reference.doubts_nl");
  ASSERT_NE(dutch, nullptr);
  ASSERT_EQ(dutch->items.size(), 2u);
  EXPECT_EQ(dutch->items[1].text, folder.notes[1].nl);
}

TEST(ImportDoubts, StandInTheCaseAndAreRepeatedByWhatReadsIt)
{
  StixProject project = project_of({clay_on_sand()});
  project.scenarios[0].stages[0].layers[0].label = "clay \"a\" \\ b";
  const std::string text = folder_of(project).files.front().second;
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/imported.toml") << text;
  const CaseFile file = read_case_text(text, folder.path() + "/case.toml");
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0].key, "reference.doubts");
  EXPECT_THAT(file.warnings[0].detail, HasSubstr("The layer `clay (clay \"a\" \\ b)` has SHANSEP strength, but no"));
  const Node document = parse_toml(text);
  for (const auto& [key, last] : {std::pair{"reference.assumed", "defaults of sand."},
           {"reference.assumed_nl", "standaardwaarden van de soort sand."}}) {
    const Node* const assumed = find_node(document, key);
    ASSERT_NE(assumed, nullptr);
    EXPECT_TRUE(std::ranges::any_of(assumed->items, [&](const Node& item) { return item.text.ends_with(last); }))
        << key;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
}

}  // namespace import_doubts_test
