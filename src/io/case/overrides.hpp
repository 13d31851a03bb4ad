// Changes of a case from the command line: --set KEY=VALUE.
#pragma once

#include "math/errors.hpp"
#include "io/case/document.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace terp {

/// Sets one value in the tree and creates the tables above it. `change` is "KEY=VALUE": KEY dotted, with [n] or n for
/// entries of lists (n may be one past the last) or the `name` of an entry, and * for any letters of a name or for all
/// entries of a list: "material.*.eta" sets eta of every material whose model has it. VALUE is TOML, or else taken as
/// text; blanks around both do not count. The nodes of VALUE carry override_text. Returns what is wrong with the change
/// itself, then the tree is as before or holds empty tables.
std::optional<Problem> apply_override(Node& root, const std::string& change);

/// Warns of changes of which nothing is left in the tree, as later ones took their places.
void doubt_replaced(const Node& root, const std::vector<std::string>& changes, std::vector<Problem>& warnings);

/// Sets the value of a key in the tree in the same way, of [[stage]] set; the nodes of the value keep their places.
/// where: key that a problem is about; refuse: says of each key that is meant, in its parts, why it must not be set.
std::optional<Problem> set_in_tree(Node& root, const std::string& key, const Node& value, const std::string& where,
    const std::function<std::optional<Problem>(const std::vector<std::string>&)>& refuse);

}  // namespace terp
