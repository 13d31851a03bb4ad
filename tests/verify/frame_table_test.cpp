#include "verify/frame_table.hpp"
#include "support/test.hpp"

namespace frame_table_test {

TEST(FrameTable, NamesComponentsAndTheFirstPlace)
{
  const Frame frame{.time = 0.5,
      .step = 3,
      .x = {1.0, 2.0, 5.0, 6.0},
      .fields = {{"displacement", "m", 3, {0.25, -0.5, 0.0, 1.0, 1.5, 0.0}},
          {"stress", "Pa", 4, {1.0, 2.0, 6.0, 9.0, -1.0, -2.0, -3.0, 4.0}}, {"su", "Pa", 1, {7.0, 8.0}},
          {"unknown", "-", 2, {1.0, 2.0, 3.0, 4.0}}}};
  EXPECT_THAT(
      names_of(frame), ElementsAre("t", "x", "y", "ux", "uy", "x0", "y0", "sxx", "syy", "szz", "sxy", "p", "su"));
  std::vector<Real> row;
  read_row(frame, 0, row);
  EXPECT_THAT(row, ElementsAre(0.5, 1.0, 2.0, 0.25, -0.5, 0.75, 2.5, 1.0, 2.0, 6.0, 9.0, 3.0, 7.0));
  read_row(frame, 1, row);
  EXPECT_THAT(row, ElementsAre(0.5, 5.0, 6.0, 1.0, 1.5, 4.0, 4.5, -1.0, -2.0, -3.0, 4.0, -2.0, 8.0));
}

}  // namespace frame_table_test
