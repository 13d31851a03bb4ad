// Everything follows from the table of kinds in mpm/features/side_kind.cpp, so a new kind of side needs no change here.
// A side whose word is unknown counts as every kind that its key names. The word is refused elsewhere, and its other
// keys shall not be reported because of it.

#include "io/case/side_kinds.hpp"

#include "io/case/key_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

/// A table that names a kind: { contact = "bilateral", friction = ... }. with: a key of it.
std::string example_of(const std::string& side, const SideKindInfo& kind, std::string_view with)
{
  const std::string value = kind.word.empty() ? "..." : quoted_list({std::string(kind.word)});
  return fmt::format("{} = {{ {} = {}, {} = ... }}", side, kind.key, value, with);
}

/// Whether the side is of this kind. True too where the word is none, which is refused elsewhere.
bool may_be(const Node& side, const SideKindInfo& kind)
{
  const Node* named = find_item(side, kind.key);
  if (named == nullptr || named->kind != NodeKind::text || named->text == kind.word) return named != nullptr;
  return std::ranges::none_of(
      kinds_named_by(kind.key), [&](const SideKindInfo* other) { return other->word == named->text; });
}

/// A key that is given without one that names a kind which takes it.
void check_key(const Node& side, const Node& item, const std::string& path, std::vector<Problem>& problems)
{
  const SideKindInfo* first = nullptr;
  for (const SideKindInfo& kind : side_kinds()) {
    if (std::ranges::find(kind.takes, item.name) == kind.takes.end()) continue;
    if (may_be(side, kind)) return;
    if (first == nullptr) first = &kind;
  }
  if (first == nullptr) return;  // another key, or none at all
  problems.push_back({path + '.' + item.name, fmt::format("`{}` needs `{}` beside it", item.name, first->key),
      fmt::format("As in {}. Conditions that stand alone: {}.", example_of(side.name, *first, item.name),
          quoted_list(side_kind_words(""))),
      "boundary", true});
}

}  // namespace

std::vector<std::string> side_kind_words(std::string_view key)
{
  std::vector<std::string> words;
  for (const SideKindInfo* kind : kinds_named_by(key)) words.emplace_back(kind->word);
  return words;
}

WordField side_kind_field(SideKind& kind, std::string_view key)
{
  const auto kinds = kinds_named_by(key);
  return {[&kind, kinds] {
            const auto found = std::ranges::find(kinds, kind, &SideKindInfo::kind);
            return found == kinds.end() ? -1 : static_cast<int>(found - kinds.begin());
          },
      [&kind, kinds](int word) { kind = kinds[static_cast<std::size_t>(word)]->kind; }};
}

std::string side_kind_meanings(std::string_view key)
{
  std::string text;
  for (const SideKindInfo* kind : kinds_named_by(key))
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", kind->word, kind->meaning);
  return text;
}

std::string side_key_names() { return fmt::format("{}", fmt::join(keys_of_kinds(), " or ")); }

void check_side(const Node& side, const std::string& path, std::vector<Problem>& problems)
{
  if (side.kind != NodeKind::table) return;
  if (side.items.empty())
    problems.push_back({path, fmt::format("`{}` is empty", side.name),
        fmt::format("Give {}, or one of {}.", side_key_names(), quoted_list(side_kind_words(""))), "boundary", true});
  std::vector<std::string_view> given = keys_of_kinds();
  std::erase_if(given, [&](std::string_view key) { return find_item(side, key) == nullptr; });
  if (given.size() > 1)
    problems.push_back({fmt::format("{}.{}", path, given[1]),
        fmt::format("a side has either `{}` or `{}`, not both", given[0], given[1]),
        "Each is a boundary condition of its own. Remove one of the two.", "boundary", true});
  for (const Node& item : side.items) check_key(side, item, path, problems);
}

void check_doubts(const SideCondition& side, std::vector<Problem>& warnings)
{
  const SideKindInfo& kind = info_of(side.kind);
  if (kind.doubt == nullptr) return;
  if (const auto doubt = kind.doubt(side))
    warnings.push_back({join_path("boundary", side.side) + '.' + std::string(doubt->key), std::string(doubt->what),
        std::string(doubt->detail), "boundary", true});
}

}  // namespace terp
