// summary.json: see summary_json.hpp.
#include "output/summary_json.hpp"

#include "output/files.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity: both become null.
Json number(Real value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<Real>& value) { return value ? number(*value) : Json(nullptr); }

Json softened_fraction(const Summary& summary)
{
  Json list = Json::array();
  for (const auto& [time, fraction] : summary.softened_fraction) {
    list.push_back({{"time", number(time)}, {"fraction", number(fraction)}});
  }
  return list;
}

Json footings(const Summary& summary)
{
  Json list = Json::array();
  const auto pair = [](Vec<2> v) { return Json{number(v[0]), number(v[1])}; };
  for (const FootingSummary& f : summary.footings)
    list.push_back({{"name", f.name},
                    {"displacement", pair(f.displacement)},
                    {"reaction", pair(f.reaction)},
                    {"largest_reaction", number(f.largest)},
                    {"work", number(f.work)}});
  return list;
}

}  // namespace

std::string summary_text(const Summary& summary, bool finished, const CaseText& case_text)
{
  const Json json = {
      {"terp_version", TERP_VERSION},
      {"finished", finished},
      {"scheme", summary.scheme},
      {"points", summary.n_points},
      {"cells", summary.n_cells},
      {"steps", summary.n_steps},
      {"dt", number(summary.dt)},
      {"wall_s", number(summary.wall_s)},
      {"point_steps_per_s", number(summary.point_steps_per_s)},
      {"threads", summary.threads},
      {"instructions", summary.instructions},
      {"front_x", number(summary.front_x)},
      {"crest_x", number(summary.crest_x)},
      {"second_failure_time", number(summary.second_failure_time)},
      {"max_eps_eq_p", number(summary.max_eps_eq_p)},
      {"softened_fraction", softened_fraction(summary)},
      {"points_eps_eq_p_fell", summary.points_eps_eq_p_fell},
      {"points_su_rose", summary.points_su_rose},
      {"energy_balance_error", number(summary.energy_balance_error)},
      {"clamped_points", summary.clamped_points},
      {"points_left", summary.points_left},
      {"footings", footings(summary)},
      {"v_999", number(summary.v_999)},
      {"case_name", case_text.name},
      {"case", case_text.toml},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string case_name_in(const std::string& folder)
{
  std::ifstream file(path_in(folder, summary_file));
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  if (summary.is_object() && summary.contains("case_name") && summary["case_name"].is_string()) return summary["case_name"];
  return std::filesystem::path(folder).lexically_normal().filename().string();
}

void write_summary(const std::string& path, const Summary& summary, bool finished, const CaseText& case_text)
{
  write_file_atomically(path, summary_text(summary, finished, case_text));
}

}  // namespace terp
