#include "math/errors.hpp"
#include "import/dstability/case_folder.hpp"
#include "import/dstability/read_stix.hpp"
#include "io/case/case_file.hpp"
#include "model/bodies/overlay.hpp"
#include "archives.hpp"
#include "sections.hpp"
#include "support/problems.hpp"
#include "model/water/water_pressure.hpp"

#include <fmt/format.h>

namespace case_folder_test {

/// Writes the folder to a place of its own, as tests run side by side, and reads its case.
CaseFile read_folder(const CaseFolder& folder)
{
  const ScratchFolder own;
  for (const auto& [file, contents] : folder.files) std::ofstream(own.path() + "/" + file) << contents;
  return read_case(own.path() + "/case.toml");
}

/// Area of each polygon that is not covered by a later one: by the strips of one vast cell.
std::vector<Real> areas_on_top(const std::vector<Polygon>& polygons)
{
  Vec<2> low{1e30, 1e30}, high{-1e30, -1e30};
  Overlay overlay;
  for (const Polygon& polygon : polygons) {
    overlay.rings.push_back({polygon, static_cast<Index>(overlay.rings.size()), false});
    for (const Vec<2>& x : polygon)
      for (int d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d] - 1.0), high[d] = std::max(high[d], x[d] + 1.0);
  }
  std::vector<Real> areas(polygons.size(), 0.0);
  for (const Part& part : share_out(overlay, {low, Vec<2>{high[0], low[1]}, high, Vec<2>{low[0], high[1]}}))
    areas[part.body] += part.area;
  return areas;
}

/// Weight of the layers, the smaller ones on top, less what is dug away [N/m]; the same above the phreatic line.
Real weight_of_file(const StixProject& project, const StixStage& stage)
{
  std::vector<StixLayer> layers = stage.layers;
  std::ranges::stable_sort(
      layers, std::greater{}, [](const StixLayer& l) { return std::abs(signed_area(Polygon(l.outline))); });
  std::vector<Polygon> polygons;
  for (const StixLayer& layer : layers) polygons.push_back(layer.outline);
  for (const StixLine& pit : stage.excavations) {
    Polygon dug(pit);
    dug.push_back({pit.back()[0], 1e3});
    dug.push_back({pit.front()[0], 1e3});
    polygons.push_back(dug);
  }
  const std::vector<Real> areas = areas_on_top(polygons);
  Real weight = 0.0;
  for (std::size_t k = 0; k < layers.size(); ++k) weight += areas[k] * project.soils[*layers[k].soil].weight_below;
  return weight;
}

Real weight_of_case(const Case& description)
{
  std::vector<Polygon> polygons;
  for (const BodyCase& body : description.bodies) polygons.push_back(body.polygon);
  const std::vector<Real> areas = areas_on_top(polygons);
  Real weight = 0.0;
  for (std::size_t k = 0; k < areas.size(); ++k)
    for (const MaterialCase& material : description.materials)
      if (material.name == description.bodies[k].material) weight += areas[k] * material.density * 9.81;
  return weight;
}

struct Wanted {
  const char* name;
  std::size_t scenario, stage;
};

class Sample : public testing::TestWithParam<Wanted> {};

TEST_P(Sample, GivesACaseThatIsReadAndWeighsWhatItsPolygonsWeigh)
{
  const auto [name, scenario, stage] = GetParam();
  const StixProject project = read_stix(sample_path(name));
  const CaseFolder folder = case_folder_of(
      project, {.scenario = scenario, .stage = stage, .between = Vec<2>{-1e4, 1e4}, .base = -1e4, .kinds = kinds()});
  const CaseFile file = read_folder(folder);
  const StixStage& from = project.scenarios[scenario].stages[stage];
  const Real weight = weight_of_file(project, from);
  const Real near = from.excavations.empty() ? 1e-9 : 1e-7;  // the edge of a pit may move by 1 mm
  EXPECT_NEAR(weight_of_case(file.values), weight, near * weight);
  EXPECT_EQ(folder.files.front().first, "case.toml");
  EXPECT_EQ(folder.files[1], std::pair(std::string("imported.toml"), folder.files[0].second));
  EXPECT_EQ(folder.files.back().first, "report.md");
  for (const MaterialCase& material : file.values.materials) EXPECT_GT(material.density, 900.0);
}

INSTANTIATE_TEST_SUITE_P(Files, Sample,
    testing::Values(Wanted{"tutorial-2023", 0, 0}, Wanted{"tutorial-2023", 1, 1}, Wanted{"tutorial-2023", 2, 2},
        Wanted{"tutorial-2026.01", 1, 1}, Wanted{"tutorial-2026.01", 4, 0}, Wanted{"tutorial-2022.01-v1", 0, 7},
        Wanted{"tutorial-2020-v1", 0, 1}, Wanted{"berm-fragility-2023", 0, 0}, Wanted{"example-2020.03-v1", 0, 1},
        Wanted{"all-result-kinds-stale", 0, 0}));

const CaseFolder& tutorial()
{
  static const CaseFolder folder = [] {
    return case_folder_of(read_stix(sample_path("tutorial-2023")), {.scenario = 1, .stage = 1, .kinds = kinds()});
  }();
  return folder;
}

TEST(CaseFolder, HasTheWaterPressuresOfTheFile)
{
  const StixProject project = read_stix(sample_path("tutorial-2023"));
  const StixSection section(project, 1, 1, StixBasis::deterministic);
  const WaterCase water = read_folder(tutorial()).values.water;
  Real most = 0.0;
  for (Real x = -61.0; x < 85.0; x += 3.7) {
    const StixColumn column = section.column(x);
    for (Real z = -8.9; z < column.ground(); z += 0.9)
      most = std::max(
          most, std::abs(water_pressure(water, water.situations[0], {x, z}, 0.0) - column.now().water().pressure(z)));
  }
  EXPECT_LT(most, 500.0);
  EXPECT_GT(most, 0.0);
}

TEST(CaseFolder, HasTheColoursAndSlipPlanesOfTheFile)
{
  const Case description = read_folder(tutorial()).values;
  std::vector<StixCalculation> stored = read_stix(sample_path("tutorial-2023")).scenarios[1].calculations;
  std::erase_if(stored, [](const StixCalculation& c) { return c.result->slip_plane.empty(); });  // probabilistic
  ASSERT_EQ(stored.size(), 3u);
  ASSERT_EQ(description.slip_planes.size(), stored.size());
  for (std::size_t k = 0; k < stored.size(); ++k) {
    EXPECT_EQ(description.slip_planes[k].method, stored[k].method);
    const Real factor = description.slip_planes[k].factor_of_safety;
    if (stored[k].kind == StixCalculationKind::deterministic)
      EXPECT_NEAR(factor, stored[k].result->factor_of_safety, 1e-4);
    else
      EXPECT_TRUE(std::isnan(factor)) << "of other strengths than those of the case";
    EXPECT_EQ(description.slip_planes[k].line.size(), stored[k].result->slip_plane.size());
  }
  for (const MaterialCase& material : description.materials) EXPECT_EQ(material.color.size(), 7u) << material.name;
}

StixStage stage_of(const std::vector<StixLayer>& layers, const StixLine& phreatic, const std::string& label = "stage")
{
  StixStage stage = clay_on_sand();
  stage.label = label;
  stage.layers = layers;
  stage.water.head_lines[0].line = phreatic;
  if (phreatic.empty()) stage.water.phreatic.reset();
  return stage;
}

CaseFolder last_stage(const StixProject& project)
{
  return case_folder_of(project, {.stage = project.scenarios[0].stages.size() - 1, .kinds = kinds()});
}

Case case_of(const StixProject& project) { return read_folder(last_stage(project)).values; }

TEST(HandSection, HasItsRiverWhereTheWaterStandsHigherNotDeeper)
{
  // 2 m of water on the foreland at +4 m, 4 m in a lake in the polder at -1 m.
  const StixLayer sand{.id = "s",
      .label = "s",
      .outline = {{0, 2}, {20, 2}, {30, 6}, {35, 6}, {50, -1}, {60, -5}, {80, -5}, {80, -15}, {0, -15}},
      .soil = 0};
  const Case lake = case_of(project_of({stage_of({sand}, {{0, 4}, {25, 4}, {50, -1}, {80, -1}})}));
  EXPECT_EQ(lake.flood.river, RiverSide::left);
  EXPECT_EQ(lake.flood.water_level, 4.0);
}

TEST(HandSection, NamesTwoLoadsOfOneLabelApart)
{
  StixStage stage = clay_on_sand();
  stage.loads = {{.label = "Traffic", .start = 2, .end = 4, .magnitude = 13e3},
      {.label = "Traffic", .start = 8, .end = 9, .magnitude = 5e3}, {.start = 12, .end = 13, .magnitude = 5e3}};
  const Case two = case_of(project_of({stage}));
  ASSERT_EQ(two.loads.size(), 3u);
  EXPECT_EQ(two.loads[0].name, "traffic");
  EXPECT_EQ(two.loads[1].name, "traffic_2");
  EXPECT_EQ(two.loads[2].name, "load");
}

TEST(HandSection, KeepsTheWaterOfTheFirstStageWhereTheAnalysedOneIsDry)
{
  const auto layers = clay_on_sand().layers;
  const CaseFolder folder = last_stage(project_of({clay_on_sand(), stage_of(layers, {}, "dry")}));
  const Case dry = read_folder(folder).values;
  EXPECT_EQ(dry.water.start.phreatic_line[0][1], -1.0);
  ASSERT_EQ(dry.water.situations.size(), 1u);
  EXPECT_EQ(water_pressure(dry.water, dry.water.situations[0], {10.0, -10.0}, 0.0), 0.0);
  EXPECT_THAT(
      folder.files.back().second, HasSubstr("Stage \"dry\" has no water: in the case it stands below the section."));
  const Case wet = case_of(project_of({stage_of(layers, {}, "dry"), clay_on_sand()}));
  EXPECT_EQ(water_pressure(wet.water, wet.water.start, {10.0, -10.0}, 0.0), 0.0);
  EXPECT_EQ(water_pressure(wet.water, wet.water.situations[0], {10.0, -10.0}, 0.0), 90e3);
}

TEST(HandSection, HasItsBaseBelowAllLayers)
{
  // Two layers on a base that is not level: what fills it may cover neither.
  const StixLayer left{
      .id = "l", .label = "l", .outline = {{0, 0.5}, {40, 0}, {60, 0}, {80, 0.4}, {80, 10}, {0, 10}}, .soil = 0},
      right{.id = "r", .label = "r", .outline = {{80, 0.4}, {90, .5}, {100, .5}, {100, 10}, {80, 10}}, .soil = 1};
  const Case described = case_of(project_of({stage_of({left, right}, {{0, 20}})}));
  std::vector<Polygon> polygons;
  for (const BodyCase& body : described.bodies) polygons.push_back(body.polygon);
  const std::vector<Real> areas = areas_on_top(polygons);
  ASSERT_EQ(areas.size(), 4u);  // a piece on each side of the lowest place
  const Real of_left = std::abs(signed_area(Polygon(left.outline))),
             of_right = std::abs(signed_area(Polygon(right.outline)));
  EXPECT_NEAR(areas[0] + areas[1], 1000.0 - of_left - of_right, 1e-8);
  EXPECT_NEAR(areas[2], of_left, 1e-8);
  EXPECT_NEAR(areas[3], of_right, 1e-8);
}

TEST(HandSection, FitsATableOfStrengthToTheDeepestPieceInWhateverOrder)
{
  StixStage stage = stage_of({box_layer("top", {0, -1}, {50, 0}, 0), box_layer("clay", {0, -5}, {50, -1}, 1),
                                 box_layer("deep", {0, -20}, {50, -5}, 0)},
      {{0, -1}});
  StixStage turned = stage;
  std::ranges::reverse(turned.layers);
  std::vector<std::string> angles;
  for (const StixStage& of : {stage, turned}) {
    StixProject project = project_of({of});
    project.soils[0].above = project.soils[0].below = StixStrengthModel::sigma_tau_table;
    project.soils[0].weight_above = project.soils[0].weight_below;
    project.soils[0].sigma_tau_table.rows = {{0, 0}, {20e3, 20e3}, {200e3, 60e3}};
    const std::string text = last_stage(project).files.front().second;
    const std::size_t at = text.find("friction_angle", text.find("[material.sand]"));
    angles.push_back(text.substr(at, text.find('#', at) - at));
  }
  EXPECT_EQ(angles[0], angles[1]);
  EXPECT_LT(std::stod(angles[0].substr(angles[0].find('=') + 1)), 25.0);  // 45 degrees in the top metre alone
}

TEST(HandSection, SaysThatALineIsLevelBeyondItsEnds)
{
  const Case described = case_of(project_of({stage_of(clay_on_sand().layers, StixLine{{2, -1}, {8, -1}, {12, -2}})}));
  EXPECT_THAT(
      described.water.start.phreatic_line, ElementsAre(Vec<2>{2, -1}, Vec<2>{8, -1}, Vec<2>{12, -2}, Vec<2>{20, -2}));
}

TEST(HandSection, RefusesACrossedOutlineAlsoWhereAPartIsTaken)
{
  StixStage stage = clay_on_sand();
  stage.layers.push_back({.id = "x", .label = "bow", .outline = {{5, -2}, {8, -5}, {8, -2}, {5, -5}}, .soil = 0});
  EXPECT_THAT(problems_of([&] {
    case_folder_of(project_of({stage}), {.between = Vec<2>{1.0, 19.0}, .kinds = kinds()});
  }),
      ElementsAre(told("sand (bow)", "this outline is no layer", HasSubstr("the polygon crosses itself"))));
}

}  // namespace case_folder_test
