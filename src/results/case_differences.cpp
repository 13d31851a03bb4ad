#include "results/compare.hpp"

#include "input/keys.hpp"
#include "input/units.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace terp {
namespace {

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
