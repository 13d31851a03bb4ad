// Rows of the ledger: each number against its reference.
#pragma once

#include "verify/solve_variant.hpp"

namespace terp {

enum class Verdict {
  pass,        ///< agrees with a reference from outside Terp
  regression,  ///< agrees, but with no more than what Terp itself gave
  red,         ///< does not agree, and the case says why
  fail,        ///< does not agree, and nobody has said why
};

/// One row, ready to be shown.
struct Row {
  std::string case_name = {}, run = {}, quantity = {}, reference = {}, source = {}, terp = {}, error = {},
              tolerance = {};
  Verdict verdict = Verdict::pass;
  bool declared_red = false;         ///< the case declares that it does not agree
  bool declared_regression = false;  ///< the case declares that no value from outside Terp holds it
  std::string remark = {};           ///< why it is red or a regression row, or what went wrong
  Real used = -1.0;  ///< share of the bound that is used [-], 1 at the bound; negative: the bound has no size
};

/// The row of a run, or of a whole case, that gave no numbers.
Row fault_row(
    const std::string& case_name, const std::string& run, const std::string& quantity, const std::string& fault);

/// Rows of one case from all its runs: quantities in the order of the file, then orders of convergence.
std::vector<Row> judge(const std::string& case_name, const Expected& file, const std::vector<Solve>& solves,
    const std::vector<Solved>& solved);

}  // namespace terp
