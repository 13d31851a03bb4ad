#include "input/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

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
  const bool digits =
      !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c); });
  if (!digits || part.size() > 6) return std::nullopt;
  return std::stoul(part);
}

/// The entry `part` of a list or table, made if it is missing; nullptr if there is no such place.
Node* enter(Node& parent, const std::string& part, const std::string& override_text)
{
  const auto index = index_of(part);
  if (parent.kind == NodeKind::table && parent.items.empty() && index) parent.kind = NodeKind::list;
  if (parent.kind == NodeKind::list) {
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

std::string describe_holder(const Node& holder, const std::string& path)
{
  if (holder.kind == NodeKind::list)
    return fmt::format("The list `{}` has {} entries; count from 0.", path, holder.items.size());
  if (holder.kind == NodeKind::table) return fmt::format("`{}` is a table, not a list.", path);
  return fmt::format("`{0}` is a single value and holds no keys. Set it as a whole: --set {0}=...", path);
}

}  // namespace

std::optional<Problem> apply_override(Node& root, const std::string& change)
{
  const std::string where = "--set " + change;
  const std::size_t equals = change.find('=');
  const auto parts = split_path(trimmed(std::string_view(change).substr(0, equals)));
  if (equals == std::string::npos || parts.empty())
    return Problem{
        where, "a change has the form KEY=VALUE", "For example --set scheme=mpm_mixed or --set mesh.cell=0.2", ""};

  if (parts.size() > most_key_parts)
    return Problem{where.substr(0, 40) + "...", fmt::format("a key has at most {} parts", most_key_parts), "", ""};

  Node* node = &root;
  std::string path;
  for (const std::string& part : parts) {
    Node* next = enter(*node, part, where);
    if (next == nullptr)
      return Problem{where, fmt::format("there is no entry `{}`", part), describe_holder(*node, path), ""};
    path = index_of(part) && node->kind == NodeKind::list ? fmt::format("{}[{}]", path, *index_of(part))
                                                          : join_path(path, part);
    node = next;
  }
  const std::string name = node->name;
  *node = parse_value(std::string(trimmed(std::string_view(change).substr(equals + 1))));
  node->name = name;
  mark(*node, where);
  return std::nullopt;
}

}  // namespace terp
