// One section of a study file against a table of its keys: types, ranges, units and the nearest name, with the messages
// of case files; and the parts of a study file that have forms of their own.
#pragma once

#include "io/case/key_text.hpp"
#include "io/case/values.hpp"
#include "batch/study_file.hpp"

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

/// Keys of a distribution beside `distribution` itself.
std::vector<std::string> distribution_keys();
/// table: that of the random number; path: where it stands; unit: of the key that is drawn. Adds problems.
Distribution read_distribution(const Node& table, const std::string& path, const std::string& unit, Findings& findings);

/// The section [fragility]. None: the file has no such section. Adds problems.
std::optional<FragilityLoad> read_fragility(const Node& root, Findings& findings);
/// Takes the distribution of the load out of the section: it has no say in what realisations give.
void drop_distribution(Node& section);

}  // namespace terp
