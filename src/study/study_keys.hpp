// One section of a study file against a table of its keys: types, ranges, units and the nearest name, with the messages
// of case files.
#pragma once

#include "input/key_text.hpp"
#include "input/values.hpp"

#include <string>
#include <vector>

namespace terp {

struct StudyKey {
  std::string name, unit;
  Range range = any_number;
  bool required = false;
  Field field;
  std::vector<std::string> (*words)() = nullptr;
};

/// Stores what the table holds; adds a problem for each key that is unknown, missing or wrong. others: names that the
/// caller reads himself. path: of the table, "random[0]"; "" is the file itself.
void read_section(const Node& table, const std::string& path, const std::vector<StudyKey>& keys,
    const std::vector<std::string>& others, Findings& findings);

/// One value as a number in a unit. False, with a problem added, if it is none.
bool read_study_number(const Node& node, const std::string& path, const StudyKey& key, Real& value, Findings& findings);

}  // namespace terp
