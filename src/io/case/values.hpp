// One value of the file: type, range and unit against its entry in the table, then into the case.
#pragma once

#include "math/errors.hpp"
#include "io/case/document.hpp"
#include "io/case/keys.hpp"

#include <string>
#include <vector>

namespace terp {

/// What was found while reading: problems stop the run, warnings do not.
struct Findings {
  std::vector<Problem> problems, warnings;
  std::vector<std::string> notes;  ///< numbers with a unit, and what each was taken for
};

/// One key of the file and its declaration.
struct Entry {
  const Node& node;
  std::string path;  ///< "body[0].box"
  const KeyInfo& key;
};

/// Stores the value in the field. False, with a problem added, if it is not allowed.
bool store_value(const Entry& entry, const Field& field, Findings& findings);

/// Reads a list of places [[x, y], ...] somewhere in the value of an entry. False, with a problem added, if it is none.
bool read_places(
    const Entry& entry, const Node& list, const std::string& path, Findings& findings, std::vector<Vec<2>>& places);

/// Adds a problem about an entry, at a path within it. Always false.
bool refuse(const Entry& entry, const std::string& path, std::string what, std::string detail, Findings& findings);

/// "the text "four"", "the number 4", "a list of 3".
std::string describe_value(const Node& node);

}  // namespace terp
