// What the formulas of one run may name: the constants of expected.toml, numbers of the case as it runs, and `end` and
// `dt`.
#pragma once

#include "io/case/case_file.hpp"
#include "io/case/expression.hpp"
#include "verify/expected.hpp"

namespace terp {

struct Scope {
  const Expected& file;
  std::map<std::string, Real> constants = {};

  /// Throws CaseError with the place of the formula.
  Real evaluate(const Formula& formula) const;
  /// The same; `otherwise` if the formula is not given.
  Real evaluate_or(const Formula& formula, Real otherwise) const;
  /// Unit of errors: 1 if it is not given. Throws CaseError unless it is finite and greater than 0.
  Real scale(const Formula& formula) const;
  Expression compile(const Formula& formula, const std::vector<std::string>& variables) const;
};

/// Constants in the order of the file, then those of the run; each may use those before it. dt [s] of the run.
Scope make_scope(const Expected& file, const Variant& variant, const CaseFile& solved, Real dt);

}  // namespace terp
