// The ledger as text for a terminal, and as a Markdown page, long or short.
#pragma once

#include "verification/judge.hpp"

namespace terp {

/// The rows of one case.
struct CaseRows {
  std::string name, title;
  std::vector<Row> rows;
};

struct Counts {
  int pass = 0, red = 0, fail = 0;
  int pass_declared_red = 0;  ///< of those that pass
};

Counts count(const std::vector<CaseRows>& cases);

/// "12 rows: 11 pass, 1 red".
std::string counts_text(const Counts& counts);

std::string text_table(const CaseRows& rows);

/// head: Markdown that stands above the tables, after the title.
std::string markdown_page(const std::vector<CaseRows>& cases, const std::string& head);

/// One line per case with the row that comes nearest to its bound, and what does not agree with its reason. head: as
/// above.
std::string markdown_overview(const std::vector<CaseRows>& cases, const std::string& head);

}  // namespace terp
