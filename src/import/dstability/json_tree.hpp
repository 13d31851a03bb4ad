// A JSON text as a tree of plain values. Not for: what the values mean (json_cursor.hpp).
// The only file of this folder that uses a JSON library is json_tree.cpp.
#pragma once

#include "math/types.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terp {

enum class JsonKind { null, boolean, number, text, list, object };

struct JsonNode {
  JsonKind kind = JsonKind::null;
  Real number = 0.0;  ///< of a number; 0 or 1 of a boolean
  std::string text = {};
  std::vector<std::pair<std::string, JsonNode>> members = {};  ///< of an object, in order; of a list with empty names

  const JsonNode* find(std::string_view key) const;  ///< null: not there
};

/// "a number", "a text": what stands there, in words.
const char* words_of(JsonKind kind);

/// Reads UTF-8, with or without a byte order mark. The values of keys in `skipped` are checked and thrown away. Throws
/// InputError at `where` if the text is no JSON, has a key twice in one object, or more than 64 levels.
JsonNode read_json(std::string_view text, const std::string& where, const std::vector<std::string>& skipped = {});

}  // namespace terp
