#include "io/results/table.hpp"
#include "io/results/runs.hpp"
#include "run/measure/followers.hpp"
#include "support/scratch.hpp"

namespace table_test {

using TableTest = ScratchTest;

TEST_F(TableTest, OfTheLedgerHasItsColumnsByName)
{
  const Table table = read_number_table(path_in(write_run(scratch.path() + "/run"), ledger_file));
  EXPECT_EQ(table.n_rows(), 2);
  EXPECT_THAT(*table.find("time"), ElementsAre(0.0, 0.25));
  EXPECT_THAT(*table.find("moved_volume"), ElementsAre(4.25, 4.25));
  EXPECT_TRUE(std::isnan((*table.find("crest_x"))[0]));
  EXPECT_EQ(table.find("warmth"), nullptr);
}

TEST_F(TableTest, OfTheHistoryIsOnePerPoint)
{
  const auto points = read_history(path_in(write_run(scratch.path() + "/run"), history_file));
  ASSERT_EQ(points.size(), 2);
  EXPECT_EQ(points[0].point, "A");
  EXPECT_THAT(*points[0].table.find("su"), ElementsAre(8000.0, 8000.0));
  EXPECT_THAT(*points[1].table.find("x"), ElementsAre(2.5, 2.5));
  EXPECT_EQ(points[1].table.find("point"), nullptr);
  EXPECT_TRUE(std::isnan((*points[1].table.find("su"))[1]));
}

TEST_F(TableTest, ReadsQuotedNamesAndLeavesOutALineThatIsBeingWritten)
{
  const std::string path = scratch.path() + "/history.csv";
  write_file_atomically(path, "time,point,x\n0,\"toe, \"\"left\"\"\",1.5\n0.1,\"toe, \"\"left\"\"\",2.5\n0.2,\"to");
  const auto points = read_history(path);
  ASSERT_EQ(points.size(), 1);
  EXPECT_EQ(points[0].point, "toe, \"left\"");
  EXPECT_THAT(*points[0].table.find("x"), ElementsAre(1.5, 2.5));
}

TEST_F(TableTest, WithALineOfAnotherLengthIsRefusedWithItsNumber)
{
  const std::string path = scratch.path() + "/ledger.csv";
  write_file_atomically(path, "time,step\n0,0\n1\n");
  EXPECT_EQ(
      file_error_of([&] { read_number_table(path); }), "cannot read " + path + ": line 3 has 1 columns, the header 2");
  write_file_atomically(path, "");
  EXPECT_EQ(file_error_of([&] { read_number_table(path); }), "cannot read " + path + ": it has no header");
}

TEST(DescribeColumn, NamesEveryColumnOfTheTables)
{
  for (const auto& table : all_tables())
    for (const QuantityInfo& column : table->columns) {
      EXPECT_EQ(describe_column(column.name).unit, column.unit) << column.name;
      EXPECT_FALSE(column.label.empty() || column.meaning.empty()) << table->name << ' ' << column.name;
    }
  EXPECT_EQ(describe_column("front_x").unit, "m");
  EXPECT_EQ(describe_column("porosity").label, "porosity");
}

}  // namespace table_test
