// Two cases are compared as flat lists of path and value. Entries of lists are paired by their place, so one that is
// put in front changes all that follow. Numbers are compared in SI. Of the measures only those with numbers are rows;
// sentences on them come from compare_words.

#include "io/results/compare.hpp"

#include "io/case/keys.hpp"
#include "io/case/units.hpp"
#include "mpm/schemes/scheme.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Value = std::optional<Real>;

std::string cell_text(Value value, int digits)
{
  return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-");
}

using Entry = std::pair<std::string, std::string>;  ///< path and value, as texts

constexpr std::string_view left_out[] = {"title", "scheme", "output", "time.end"};

/// 8, 8.0 and, of a length, "800 cm" are the same.
std::string value_text(const Node& node, const std::string& path)
{
  if (node.kind == NodeKind::boolean) return node.boolean ? "true" : "false";
  const auto number = number_of(node, node.kind == NodeKind::text ? unit_at(path) : "-");
  return number ? fmt::format("{}", *number) : node.text;
}

bool is_left_out(const std::string& path)
{
  return std::ranges::any_of(left_out, [&](std::string_view name) { return path == name; });
}

/// Value by value, with the path of each.
void flatten(const Node& node, const std::string& path, std::vector<Entry>& entries)
{
  if (is_left_out(path)) return;
  if (node.kind == NodeKind::table)
    for (const Node& item : node.items) flatten(item, path.empty() ? item.name : join_path(path, item.name), entries);
  else if (node.kind == NodeKind::list)
    for (std::size_t k = 0; k < node.items.size(); ++k) flatten(node.items[k], fmt::format("{}[{}]", path, k), entries);
  else
    entries.emplace_back(path, value_text(node, path));
}

std::vector<Entry> entries_of(const std::string& toml)
{
  std::vector<Entry> entries;
  flatten(parse_toml(toml), "", entries);
  return entries;
}

std::string difference(const std::string& path, const std::string* first, const std::string* other)
{
  constexpr std::string_view unset = "not set";
  return fmt::format("{} ({} against {})", path, first != nullptr ? *first : unset, other != nullptr ? *other : unset);
}

const std::string* find(const std::vector<Entry>& entries, const std::string& path)
{
  const auto found = std::ranges::find_if(entries, [&](const Entry& entry) { return entry.first == path; });
  return found == entries.end() ? nullptr : &found->second;
}

}  // namespace

std::string scheme_title(std::string_view scheme)
{
  const Scheme* known = find_scheme(scheme);
  return std::string(known == nullptr ? scheme : known->title);
}

Comparison compare_runs(const std::vector<RunResults>& runs, const std::vector<std::string>& names)
{
  Comparison comparison{.names = names, .schemes = {}, .rows = {}, .text = {}};
  for (const RunResults& run : runs) comparison.schemes.push_back(run.summary.values.scheme);
  for (const RunMeasure& measure : measures_of(runs)) {
    if (measure.kind == MeasureKind::word) continue;  // a row of the report holds numbers
    ComparisonRow row{.label = measure.label, .unit = measure.unit, .values = {}, .digits = measure.digits};
    for (const RunResults& run : runs) row.values.push_back(measure.value(run));
    comparison.rows.push_back(std::move(row));
  }
  comparison.text = describe_differences(runs, comparison);
  return comparison;
}

std::string comparison_table(const Comparison& comparison)
{
  std::vector<std::vector<std::string>> lines{{""}, {"scheme"}};
  for (std::size_t k = 0; k < comparison.names.size(); ++k) {
    lines[0].push_back(comparison.names[k]);
    lines[1].push_back(comparison.schemes[k]);
  }
  for (const ComparisonRow& row : comparison.rows) {
    lines.push_back({row.unit == "-" ? row.label : fmt::format("{} [{}]", row.label, row.unit)});
    for (const Value& value : row.values) lines.back().push_back(cell_text(value, row.digits));
  }
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines)
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  std::string text;
  for (const auto& line : lines) {
    text += fmt::format("{:<{}}", line[0], widths[0]);
    for (std::size_t c = 1; c < line.size(); ++c) text += fmt::format("   {:>{}}", line[c], widths[c]);
    text += '\n';
  }
  text += '\n';
  for (const auto& sentence : comparison.text) text += sentence + '\n';
  return text;
}

std::string comparison_json(const Comparison& comparison)
{
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const ComparisonRow& row : comparison.rows) {
    Json values = Json::array();
    for (const Value& value : row.values) values.push_back(value ? Json(*value) : Json());
    rows.push_back({{"label", row.label}, {"unit", row.unit}, {"digits", row.digits}, {"values", std::move(values)}});
  }
  const Json json{{"columns", comparison.names}, {"schemes", comparison.schemes}, {"rows", std::move(rows)},
      {"text", comparison.text}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<std::string> case_differences(const std::string& first_toml, const std::string& other_toml)
{
  std::vector<std::string> differences;
  try {
    const auto first = entries_of(first_toml), other = entries_of(other_toml);
    for (const auto& [path, value] : first)
      if (const std::string* there = find(other, path); there == nullptr || *there != value)
        differences.push_back(difference(path, &value, there));
    for (const auto& [path, value] : other)
      if (find(first, path) == nullptr) differences.push_back(difference(path, nullptr, &value));
  } catch (const SyntaxError&) {
    return {};
  }
  return differences;
}

}  // namespace terp
