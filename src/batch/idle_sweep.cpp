// Cases are compared by their records: values in other units, or written in another way, are the same there. Each key
// is looked at alone, with the others as the case has them.

#include "batch/idle_sweep.hpp"

#include "batch/case_refusal.hpp"
#include "io/case/case_record.hpp"
#include "model/meshes/setup_mesh.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace terp {
namespace {

CaseFile case_with(const Study& study, const SweepKey& sweep, const Node& value)
{
  return read_case_text(study.case_text, study.case_path, changes_with(study, {sweep.key + "=" + toml_value(value)}));
}

bool leaves_no_trace(const RecordedValue& value)
{
  return value.key == "title" || value.key.starts_with("output.checkpoint") || value.key.starts_with("output.fields");
}

/// Numbers of two values that make the same case.
std::optional<std::array<std::size_t, 2>> find_same(const Study& study, const SweepKey& sweep)
{
  std::map<std::string, std::size_t> seen;
  for (std::size_t k = 0; k < sweep.values.size(); ++k) {
    const CaseFile file = case_with(study, sweep, sweep.values[k]);
    const SharedMesh mesh = study.shares_mesh ? study.mesh : std::make_shared<const Mesh<2>>(build_mesh(file.values));
    CaseRecord record = make_case_record(file, *mesh);
    std::erase_if(record, leaves_no_trace);
    if (const auto [place, is_new] = seen.emplace(record_text(record), k); !is_new) return {{place->second, k}};
  }
  return std::nullopt;
}

void refuse_equal_rows(const std::vector<SweepKey>& columns, std::vector<Problem>& problems)
{
  std::map<std::string, std::size_t> seen;
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    std::string text;
    for (const SweepKey& column : columns) text += toml_value(column.values[row]) + '\n';
    if (const auto [place, is_new] = seen.emplace(text, row); !is_new)
      problems.push_back({fmt::format("{}[{}]", join_path(columns.front().path, "values"), row),
          fmt::format("rows {} and {} of the table are the same case", place->second, row), "Give each case once.",
          ""});
  }
}

}  // namespace

void refuse_idle_sweeps(const Study& study, std::vector<Problem>& problems)
{
  if (study.settings.form == SweepForm::table) return refuse_equal_rows(study.settings.sweep, problems);
  for (const SweepKey& sweep : study.settings.sweep)
    if (const auto same = find_same(study, sweep))
      problems.push_back({fmt::format("{}[{}]", join_path(sweep.path, "values"), (*same)[1]),
          fmt::format("two values of `{}` make the same case", sweep.key),
          fmt::format("{} and {} give one result twice. Give each case once, and only keys that change it.",
              toml_value(sweep.values[(*same)[0]]), toml_value(sweep.values[(*same)[1]])),
          ""});
}

void doubt_idle_sweeps(const Study& study, std::vector<Problem>& doubts)
{
  for (const SweepKey& sweep : study.settings.sweep) {
    std::string why;
    const auto has_no_effect = [&](const Node& value) {
      for (const Problem& warning : case_with(study, sweep, value).warnings)
        if (warning.key == sweep.key && warning.what.find("has no effect") != std::string::npos)
          return why = warning.what + ". " + warning.detail, true;
      return false;
    };
    if (!sweep.values.empty() && std::ranges::all_of(sweep.values, has_no_effect))
      doubts.push_back(
          {join_path(sweep.path, "key"), fmt::format("`{}` decides nothing in this case", sweep.key), why, ""});
  }
}

}  // namespace terp
