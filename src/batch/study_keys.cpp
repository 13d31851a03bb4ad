// A key of a study goes to the reader of case files as if it were one of a case. So both have the same messages; only
// their topics are removed, which are pages on keys of cases. Unknown keys come first, then the others in the order of
// the table of keys and not of the file.

#include "batch/study_keys.hpp"

#include "math/closest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

bool store(const Node& node, const std::string& path, const StudyKey& key, Findings& findings)
{
  const std::size_t n_problems = findings.problems.size(), n_warnings = findings.warnings.size();
  KeyInfo info;
  info.path = key.name, info.unit = key.unit, info.range = key.range, info.words = key.words;
  info.field = [field = key.field](Case&, std::size_t) { return field; };
  const bool good = store_value({node, path, info}, key.field, findings);
  for (std::size_t k = n_problems; k < findings.problems.size(); ++k) findings.problems[k].topic.clear();
  for (std::size_t k = n_warnings; k < findings.warnings.size(); ++k) findings.warnings[k].topic.clear();
  return good;
}

void refuse_unknown(
    const Node& item, const std::string& path, const std::vector<std::string>& names, Findings& findings)
{
  Problem problem{join_path(path, item.name), fmt::format("unknown key `{}`", item.name),
      did_you_mean(item.name, names) + "Keys here: " + plain_list(names), ""};
  problem.at_key = true;
  findings.problems.push_back(std::move(problem));
}

}  // namespace

void read_section(const Node& table, const std::string& path, const std::vector<StudyKey>& keys,
    const std::vector<std::string>& others, Findings& findings)
{
  if (table.kind != NodeKind::table)
    return findings.problems.push_back(
        {path, "a table must stand here", fmt::format("Got {}.", describe_value(table)), ""});
  std::vector<std::string> names;
  for (const StudyKey& key : keys) names.push_back(key.name);
  names.insert(names.end(), others.begin(), others.end());
  for (const Node& item : table.items)
    if (std::ranges::find(names, item.name) == names.end()) refuse_unknown(item, path, names, findings);
  for (const StudyKey& key : keys) {
    const Node* item = find_item(table, key.name);
    if (item != nullptr)
      store(*item, join_path(path, key.name), key, findings);
    else if (key.required)
      findings.problems.push_back({path, fmt::format("`{}` is missing", key.name), "See docs/probability.md.", ""});
  }
}

bool read_study_number(const Node& node, const std::string& path, const StudyKey& key, Real& value, Findings& findings)
{
  StudyKey own = key;
  own.field = &value;
  return store(node, path, own, findings);
}

}  // namespace terp
