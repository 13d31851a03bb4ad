// The name that the user probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Insertions, deletions, changes and swaps of neighbours that turn one word into the other; case does not count.
int edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `word`, the first of equals; empty if none is near (more than a third of its letters differ).
std::string closest(std::string_view word, const std::vector<std::string>& names);

/// "Did you mean `clay`?" and a line end for the nearest name; empty if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace terp
