#include "page/beside.hpp"

#include "io/results/depends.hpp"
#include "os/read_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

/// "runs/a" of "runs/a/".
std::filesystem::path folder_of_run(const RunResults& run)
{
  const std::filesystem::path folder = std::filesystem::absolute(run.folder).lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

nlohmann::ordered_json stability_beside(const RunResults& run)
{
  const auto path = folder_of_run(run).parent_path() / "stability" / "stability.json";
  if (!std::filesystem::exists(path)) return nullptr;
  const Json found = Json::parse(read_file(path.string()), nullptr, false);
  if (!found.is_object() || found.value("case", Json()) != run.case_toml) return nullptr;
  Json kept;
  for (const char* const key : {"factor_of_safety", "uncertainty", "stable_at", "failed_at", "mesh"})
    kept[key] = found.value(key, Json());
  return kept;
}

nlohmann::ordered_json depends_json(const RunResults& run)
{
  const std::filesystem::path folder = folder_of_run(run);
  const auto path = folder.parent_path() / depends_file;
  if (!std::filesystem::exists(path)) return nullptr;
  const Json all = Json::parse(read_file(path.string()), nullptr, false);
  const auto is_this = [&](const Json& one) {
    return one.is_object() && one.contains("folder") && one["folder"] == folder.filename().string();
  };
  for (const char* const key : {"runs", "turns_on", "does_not_turn_on"})
    if (!all.is_object() || !all.contains(key) || !all[key].is_array()) return nullptr;
  if (std::ranges::none_of(all["runs"], is_this)) return nullptr;
  return {{"turns_on", all["turns_on"]}, {"does_not_turn_on", all["does_not_turn_on"]},
      {"not_varied", all.value("not_varied", Json::array())}};
}

}  // namespace terp
