// What is missing or null keeps its default when it is read, so older files are read. A number that is not finite
// becomes null, so a Real that may be none must have NaN as its default. A new part needs its own `each`, or it goes to
// the JSON library as it is.

#include "io/files/summary_json.hpp"

#include "math/checksum.hpp"
#include "math/errors.hpp"
#include "run/measure/followers.hpp"
#include "io/files/files.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t summary_format = 1;
const std::string checksum_key = ",\n  \"checksum\": \"";  // the last key; its value is over the text without it

/// Calls f(name, value) for each entry of a part of summary.json, in the order of the file: written and read alike.
template <class F>
void each(PassTime& pass, F&& f)
{
  f("name", pass.name), f("seconds", pass.seconds);
}
template <class F>
void each(std::pair<Real, Real>& softened, F&& f)
{
  f("time", softened.first), f("fraction", softened.second);
}
template <class F>
void each(ReachedSide& reached, F&& f)
{
  f("side", reached.side), f("time", reached.time), f("rose", reached.rose);
}
template <class F>
void each(FootingSummary& footing, F&& f)
{
  f("name", footing.name), f("displacement", footing.displacement), f("reaction", footing.reaction);
  f("largest_reaction", footing.largest), f("work", footing.work);
}
template <class F>
void each(RunFinding& finding, F&& f)
{
  f("id", finding.id), f("en", finding.en), f("nl", finding.nl), f("see", finding.see);
}
template <class F>
void each(StageSummary& stage, F&& f)
{
  f("name", stage.name), f("start", stage.record.start), f("end", stage.record.end), f("steps", stage.record.steps);
  f("at_rest", stage.record.at_rest), f("fastest_node", stage.record.fastest);
  f("known_for", stage.record.known_for);
}
template <class F>
void each(StrengthWater& strength, F&& f)
{
  f("material", strength.material), f("parameter", strength.parameter);
  f("stress", strength.stress), f("daily", strength.daily);
}
template <class F>
void each(SlipSurface& slip, F&& f)
{
  f("time", slip.time), f("rate", slip.rate), f("points", slip.line);
}
template <class F>
void each(SlideSummary& slide, F&& f)
{
  f("facing", slide.slide.facing), f("stage", slide.stage), f("begins", slide.slide.begins);
  f("stops", slide.slide.stops);
  f("crest_from", slide.slide.crest_from), f("crest_to", slide.slide.crest_to);
  f("kinetic_peak", slide.slide.kinetic_peak), f("slip_surface", slide.slip), f("onset", slide.onset);
}

template <class F>
void each(FloodTrigger& trigger, F&& f)
{
  f("stage", trigger.stage), f("at_strength", trigger.at_strength), f("river", trigger.river);
  f("before", trigger.before);
}
template <class F>
void each(ProfileInGround& profile, F&& f)
{
  f("width", profile.width), f("slope", profile.slope), f("x", profile.x);
}
template <class F>
void each(FloodSummary& flood, F&& f)
{
  f("verdict", flood.verdict), f("water_level", flood.water_level);
  f("water_level_origin", flood.water_level_origin), f("river", flood.river);
  f("residual_height", flood.residual_height), f("freeboard", flood.freeboard);
  f("width_at_level", flood.width_at_level), f("intact_width", flood.intact_width);
  f("first_time_damaged", flood.first_time_damaged), f("first_time_below", flood.first_time_below);
  f("below_for", flood.below_for), f("below_by", flood.below_by);
  f("at_strength_damaged", flood.at_strength_damaged), f("at_strength_below", flood.at_strength_below);
  f("stage_damaged", flood.stage_damaged), f("stage_below", flood.stage_below), f("stage", flood.stage);
  f("fastest_node", flood.fastest_node), f("fastest_x", flood.fastest_x), f("fastest_y", flood.fastest_y);
  f("fastest_soil", flood.fastest_soil), f("still_moves", flood.still_moves);
  f("stage_moving", flood.stage_moving);
  f("margin", flood.margin), f("ravelled_volume", flood.ravelled_volume);
  f("ravelled_depth", flood.ravelled_depth);
  f("profile", flood.profile);
  f("criterion", flood.criterion), f("trigger", flood.trigger);
}

template <class F>
void each(MethodOptions& options, F&& f)
{
  each_option(options, f);
}

template <class F>
void each(Summary& s, F&& f)
{
  f("method", s.method);
  f("facing", s.facing), f("slides", s.slides), f("softened_fraction", s.softened_fraction);
  f("reached_sides", s.reached_sides), f("footings", s.footings), f("stages", s.stages);
  f("strength_water", s.strength_water), f("flood", s.flood), f("passes", s.passes);
  f("findings", s.findings);
}

template <class T>
concept IsPart = requires(T& part)
{
  each(part, [](const char*, auto&) {});
};

template <class T>
Json to_value(const T& value);

template <class T>
Json to_value(const std::optional<T>& value)
{
  return value ? to_value(*value) : Json(nullptr);
}

template <IsPart T>
Json to_value(const std::vector<T>& parts)
{
  Json list = Json::array();
  for (const T& part : parts) list.push_back(to_value(part));
  return list;
}

template <class T>
Json to_value(const T& value)
{
  if constexpr (IsPart<T>) {
    Json json;
    T part = value;
    each(part, [&](const char* name, const auto& entry) { json[name] = to_value(entry); });
    return json;
  } else if constexpr (std::is_same_v<T, Facing>) {
    return value == Facing::left ? "left" : "right";
  } else if constexpr (std::is_same_v<T, FloodVerdict>) {
    return std::string(info_of(value).name);
  } else if constexpr (MethodChoice<T>) {
    return std::string(word_of(value));
  } else {
    return value;
  }
}

template <class T>
void get(const nlohmann::json& json, const char* name, std::optional<T>& value);
template <IsPart T>
void get(const nlohmann::json& json, const char* name, std::vector<T>& parts);

/// The entry of that name, if it is there and of that type. False: it is not.
template <class T>
bool get(const nlohmann::json& json, const char* name, T& value)
{
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return false;
  if constexpr (IsPart<T>) {
    each(value, [&](const char* part, auto& there) { get(*found, part, there); });
  } else if constexpr (std::is_same_v<T, Facing>) {
    value = *found == "left" ? Facing::left : Facing::right;
  } else if constexpr (std::is_same_v<T, FloodVerdict>) {
    for (std::size_t k = 0; k < flood_verdicts.size(); ++k)
      if (*found == flood_verdicts[k].name) value = static_cast<FloodVerdict>(k);
  } else if constexpr (MethodChoice<T>) {
    for (std::size_t k = 0; k < words_of(value).size(); ++k)
      if (*found == words_of(value)[k]) value = static_cast<T>(k);
  } else {
    try {
      value = found->get<T>();
    } catch (const nlohmann::json::exception&) {
      return false;
    }
  }
  return true;
}

template <class T>
void get(const nlohmann::json& json, const char* name, std::optional<T>& value)
{
  if (T there{}; get(json, name, there)) value = there;
}

template <IsPart T>
void get(const nlohmann::json& json, const char* name, std::vector<T>& parts)
{
  for (const auto& entry : json.value(name, nlohmann::json::array()))
    each(parts.emplace_back(), [&](const char* part, auto& value) { get(entry, part, value); });
}

/// JSON, without what is nested deeper than Terp writes it: copying that would take one call per level. Discarded where
/// it is none.
nlohmann::json parse(const std::string& text)
{
  constexpr int most_levels = 16;
  return nlohmann::json::parse(
      text, [](int depth, auto, auto&) { return depth <= most_levels; }, false);
}

void check_own_checksum(const std::string& path, const std::string& text)
{
  const std::size_t at = text.rfind(checksum_key);
  if (at != std::string::npos) {
    const std::string sealed = text.substr(0, at) + "\n}";
    if (text == sealed.substr(0, at) + checksum_key + digits_of(sealed) + "\"\n}\n") return;
  }
  throw FileError(fmt::format(
      "{}: this is not what the run wrote: it was altered\n  Copy the folder again, or solve the case again.", path));
}

SavedSummary read_values(const std::string& path)
{
  SavedSummary saved{
      .values = {}, .finished = false, .terp_version = {}, .text = read_file(path), .case_toml = {}, .tables = {}};
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
  if (json.contains("checksum")) {
    check_own_checksum(path, saved.text);
    saved.case_toml = json.at("case");
    for (const auto& table : json.at("tables"))
      saved.tables.push_back({table.at("file"), table.at("bytes"), table.at("checksum")});
  }
  Summary& s = saved.values;
  for (const SummaryQuantity& quantity : summary_quantities())
    std::visit([&](auto member) { get(json, quantity.info.name.data(), s.*member); }, quantity.member);
  each(s, [&](const char* name, auto& part) { get(json, name, part); });
  if (!s.slides.empty()) s.first_slide_time = s.slides.front().slide.begins;
  for (const FollowerType* type : all_followers())
    for (const QuantityInfo& info : type->summary) {
      if (!json.contains(info.name)) continue;  // a summary of an older version
      Real value = std::nan("");
      get(json, info.name.data(), value);
      s.numbers.emplace(info.name, value);
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

nlohmann::ordered_json slides_json(const Summary& summary) { return to_value(summary.slides); }

nlohmann::ordered_json flood_json(const Summary& summary) { return to_value(summary.flood); }

std::string summary_text(
    const Summary& summary, bool finished, const CaseText& case_text, const std::vector<WrittenTable>& tables)
{
  Json json = {{"terp_version", TERP_VERSION}, {"format", summary_format}, {"finished", finished}};
  for (const SummaryQuantity& quantity : summary_quantities())
    std::visit(
        [&](auto member) { json[std::string(quantity.info.name)] = to_value(summary.*member); }, quantity.member);
  Summary shown = summary;
  if (shown.flood && !finished) withhold_verdict(*shown.flood);
  each(shown, [&](const char* name, auto& part) { json[name] = to_value(part); });
  for (const auto& [name, value] : summary.numbers) json[name] = value;
  json["case_name"] = case_text.name;
  json["case"] = case_text.toml;
  json["tables"] = Json::array();
  for (const WrittenTable& table : tables)
    json["tables"].push_back({{"file", table.file}, {"bytes", table.n_bytes}, {"checksum", table.checksum}});
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  return text.substr(0, text.size() - 2) + checksum_key + digits_of(text) + "\"\n}\n";
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

void write_summary(const std::string& path, const Summary& summary, bool finished, const CaseText& case_text,
    const std::vector<WrittenTable>& tables)
{
  write_file_atomically(path, summary_text(summary, finished, case_text, tables));
}

}  // namespace terp
