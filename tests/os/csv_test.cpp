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

TEST(Csv, ReadsWhatItWrites)
{
  EXPECT_THAT(csv_cells(csv_cell("a, \"b\"") + ",,2.5, c "), ElementsAre("a, \"b\"", "", "2.5", " c "));
  EXPECT_THAT(csv_cells(""), ElementsAre(""));
}

}  // namespace csv_test
