// The ledger as text for a terminal, and as a Markdown page with all rows. The short page: overview.hpp.
#pragma once

#include "verification/judge.hpp"

namespace terp {

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

/// What a row that does not agree says; empty: it agrees, or has no reason.
std::string remark_of(const Row& row);

/// Those of the rows of a case, each once.
std::vector<std::string> remarks_of(const CaseRows& rows);

/// Text without what Markdown would take for marks.
std::string for_markdown(const std::string& text);

}  // namespace terp
