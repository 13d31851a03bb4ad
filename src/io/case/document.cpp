// toml++ reads the text. Its tables are in alphabetical order, so items are sorted by their places in the file. What
// toml++ 3.3 cannot bear is refused or changed before: letters outside of quotes, letters at which its behaviour is
// undefined (lift and lower), and keys so deep that calls within calls overrun the stack.

#include "io/case/document.hpp"

#include "math/utf8.hpp"

#include <fmt/format.h>

// toml++ 3.3 asserts that a header starts with a letter, then reports it properly if not: "[=a]" must not abort a build
// with assertions.
#define TOML_ASSERT(condition) static_assert(true)
#define TOML_MAX_NESTED_VALUES \
  32  // lists and tables in one another; with most_key_parts, what keeps us off the end of the stack
#include <toml++/toml.h>

#include <algorithm>

namespace terp {
namespace {

constexpr std::uint32_t lifted_by = 0xF0000, first_letter = 0x80, last_letter = 0xFFFF, mark_at_start = 0xFEFF;

/// Moves the letters U+0080 to U+FFFF to U+F0080 to U+FFFFF, where Unicode has none of its own (plane 15, private use):
/// outside strings toml++ 3.3 runs into undefined behaviour at some between U+00A0 and U+FEFF, and what it takes for a
/// string is known only to itself. Each stays one letter, so columns stay.
std::string lift(std::string_view text)
{
  std::string lifted;
  while (!text.empty()) {
    const Letter letter = take_letter(text);
    const bool stays =
        letter.code < first_letter || letter.code > last_letter || (letter.code == mark_at_start && lifted.empty());
    lifted += stays ? std::string(letter.bytes) : utf8_of(letter.code + lifted_by);
  }
  return lifted;
}

bool is_lifted(const Letter& letter)
{
  return letter.code >= first_letter + lifted_by && letter.code <= last_letter + lifted_by;
}

std::string lower(std::string_view text)
{
  std::string lowered;
  while (!text.empty()) {
    const Letter letter = take_letter(text);
    lowered += is_lifted(letter) ? utf8_of(letter.code - lifted_by) : std::string(letter.bytes);
  }
  return lowered;
}

void refuse_lifted_letters(std::string_view text)
{
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t at = text.size() - rest.size();
    if (is_lifted(take_letter(rest)))
      throw SyntaxError("Letters of private use (U+F0080 to U+FFFFF) cannot stand in a case file.", place_at(text, at));
  }
}

Place place_of(const toml::source_region& region)
{
  const int line = static_cast<int>(region.begin.line), column = static_cast<int>(region.begin.column);
  const bool one_line = region.end.line == region.begin.line;
  const int length = one_line ? static_cast<int>(region.end.column) - column : 0;  // 0: to the end of the line
  return {line, column, length};
}

Node to_node(const toml::node& source);

void add_entries(const toml::table& source, Node& table)
{
  for (auto&& [key, value] : source) {
    Node& item = table.items.emplace_back(to_node(value));
    item.name = lower(key.str());
    item.key = place_of(key.source());
  }
  const auto before = [](const Node& a, const Node& b) {
    return std::pair(a.key.line, a.key.column) < std::pair(b.key.line, b.key.column);
  };
  std::ranges::stable_sort(table.items, before);
}

Node to_node(const toml::node& source)
{
  Node node;
  node.value = place_of(source.source());
  if (const auto* table = source.as_table()) {
    add_entries(*table, node);
  } else if (const auto* list = source.as_array()) {
    node.kind = NodeKind::list;
    for (const toml::node& item : *list) node.items.push_back(to_node(item));
  } else if (const auto* text = source.as_string()) {
    node.kind = NodeKind::text, node.text = lower(text->get());
  } else if (const auto* integer = source.as_integer()) {
    node.kind = NodeKind::integer, node.integer = integer->get();
  } else if (const auto* number = source.as_floating_point()) {
    node.kind = NodeKind::number, node.number = number->get();
  } else if (const auto* boolean = source.as_boolean()) {
    node.kind = NodeKind::boolean, node.boolean = boolean->get();
  } else {
    node.kind = NodeKind::date;
  }
  return node;
}

/// TOML has plain letters only outside strings and comments. A no-break space copied from a web page deserves its own
/// message.
void refuse_foreign_letters(std::string_view text)
{
  for (std::size_t k = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; k < text.size(); ++k) {
    if (text[k] == '"' || text[k] == '\'')
      k = skip_string(text, k) - 1;
    else if (text[k] == '#')
      k = std::min(text.find('\n', k), text.size()) - 1;
    else if (static_cast<unsigned char>(text[k]) >= 0x80)
      throw SyntaxError(
          "Letters beyond a to z, and special spaces, stand only in quotes and comments.", place_at(text, k));
  }
}

/// Every part of a key is a table in a table, and what walks them calls itself: 20 000 of them overrun the stack.
void refuse_deep_keys(std::string_view text)
{
  std::size_t n_parts = 1;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"' || text[k] == '\'')
      k = skip_string(text, k) - 1;
    else if (text[k] == '#')
      k = std::min(text.find('\n', k), text.size()) - 1;
    else if (std::string_view("=\n,[]{}").find(text[k]) != std::string_view::npos)
      n_parts = 1;
    else if (text[k] == '.' && ++n_parts > most_key_parts)
      throw SyntaxError(fmt::format("A key has at most {} parts.", most_key_parts), place_at(text, k));
  }
}

std::string quote(std::string_view text)
{
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += '\\', quoted += c;
    else if (code < 0x20 || code == 0x7f)
      quoted += fmt::format("\\u{:04x}", code);
    else
      quoted += c;
  }
  return quoted + '"';
}

std::string write_key(std::string_view name)
{
  const auto is_bare = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-'); };
  return !name.empty() && std::ranges::all_of(name, is_bare) ? std::string(name) : quote(name);
}

std::string write_number(Real value)
{
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".eni") == std::string::npos ? text + ".0" : text;  // "ni": nan, inf
}

std::string write_value(const Node& node)
{
  switch (node.kind) {
    case NodeKind::boolean: return node.boolean ? "true" : "false";
    case NodeKind::integer: return fmt::format("{}", node.integer);
    case NodeKind::number: return write_number(node.number);
    case NodeKind::list:
    case NodeKind::table: break;
    default: return quote(node.text);
  }
  std::string inside;
  for (const Node& item : node.items) {
    if (!inside.empty()) inside += ", ";
    if (node.kind == NodeKind::table) inside += write_key(item.name) + " = ";
    inside += write_value(item);
  }
  return (node.kind == NodeKind::list ? '[' : '{') + inside + (node.kind == NodeKind::list ? ']' : '}');
}

bool is_list_of_tables(const Node& node)
{
  const auto is_table = [](const Node& item) { return item.kind == NodeKind::table; };
  return node.kind == NodeKind::list && !node.items.empty() && std::ranges::all_of(node.items, is_table);
}

/// Values first, then the tables below: TOML gives a value to the last header above it.
void write_table(const Node& table, const std::string& path, std::string& out)
{
  const auto below = [](const Node& item) { return item.kind == NodeKind::table || is_list_of_tables(item); };
  for (const Node& item : table.items)
    if (!below(item)) out += write_key(item.name) + " = " + write_value(item) + '\n';
  for (const Node& item : table.items) {
    if (!below(item)) continue;
    const std::string name = path.empty() ? write_key(item.name) : path + '.' + write_key(item.name);
    const bool is_list = item.kind == NodeKind::list;
    if (is_list) {
      for (const Node& entry : item.items) out += "\n[[" + name + "]]\n", write_table(entry, name, out);
    } else {
      const bool implied = !item.items.empty() && std::ranges::all_of(item.items, below);
      if (!implied) out += "\n[" + name + "]\n";
      write_table(item, name, out);
    }
  }
}

std::string read_quoted(std::string_view path, std::size_t& k)
{
  const char mark = path[k++];
  const std::size_t end = std::min(path.find(mark, k), path.size());
  std::string part(path.substr(k, end - k));
  k = std::min(end + 1, path.size());
  return part;
}

}  // namespace

std::size_t skip_string(std::string_view text, std::size_t k)
{
  const std::string three(3, text[k]);
  const bool many_lines = text.substr(k, 3) == three, escapes = text[k] == '"';
  const std::string mark = many_lines ? three : three.substr(0, 1);
  for (k += mark.size(); k < text.size(); ++k) {
    if (escapes && text[k] == '\\')
      ++k;
    else if (text.substr(k, mark.size()) == mark)
      return k + mark.size();
    else if (!many_lines && text[k] == '\n')
      return k;
  }
  return text.size();
}

Place place_at(std::string_view text, std::size_t offset)
{
  const std::string_view before = text.substr(0, offset);
  const std::string_view line = before.substr(before.rfind('\n') + 1);  // npos + 1 = 0
  return {static_cast<int>(std::ranges::count(before, '\n')) + 1, static_cast<int>(count_letters(line)) + 1, 1};
}

Node parse_toml(std::string_view text)
{
  refuse_foreign_letters(text);
  refuse_deep_keys(text);
  refuse_lifted_letters(text);
  try {
    const std::string lifted = lift(text);
    const toml::table table = toml::parse(std::string_view(lifted));
    return to_node(table);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw SyntaxError(lower(error.description()), {static_cast<int>(at.line), static_cast<int>(at.column), 1});
  }
}

std::string write_toml(const Node& root)
{
  std::string out;
  write_table(root, "", out);
  return out;
}

std::string toml_value(const Node& node) { return write_value(node); }

std::vector<std::pair<std::string, const Node*>> leaves_of(const Node& table)
{
  std::vector<std::pair<std::string, const Node*>> leaves;
  const auto enter = [&](const auto& self, const Node& node, const std::string& path) -> void {
    for (const Node& item : node.items) {
      const std::string key = path.empty() ? item.name : join_path(path, item.name);
      if (item.kind == NodeKind::table)
        self(self, item, key);
      else
        leaves.emplace_back(key, &item);
    }
  };
  enter(enter, table, "");
  return leaves;
}

const Node* find_item(const Node& table, std::string_view name)
{
  for (const Node& item : table.items)
    if (table.kind == NodeKind::table && item.name == name) return &item;
  return nullptr;
}

Node* find_item(Node& table, std::string_view name)
{
  return const_cast<Node*>(find_item(static_cast<const Node&>(table), name));
}

std::vector<std::string> split_path(std::string_view path)
{
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < path.size();) {
    if (path[k] == '.') {
      ++k;
    } else if (path[k] == '"' || path[k] == '\'') {
      parts.push_back(read_quoted(path, k));
    } else {
      const bool is_index = path[k] == '[';
      const std::size_t end = is_index ? path.find(']', k) : path.find_first_of(".[", k);
      const std::size_t next = std::min(end == std::string_view::npos ? path.size() : end + is_index, path.size());
      parts.emplace_back(path.substr(k, next - k));
      k = next;
    }
  }
  return parts;
}

std::string join_path(std::string_view path, std::string_view name)
{
  const bool plain = !name.empty() && name.find_first_of(".[]\"'") == std::string_view::npos;
  const std::string part = plain ? std::string(name) : '"' + std::string(name) + '"';
  return path.empty() ? part : std::string(path) + '.' + part;
}

const Node* find_node(const Node& root, std::string_view path)
{
  const Node* node = &root;
  for (const std::string& part : split_path(path)) {
    if (node == nullptr || node->kind != NodeKind::list) {
      node = node == nullptr ? nullptr : find_item(*node, part);
      continue;
    }
    const std::size_t index = part.starts_with('[') ? std::strtoul(part.c_str() + 1, nullptr, 10) : node->items.size();
    node = index < node->items.size() ? &node->items[index] : nullptr;
  }
  return node;
}

}  // namespace terp
