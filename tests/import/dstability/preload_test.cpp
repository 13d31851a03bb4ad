// Stresses by hand: tests/import/dstability/sections.hpp.
#include "import/dstability/preload.hpp"

#include "sections.hpp"

namespace preload_test {

const CleanRegion clay{0, {{0, -6}, {20, -6}, {20, 0}, {0, 0}}, {}};
const LayerPiece all_clay{&clay, 0};

StixStage with_pop(Real pop, const std::string& layer = "clay")
{
  StixStage stage = clay_on_sand();
  stage.state_points = {{.id = "1", .layer = layer, .place = {5.0, -3.0}, .preload = {.pop = {.value = pop}}}};
  return stage;
}

StixStage loaded(Real start, Real end)
{
  StixStage stage = clay_on_sand();
  stage.loads = {{.label = "traffic", .start = start, .end = end, .magnitude = 13e3}};
  return stage;
}

std::optional<Real> pop_of(const StixProject& project)
{
  const std::size_t last = project.scenarios[0].stages.size() - 1;
  if (!same_ground_until(project.scenarios[0], last)) return std::nullopt;
  return constant_pop(
      {project, 0, last, StixBasis::deterministic}, {project, 0, 0, StixBasis::deterministic}, all_clay, 0.5);
}

Real value_at(const std::string& csv, const std::string& place)
{
  const std::size_t at = csv.find("\n" + place + ",");
  EXPECT_NE(at, std::string::npos) << place;
  return at == std::string::npos ? not_given : std::stod(csv.substr(at + place.size() + 2));
}

TEST(Preload, IsOnePopBesideALoad)
{
  EXPECT_EQ(pop_of(project_of({with_pop(20e3), loaded(8.0, 12.0)})), 20e3);
  EXPECT_EQ(pop_of(project_of({clay_on_sand(), clay_on_sand()})), 0.0);
}

TEST(Preload, IsOnAGridUnderALoadOverTheWholeLayer)
{
  const StixProject project = project_of({with_pop(20e3), loaded(-10.0, 30.0)});
  EXPECT_EQ(pop_of(project), std::nullopt);
  const YieldGrid grid = yield_grid({project, 0, 1, StixBasis::deterministic}, {all_clay}, 0.5);
  // At z = -4: 15 + 3 * 16 - 3 * 10 = 33 kPa, POP 20: the load of 13 kPa gives less.
  EXPECT_NEAR(value_at(grid.csv, "10.0,-4.0"), 53e3, 0.1);
  EXPECT_LT(grid.deviation, 1.0);
}

TEST(Preload, IsOnAGridWhereALayerChangesItsSoilBetweenStages)
{
  StixStage before = with_pop(20e3, "sand");
  StixStage after = clay_on_sand();
  std::swap(before.layers[0].soil, before.layers[1].soil);  // sand over clay, then clay over sand
  const StixProject project = project_of({before, after});
  EXPECT_FALSE(same_ground_until(project.scenarios[0], 1));
  EXPECT_TRUE(same_ground_until(project.scenarios[0], 0));
}

TEST(Preload, IsOnAGridWhereAnEarlierStageHasALoad)
{
  EXPECT_FALSE(same_ground_until(project_of({clay_on_sand(), loaded(0, 20), clay_on_sand()}).scenarios[0], 2));
  EXPECT_TRUE(same_outlines_until(project_of({clay_on_sand(), loaded(0, 20), clay_on_sand()}).scenarios[0], 2));
  EXPECT_TRUE(same_ground_until(project_of({clay_on_sand(), clay_on_sand(), loaded(0, 20)}).scenarios[0], 2));
}

TEST(Preload, KeepsTheGridsOfLayersWithAnotherPopApart)
{
  // Clay to -3 m with POP 100 kPa on clay to -6 m without.
  StixStage stage = with_pop(100e3);
  stage.layers[0] = box_layer("clay", {0.0, -3.0}, {20.0, 0.0}, 1);
  stage.layers.push_back(box_layer("deep", {0.0, -6.0}, {20.0, -3.0}, 1));
  const StixProject project = project_of({stage, loaded(0.0, 20.0)});
  const StixSection section(project, 0, 1, StixBasis::deterministic);
  const CleanRegion upper{0, {{0, -3}, {20, -3}, {20, 0}, {0, 0}}, {}},
      lower{2, {{0, -6}, {20, -6}, {20, -3}, {0, -3}}, {}};
  StixProject last = project;
  last.scenarios[0].stages[1].layers = stage.layers;
  const StixSection both(last, 0, 1, StixBasis::deterministic);
  EXPECT_NE(pop_history(both, {&upper, 0}, 0.5), pop_history(both, {&lower, 2}, 0.5));
  for (const LayerPiece& piece : {LayerPiece{&upper, 0}, LayerPiece{&lower, 2}}) {
    const YieldGrid grid = yield_grid(both, {piece}, 0.8);  // no row of the grid lies on the boundary
    EXPECT_LT(grid.deviation, 500.0);
  }
  EXPECT_GT(yield_grid(both, {{&upper, 0}, {&lower, 2}}, 0.8).deviation, 10e3);
}

TEST(Preload, SharesAGridBetweenLayersOfOneHistory)
{
  StixStage stage = clay_on_sand();
  stage.layers[0] = box_layer("clay", {0.0, -6.0}, {10.0, 0.0}, 1);
  stage.layers.push_back(box_layer("other", {10.0, -6.0}, {20.0, 0.0}, 1));
  const StixProject project = project_of({stage});
  const StixSection section(project, 0, 0, StixBasis::deterministic);
  const CleanRegion left{0, {{0, -6}, {10, -6}, {10, 0}, {0, 0}}, {}},
      right{2, {{10, -6}, {20, -6}, {20, 0}, {10, 0}}, {}};
  EXPECT_EQ(pop_history(section, {&left, 0}, 0.5), pop_history(section, {&right, 2}, 0.5));
}

}  // namespace preload_test
