#include "math/closest.hpp"

#include <algorithm>
#include <cctype>

namespace terp {
namespace {

bool same_letter(char a, char b)
{
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b)
{
  // Row i of the Damerau-Levenshtein table (adjacent swaps) from rows i-1 and i-2.
  std::vector<int> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int change = last[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

std::string closest(std::string_view word, const std::vector<std::string>& names)
{
  std::string best;
  int least = static_cast<int>(word.size());
  for (const std::string& name : names) {
    const int distance = edit_distance(word, name);
    const bool near = 3 * distance <= static_cast<int>(std::max(word.size(), name.size()));
    if (near && distance < least) best = name, least = distance;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names)
{
  const std::string nearest = closest(word, names);
  return nearest.empty() ? "" : "Did you mean `" + nearest + "`?\n";
}

}  // namespace terp
