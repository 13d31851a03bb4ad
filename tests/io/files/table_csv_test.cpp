#include "io/files/table_csv.hpp"
#include "io/files/samples.hpp"
#include "support/paths.hpp"

namespace table_csv_test {

struct TableCsv : testing::Test {
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/ledger.csv", ledger_header = header_of(*sample_ledger_table()),
                    history_header = header_of(*history_table());
};

TEST_F(TableCsv, AHistoryRowIsWrittenWithShortestNumbersAndNan)
{
  EXPECT_EQ(csv_lines(sample_history(0.1)),
      "0.1,A,7,1.5,0.25,0.01,0.002,8000,-125.5,nan\n"
      "0.1,B,9,2.5,0.75,0.03,0,nan,0.3333333333333333,nan\n");
}

TEST_F(TableCsv, ANegativeNanIsNanToo)
{
  auto rows = sample_history(0.1);
  rows[0]["su"] = -std::nan("");
  EXPECT_THAT(csv_lines(rows), HasSubstr(",nan,-125.5,nan\n"));
}

TEST_F(TableCsv, ANameWithACommaOrAQuotationMarkIsQuoted)
{
  auto rows = sample_history(0.0);
  rows[0].text = "toe, \"left\"";
  EXPECT_THAT(csv_lines(rows), StartsWith("0,\"toe, \"\"left\"\"\",7,"));
}

TEST_F(TableCsv, ALedgerRowFollowsItsHeader)
{
  EXPECT_EQ(csv_lines(sample_ledger(0.5)),
      "0.5,100,2,1.25,0.75,2.5,nan,3.75,0.0625,4.5,-5.5,-6.5,0.375,0.875,-0.5,nan,-0.25,0.125,1e-12,nan,nan,nan,"
      "31840,640,320,7.5,-8.5,3,0,"
      "6.25,5.75,13.1,nan,1.75,nan,3.5,1.5,4.25,nan,nan,3.25,5.125,4.5\n");
  EXPECT_THAT(ledger_header, StartsWith("time,step,stage,kinetic,kinetic_nodal,elastic,"));
  EXPECT_EQ(std::ranges::count(ledger_header, ','), 42);
}

TEST_F(TableCsv, OpeningWritesTheHeaderOnce)
{
  TableFile(path, history_header).append(csv_lines(sample_history(0.1)));
  TableFile(path, history_header).append(csv_lines(sample_history(0.2)));
  EXPECT_EQ(read_file(path), history_header + "\n" + csv_lines(sample_history(0.1)) + csv_lines(sample_history(0.2)));
}

TEST_F(TableCsv, RowsAfterATimeAreDroppedAndThatTimeStays)
{
  const Real exact = 0.1 + 0.2;  // not 0.3: only the exact bits keep the row
  TableFile table(path, ledger_header);
  for (const Real time : {0.1, exact, std::nextafter(exact, 1.0)}) table.append(csv_lines(sample_ledger(time)));
  drop_rows_after(path, ledger_header, exact);
  EXPECT_EQ(read_file(path), ledger_header + "\n" + csv_lines(sample_ledger(0.1)) + csv_lines(sample_ledger(exact)));
}

TEST_F(TableCsv, ALastRowThatWasCutShortIsDropped)
{
  TableFile(path, ledger_header).append(csv_lines(sample_ledger(0.1)) + "0.2,100,1.2");
  drop_rows_after(path, ledger_header, 5.0);
  EXPECT_EQ(read_file(path), ledger_header + "\n" + csv_lines(sample_ledger(0.1)));
}

/// A table is begun when its first row comes, which may be after the checkpoint that a run goes on from.
TEST_F(TableCsv, OneThatWasCutWithinItsHeaderIsBegunAgain)
{
  const std::string header = header_of(*table_named("left_the_mesh")) + '\n';
  for (const std::size_t length : {std::size_t{0}, std::size_t{12}, header.size() - 1}) {
    const ScratchFolder folder;
    const std::string path = folder.path() + "/left_the_mesh.csv";
    write_file_atomically(path, header.substr(0, length));
    EXPECT_EQ(read_part_until(path, header_of(*table_named("left_the_mesh")), 5.0).n_rows, 0) << length;
    drop_rows_after(path, header_of(*table_named("left_the_mesh")), 5.0);
    TableFile(path, header_of(*table_named("left_the_mesh"))).append("");
    EXPECT_EQ(read_file(path), header) << length;
  }
}

TEST_F(TableCsv, CountsTheWholeRowsUpToATime)
{
  EXPECT_EQ(read_part_until(path, ledger_header, 1.0).n_rows, 0);
  EXPECT_EQ(read_part_until(path, ledger_header, 1.0).checksum, "");
  TableFile table(path, ledger_header);
  for (const Real time : {0.1, 0.2, 0.3}) table.append(csv_lines(sample_ledger(time)));
  table.append("0.4,100,1.2");
  EXPECT_EQ(read_part_until(path, ledger_header, 0.2).n_rows, 2);
  EXPECT_EQ(read_part_until(path, ledger_header, 0.4).n_rows, 3);
}

TEST_F(TableCsv, TheChecksumOfAGrowingTableIsThatOfItsPartUpToThere)
{
  std::string first, second;
  {
    TableFile table(path, ledger_header);
    table.append(csv_lines(sample_ledger(0.1)));
    first = table.checksum();
  }
  TableFile again(path, ledger_header);
  EXPECT_EQ(again.checksum(), first);
  again.append(csv_lines(sample_ledger(0.2)));
  second = again.checksum();
  again.append(csv_lines(sample_ledger(0.3)));
  EXPECT_EQ(read_part_until(path, ledger_header, 0.1).checksum, first);
  EXPECT_EQ(read_part_until(path, ledger_header, 0.2).checksum, second);
  EXPECT_NE(first, second);
}

TEST_F(TableCsv, ATableOfOtherColumnsIsRefused)
{
  write_file_atomically(path, "time,x\n0.1,2\n");
  EXPECT_EQ(file_error_of([&] { drop_rows_after(path, history_header, 1.0); }),
      "cannot continue " + path + ": its columns are not those of terp " TERP_VERSION);
}

TEST_F(TableCsv, WithoutATableThereIsNothingToDrop) { EXPECT_NO_THROW(drop_rows_after(path, history_header, 1.0)); }

TEST_F(TableCsv, OneLinePerFooting)
{
  TableRow row(table_named("footings"), "plate, left");
  row.values = {0.25, 0.0, -0.125, 1.5, 20000.5, 64.0};
  EXPECT_EQ(csv_lines({row, row}),
      "0.25,\"plate, left\",0,-0.125,1.5,20000.5,64\n0.25,\"plate, left\",0,-0.125,1.5,20000.5,64\n");
}

}  // namespace table_csv_test
