#include "import/dstability/drawing_folder.hpp"

#include "sections.hpp"
#include "support/problems.hpp"

namespace drawing_folder_test {

const DxfRegions two_layers{{{"Zand 1", {{0, 0}, {40, 0}, {40, 2}, {0, 2}}},
                                {"klei", {{0, 2}, {40, 2}, {40, 4}, {25, 4}, {22, 7}, {18, 7}, {12, 4}, {0, 4}}}},
    {}};

std::string case_text(const DxfRegions& drawing, const DrawingFolderOptions& options)
{
  return drawing_folder_of(drawing, {}, options).files.front().second;
}

TEST(DrawingFolder, HasABodyForEachRegionWithTheSoilOfItsName)
{
  const std::string text = case_text(two_layers, {.path = "d.dxf", .kinds = kinds()});
  EXPECT_THAT(text,
      HasSubstr(
          "# Layer \"Zand 1\" of the drawing\n[[body]]\nname     = \"Zand 1\"\nmaterial = \"zand_1\"\npolygon  = "));
  EXPECT_THAT(text, HasSubstr("[material.zand_1]\nmodel          = \"mohr_coulomb\""));
  EXPECT_THAT(text, HasSubstr("[material.klei]\nmodel           = \"tresca_softening\""));
  EXPECT_THAT(text, HasSubstr("phreatic_line = [[0.0, 3.5]]"));  // half a metre below the ground at 4 m
}

TEST(DrawingFolder, TakesAPartAndASizeOfCells)
{
  const std::string text =
      case_text(two_layers, {.path = "d.dxf", .cell = 0.5, .between = Vec<2>{10.0, 30.0}, .kinds = kinds()});
  EXPECT_THAT(text, HasSubstr("origin = [10.0, 0.0]"));
  EXPECT_THAT(text, HasSubstr("size   = [20.0, 8.0]"));  // 7 m and two cells of air
  EXPECT_THAT(text, HasSubstr("cell   = 0.5"));
}

TEST(DrawingFolder, FillsBelowAnUnevenBase)
{
  const DxfRegions wedge{{{"sand", {{0, 0}, {20, 1}, {20, 4}, {0, 4}}}}, {}};
  const CaseFolder folder = drawing_folder_of(wedge, {}, {.path = "d.dxf", .kinds = kinds()});
  EXPECT_THAT(folder.files.front().second, HasSubstr("Not in the drawing: fills what is below its base"));
  EXPECT_THAT(folder.files.back().second, HasSubstr("10.000 m2 below the base were filled."));
}

TEST(DrawingFolder, RefusesOutlinesThatAreNone)
{
  const DxfRegions bow{{{"sand", {{0, 0}, {40, 0}, {40, 5}, {0, 5}}}, {"bow", {{1, 1}, {2, 2}, {2, 1}, {1, 2}}}}, {}};
  const std::vector<DrawingFolderOptions> all{
      {.path = "d.dxf", .kinds = kinds()}, {.path = "d.dxf", .between = Vec<2>{0.5, 30.0}, .kinds = kinds()}};
  for (const DrawingFolderOptions& options : all)
    EXPECT_THAT(problems_of([&] { case_text(bow, options); }),
        ElementsAre(told("bow", "this outline is no layer", HasSubstr("the polygon crosses itself"))));
}

TEST(DrawingFolder, ListsRegionsWithTheirAreas)
{
  EXPECT_THAT(drawing_listing(two_layers, {"A note."}),
      AllOf(ContainsRegex("klei +105\\.500 "), ContainsRegex("all +185\\.500"), HasSubstr("A note.\n")));
}

}  // namespace drawing_folder_test
