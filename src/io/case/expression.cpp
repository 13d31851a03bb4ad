// How it thinks: muParser writes to its parser when it evaluates, so that no two threads may share one. An Expression
// holds the text alone and never changes; each thread keeps parsers of its own, by the number of the expression.

#include "io/case/expression.hpp"

#include "math/closest.hpp"
#include "math/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string_view>

namespace terp {
namespace {

/// The largest or smallest of numbers; none if one of them is none, which muParser's own leave out.
template <bool largest>
mu::value_type extreme(const mu::value_type* values, int n)
{
  mu::value_type best = values[0];
  for (int k = 0; k < n; ++k) {
    if (std::isnan(values[k])) return values[k];
    best = largest ? std::max(best, values[k]) : std::min(best, values[k]);
  }
  return best;
}

mu::value_type step(mu::value_type x) { return std::isnan(x) ? x : x < 0.0 ? 0.0 : 1.0; }

/// muParser gives `1,2` the value of its last part and takes `=` for an assignment: "0,5" would be 5, and "x0 = 1" hold
/// everywhere. A comma stands only between the arguments of a function, and `=` only in a comparison.
void refuse_what_would_pass(const std::string& text)
{
  std::vector<bool> of_function;  // of the brackets that are open
  char before = ' ';              // the last letter that is no blank
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '(') of_function.push_back(std::isalnum(static_cast<unsigned char>(before)) != 0 || before == '_');
    if (c == ')' && !of_function.empty()) of_function.pop_back();
    if (c == ',' && (of_function.empty() || !of_function.back()))
      throw ExpressionError(fmt::format(
          "The comma at letter {} separates no arguments of a function. The decimal point is `.`, as in 0.5.", k + 1));
    const bool compares =
        k + 1 < text.size() && text[k + 1] == '=' && std::string_view("=<>!").find(c) != std::string_view::npos;
    if (c == '=' && !compares)
      throw ExpressionError(
          fmt::format("`=` at letter {} compares nothing. Compare with `==`, `<=`, `>=` or `!=`.", k + 1));
    if (compares) ++k;
    if (c != ' ' && c != '\t') before = c;
  }
}

/// Why muParser refuses the text, in our words; the nearest name where one is not known.
std::string why(const mu::Parser::exception_type& error, const std::vector<std::string>& names)
{
  const bool unknown = error.GetCode() == mu::ecUNASSIGNABLE_TOKEN || error.GetCode() == mu::ecINVALID_NAME;
  if (!unknown) return error.GetMsg();
  std::vector<std::string> known(names);
  std::ranges::sort(known);
  const std::string word = error.GetToken().substr(0, error.GetToken().find_first_of(" +-*/^()<>=&|,"));
  const std::string nearest = closest(word, known);
  return fmt::format("`{}` is not known here.{} Names: {}", error.GetToken(),
      nearest.empty() ? "" : fmt::format(" Did you mean `{}`?", nearest), fmt::join(known, ", "));
}

/// A parser with values of its own, to which the variables of its formula are bound.
struct BoundParser {
  std::uint64_t number = 0;  // of the expression that it evaluates; 0: none
  mu::Parser parser;
  std::vector<mu::value_type> values;  // variables, then constants; bound by address
  std::vector<std::size_t> used;       // those that the text speaks of
};

void define_functions(mu::Parser& p)
{
  p.DefineConst("pi", std::numbers::pi);
  p.DefineFun("erf", static_cast<mu::value_type (*)(mu::value_type)>([](mu::value_type x) { return std::erf(x); }));
  p.DefineFun("erfc", static_cast<mu::value_type (*)(mu::value_type)>([](mu::value_type x) { return std::erfc(x); }));
  p.DefineFun("mod", static_cast<mu::value_type (*)(mu::value_type, mu::value_type)>(
                         [](mu::value_type a, mu::value_type b) { return a - b * std::floor(a / b); }));
  p.DefineFun("step", step);
  p.DefineFun("min", extreme<false>);
  p.DefineFun("max", extreme<true>);
}

}  // namespace

struct Expression::ParsedText {
  std::uint64_t number;
  std::string text;
  std::vector<std::string> names;  // variables, then constants
  std::vector<mu::value_type> values;
  std::size_t n_variables;
};

namespace {

std::unique_ptr<BoundParser> parse(const auto& source)
{
  auto bound = std::make_unique<BoundParser>();
  bound->number = source.number;
  bound->values = source.values;
  mu::Parser& p = bound->parser;
  try {
    define_functions(p);
    for (std::size_t k = 0; k < source.names.size(); ++k) p.DefineVar(source.names[k], &bound->values[k]);
    p.SetExpr(source.text);
    p.Eval();
    for (const auto& [name, address] : p.GetUsedVar()) {
      if (std::ranges::count(source.names, name) > 1)
        throw ExpressionError(
            fmt::format("`{}` is a constant and the name of what stands here. Give the constant another name.", name));
      bound->used.push_back(static_cast<std::size_t>(address - bound->values.data()));
    }
  } catch (const mu::Parser::exception_type& error) {
    throw ExpressionError(why(error, source.names));
  }
  return bound;
}

/// This thread's parser of a source: made at the first use, and anew when another formula took its place.
BoundParser& parser_of(const auto& source)
{
  constexpr std::size_t most_kept = 64;  // formulas of a case: two of each body and side with a velocity
  thread_local std::array<std::unique_ptr<BoundParser>, most_kept> kept;
  std::unique_ptr<BoundParser>& place = kept[source.number % most_kept];
  if (!place || place->number != source.number) place = parse(source);
  return *place;
}

std::uint64_t next_number()
{
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Expression::Expression(
    const std::string& text, const std::vector<std::string>& variables, const std::map<std::string, Real>& constants)
{
  refuse_what_would_pass(text);
  ParsedText source{next_number(), text, variables, std::vector<mu::value_type>(variables.size()), variables.size()};
  for (const auto& [name, value] : constants) source.names.push_back(name), source.values.push_back(value);
  source_ = std::make_shared<const ParsedText>(std::move(source));
  parser_of(*source_);  // says what is wrong
}

Real Expression::operator()(std::span<const Real> values) const
{
  TERP_ASSERT(values.size() == source_->n_variables);
  BoundParser& bound = parser_of(*source_);
  std::copy(values.begin(), values.end(), bound.values.begin());
  for (const std::size_t k : bound.used)  // a comparison would take what is no number for a wrong one
    if (std::isnan(bound.values[k])) return bound.values[k];
  return bound.parser.Eval();
}

Real evaluate(const std::string& text, const std::map<std::string, Real>& constants)
{
  return Expression(text, {}, constants)({});
}

std::vector<std::string> names_in_formulas()
{
  mu::Parser p;
  define_functions(p);
  std::vector<std::string> names;
  for (const auto& [name, function] : p.GetFunDef()) names.push_back(name);
  for (const auto& [name, value] : p.GetConst()) names.push_back(name);
  return names;
}

}  // namespace terp
