// A TOML file as a plain tree that knows where every key and value stands.
// Not for: what the keys mean (keys.hpp) nor for --set (overrides.hpp).
#pragma once

#include "math/types.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terp {

/// A stretch of text in the case file, lines and columns from 1, columns in characters.
struct Place {
  int line = 0;  ///< 0: not in the file
  int column = 0;
  int length = 0;  ///< in characters; 0: to the end of the line
};

enum class NodeKind { boolean, integer, number, text, list, table, date };

struct Node {
  NodeKind kind = NodeKind::table;
  std::string name;           ///< its key in the table above; empty in lists and at the root
  Place key, value;           ///< where they stand
  std::string override_text;  ///< "--set KEY=VALUE" if it came from there, otherwise empty
  bool boolean = false;
  std::int64_t integer = 0;
  Real number = 0.0;
  std::string text;
  std::vector<Node> items;  ///< of a list or table, in the order of the file
};

struct Document {
  std::string path;  ///< as the user wrote it
  std::string text;  ///< of the file, unchanged
  Node root;         ///< with the changes by --set
};

/// The text is not TOML.
class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(const std::string& why, Place where) : std::runtime_error(why), place(where) {}
  Place place;
};

/// Parts of a key a.b.c that Terp takes; no case needs more than four. More are refused, as each is a call within a
/// call.
inline constexpr std::size_t most_key_parts = 100;

/// Where a string that opens at `k` has ended: behind its closing quotes, or at the end of its line.
std::size_t skip_string(std::string_view text, std::size_t k);

/// Line and column of a byte of the text.
Place place_at(std::string_view text, std::size_t offset);

/// Throws SyntaxError.
Node parse_toml(std::string_view text);

/// TOML text of a tree: comments are lost, values are kept to the bit.
std::string write_toml(const Node& root);

/// TOML text of one value, on one line.
std::string toml_value(const Node& node);

/// The values below a table and their keys, "material.clay.eta"; keys that are quoted as a whole stay as they are.
std::vector<std::pair<std::string, const Node*>> leaves_of(const Node& table);

/// The entry of a table with that key, or nullptr.
const Node* find_item(const Node& table, std::string_view name);
Node* find_item(Node& table, std::string_view name);

/// "body[0].box" -> "body", "[0]", "box". Quoted parts may hold dots.
std::vector<std::string> split_path(std::string_view path);

/// "material", "clay" -> "material.clay"; a name with a dot is quoted.
std::string join_path(std::string_view path, std::string_view name);

/// The node at a dotted path, or nullptr.
const Node* find_node(const Node& root, std::string_view path);

}  // namespace terp
