#include "soil/row_table.hpp"
#include "mpm/points/point_blocks.hpp"
#include "support/test.hpp"

namespace row_table_test {

RowInfo opening(Index material)
{
  return {.name = "opening",
      .unit = "-",
      .meaning = "gap",
      .owner = "law",
      .averaging = Averaging::cell,
      .initial = 0.2,
      .shown = true,
      .of = {material}};
}

TEST(RowTable, BeginsWithTheFixedRowsWhereTheKernelsLookForThem)
{
  const RowTable table;
  EXPECT_EQ(table.n_rows(), Rows::state);
  EXPECT_TRUE(table.added().empty());
  for (const RowInfo& row : table.entries()) {
    const int expected = row.name == "velocity" ? Rows::v
                         : row.name == "stress" ? Rows::sigma
                         : row.name == "id"     ? Rows::id
                                                : row.first;
    EXPECT_EQ(row.first, expected) << row.name;
    EXPECT_TRUE(row.saved && row.is_of(7)) << row.name;
  }
}

TEST(RowTable, SharesARowThatTwoMaterialsHave)
{
  RowTable table;
  const int first = table.add(opening(0));
  const int other = table.add({.name = "parameter_eta", .unit = "-", .meaning = "shape", .owner = "law"});
  EXPECT_EQ(table.add(opening(2)), first);
  EXPECT_EQ(first, Rows::state);
  EXPECT_EQ(other, first + 1);
  EXPECT_EQ(table.n_rows(), other + 1);
  const RowInfo& row = table.added()[0];
  EXPECT_TRUE(row.is_of(0) && !row.is_of(1) && row.is_of(2));
  EXPECT_EQ(row.initial, 0.2);
}

TEST(RowTable, SizesTheBlocks)
{
  RowTable table;
  table.add(opening(0));
  const PointBlocks<2> points(3, table);
  EXPECT_EQ(points.n_rows(), Rows::state + 1);
  EXPECT_EQ(points.table().added()[0].name, "opening");
}

TEST(RowView, TakesRowsInAnyOrder)
{
  Real numbers[6] = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const int picked[] = {2, 0};
  const RowView some{numbers, 2, picked}, all{numbers, 2};
  EXPECT_EQ(*some(0), 5.0);
  EXPECT_EQ(*some(1), 1.0);
  EXPECT_EQ(*all(1), 3.0);
}

}  // namespace row_table_test
