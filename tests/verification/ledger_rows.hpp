// A row of the ledger for tests of its pages.
#pragma once

#include "verification/report.hpp"

namespace terp::test {

inline Row row_that_passes(const std::string& case_name)
{
  return {.case_name = case_name,
      .run = "h = 1 m, mpm_gp",
      .quantity = "stress <zz>",
      .reference = "a|b",
      .source = "Euler",
      .terp = "2",
      .error = "0.1",
      .tolerance = "0.2",
      .verdict = Verdict::pass};
}

}  // namespace terp::test
