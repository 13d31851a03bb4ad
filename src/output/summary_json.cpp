// summary.json: see summary_json.hpp.
#include "output/summary_json.hpp"

#include "base/errors.hpp"
#include "output/files.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t summary_format = 1;

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

Json reached_sides(const Summary& summary)
{
  Json list = Json::array();
  for (const ReachedSide& reached : summary.reached_sides)
    list.push_back({{"side", reached.side}, {"time", number(reached.time)}, {"rose", reached.rose}});
  return list;
}

Json footings(const Summary& summary)
{
  Json list = Json::array();
  const auto pair = [](Vec<2> v) { return Json{number(v[0]), number(v[1])}; };
  for (const FootingSummary& f : summary.footings)
    list.push_back({{"name", f.name}, {"displacement", pair(f.displacement)}, {"reaction", pair(f.reaction)},
        {"largest_reaction", number(f.largest)}, {"work", number(f.work)}});
  return list;
}

/// The entry of that name, if it is there and of that type.
template <class T>
void get(const nlohmann::json& json, const char* name, T& value)
{
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return;
  try {
    value = found->get<T>();
  } catch (const nlohmann::json::exception&) {
  }
}

void get(const nlohmann::json& json, const char* name, std::optional<Real>& value)
{
  Real there = std::nan("");
  get(json, name, there);
  value = std::isnan(there) ? std::nullopt : std::optional(there);
}

/// "right" or "left".
std::string_view facing_name(Facing facing) { return facing == Facing::left ? "left" : "right"; }

Facing facing_of(const nlohmann::json& json)
{
  std::string name;
  get(json, "facing", name);
  return name == "left" ? Facing::left : Facing::right;
}

Json slides_json(const Summary& summary)
{
  Json list = Json::array();
  for (const auto& [slide, slip] : summary.slides) {
    Json points = Json::array();
    for (const Vec<2>& x : slip.line) points.push_back({number(x[0]), number(x[1])});
    list.push_back({{"facing", facing_name(slide.facing)}, {"begins", number(slide.begins)},
        {"stops", number(slide.stops)}, {"crest_from", number(slide.crest_from)}, {"crest_to", number(slide.crest_to)},
        {"kinetic_peak", number(slide.kinetic_peak)},
        {"slip_surface", {{"time", number(slip.time)}, {"rate", number(slip.rate)}, {"points", points}}}});
  }
  return list;
}

Json passes_json(const Summary& summary)
{
  Json list = Json::array();
  for (const auto& pass : summary.passes) list.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  return list;
}

void read_slides(const nlohmann::json& json, Summary& summary)
{
  for (const auto& entry : json.value("slides", nlohmann::json::array())) {
    SlideSummary slide;
    slide.slide.facing = facing_of(entry);
    get(entry, "begins", slide.slide.begins);
    get(entry, "stops", slide.slide.stops);
    get(entry, "crest_from", slide.slide.crest_from);
    get(entry, "crest_to", slide.slide.crest_to);
    get(entry, "kinetic_peak", slide.slide.kinetic_peak);
    const auto slip = entry.value("slip_surface", nlohmann::json::object());
    get(slip, "time", slide.slip.time);
    get(slip, "rate", slide.slip.rate);
    get(slip, "points", slide.slip.line);
    summary.slides.push_back(std::move(slide));
  }
}

void read_reached_sides(const nlohmann::json& json, Summary& summary)
{
  for (const auto& entry : json.value("reached_sides", nlohmann::json::array())) {
    ReachedSide reached;
    get(entry, "side", reached.side);
    get(entry, "time", reached.time);
    reached.rose = entry.value("rose", false);
    summary.reached_sides.push_back(std::move(reached));
  }
}

void read_footings(const nlohmann::json& json, Summary& summary)
{
  for (const auto& entry : json.value("footings", nlohmann::json::array())) {
    FootingSummary footing;
    get(entry, "name", footing.name);
    get(entry, "displacement", footing.displacement);
    get(entry, "reaction", footing.reaction);
    get(entry, "largest_reaction", footing.largest);
    get(entry, "work", footing.work);
    summary.footings.push_back(std::move(footing));
  }
}

void read_passes(const nlohmann::json& json, Summary& summary)
{
  for (const auto& entry : json.value("passes", nlohmann::json::array())) {
    PassTime pass;
    get(entry, "name", pass.name);
    get(entry, "seconds", pass.seconds);
    summary.passes.push_back(std::move(pass));
  }
}

/// JSON, without what is nested deeper than Terp writes it: copying that would take one call per level. Discarded where
/// it is none.
nlohmann::json parse(const std::string& text)
{
  constexpr int most_levels = 16;
  return nlohmann::json::parse(
      text, [](int depth, auto, auto&) { return depth <= most_levels; }, false);
}

SavedSummary read_values(const std::string& path)
{
  SavedSummary saved{.values = {}, .finished = false, .terp_version = {}, .text = read_file(path)};
  const auto json = parse(saved.text);
  if (!json.is_object()) throw FileError("cannot read " + path + ": it is not JSON");
  get(json, "terp_version", saved.terp_version);
  std::int64_t format = summary_format;
  get(json, "format", format);
  if (format > summary_format)
    throw FileError(
        fmt::format("cannot read {}: it is of format {}, terp {} reads formats up to {}\n  terp {} wrote it: read it "
                    "with that one.",
            path, format, TERP_VERSION, summary_format, saved.terp_version));
  get(json, "finished", saved.finished);
  Summary& s = saved.values;
  get(json, "scheme", s.scheme);
  get(json, "points", s.n_points);
  get(json, "cells", s.n_cells);
  get(json, "steps", s.n_steps);
  get(json, "dt", s.dt);
  get(json, "wall_s", s.wall_s);
  get(json, "point_steps_per_s", s.point_steps_per_s);
  get(json, "threads", s.threads);
  get(json, "instructions", s.instructions);
  get(json, "processor", s.processor);
  read_passes(json, s);
  if (json.contains("facing") && !json["facing"].is_null()) s.facing = facing_of(json);
  get(json, "free_toe", s.free_toe);
  get(json, "front_x", s.front_x);
  get(json, "crest_x", s.crest_x);
  get(json, "crest_y", s.crest_y);
  get(json, "run_out", s.run_out);
  get(json, "moved_distance", s.moved_distance);
  get(json, "moved_volume", s.moved_volume);
  get(json, "moved_fraction", s.moved_fraction);
  get(json, "intact_fraction", s.intact_fraction);
  read_slides(json, s);
  get(json, "second_failure_time", s.second_failure_time);
  get(json, "max_eps_eq_p", s.max_eps_eq_p);
  get(json, "softened_strain", s.softened_strain);
  get(json, "points_eps_eq_p_fell", s.points_eps_eq_p_fell);
  get(json, "points_su_rose", s.points_su_rose);
  get(json, "energy_balance_error", s.energy_balance_error);
  get(json, "clamped_points", s.clamped_points);
  get(json, "points_left", s.points_left);
  read_reached_sides(json, s);
  read_footings(json, s);
  get(json, "v_999", s.v_999);
  for (const auto& row : json.value("softened_fraction", nlohmann::json::array())) {
    Real time = 0.0, fraction = 0.0;
    get(row, "time", time);
    get(row, "fraction", fraction);
    s.softened_fraction.emplace_back(time, fraction);
  }
  return saved;
}

}  // namespace

SavedSummary read_summary(const std::string& path)
{
  try {
    return read_values(path);
  } catch (const nlohmann::json::exception& error) {  // a value of another kind than Terp writes
    const std::string what = error.what();  // "[json.exception.type_error.302] type must be boolean, but is string"
    throw FileError(fmt::format(
        "cannot read {}: it is not what terp wrote there: {}\n  Put a copy of it back, or solve the case again.", path,
        what.substr(what.find("] ") + 2)));
  }
}

std::string summary_text(const Summary& summary, bool finished, const CaseText& case_text)
{
  const Json json = {
      {"terp_version", TERP_VERSION},
      {"format", summary_format},
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
      {"processor", summary.processor},
      {"passes", passes_json(summary)},
      {"facing", summary.facing ? Json(facing_name(*summary.facing)) : Json(nullptr)},
      {"free_toe", summary.free_toe},
      {"front_x", number(summary.front_x)},
      {"crest_x", number(summary.crest_x)},
      {"crest_y", number(summary.crest_y)},
      {"run_out", number(summary.run_out)},
      {"moved_distance", number(summary.moved_distance)},
      {"moved_volume", number(summary.moved_volume)},
      {"moved_fraction", number(summary.moved_fraction)},
      {"intact_fraction", number(summary.intact_fraction)},
      {"slides", slides_json(summary)},
      {"second_failure_time", number(summary.second_failure_time)},
      {"max_eps_eq_p", number(summary.max_eps_eq_p)},
      {"softened_strain", number(summary.softened_strain)},
      {"softened_fraction", softened_fraction(summary)},
      {"points_eps_eq_p_fell", summary.points_eps_eq_p_fell},
      {"points_su_rose", summary.points_su_rose},
      {"energy_balance_error", number(summary.energy_balance_error)},
      {"clamped_points", summary.clamped_points},
      {"points_left", summary.points_left},
      {"reached_sides", reached_sides(summary)},
      {"footings", footings(summary)},
      {"v_999", number(summary.v_999)},
      {"case_name", case_text.name},
      {"case", case_text.toml},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string case_name_in(const std::string& folder)
{
  const std::string path = path_in(folder, summary_file);
  std::error_code none;
  const auto summary = std::filesystem::is_regular_file(path, none) ? parse(read_file(path)) : nlohmann::json();
  if (summary.is_object() && summary.contains("case_name") && summary["case_name"].is_string())
    return summary["case_name"];
  return std::filesystem::path(folder).lexically_normal().filename().string();
}

void write_summary(const std::string& path, const Summary& summary, bool finished, const CaseText& case_text)
{
  write_file_atomically(path, summary_text(summary, finished, case_text));
}

}  // namespace terp
