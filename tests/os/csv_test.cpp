// Cells of a CSV table, written and read.
#include "os/csv.hpp"
#include "support/test.hpp"

namespace csv_test {

TEST(Csv, ACellIsInQuotesWhereItMustBe)
{
  EXPECT_EQ(csv_cell("clay"), "clay");
  EXPECT_EQ(csv_cell("clay, wet"), "\"clay, wet\"");
  EXPECT_EQ(csv_cell("the \"old\" dike"), "\"the \"\"old\"\" dike\"");
  EXPECT_EQ(csv_cell("first\r\nsecond"), "first; second");
}

TEST(Csv, ATextOfOthersIsNoFormula)
{
  EXPECT_EQ(plain_csv_cell("=HYPERLINK(\"a\",\"b\")"), "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\"");
  EXPECT_EQ(plain_csv_cell(" +1+cmd"), "' +1+cmd");
  EXPECT_EQ(plain_csv_cell("@sum"), "'@sum");
  EXPECT_EQ(plain_csv_cell("-clay"), "'-clay");
  for (const char* plain : {"-1.5", "+2e3", "clay = peat", "", "dike"}) EXPECT_EQ(plain_csv_cell(plain), plain);
}

TEST(Csv, ReadsWhatItWrites)
{
  EXPECT_THAT(csv_cells(csv_cell("a, \"b\"") + ",,2.5, c "), ElementsAre("a, \"b\"", "", "2.5", " c "));
  EXPECT_THAT(csv_cells(""), ElementsAre(""));
}

}  // namespace csv_test
