// A formula that a file holds as text: "V sin(pi x / L)" is written V*sin(pi*x/L). Names of variables and constants
// come from the caller; functions are those of muParser, and erf, erfc, mod, step (0 before 0, else 1). Not for: what
// runs in a step, nor keys of a case file, which are numbers.
#pragma once

#include "math/types.hpp"

#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace terp {

/// The text is not a formula, or names what is not there. what(): why, in a sentence.
class ExpressionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Copies are cheap, and one expression may be evaluated by several threads at once.
class Expression {
 public:
  /// A text that speaks of a constant which bears the name of a variable is refused. Throws ExpressionError.
  Expression(
      const std::string& text, const std::vector<std::string>& variables, const std::map<std::string, Real>& constants);

  /// Its value; the numbers are those of the variables, in their order. NaN where one that the text speaks of is NaN.
  Real operator()(std::span<const Real> values) const;

 private:
  struct ParsedText;
  std::shared_ptr<const ParsedText> source_;
};

/// A formula without variables.
Real evaluate(const std::string& text, const std::map<std::string, Real>& constants);

/// Functions and constants that any formula knows.
std::vector<std::string> names_in_formulas();

}  // namespace terp
