#include "model/bodies/points_csv.hpp"
#include "support/paths.hpp"

namespace points_csv_test {

std::string message_for(const std::string& text)
{
  return refusal<CsvError>([&] { read_points_csv_text("points.csv", text); });
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
  for (const char* wrong : {"+", "+-1", "++1", "-+1", "+ 1"})
    EXPECT_THAT(message_for(std::string("x,y,volume,material\n") + wrong + ",1,1,clay\n"),
        HasSubstr(std::string("x is `") + wrong + "`, which is not a number"));
}

TEST(PointsCsv, RefusesAnUnknownColumnAndSaysWhatWasMeant)
{
  EXPECT_EQ(message_for("x,y,volme,material\n1,2,3,clay\n"),
      "the table of points has 2 faults:\n"
      "  points.csv:1: unknown column `volme`; did you mean `volume`?\n"
      "  points.csv:1: no column `volume`\n"
      "  It has the columns x, y, volume, material: m, m, m^2 (volume per metre of thickness), and a material of the "
      "case.");
  EXPECT_THAT(
      message_for("x,y,volume,material,temperature\n"), HasSubstr("points.csv:1: unknown column `temperature`\n"));
  EXPECT_THAT(message_for("x,y,x,volume,material\n"), HasSubstr("points.csv:1: column `x` is there 2 times"));
}

TEST(PointsCsv, SaysOnceHowValuesAreSeparated)
{
  EXPECT_EQ(message_for("x;y;volume;material\n1;2;3;clay\n"),
      "the table of points has 1 fault:\n"
      "  points.csv:1: the values are separated by semicolons; Terp reads commas, and a decimal point in numbers. In a "
      "spreadsheet: save as CSV with commas, language English\n"
      "  It has the columns x, y, volume, material: m, m, m^2 (volume per metre of thickness), and a material of the "
      "case.");
  EXPECT_THAT(message_for("x\ty\tvolume\tmaterial\n"),
      HasSubstr("1 fault:\n  points.csv:1: the values are separated by tabs;"));
  EXPECT_THAT(message_for("x y volume material\n"), HasSubstr("the values are separated by blanks;"));
  EXPECT_THAT(message_for("x,y,volume,material\n1,5,2,0,0,25,clay\n"),
      HasSubstr("points.csv:2: 7 values, and 4 columns; numbers have a decimal point, no comma\n"));
  EXPECT_THAT(message_for("x,y,volume,material\n\"1,5\",2,0.25,clay\n"),
      HasSubstr("points.csv:2: x is `1,5`, which is not a number; numbers have a decimal point, no comma\n"));
}

TEST(PointsCsv, AQuoteEndsInItsLine)
{
  for (const char* wrong : {"1,2,0.5,\"clay\n1,2,0.5,clay\n", "1,2,0.5,clay\"\n", "\"1,2,0.5,clay\n"})
    EXPECT_THAT(message_for(std::string("x,y,volume,material\n") + wrong),
        HasSubstr("1 fault:\n  points.csv:2: a quote is not closed in its line; a quote in a text stands twice\n"));
  EXPECT_THAT(message_for("x,y,volume,\"material\n1,2,0.5,clay\n"),
      HasSubstr("1 fault:\n  points.csv:1: a quote is not closed in its line;"));
  const auto points = read_points_csv_text("points.csv", "x,y,volume,material\n1,2,0.5,\"clay, \"\"old\"\"\"\n");
  EXPECT_EQ(points[0].material, "clay, \"old\"");
}

TEST(PointsCsv, SaysWhatIsWrongWithEachLine)
{
  const std::string message = message_for(
      "x,y,volume,material\n1,2,0.5,clay\n1,2,clay\n1,two,0.5,clay\nnan,2,0.5,clay\n1,inf,0.5,clay\n"
      "1,2,0,clay\n1,2,-3e-4,clay\n1,2,0.5,\n1,2,3x,clay\n");
  EXPECT_THAT(message, HasSubstr("the table of points has 8 faults:\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:3: 3 values, and 4 columns\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:4: y is `two`, which is not a number\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:5: x is nan; it must be finite\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:6: y is inf; it must be finite\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:7: volume is 0 m^2; it must be greater than 0\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:8: volume is -3e-4 m^2; it must be greater than 0\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:9: material is empty\n"));
  EXPECT_THAT(message, HasSubstr("points.csv:10: volume is `3x`, which is not a number\n"));
}

TEST(PointsCsv, ShowsTenFaultsAndCountsTheRest)
{
  std::string text = "x,y,volume,material\n";
  for (int k = 0; k < 13; ++k) text += "1,2,0,clay\n";
  EXPECT_THAT(message_for(text), AllOf(HasSubstr("the table of points has 13 faults:\n"), HasSubstr("points.csv:11: "),
                                     Not(HasSubstr("points.csv:12: ")), HasSubstr("\n  and 3 more\n")));
}

TEST(PointsCsv, RefusesATableWithoutPoints)
{
  EXPECT_THAT(message_for(""), HasSubstr("points.csv:1: the file is empty\n"));
  EXPECT_THAT(
      message_for("x,y,volume,material\n"), HasSubstr("points.csv:1: no rows below the names of the columns\n"));
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
