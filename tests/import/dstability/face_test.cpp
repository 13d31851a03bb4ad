// Cohesion in the outer metre of drained soil of the dike.
#include "import/dstability/case_folder.hpp"
#include "import/dstability/section_part.hpp"
#include "import/dstability/soil_text.hpp"
#include "io/case/case_file.hpp"
#include "river_dike.hpp"

namespace face_test {

/// The dike of 4 m, of sand down to z = -2 m, without cohesion.
StixProject sand_dike(Real cohesion = 0.0)
{
  StixStage stage = river_dike();
  stage.layers = {{.id = "dike",
                      .label = "dike",
                      .outline = {{-20.0, 0.0}, {-4.0, 0.0}, {4.0, 4.0}, {8.0, 4.0}, {16.0, 0.0}, {40.0, 0.0},
                          {40.0, -2.0}, {-20.0, -2.0}},
                      .soil = 0},
      box_layer("clay", {-20.0, -6.0}, {40.0, -2.0}, 1), box_layer("sand", {-20.0, -10.0}, {40.0, -6.0}, 0)};
  StixProject project = project_of({stage});
  StixSoil& sand = project.soils[0];
  sand.weight_above = sand.weight_below;
  sand.advanced.cohesion.value = cohesion;
  return project;
}

FolderOptions options_of(Real face_cohesion = 2e3)
{
  return {.cell = 1.0, .kinds = kinds(), .has_films = false, .face_cohesion = face_cohesion};
}

std::string case_of(const StixProject& project, Real face_cohesion = 2e3)
{
  return case_folder_of(project, options_of(face_cohesion)).files.front().second;
}

TEST(Face, IsTheOuterMetreOfTheDikeAboveItsInnerToe)
{
  const CaseFolder folder = case_folder_of(sand_dike(), options_of());
  const ScratchFolder own;
  for (const auto& [file, contents] : folder.files) std::ofstream(own.path() + "/" + file) << contents;
  const Case read = read_case(own.path() + "/case.toml").values;
  std::map<std::string, Real> areas;
  for (const BodyCase& body : read.bodies) areas[body.material] += signed_area(body.polygon);
  EXPECT_NEAR(areas.at("sand_face"), 4.0 * (20.0 + 4.0) / 2.0, 1e-6);
  EXPECT_NEAR(areas.at("sand"), 60.0 * 2.0 + 60.0 * 2.0, 1e-6) << "the land and the aquifer have none";
  const std::string& text = folder.files.front().second;
  EXPECT_NE(text.find("{ depth = [[0, \"2 kPa\"], [1, \"2 kPa\"], [1, \"0 kPa\"], [50, \"0 kPa\"]] }"), text.npos);
  EXPECT_NE(text.find("sand_face: a cohesion of 2 kPa down to 1 m below the ground, in place of 0.00 kPa"), text.npos);
  EXPECT_NE(text.find("sand_face: een cohesie van 2 kPa tot 1 m onder het maaiveld"), text.npos);
}

TEST(Face, IsNoneOfSoilWithCohesionOrWhereItIsNotWanted)
{
  EXPECT_EQ(case_of(sand_dike(3e3)).find("_face"), std::string::npos);
  EXPECT_EQ(case_of(sand_dike(), 0.0).find("_face"), std::string::npos);
  EXPECT_NE(case_of(sand_dike(3e3), 4e3).find("[1, \"4 kPa\"], [1, \"2.59807621 kPa\"]"), std::string::npos);
}

TEST(Face, IsNoneOfSoilDeepInTheDike)
{
  StixProject project = sand_dike();
  auto& layers = project.scenarios[0].stages[0].layers;
  layers[0].outline = {{-4.0, 0.0}, {4.0, 2.0}, {8.0, 2.0}, {16.0, 0.0}};
  const StixLayer body{.id = "cover",
      .label = "cover",
      .outline = {{-20.0, 0.0}, {-10.0, 0.0}, {0.0, 4.0}, {12.0, 4.0}, {22.0, 0.0}, {40.0, 0.0}, {40.0, -2.0},
          {-20.0, -2.0}},
      .soil = 1};
  layers.insert(layers.begin(), body);
  EXPECT_EQ(case_of(project).find("_face"), std::string::npos);
}

TEST(Face, TheToeIsThatOfTheFileElseWhereTheGroundComesDownOnTheSideOfTheLand)
{
  const SectionPart part{.toes = {1.0, 2.0}, .why = "a dike"};
  EXPECT_EQ(inner_toe(part, "left", not_given, 0.0), 2.0);
  EXPECT_EQ(inner_toe(part, "right", not_given, 0.0), 1.0);
  EXPECT_EQ(inner_toe(part, "", not_given, 0.0), 2.0) << "the higher one";
  EXPECT_EQ(inner_toe(part, "left", 0.5, 0.0), 0.5);
  EXPECT_EQ(inner_toe(part, "left", -1.0, 0.0), 0.0) << "a toe in a ditch";
  EXPECT_FALSE(inner_toe({}, "left", not_given, 0.0)) << "level ground";
}

}  // namespace face_test
