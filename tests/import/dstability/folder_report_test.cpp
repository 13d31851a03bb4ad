#include "import/dstability/folder_report.hpp"
#include "support/test.hpp"

namespace folder_report_test {

TEST(FolderReport, AddsTheWeightsAndSaysWhereThereIsNothing)
{
  const std::string text = text_of({.title = "High: High",
      .head = {"Written by terp import."},
      .weights = {{"clay", {2.0, 30e3}}, {"sand", {4.0, 80e3}}},
      .sections = {{"Water", {}}, {"Assumed", {"One.", "Two."}}}});
  EXPECT_THAT(text, testing::StartsWith("# High: High\n\nWritten by terp import.\n\n## Weight\n"));
  EXPECT_THAT(
      text, HasSubstr("| all | 6.000000 | 110.000000 |\n\n## Water\n\n- nothing\n\n## Assumed\n\n- One.\n- Two.\n"));
  EXPECT_THAT(text, HasSubstr("## Not in any file of this kind\n\n- Softening: "));
}

}  // namespace folder_report_test
