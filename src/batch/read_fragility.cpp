// A text that has h as a word of its own is a formula of the load. Formulas stay in the values of the keys, and become
// numbers when a level is chosen. While the file is read each is tried at all levels. So a wrong one is a problem of
// the file and not of a realisation. For that levels are read before the changes.

#include "io/case/expression.hpp"
#include "batch/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

constexpr const char* section = "fragility";
constexpr std::size_t fewest_levels = 2, most_levels = 100;

/// The name of the level in formulas.
const std::vector<std::string> name_of_level{"h"};

void read_levels(const Node& table, FragilityLoad& load, Findings& findings)
{
  const std::string path = join_path(section, "levels");
  const Node* list = find_item(table, "levels");
  const auto wrong = [&](const std::string& got) {
    findings.problems.push_back({list != nullptr ? path : section, "`levels` must be a list of numbers that ascend",
        fmt::format(
            "From {} to {} of them, as in levels = [3.0, 3.5, 4.0, 4.5, 5.0]. {}", fewest_levels, most_levels, got),
        ""});
  };
  if (list == nullptr || list->kind != NodeKind::list) return wrong("");
  if (list->items.size() < fewest_levels || list->items.size() > most_levels)
    return wrong(fmt::format("Got {}.", list->items.size()));
  for (std::size_t k = 0; k < list->items.size(); ++k) {
    Real value = 0.0;
    if (!read_study_number(list->items[k], fmt::format("{}[{}]", path, k), {"levels", load.unit, any_number, false, {}},
            value, findings))
      return;
    if (!load.levels.empty() && value <= load.levels.back())
      return wrong(fmt::format("Got {:g} after {:g}.", value, load.levels.back()));
    load.levels.push_back(value);
  }
}

void read_changes(const Node& table, FragilityLoad& load, Findings& findings)
{
  const std::string path = join_path(section, "set");
  const Node* set = find_item(table, "set");
  const auto fail = [&](const std::string& at, std::string what, std::string detail) {
    findings.problems.push_back({at, std::move(what), std::move(detail), ""});
  };
  constexpr const char* example = "As in\n[fragility.set]\n\"load[0].pressure\" = \"1000 * h\"";
  if (set == nullptr || set->kind != NodeKind::table || set->items.empty())
    return fail(set != nullptr ? path : section, "`set` must say which keys of the case follow the load", example);
  for (const Node& item : set->items) {
    const std::string at = join_path(path, item.name);
    if (item.kind == NodeKind::table && item.name.find('.') == std::string::npos)
      return fail(at, "write the key in quotes", fmt::format("As in \"{}.KEY\" = VALUE.", item.name));
    load.set.emplace_back(item.name, item);
    if (!has_formula(item, name_of_level))
      fail(at, fmt::format("`{}` does not follow the load", item.name),
          "Give a formula of h, the level, as a text; or set the key in [set], for all levels.");
    try {
      for (const Real level : load.levels) with_numbers(item, name_of_level, {level});
    } catch (const ExpressionError& error) {
      fail(at, "this is no formula of h", error.what());
    }
  }
}

}  // namespace

std::vector<std::string> FragilityLoad::changes_at(Real level) const
{
  return changes_with_numbers(set, name_of_level, {level});
}

std::optional<FragilityLoad> read_fragility(const Node& root, Findings& findings)
{
  const Node* table = find_item(root, section);
  if (table == nullptr) return std::nullopt;
  FragilityLoad load;
  std::vector<std::string> others = distribution_keys();
  others.insert(others.end(), {"distribution", "levels", "set"});
  read_section(*table, section,
      {{"name", "", any_number, false, &load.name}, {"unit", "", any_number, false, &load.unit}}, others, findings);
  if (table->kind != NodeKind::table) return load;
  read_levels(*table, load, findings);
  read_changes(*table, load, findings);
  const bool has_any = std::ranges::any_of(
      distribution_keys(), [&](const std::string& key) { return find_item(*table, key) != nullptr; });
  if (has_any || find_item(*table, "distribution") != nullptr)
    load.distribution = read_distribution(*table, section, load.unit, findings);
  return load;
}

void drop_distribution(Node& table)
{
  const auto names = distribution_keys();
  std::erase_if(table.items, [&](const Node& item) {
    return item.name == "distribution" || item.name == "name" || std::ranges::find(names, item.name) != names.end();
  });
}

}  // namespace terp
