#include "model/bodies/points_csv.hpp"
#include "model/bodies/values_csv.hpp"
#include "support/catalogue.hpp"
#include "support/paths.hpp"

namespace points_csv_test {

TEST(PointsCsv, AndValuesThatAreNoneHaveTheMessageOfTheCatalogue)
{
  const std::string path = source_path("tests/model/bodies/tables.wrong");
  for (const WrongRow& row : read_catalogue(path))
    expect_row(path, row, refusal<CsvError>([&] {
      if (row.name == "points") read_points_csv_text("points.csv", row.before);
      if (row.name == "values") read_values_csv_text("su.csv", row.before);
    }));
}

TEST(PointsCsv, ReadsPointsInTheOrderOfTheFile)
{
  const auto points = read_points_csv_text("points.csv", "x,y,volume,material\n0.25,-1.5e-1,4e-4,clay\n3,4,0.5,sand\n");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].x, (Vec<2>{0.25, -0.15}));
  EXPECT_EQ(points[0].volume, 4e-4);
  EXPECT_EQ(points[0].material, "clay");
  EXPECT_EQ(points[0].line, 2);
  EXPECT_EQ(points[1].x, (Vec<2>{3.0, 4.0}));
  EXPECT_EQ(points[1].material, "sand");
  EXPECT_EQ(points[1].line, 3);
}

TEST(PointsCsv, TakesColumnsInAnyOrderAndPassesOverSpacesCommentsAndEmptyLines)
{
  const std::string text =
      "\xEF\xBB\xBF# from the survey\r\n\r\n material , volume,\"y\", x\r\n \"clay\" , 0.5 ,2, 1\r\n\r\n# end";
  const auto points = read_points_csv_text("points.csv", text);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].x, (Vec<2>{1.0, 2.0}));
  EXPECT_EQ(points[0].volume, 0.5);
  EXPECT_EQ(points[0].material, "clay");
  EXPECT_EQ(points[0].line, 4);
}

TEST(PointsCsv, ANumberMayBeginWithAPlus)
{
  const auto points = read_points_csv_text("points.csv", "x,y,volume,material\n+0.06,-1,+4e-4,clay\n");
  EXPECT_EQ(points[0].x, (Vec<2>{0.06, -1.0}));
  EXPECT_EQ(points[0].volume, 4e-4);
}

TEST(PointsCsv, TakesAQuoteInAText)
{
  const auto points = read_points_csv_text("points.csv", "x,y,volume,material\n1,2,0.5,\"clay, \"\"old\"\"\"\n");
  EXPECT_EQ(points[0].material, "clay, \"old\"");
}

TEST(PointsCsv, ReadsAFileAndSaysWhichOneItCannotRead)
{
  const ScratchFolder folder;
  const std::string path = folder.path() + "/points.csv";
  std::ofstream(path) << "x,y,volume,material\n1,2,0.5,clay\n";
  EXPECT_EQ(read_points_csv(path).size(), 1u);
  EXPECT_EQ(refusal<FileError>([&] { read_points_csv(folder.path() + "/other.csv"); }),
      "cannot read " + folder.path() + "/other.csv: No such file or directory");
}

}  // namespace points_csv_test
