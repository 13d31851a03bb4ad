// A key without `*` need not exist: tables and entries are made on the way, but no parameter of a material that is not
// there. What says the same in another way is taken out before: another kind of field, a ratio or the parameter that it
// gives. Nodes that are made keep the place in the file, or the text of --set, that made them: messages point there.

#include "io/case/overrides.hpp"

#include "math/closest.hpp"
#include "math/utf8.hpp"
#include "io/case/field_kinds.hpp"
#include "io/case/key_text.hpp"
#include "io/case/keys.hpp"
#include "io/case/units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

Node parse_value(const std::string& text)
{
  try {
    Node table = parse_toml("value = " + text);
    if (table.items.size() == 1) return std::move(table.items.front());
  } catch (const SyntaxError&) {
    // Not TOML: scheme=mpm_gp without quotes, as shells leave it.
  }
  Node node;
  node.kind = NodeKind::text;
  node.text = text;
  return node;
}

void mark(Node& node, const std::string& override_text)
{
  node.override_text = override_text;
  node.key = node.value = Place{};
  for (Node& item : node.items) mark(item, override_text);
}

/// 0, 1, ... of "[0]" or "1"; none if it is no index.
std::optional<std::size_t> index_of(std::string part)
{
  if (part.size() > 2 && part.front() == '[' && part.back() == ']') part = part.substr(1, part.size() - 2);
  const bool digits = !part.empty() && std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c); });
  if (!digits || part.size() > 6) return std::nullopt;
  return std::stoul(part);
}

/// The entry of a list that a part means: by its number, or by its `name`.
std::optional<std::size_t> entry_of(const Node& list, const std::string& part)
{
  if (const auto index = index_of(part)) return index;
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const Node* name = list.items[k].kind == NodeKind::table ? find_item(list.items[k], "name") : nullptr;
    if (name != nullptr && name->kind == NodeKind::text && name->text == part) return k;
  }
  return std::nullopt;
}

/// The entry `part` of a list or table, made if it is missing; nullptr if there is no such place.
Node* enter(Node& parent, const std::string& part, const std::string& override_text)
{
  if (parent.kind == NodeKind::table && parent.items.empty() && index_of(part)) parent.kind = NodeKind::list;
  if (parent.kind == NodeKind::list) {
    const auto index = entry_of(parent, part);
    if (!index || *index > parent.items.size()) return nullptr;
    if (*index < parent.items.size()) return &parent.items[*index];
  } else if (parent.kind != NodeKind::table || part.starts_with('[')) {
    return nullptr;
  } else if (Node* item = find_item(parent, part)) {
    return item;
  }
  Node& item = parent.items.emplace_back();
  item.override_text = override_text;
  if (parent.kind == NodeKind::table) item.name = part;
  return &item;
}

std::string describe_holder(const Node& holder, const std::string& path, const std::string& part)
{
  if (holder.kind == NodeKind::list && !index_of(part))
    return fmt::format("`{0}` is a list: write {0}[0].{1}, counted from 0, or {0}.*.{1} for all {2} entries.", path,
        part, holder.items.size());
  if (holder.kind == NodeKind::list)
    return fmt::format("The list `{}` has {} entries; count from 0.", path, holder.items.size());
  if (holder.kind == NodeKind::table) return fmt::format("`{}` is a table, not a list.", path);
  return fmt::format("`{0}` is a single value and holds no keys. Set it as a whole: --set {0}=...", path);
}

using PathParts = std::vector<std::string>;

/// `*` stands for any letters, also none. Goes back to the last star only, so that many stars cost no time.
bool fits(std::string_view pattern, std::string_view name)
{
  std::size_t p = 0, n = 0, star = std::string_view::npos, from = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++, from = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1, n = ++from;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

const Node* below_of(const Node& node, const std::string& part)
{
  if (node.kind != NodeKind::list) return find_item(node, part);
  const auto index = entry_of(node, part);
  return index && *index < node.items.size() ? &node.items[*index] : nullptr;
}

std::vector<std::string> names_below(const Node& node)
{
  std::vector<std::string> names;
  for (std::size_t k = 0; k < node.items.size(); ++k)
    names.push_back(node.kind == NodeKind::list ? fmt::format("[{}]", k) : node.items[k].name);
  return names;
}

/// A pattern over materials means those whose law has the parameter.
bool takes_key(const Node& material, const std::string& key)
{
  const Node* model = find_item(material, "model");
  const MaterialType* law = model != nullptr ? find_material(model->text) : nullptr;
  if (law == nullptr || find_key("material.NAME." + key) != nullptr) return true;
  return std::ranges::any_of(
      law->parameters, [&](const auto& info) { return info.name == key || info.ratio.name == key; });
}

/// The keys that a key with patterns stands for, from part `first` on; none where nothing fits.
void expand(const Node* node, const PathParts& parts, std::size_t first, PathParts& path, std::vector<PathParts>& found)
{
  if (first == parts.size()) return found.push_back(path);
  const std::string& part = parts[first];
  const bool is_pattern = part.find('*') != std::string::npos;
  const auto go_on = [&](const Node* below, const std::string& name) {
    path.push_back(name);
    expand(below, parts, first + 1, path, found);
    path.pop_back();
  };
  if (!is_pattern) {
    const bool named = node != nullptr && node->kind == NodeKind::list && !index_of(part) && entry_of(*node, part);
    return go_on(
        node == nullptr ? nullptr : below_of(*node, part), named ? fmt::format("[{}]", *entry_of(*node, part)) : part);
  }
  if (node == nullptr) return;
  const std::string pattern = part.size() > 2 && part.front() == '[' ? part.substr(1, part.size() - 2) : part;
  for (const std::string& name : names_below(*node)) {
    const Node* below = below_of(*node, name);
    const bool of_material = first == 1 && parts[0] == "material" && parts.size() >= 3;
    if (below != nullptr && fits(pattern, node->kind == NodeKind::list ? name.substr(1, name.size() - 2) : name) &&
        (!of_material || takes_key(*below, parts[2])))
      go_on(below, name);
  }
}

/// Where a pattern fits materials, but none has the key: the nearest key that one has.
std::string hint_at_parameter(const Node& root, const PathParts& parts)
{
  const Node* materials = find_item(root, "material");
  if (parts.size() != 3 || parts[0] != "material" || materials == nullptr) return "";
  std::vector<std::string> keys;
  for (const Node& material : materials->items) {
    const Node* model = find_item(material, "model");
    const MaterialType* law = model != nullptr && fits(parts[1], material.name) ? find_material(model->text) : nullptr;
    if (law == nullptr) continue;
    for (const ParameterInfo& info : law->parameters) {
      keys.emplace_back(info.name);
      if (!info.ratio.name.empty()) keys.emplace_back(info.ratio.name);
    }
    for (const std::string& name : names_in_section("material.NAME")) keys.push_back(name);
  }
  const std::string nearest = closest(parts[2], keys);
  return nearest.empty() ? "" : fmt::format("Did you mean `material.{}.{}`?\n", parts[1], nearest);
}

std::optional<Problem> refuse_pattern(const Node& root, const PathParts& parts, const std::string& where)
{
  const Node* holder = &root;
  for (const std::string& part : parts) {
    if (part.find('*') != std::string::npos) break;
    const Node* next = below_of(*holder, part);
    if (next == nullptr) break;
    holder = next;
  }
  const auto names = names_below(*holder);
  return Problem{where, "the pattern fits nothing",
      hint_at_parameter(root, parts) + fmt::format("There are: {}. In [material], those count whose model has the key.",
                                           names.empty() ? "none" : plain_list(names)),
      ""};
}

/// A parameter of a material that the case does not have: to make a new one by a parameter is hardly meant.
std::optional<Problem> refuse_new_material(const Node& root, const PathParts& parts, const std::string& where)
{
  const Node* materials = find_item(root, "material");
  if (parts.size() < 3 || parts[0] != "material" || materials == nullptr || materials->items.empty() ||
      materials->kind != NodeKind::table || find_item(*materials, parts[1]) != nullptr || parts[2] == "model")
    return std::nullopt;
  const auto names = names_below(*materials);
  const std::string nearest = closest(parts[1], names);
  return Problem{where, fmt::format("there is no material `{}`", parts[1]),
      (nearest.empty() ? "" : fmt::format("Did you mean `material.{}.{}`?\n", nearest, parts[2])) +
          fmt::format("Materials of this case: {}", plain_list(names)),
      "material"};
}

/// Makes a value, or a field of another kind, a table for the kind of field that the keys go on with: su_peak.csv.
void change_kind_of_field(Node* value, const PathParts& parts, std::size_t first)
{
  const auto is_kind = [](const std::string& name) {
    return std::ranges::find(field_kinds(), name, &FieldKind::name) != field_kinds().end();
  };
  for (std::size_t k = first; value != nullptr && k < parts.size(); ++k) {
    const bool has_it = value->kind == NodeKind::table && find_item(*value, parts[k]) != nullptr;
    if (!has_it && is_kind(parts[k])) {
      value->kind = NodeKind::table;
      value->items.clear();
    }
    value = find_item(*value, parts[k]);
  }
}

/// What is set takes the place of what says the same in another way: another kind of field; a ratio (sensitivity) or
/// the parameter that follows from it (su_residual).
void drop_alternatives(Node& root, const PathParts& parts)
{
  Node* materials = find_item(root, "material");
  Node* material =
      materials != nullptr && parts[0] == "material" && parts.size() > 2 ? find_item(*materials, parts[1]) : nullptr;
  if (material == nullptr) return;
  const bool in_part = parts.size() > 3 && (parts[2] == "below" || parts[2] == "above");
  Node* holder = in_part ? find_item(*material, parts[2]) : material;
  if (holder == nullptr || holder->kind != NodeKind::table) return;
  const std::size_t k = in_part ? 3 : 2;
  const Node* model = find_item(*holder, "model");
  if (model == nullptr) model = find_item(*material, "model");
  const MaterialType* law = model != nullptr ? find_material(model->text) : nullptr;
  for (std::size_t n = 0; law != nullptr && n < law->parameters.size(); ++n) {
    const std::string name(law->parameters[n].name), ratio(law->parameters[n].ratio.name);
    if (ratio.empty() || (parts[k] != name && parts[k] != ratio)) continue;
    std::erase_if(holder->items, [&](const Node& item) { return item.name == (parts[k] == name ? ratio : name); });
  }
  change_kind_of_field(find_item(*holder, parts[k]), parts, k + 1);
}

/// override_text: what the nodes on the way carry that are made.
std::optional<Problem> set_one(
    Node& root, const PathParts& parts, const Node& value, const std::string& where, const std::string& override_text)
{
  if (auto problem = refuse_new_material(root, parts, where)) return problem;
  drop_alternatives(root, parts);
  Node* node = &root;
  std::string path;
  for (const std::string& part : parts) {
    Node* next = enter(*node, part, override_text);
    if (next == nullptr)
      return Problem{where, fmt::format("there is no entry `{}`", part), describe_holder(*node, path, part), ""};
    path = index_of(part) && node->kind == NodeKind::list ? fmt::format("{}[{}]", path, *index_of(part))
                                                          : join_path(path, part);
    if (next->key.line == 0 && next->value.line == 0)  // new: messages about it point at what sets it
      next->key = value.key, next->value = value.value;
    node = next;
  }
  const std::string name = node->name;
  *node = value;
  node->name = name;
  return std::nullopt;
}

}  // namespace

std::optional<Problem> apply_override(Node& root, const std::string& change)
{
  const std::string where = "--set " + change;
  const std::size_t equals = change.find('=');
  const PathParts parts = split_path(trimmed(std::string_view(change).substr(0, equals)));
  if (equals == std::string::npos || parts.empty())
    return Problem{
        where, "a change has the form KEY=VALUE", "For example --set scheme=mpm_mixed or --set mesh.cell=0.2", ""};
  if (parts.size() > most_key_parts)
    return Problem{where.substr(0, 40) + "...", fmt::format("a key has at most {} parts", most_key_parts), "", ""};
  const std::string value(trimmed(std::string_view(change).substr(equals + 1)));
  if (value.empty())
    return Problem{where, "a change has a value after the equals sign",
        "An empty text is written with quotes: --set 'title=\"\"'", ""};

  PathParts path;
  std::vector<PathParts> keys;
  expand(&root, parts, 0, path, keys);
  if (keys.empty()) return refuse_pattern(root, parts, where);
  Node node = parse_value(value);
  mark(node, where);
  for (const PathParts& key : keys)
    if (auto problem = set_one(root, key, node, where, where)) return problem;
  return std::nullopt;
}

void doubt_replaced(const Node& root, const std::vector<std::string>& changes, std::vector<Problem>& warnings)
{
  const auto holds = [](const auto& self, const Node& node, const std::string& text) -> bool {
    return node.override_text == text ||
           std::ranges::any_of(node.items, [&](const Node& item) { return self(self, item, text); });
  };
  for (const std::string& change : changes)
    if (const std::string where = "--set " + change; !holds(holds, root, where))
      warnings.push_back({where, "it has no effect: a later --set gives the same key another value",
          "The last one counts. Leave one of the two out.", ""});
}

std::optional<Problem> set_in_tree(Node& root, const std::string& key, const Node& value, const std::string& where,
    const std::function<std::optional<Problem>(const std::vector<std::string>&)>& refuse)
{
  const PathParts parts = split_path(key);
  if (parts.empty() || parts.size() > most_key_parts)
    return Problem{where, fmt::format("`{}` is no key", key.substr(0, 40)), "", "stage.set"};
  PathParts path;
  std::vector<PathParts> keys;
  expand(&root, parts, 0, path, keys);
  if (keys.empty()) return refuse_pattern(root, parts, where);
  for (const PathParts& each : keys) {
    if (auto problem = refuse(each)) return problem;
    if (auto problem = set_one(root, each, value, where, "")) return problem;
  }
  return std::nullopt;
}

}  // namespace terp
