// The kinds of boundary condition (mpm/features/side_kind.hpp) as a case file writes them: words, and what stands
// beside them.
#pragma once

#include "math/errors.hpp"
#include "io/case/document.hpp"
#include "io/case/keys.hpp"

namespace terp {

/// Words of the kinds that a key of the side's table names; "": of those that stand alone.
std::vector<std::string> side_kind_words(std::string_view key);
/// The kind of a side among those that a key names, by its word.
WordField side_kind_field(SideKind& kind, std::string_view key);
/// "open: soil leaves; fixed: no motion"
std::string side_kind_meanings(std::string_view key);
/// Keys that name a kind: "contact or velocity".
std::string side_key_names();

/// Looks for keys of one side that do not go together. side: its text or its table.
void check_side(const Node& side, const std::string& path, std::vector<Problem>& problems);
/// What is possible but doubtful.
void check_doubts(const SideCondition& side, std::vector<Problem>& warnings);

}  // namespace terp
