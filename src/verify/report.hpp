// The ledger as text for a terminal, and as a Markdown page with all rows. The short page: overview.hpp.
#pragma once

#include "verify/judge.hpp"

namespace terp {

struct CaseRows {
  std::string name, title;
  std::vector<Row> rows;
};

struct Counts {
  int pass = 0, regression = 0, red = 0, fail = 0;
  int agree_declared_red = 0;  ///< of those that pass or are regression rows

  int rows() const { return pass + regression + red + fail; }
};

Counts count(const std::vector<CaseRows>& cases);

/// "12 rows: 10 pass, 1 red, 1 regression".
std::string counts_text(const Counts& counts);

/// More than a tenth of the rows hold Terp against its own results alone.
inline bool too_many_regressions(int regressions, int rows) { return 10 * regressions > rows; }

std::string text_table(const CaseRows& rows);

/// head: Markdown that stands above the tables, after the title.
std::string markdown_page(const std::vector<CaseRows>& cases, const std::string& head);

/// Why a row is no pass; empty: it passes, or has no reason.
std::string remark_of(const Row& row);

/// Those of the rows of a case, each once: of rows that do not agree, or of the regression rows.
std::vector<std::string> remarks_of(const CaseRows& rows, bool of_regressions);

/// Text without what Markdown would take for marks.
std::string for_markdown(const std::string& text);

}  // namespace terp
