// The kind is read first, as it decides which other keys are allowed and which are needed. Then come the numbers, the
// spread, for which the mean must be known, and at last what they say together. A step that needs the ones before it is
// taken only if they added no problem; problems of other tables do not count.

#include "batch/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

std::vector<std::string> names_of_distributions()
{
  std::vector<std::string> names;
  for (const DistributionInfo& info : all_distributions()) names.emplace_back(info.name);
  return names;
}

struct Reader {
  const Node& table;
  const std::string& path;
  const std::string& unit;
  Findings& findings;

  bool has(std::string_view name) const { return find_item(table, name) != nullptr; }
  void fail(std::string_view at, std::string what, std::string detail) const
  {
    findings.problems.push_back({at.empty() ? path : join_path(path, at), std::move(what), std::move(detail), ""});
  }
  bool number(const char* name, const std::string& of_unit, Range range, Real& value) const
  {
    const Node* item = find_item(table, name);
    return item != nullptr &&
           read_study_number(*item, join_path(path, name), {name, of_unit, range, false, {}}, value, findings);
  }
};

/// sd, from `sd` or from `cov` and the mean.
void read_spread(const Reader& r, Distribution& d)
{
  Real cov = 0.0;
  if (r.has("sd") && r.has("cov")) return r.fail("cov", "`sd` and `cov` are both given", "Remove one of the two.");
  if (!r.has("sd") && !r.has("cov"))
    return r.fail("", "the distribution needs `sd` or `cov`",
        "The standard deviation in the unit of the key, or as a share of the mean.");
  if (r.has("sd")) {
    r.number("sd", r.unit, positive, d.sd);
  } else if (r.number("cov", "-", positive, cov)) {
    if (d.mean == 0.0) return r.fail("cov", "a mean of 0 has no coefficient of variation", "Give `sd`.");
    d.sd = cov * std::abs(d.mean);
  }
}

void read_table(const Reader& r, Distribution& d)
{
  const Node& list = *find_item(r.table, "table");
  const std::string path = join_path(r.path, "table");
  const auto wrong = [&] {
    r.fail("table", "`table` must be a list of quantiles",
        "[[probability, value], ...], both ascending, from probability 0 to 1.");
  };
  if (list.kind != NodeKind::list || list.items.size() < 2) return wrong();
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const Node& pair = list.items[k];
    if (pair.kind != NodeKind::list || pair.items.size() != 2) return wrong();
    const std::string at = fmt::format("{}[{}]", path, k);
    Vec<2>& row = d.table.emplace_back();
    if (!read_study_number(
            pair.items[0], at + "[0]", {"table", "-", between(0.0, 1.0), false, {}}, row[0], r.findings) ||
        !read_study_number(pair.items[1], at + "[1]", {"table", r.unit, any_number, false, {}}, row[1], r.findings))
      return;
    if (k > 0 && (row[0] <= d.table[k - 1][0] || row[1] < d.table[k - 1][1])) return wrong();
  }
  if (d.table.front()[0] != 0.0 || d.table.back()[0] != 1.0) wrong();
}

void check_shape(const Reader& r, const Distribution& d)
{
  if (d.kind == DistributionKind::lognormal && !(d.mean > 0.0))
    r.fail("mean", "a lognormal distribution has a positive mean", fmt::format("Got {}.", d.mean));
  if (!(d.lowest < d.highest))
    r.fail("highest", "`highest` must lie above `lowest`", fmt::format("Got {} and {}.", d.highest, d.lowest));
  if (d.kind != DistributionKind::truncated_normal) return;
  const Real share = normal_probability((d.highest - d.mean) / d.sd) - normal_probability((d.lowest - d.mean) / d.sd);
  constexpr Real least = 1e-6;
  if (!(share > least))
    r.fail("", "nothing of the distribution lies between `lowest` and `highest`",
        fmt::format("Of a normal one of mean {:g} and standard deviation {:g}: {:.2g}.", d.mean, d.sd, share));
}

/// By location and decimation height instead of mean and spread. False: it is given the other way.
bool read_gumbel(const Reader& r, Distribution& d)
{
  if (!r.has("location") && !r.has("decimation_height")) return false;
  Real location = 0.0, decimation_height = 0.0;
  for (const char* other : {"mean", "sd", "cov"})
    if (r.has(other))
      r.fail(other, "the distribution is given twice", "By `mean` and `sd`, or by `location` and `decimation_height`.");
  for (const char* name : {"location", "decimation_height"})
    if (!r.has(name)) r.fail("", fmt::format("a gumbel distribution needs `{}` too", name), "");
  if (r.number("location", r.unit, any_number, location) &&
      r.number("decimation_height", r.unit, positive, decimation_height))
    d = gumbel_of(location, decimation_height);
  return true;
}

bool has_spread(const DistributionInfo& info) { return std::ranges::find(info.needed, "spread") != info.needed.end(); }

bool takes(const DistributionInfo& info, std::string_view key)
{
  if (key == "sd" || key == "cov") return has_spread(info);
  return std::ranges::find(info.needed, key) != info.needed.end() ||
         std::ranges::find(info.optional, key) != info.optional.end();
}

}  // namespace

std::vector<std::string> distribution_keys()
{
  return {"mean", "sd", "cov", "lowest", "highest", "location", "decimation_height", "table"};
}

Distribution read_distribution(const Node& table, const std::string& path, const std::string& unit, Findings& findings)
{
  Distribution d;
  const Reader r{table, path, unit, findings};
  std::string name;
  const std::size_t before = findings.problems.size();
  Node only = table;
  std::erase_if(only.items, [](const Node& item) { return item.name != "distribution"; });
  read_section(only, path, {{"distribution", "", any_number, true, &name, names_of_distributions}}, {}, findings);
  if (findings.problems.size() > before) return d;
  const auto info = std::ranges::find(all_distributions(), name, &DistributionInfo::name);
  d.kind = info->kind;
  for (const std::string& key : distribution_keys())
    if (r.has(key) && !takes(*info, key))
      r.fail(key, fmt::format("a {} distribution has no `{}`", name, key), fmt::format("It is: {}.", info->meaning));
  if (findings.problems.size() == before && d.kind == DistributionKind::gumbel && read_gumbel(r, d)) return d;
  for (const std::string_view key : info->needed)
    if (key != "spread" && !r.has(key))
      r.fail("", fmt::format("a {} distribution needs `{}`", name, key), fmt::format("It is: {}.", info->meaning));
  if (findings.problems.size() > before) return d;
  r.number("mean", unit, any_number, d.mean);
  r.number("lowest", unit, any_number, d.lowest);
  r.number("highest", unit, any_number, d.highest);
  if (findings.problems.size() > before) return d;
  if (has_spread(*info)) read_spread(r, d);
  if (d.kind == DistributionKind::quantiles) read_table(r, d);
  if (d.kind == DistributionKind::truncated_normal && !r.has("lowest") && !r.has("highest"))
    r.fail("", "a truncated distribution needs `lowest` or `highest`", "Else it is a normal one.");
  if (findings.problems.size() == before) check_shape(r, d);
  return d;
}

}  // namespace terp
