// Keys that every file of a data model has, and what the reader takes where one is missing. So a damaged file, or one
// of another program, is not read as if it said nothing of loads, states or water. Not for: keys that the reader does
// not know (json_cursor.hpp), keys without which it refuses a file (read_*.cpp).
#pragma once

#include "dstability/json_cursor.hpp"

#include <string>
#include <vector>

namespace terp {

struct StixContent {
  std::string name;  ///< "states/states_1.json"
  std::string kind;  ///< "states"
  const JsonNode* content;
};

/// Tells of each key that is missing: once for all members of a kind and all entries of a list, with the stages that it
/// is of. Scenarios, or stages of data model 1, stand in the order in which they are numbered.
void tell_missing_keys(const std::vector<StixContent>& members, StixNotes& notes);

}  // namespace terp
