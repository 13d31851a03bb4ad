#include "import/dstability/film.hpp"

#include "import/dstability/case_folder.hpp"
#include "river_dike.hpp"
#include "sections.hpp"

#include <cmath>
#include <numbers>

using namespace terp::test;

namespace film_test {

/// Clay of 6 m on sand without cohesion, x from 0 to 20 m: 95 kPa of weight on the sand, whose water stands at `head`.
StixProject lifted_ground(Real head, Real cohesion = 0.0)
{
  StixStage stage = clay_on_sand();
  stage.water.head_lines.push_back({.id = "h", .label = "aquifer", .line = {{0.0, head}, {20.0, head}}});
  stage.water.reference_lines = {
      {.label = "top", .line = {{0.0, -6.0}, {20.0, -6.0}}, .top_head = 1, .bottom_head = 1}};
  StixProject project = project_of({stage});
  project.soils[0].advanced.cohesion.value = cohesion;
  return project;
}

std::vector<Film> films_in(const StixProject& project, Real row = 1.0)
{
  const StixSection section(project, 0, project.scenarios[0].stages.size() - 1, StixBasis::deterministic);
  return films_of(section, section, {0.0, 20.0}, row);
}

const Real tan_reduced = std::sin(30.0 * std::numbers::pi / 180.0);  // tan phi* of sand that does not dilate

TEST(Film, GivesARowOfCellsTheStrengthOfTheBorder)
{
  const std::vector<Film> films = films_in(lifted_ground(2.5));  // 85 kPa of water: 10 kPa are left
  ASSERT_EQ(films.size(), 1u);
  const Film& film = films[0];
  EXPECT_NEAR(film.least, tan_reduced * 10e3, 1.0);
  EXPECT_NEAR(film.most, tan_reduced * 10e3, 1.0);
  const Real in_the_middle = 10e3 + 0.5 * 10e3;  // gamma' of the sand is 10 kN/m3
  for (const auto& [x, tangent] : film.friction) EXPECT_NEAR(tangent * in_the_middle, tan_reduced * 10e3, 1.0);
  EXPECT_NEAR(film.carried_more, tan_reduced * 5e3 * 20.0, 1.0);
  EXPECT_NEAR(signed_area(film.outline), 20.0, 1e-3);  // a row of 1 m
}

TEST(Film, IsOnlyWhereWaterPushesFromBelowAndSandHasNoCohesion)
{
  EXPECT_TRUE(films_in(lifted_ground(-1.0)).empty());        // that of the phreatic line
  EXPECT_TRUE(films_in(lifted_ground(2.5, 5e3)).empty());    // c* of 4.3 kPa
  EXPECT_EQ(films_in(lifted_ground(-0.9), 1.0).size(), 1u);  // 44 kPa, less than that of five rows
  EXPECT_TRUE(films_in(lifted_ground(-0.9), 0.5).empty());
}

TEST(Film, EndsWithItsLayer)
{
  StixProject project = lifted_ground(2.5);
  project.scenarios[0].stages[0].layers[1] = box_layer("sand", {0.0, -6.4}, {20.0, -6.0}, 0);
  project.scenarios[0].stages[0].layers.push_back(box_layer("clay 2", {0.0, -10.0}, {20.0, -6.4}, 1));
  const std::vector<Film> films = films_in(project);
  ASSERT_EQ(films.size(), 1u);
  EXPECT_NEAR(signed_area(films[0].outline), 20.0 * 0.4, 1e-3);
}

TEST(Film, FollowsAStepOfTheBorder)
{
  StixProject project = lifted_ground(2.5);
  auto& layers = project.scenarios[0].stages[0].layers;
  layers[0].outline = {{0.0, 0.0}, {20.0, 0.0}, {20.0, -5.0}, {8.0, -5.0}, {8.0, -6.0}, {0.0, -6.0}};
  layers[1].outline = {{0.0, -6.0}, {8.0, -6.0}, {8.0, -5.0}, {20.0, -5.0}, {20.0, -10.0}, {0.0, -10.0}};
  const std::vector<Film> films = films_in(project);
  ASSERT_EQ(films.size(), 1u);
  const auto has = [&](Vec<2> x) {
    return std::ranges::any_of(
        films[0].outline, [&](Vec<2> at) { return std::hypot(at[0] - x[0], at[1] - x[1]) < 1e-3; });
  };
  EXPECT_TRUE(has({8.0, -6.0}) && has({8.0, -5.0}) && has({8.0, -7.0}));
}

TEST(Film, ARowOfCellsBeginsAtIt)
{
  const std::vector<Film> films = films_in(lifted_ground(2.5));
  EXPECT_NEAR(base_with_row_at(films, -10.3, 1.0).value_or(0.0), -10.0, 1e-9);
  EXPECT_FALSE(base_with_row_at(films, -10.0, 1.0));  // as it is
  EXPECT_FALSE(base_with_row_at(films, -6.5, 1.0));   // no row below it
}

TEST(Film, TheSectionReachesBeyondGroundThatLifts)
{
  StixProject project = lifted_ground(2.5);
  project.scenarios[0].stages[0].layers = {
      box_layer("clay", {0.0, -6.0}, {100.0, 0.0}, 1), box_layer("sand", {0.0, -10.0}, {100.0, -6.0}, 0)};
  project.scenarios[0].stages[0].water.head_lines[1].line = {
      {0.0, 2.0}, {50.0, 2.0}, {50.0, 3.5}, {60.0, 3.5}, {60.0, 2.0}, {100.0, 2.0}};
  const StixSection section(project, 0, 0, StixBasis::deterministic);
  const Vec<2> both = with_uplift(section, "", {49.0, 61.0}), land = with_uplift(section, "left", {49.0, 61.0});
  EXPECT_NEAR(both[0], 30.0, 1.0);
  EXPECT_NEAR(both[1], 80.0, 1.0);
  EXPECT_EQ(land[0], 49.0);
  const StixProject calm = lifted_ground(2.5);
  EXPECT_EQ(with_uplift(StixSection(calm, 0, 0, StixBasis::deterministic), "", {9.0, 11.0}), (Vec<2>{9.0, 11.0}));
}

/// The dike of 4 m on sand without cohesion, 6 m of clay between: the water in the sand stands 3 m above the polder.
StixProject lifted_dike()
{
  StixStage stage = river_dike();
  stage.water.head_lines[1].line = {{-20.0, 3.0}, {40.0, 3.0}};
  StixProject project = project_of({stage});
  project.soils[0].advanced.cohesion.value = 0.0;
  return project;
}

TEST(Film, IsABodyOfTheCaseThatSaysSo)
{
  FolderOptions options{.cell = 1.0, .kinds = kinds()};
  const StixProject project = lifted_dike();
  const CaseFolder with = case_folder_of(project, options);
  const std::string& text = with.files.front().second;
  EXPECT_NE(text.find("name     = \"film at the top of sand (sand)\""), std::string::npos);
  EXPECT_NE(text.find("friction_angle  = { csv = \"film_sand.csv\" }"), std::string::npos);
  EXPECT_NE(text.find("--no-film leaves it out"), std::string::npos);
  EXPECT_TRUE(std::ranges::any_of(with.files, [](const auto& file) { return file.first == "film_sand.csv"; }));
  options.has_films = false;
  EXPECT_EQ(case_folder_of(project, options).files.front().second.find("film"), std::string::npos);
}

}  // namespace film_test
