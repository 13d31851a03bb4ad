#include "batch/follow.hpp"

#include "io/case/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace terp {
namespace {

/// The text speaks of the name, as a word of its own.
bool speaks_of(const std::string& text, const std::string& name)
{
  const auto in_word = [&](std::size_t k) {
    return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) != 0 || text[k] == '_');
  };
  for (std::size_t k = text.find(name); k != std::string::npos; k = text.find(name, k + 1))
    if (!in_word(k + name.size()) && (k == 0 || !in_word(k - 1))) return true;
  return false;
}

bool is_formula(const Node& value, const std::vector<std::string>& names)
{
  return value.kind == NodeKind::text &&
         std::ranges::any_of(names, [&](const std::string& name) { return speaks_of(value.text, name); });
}

}  // namespace

bool has_formula(const Node& value, const std::vector<std::string>& names)
{
  return is_formula(value, names) ||
         std::ranges::any_of(value.items, [&](const Node& item) { return has_formula(item, names); });
}

Node with_numbers(Node value, const std::vector<std::string>& names, const std::vector<Real>& values)
{
  if (is_formula(value, names)) {
    value.number = Expression(value.text, names, {})(values);
    if (!std::isfinite(value.number)) {
      std::string at;
      for (std::size_t k = 0; k < names.size(); ++k)
        if (speaks_of(value.text, names[k]))
          at += fmt::format("{}{} = {:g}", at.empty() ? "" : ", ", names[k], values[k]);
      throw ExpressionError(fmt::format("\"{}\" is no number at {}", value.text, at));
    }
    value.kind = NodeKind::number;
  }
  for (Node& item : value.items) item = with_numbers(std::move(item), names, values);
  return value;
}

std::vector<std::string> changes_with_numbers(
    const KeyValues& keys, const std::vector<std::string>& names, const std::vector<Real>& values)
{
  std::vector<std::string> changes;
  for (const auto& [key, value] : keys) changes.push_back(key + "=" + toml_value(with_numbers(value, names, values)));
  return changes;
}

}  // namespace terp
