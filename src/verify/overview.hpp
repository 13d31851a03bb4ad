// The short page of the ledger, docs/verification.md: one line per case, and the reasons of rows that do not agree. A
// case that was not solved keeps what the page says of it, so that one case can be solved again without hours for all.
#pragma once

#include "verify/report.hpp"

#include <map>

namespace terp {

struct OverviewEntry {
  std::string line;  ///< of the table
  int rows = 0, red = 0, regression = 0;
  std::string reasons = {};      ///< a list: why rows are red; empty: all agree
  std::string regressions = {};  ///< a list: why rows are regression rows; empty: there are none
};

/// The entries by the name of their case.
using Overview = std::map<std::string, OverviewEntry>;

/// entries of cases that were solved, each with the row that comes nearest to its bound.
Overview overview_of(const std::vector<CaseRows>& cases);

/// A page that overview_page wrote, read; what is no entry is left out.
Overview read_overview(const std::string& page);

/// head: Markdown that stands above the table, after the title.
std::string overview_page(const Overview& overview, const std::string& head);

}  // namespace terp
