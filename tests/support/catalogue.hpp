// Tables of wrong input with what is said of it, one line each: tests/io/case/wrong_cases/*.wrong and others.
#pragma once

#include <string>
#include <vector>

namespace terp::test {

/// OLD | NEW | what the message holds. OLD stands once in the text; empty: NEW is added at the end. \n: a new line.
/// --set KEY=VALUE --set KEY=VALUE | what the message holds: changes from the command line
/// @ NAME VERDICT: the text that the rows below change, and what becomes of it
struct WrongRow {
  std::string where;  ///< "column.wrong:3"
  std::string name, verdict;
  std::vector<std::string> changes;  ///< of --set
  std::string before, after, expected;
};

/// Rows of the file `path`; those before a line with @ change the text of the file's name and are refused.
std::vector<WrongRow> read_catalogue(const std::string& path);

/// What is said is what the row holds; where TERP_UPDATE_GOLDEN is set, it is written there: look at the difference.
void expect_row(const std::string& path, const WrongRow& row, const std::string& said);

std::string spoil(const std::string& good, const WrongRow& row);

}  // namespace terp::test
