// What changed in an imported case since terp import wrote it: the case beside its record, imported.toml.
// Not for: in what the cases of two runs differ (compare).
#pragma once

#include "math/sentence.hpp"
#include "io/case/document.hpp"

#include <string>
#include <vector>

namespace terp {

/// A sentence for each value that is another one now. Titles, colours, what is written, [reference] and the names of
/// files do not count.
std::vector<Sentence> import_changes(const Node& imported, const Node& now);

/// The same of a case with `reference.imported`, a file in that folder; nothing of a case without it. A record that
/// cannot be read is one sentence.
std::vector<Sentence> changes_since_import(const Node& now, const std::string& folder);

}  // namespace terp
