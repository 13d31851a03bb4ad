// Keys of a study that set the same value of the case. How it thinks: two changes that have nothing to do with each
// other give the same case in either order.

#include "batch/case_refusal.hpp"

#include "io/case/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

struct Change {
  std::string key, path, value;
  bool takes_mean = false;  ///< a field about what the case has, numbers that are drawn included
  bool is_coarse = false;   ///< of two levels; such changes follow one another as those of `set` do

  bool takes_as_mean(const std::string& other) const
  {
    return takes_mean && (other == key || other.starts_with(key + '.'));
  }
};

/// KEY=VALUE of a table of the study file.
Change change_of(const std::string& text, const char* table)
{
  const std::size_t end = text.find('=');
  const std::string key = text.substr(0, end);
  return {.key = key, .path = join_path(table, key), .value = text.substr(end + 1)};
}

std::vector<Change> changes_of(const StudySettings& s)
{
  std::vector<Change> changes;
  const auto number = [&] { return fmt::format("{}", 1.0625 + static_cast<Real>(changes.size())); };
  for (const std::string& change : s.multilevel.coarse)
    changes.push_back(change_of(change, "estimator.coarse")), changes.back().is_coarse = true;
  for (const SweepKey& sweep : s.sweep) changes.push_back({sweep.key, join_path(sweep.path, "key"), number()});
  if (s.fragility)
    for (const auto& [key, value] : s.fragility->set)
      changes.push_back({key, join_path("fragility.set", key), number()});
  for (const RandomNumber& random : s.numbers)
    if (!random.is_name) changes.push_back({random.key, join_path(random.path, "key"), number()});
  for (const auto& [key, value] : s.follow) changes.push_back({key, join_path("follow", key), number()});
  for (const RandomFieldKey& field : s.fields)
    changes.push_back({field.key, join_path(field.path, "key"), fmt::format("{{ random = {{ mean = {} }} }}", number()),
        field.mean.empty()});
  return changes;
}

/// Cheap, and true of all that overlap: materials and other parts of the case do not mix.
bool may_overlap(const Change& a, const Change& b)
{
  const auto x = split_path(a.key), y = split_path(b.key);
  const auto is_open = [](const std::string& part) { return part.find_first_of("*[") != std::string::npos; };
  for (std::size_t k = 0; k < std::min<std::size_t>({x.size(), y.size(), 2}); ++k)
    if (x[k] != y[k] && !is_open(x[k]) && !is_open(y[k])) return false;
  return true;
}

void sort_tables(Node& node)
{
  if (node.kind == NodeKind::table) std::ranges::sort(node.items, {}, &Node::name);
  for (Node& item : node.items) sort_tables(item);
}

/// The case after some changes, one after another; empty where it does not take one of them.
std::string case_after(const Node& root, const std::vector<const Change*>& changes)
{
  Node node = root;
  for (const Change* change : changes)
    if (apply_override(node, change->key + "=" + change->value)) return "";
  sort_tables(node);
  return write_toml(node);
}

/// What `set` says of a key and no realisation has, as each draws it, or all parts of it.
void refuse_lost_settings(const Study& study, const std::vector<Change>& changes, std::vector<Problem>& problems)
{
  const Node root = parse_toml(study.case_text);
  for (const std::string& text : study.settings.set) {
    const Change set = change_of(text, "set");
    if (case_after(root, {&set}) == case_after(root, {})) continue;
    std::vector<const Change*> parts;
    const auto refuse_if_lost = [&](std::vector<const Change*> drawn) {
      const std::string without = case_after(root, drawn);
      drawn.insert(drawn.begin(), &set);
      if (without.empty() || case_after(root, drawn) != without) return false;
      std::string names;
      for (std::size_t k = 1; k < drawn.size(); ++k)
        names += fmt::format("{}`{}`", k == 1 ? "" : k + 1 < drawn.size() ? ", " : " and ", drawn[k]->key);
      problems.push_back({drawn.back()->path,
          fmt::format("`{}` of [set] is lost: {} {} given in each realisation anew", set.key, names,
              drawn.size() > 2 ? "are" : "is"),
          "Leave it out of [set], or do not draw it.", ""});
      return true;
    };
    bool is_lost = false;
    for (const Change& change : changes) {
      if (change.is_coarse || change.takes_as_mean(set.key) || !may_overlap(set, change)) continue;
      is_lost = refuse_if_lost({&change}) || is_lost;
      parts.push_back(&change);
    }
    if (!is_lost && parts.size() > 1) refuse_if_lost(parts);
  }
}

/// What is drawn and a stage sets anew: from its start on no realisation has what was drawn.
void refuse_draws_lost_in_stages(const Study& study, const std::vector<Change>& changes, std::vector<Problem>& problems)
{
  const Node& root = study.base.source.root;
  for (const StageCase& stage : study.base.values.stages)
    for (const auto& [key, value] : stage.changes) {
      const Change set{.key = key, .path = "", .value = value};
      const std::string alone = case_after(root, {&set});
      for (const Change& change : changes) {
        if (change.is_coarse || alone.empty() || !may_overlap(set, change)) continue;
        const std::string drawn = case_after(root, {&change});
        if (drawn.empty() || drawn == case_after(root, {}) || case_after(root, {&change, &set}) != alone) continue;
        problems.push_back(
            {change.path, fmt::format("`{}` is lost in the stage `{}`, which sets `{}`", change.key, stage.name, key),
                "All realisations have the value of the stage from there on. Leave one of the two out.", ""});
      }
    }
}

}  // namespace

void refuse_overlaps(const Study& study, std::vector<Problem>& problems)
{
  const std::vector<Change> changes = changes_of(study.settings);
  refuse_lost_settings(study, changes, problems);
  refuse_draws_lost_in_stages(study, changes, problems);
  for (std::size_t b = 1; b < changes.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const Change &first = changes[a], &second = changes[b];
      const bool is_part_of_mean = !first.takes_mean && second.takes_as_mean(first.key);
      if (is_part_of_mean || (first.is_coarse && second.is_coarse) || !may_overlap(first, second)) continue;
      const Node& root = study.base.source.root;
      if (case_after(root, {&first, &second}) == case_after(root, {&second, &first})) continue;
      problems.push_back({second.path, fmt::format("`{}` and `{}` set the same value", first.key, second.key),
          "One of the two would be lost without a word. Leave one out.", ""});
    }
}

}  // namespace terp
