// A constant sees only those that are already in the scope. First come `end` and `dt` of the run, then constants of the
// file, then those of the variant. A constant from the case is what is written there or in `set`, in SI; defaults are
// not found. Constants are bound when a formula is compiled, and variables when it is evaluated.

#include "verify/scope.hpp"

#include "io/case/keys.hpp"
#include "io/case/units.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

Real number_of_case(const Expected& file, const Constant& c, const CaseFile& solved)
{
  const Node* node = find_node(solved.source.root, c.key);
  if (node == nullptr)
    refuse(file, c.formula.place, fmt::format("the case says nothing of `{}`", c.key),
        "A constant takes a number that case.toml or `set` gives.");
  const auto number = number_of(*node, unit_at(c.key));
  if (!number) refuse(file, c.formula.place, fmt::format("`{}` is not a number", c.key), "");
  return *number;
}

void add_constants(Scope& scope, const std::vector<Constant>& constants, const CaseFile& solved)
{
  for (const Constant& c : constants)
    scope.constants[c.name] = c.key.empty() ? scope.evaluate(c.formula) : number_of_case(scope.file, c, solved);
}

}  // namespace

Real Scope::evaluate(const Formula& formula) const
{
  try {
    return terp::evaluate(formula.text, constants);
  } catch (const ExpressionError& error) {
    refuse(file, formula.place, "this formula cannot be evaluated", error.what());
  }
}

Real Scope::evaluate_or(const Formula& formula, Real otherwise) const
{
  return formula.given() ? evaluate(formula) : otherwise;
}

Real Scope::scale(const Formula& formula) const
{
  const Real value = evaluate_or(formula, 1.0);
  if (!(std::isfinite(value) && value > 0.0))
    refuse(file, formula.place, "`scale` must be a finite number, greater than 0", fmt::format("Got {}.", value));
  return value;
}

Expression Scope::compile(const Formula& formula, const std::vector<std::string>& variables) const
{
  try {
    return {formula.text, variables, constants};
  } catch (const ExpressionError& error) {
    refuse(file, formula.place, "this formula cannot be evaluated", error.what());
  }
}

Scope make_scope(const Expected& file, const Variant& variant, const CaseFile& solved, Real dt)
{
  Scope scope{.file = file, .constants = {{"end", solved.values.time.end}, {"dt", dt}}};
  add_constants(scope, file.constants, solved);
  add_constants(scope, variant.constants, solved);
  return scope;
}

}  // namespace terp
