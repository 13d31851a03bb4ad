// The record of a section is its memory over processes: each step writes it. A record that lacks an entry counts as
// none: a new entry makes older records so. What is damaged in a run is a fault of that section and not of the reach.

#include "io/results/reach.hpp"

#include "os/csv.hpp"
#include "math/errors.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/summary_json.hpp"

#include <algorithm>
#include <filesystem>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr int reach_format = 1;

/// Calls f(key, member) for each entry of a record: written and read alike.
template <class Record, class F>
void each(Record& r, F&& f)
{
  f("name", r.name), f("file", r.file), f("title", r.title), f("question", r.question);
  f("program", r.program), f("language", r.language), f("strength", r.strength);
  f("files", r.files), f("files_next", r.files_next);
  f("case_found", r.case_found), f("run_of", r.run_of), f("step", r.step), f("fault", r.fault), f("is_done", r.is_done);
  f("is_refused", r.is_refused), f("notes", r.notes), f("notes_nl", r.notes_nl);
  f("has_report", r.has_report), f("has_trigger", r.has_trigger), f("is_held", r.is_held), f("trigger", r.trigger);
  f("ignored", r.ignored), f("factor", r.factor), f("uncertainty", r.uncertainty);
  f("stands", r.stands), f("fails", r.fails), f("creeps", r.creeps);
  f("cell", r.cell), f("points", r.n_points), f("expected_s", r.expected_s), f("seconds", r.seconds);
}

template <class T>
Json value_of(const T& value)
{
  return value;
}
template <class T>
Json value_of(const std::optional<T>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

template <class T>
void get(const Json& json, T& value)
{
  value = json.get<T>();
}
template <class T>
void get(const Json& json, std::optional<T>& value)
{
  if (!json.is_null()) value = json.get<T>();
}

/// Bytes that are no UTF-8 are replaced.
std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json stored_json(const SectionRecord& record)
{
  Json list = Json::array();
  for (const StoredFactor& s : record.stored)
    list.push_back({{"method", s.method}, {"factor", s.factor}, {"stale", s.stale}, {"strength", s.strength}});
  return list;
}

Json record_json(const SectionRecord& record)
{
  Json json;
  each(record, [&](const char* key, const auto& value) { json[key] = value_of(value); });
  json["stored"] = stored_json(record);
  return json;
}

/// Least of the stored factors that are of the section and of the strengths of its case; infinite: there is none.
Real least_stored(const SectionRecord& record)
{
  Real least = std::numeric_limits<Real>::infinity();
  for (const StoredFactor& s : record.stored)
    if (!s.stale && s.strength == record.strength) least = std::min(least, s.factor);
  return least;
}

/// A number as text, with a comma in Dutch.
std::string decimal_sign(std::string number, bool dutch)
{
  if (dutch) std::ranges::replace(number, '.', ',');
  return number;
}

std::string strength_words(const std::string& strength, bool dutch)
{
  if (!dutch) return strength + " strengths";
  return strength == "design" ? "rekenwaarden" : strength == "mean" ? "gemiddelde sterktes" : "andere sterktes";
}

/// Of the section as it is, without what a trigger does.
std::optional<FloodVerdict> verdict_as_it_is(const ReachSection& section)
{
  if (!section.is_solved || !section.summary.flood) return std::nullopt;
  const FloodSummary& flood = *section.summary.flood;
  return flood.trigger ? flood.trigger->before : flood.verdict;
}

std::string hints_text(const ReachSection& section)
{
  std::string text;
  for (const Hint hint : hints_on(section)) text += (text.empty() ? "" : "; ") + words_of(hint, section, false);
  return text;
}

/// Of the fastest node [m/s]. A case without a verdict on the water has it from its last stage.
std::optional<Real> speed_at_end(const ReachSection& section)
{
  if (!section.is_solved) return std::nullopt;
  const Summary& summary = section.summary;
  if (summary.flood && summary.flood->fastest_node) return summary.flood->fastest_node;
  if (summary.stages.empty() || !std::isfinite(summary.stages.back().record.fastest)) return std::nullopt;
  return summary.stages.back().record.fastest;
}

struct Column {
  const char* name;
  std::string (*text)(const ReachSection&);
};

using S = const ReachSection&;

std::string number(Real value, const char* form = "{:.4g}")
{
  return std::isfinite(value) ? fmt::format(fmt::runtime(form), value) : "";
}
std::string number(std::optional<Real> value, const char* form = "{:.4g}") { return value ? number(*value, form) : ""; }

template <class F>
std::string of_flood(S s, F&& f)
{
  return s.is_solved && s.summary.flood ? f(*s.summary.flood) : std::string();
}

/// In the order of the file. A new column is one entry here and a row of docs/assess.md.
const Column reach_columns[] = {
    {"section", [](S s) { return plain_csv_cell(s.record.name); }},
    {"file", [](S s) { return plain_csv_cell(s.record.file); }},
    {"title", [](S s) { return plain_csv_cell(s.record.title); }},
    {"state", [](S s) { return state_of(s); }},
    {"reason", [](S s) { return plain_csv_cell(s.record.fault); }},
    {"verdict",
        [](S s) {
          return of_flood(
              s, [](const FloodSummary& f) { return std::string(f.verdict ? info_of(*f.verdict).name : ""); });
        }},
    {"trigger",
        [](S s) {
          return of_flood(
              s, [](const FloodSummary& f) { return plain_csv_cell(f.trigger ? trigger_words(*f.trigger) : ""); });
        }},
    {"verdict_before",
        [](S s) {
          return of_flood(s, [](const FloodSummary& f) {
            return f.trigger && f.trigger->before ? std::string(info_of(*f.trigger->before).name) : std::string();
          });
        }},
    {"held", [](S s) { return std::string(s.record.is_held ? "yes" : "no"); }},
    {"at_rest",
        [](S s) {
          const auto at_rest = ended_at_rest(s);
          return std::string(at_rest ? *at_rest ? "yes" : "no" : "");
        }},
    {"fastest_node_m_s", [](S s) { return number(speed_at_end(s), "{:.2g}"); }},
    {"hints", [](S s) { return plain_csv_cell(hints_text(s)); }},
    {"water_level_m",
        [](S s) { return of_flood(s, [](const FloodSummary& f) { return number(f.water_level, "{:.2f}"); }); }},
    {"residual_height_m", [](S s) { return s.is_solved ? number(s.summary.residual_height, "{:.2f}") : ""; }},
    {"freeboard_m",
        [](S s) { return of_flood(s, [](const FloodSummary& f) { return number(f.freeboard, "{:.2f}"); }); }},
    {"width_at_level_m",
        [](S s) { return of_flood(s, [](const FloodSummary& f) { return number(f.width_at_level, "{:.2f}"); }); }},
    {"first_slide_s", [](S s) { return s.is_solved ? number(s.summary.first_slide_time, "{:.2f}") : ""; }},
    {"floods_from_s",
        [](S s) { return of_flood(s, [](const FloodSummary& f) { return number(f.first_time_below, "{:.2f}"); }); }},
    {"factor", [](S s) { return number(s.record.factor, "{:.3f}"); }},
    {"factor_uncertainty", [](S s) { return number(s.record.uncertainty, "{:.3f}"); }},
    {"stored_factors", [](S s) { return plain_csv_cell(stored_text(s.record, false)); }},
    {"cell_m", [](S s) { return number(s.record.cell); }},
    {"points", [](S s) { return fmt::format("{}", s.record.n_points); }},
    {"expected_s", [](S s) { return number(s.record.expected_s, "{:.0f}"); }},
    {"seconds", [](S s) { return number(s.record.seconds, "{:.0f}"); }},
};

}  // namespace

std::string record_text(const SectionRecord& record) { return text_of(record_json(record)); }

SectionRecord read_record(const std::string& folder)
{
  SectionRecord record;
  try {
    const Json json = Json::parse(read_file(path_in(folder, record_file)));
    each(record, [&](const char* key, auto& value) { get(json.at(key), value); });
    for (const Json& s : json.at("stored"))
      record.stored.push_back({s.at("method").get<std::string>(), s.at("factor").get<Real>(), s.at("stale").get<bool>(),
          s.at("strength").get<std::string>()});
    return record;
  } catch (const FileError&) {
  } catch (const Json::exception&) {
  }
  return {};
}

ReachSection read_section(
    const std::string& folder, std::vector<std::array<Real, 3>> (*profile_of)(const RunResults& run))
{
  ReachSection section{.record = read_record(folder)};
  const std::string run = path_in(folder, run_of_section);
  if (!section.record.is_done || !section.record.fault.empty()) return section;
  try {
    SavedSummary saved = read_summary(path_in(run, summary_file));
    section.is_solved = saved.finished;
    section.summary = std::move(saved.values);
    section.profile = profile_of(read_run(run));
  } catch (const std::exception& error) {  // of whatever is damaged there
    section.is_solved = false;
    section.record.fault = error.what();
  }
  return section;
}

std::string state_of(const ReachSection& section)
{
  if (section.is_solved) return "solved";
  if (section.record.fault.empty()) return "not finished";
  return section.record.is_refused ? "refused" : "failed";
}

std::optional<bool> ended_at_rest(const ReachSection& section)
{
  if (!section.is_solved || section.summary.stages.empty()) return std::nullopt;
  const StageRecord& last = section.summary.stages.back().record;
  return last.at_rest || std::isfinite(last.fastest) ? std::optional(last.at_rest) : std::nullopt;
}

bool moved_before_trigger(const ReachSection& section)
{
  const auto& flood = section.summary.flood;
  if (!section.is_solved || !flood || !flood->trigger || flood->trigger->before) return false;
  const auto& stages = section.summary.stages;
  const auto first = std::ranges::find(stages, flood->trigger->stage, &StageSummary::name);
  return first != stages.begin() && first != stages.end() && !std::prev(first)->record.at_rest;
}

std::vector<Hint> hints_on(const ReachSection& section)
{
  std::vector<Hint> hints;
  if (!section.is_solved) return hints;
  if (!section.record.notes.empty()) hints.push_back(Hint::doubt);
  if (!section.record.ignored.empty()) hints.push_back(Hint::ignored);
  const auto& flood = section.summary.flood;
  const bool moves = !ended_at_rest(section).value_or(true) || (flood && flood->still_moves);
  if (moves && !(flood && flood->verdict == FloodVerdict::floods)) hints.push_back(Hint::moves);
  if (section.record.is_held) hints.push_back(Hint::held);
  const Real least = least_stored(section.record);
  const auto verdict = verdict_as_it_is(section);
  if (verdict == FloodVerdict::stands && least < 1.0) hints.push_back(Hint::stored_below);
  if (verdict == FloodVerdict::floods && least >= 1.0 && std::isfinite(least)) hints.push_back(Hint::stored_above);
  return hints;
}

std::string words_of(Hint hint, const ReachSection& section, bool dutch)
{
  const auto fastest = speed_at_end(section);
  const std::string speed = fastest ? decimal_sign(fmt::format(" ({:.2g} m/s)", *fastest), dutch) : "";
  const auto& flood = section.summary.flood;
  const std::string stage = flood && !flood->moves_at_end()
                                ? fmt::format("{}`{}`", dutch ? " van fase " : " of the stage ", flood->stage_moving)
                                : "";
  switch (hint) {
    case Hint::doubt:
      return fmt::format("{}{}", dutch ? "twijfel bij het inlezen: " : "in doubt since the import: ",
          fmt::join(dutch ? section.record.notes_nl : section.record.notes, " "));
    case Hint::ignored: return (dutch ? "niet toegepast (Engels): " : "") + section.record.ignored;
    case Hint::moves:
      return (dutch ? "aan het eind" : "not at rest at the end") + stage + (dutch ? " niet in rust" : "") + speed +
             (!section.summary.flood ? ""
                 : dutch             ? ": het oordeel kan veranderen"
                                     : ": the verdict may change");
    case Hint::held:
      return dutch ? "evenwicht zonder steun niet gevonden: de grond is eerst vastgehouden"
                   : "held at first: the soil does not stand by itself";
    case Hint::stored_below:
      return fmt::format(fmt::runtime(dutch ? "standzeker, maar een opgeslagen factor is {}, kleiner dan 1"
                                            : "stands, but a stored factor is {}, below 1"),
          decimal_sign(fmt::format("{:.3f}", least_stored(section.record)), dutch));
    case Hint::stored_above:
      return fmt::format(fmt::runtime(dutch ? "loopt over, maar elke opgeslagen factor is ten minste {}"
                                            : "floods, but every stored factor is at least {}"),
          decimal_sign(fmt::format("{:.3f}", least_stored(section.record)), dutch));
  }
  return "";
}

std::string sentence_on(const ReachSection& section)
{
  if (!section.is_solved) return fmt::format("{}: {}", state_of(section), section.record.fault);
  const std::string hints = hints_text(section);
  return (section.summary.flood ? flood_clause(*section.summary.flood)
                                : "solved; the case asks for no verdict on the water") +
         (hints.empty() ? "" : fmt::format(" ({})", hints));
}

std::string stored_text(const SectionRecord& record, bool dutch)
{
  std::string text;
  for (const StoredFactor& s : record.stored) {
    std::vector<std::string> remarks;
    if (s.strength != "deterministic") remarks.push_back(strength_words(s.strength, dutch));
    if (s.stale) remarks.emplace_back(dutch ? "ander dwarsprofiel" : "other section");
    text += fmt::format("{}{} {}{}",
        text.empty() ? ""
        : dutch      ? "; "
                     : ", ",
        s.method, decimal_sign(fmt::format("{:.3f}", s.factor), dutch),
        remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, ", ")));
  }
  return text;
}

std::string reach_csv(const std::vector<ReachSection>& sections)
{
  std::string text;
  for (const Column& column : reach_columns) text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  for (const ReachSection& section : sections) {
    std::string row;
    for (const Column& column : reach_columns) row += (&column == reach_columns ? "" : ",") + column.text(section);
    text += '\n' + row;
  }
  return text + '\n';
}

std::string vrtool_csv(const std::vector<ReachSection>& sections)
{
  constexpr Real model_factor = 1.06, offset = 0.41, slope = 0.15, largest_index = 8.0;
  std::string rows;
  int n = 0;
  for (const ReachSection& section : sections) {
    const SectionRecord& record = section.record;
    if (!record.factor) continue;
    const Real beta = std::min((*record.factor / model_factor - offset) / slope, largest_index);
    rows +=
        fmt::format("{},{},1,{},1.0,{:.4g},{:.4g},{}\n", n++, plain_csv_cell(record.name), plain_csv_cell(record.title),
            *record.factor, beta, plain_csv_cell(std::filesystem::path(record.file).filename().string()));
  }
  return rows.empty() ? "" : ",doorsnede,scenario,scenarionaam,scenariokans,SF,beta,stixnaam\n" + rows;
}

std::string reach_json(const std::vector<ReachSection>& sections, const std::string& written, bool with_ground)
{
  Json list = Json::array();
  for (const ReachSection& section : sections) {
    Json json = record_json(section.record);
    json["state"] = state_of(section);
    json["at_rest"] = value_of(ended_at_rest(section));
    for (const bool dutch : {false, true}) {
      Json& hints = json[dutch ? "hints_nl" : "hints"] = Json::array();
      for (const Hint hint : hints_on(section)) hints.push_back(words_of(hint, section, dutch));
      json[dutch ? "stored_text_nl" : "stored_text"] = stored_text(section.record, dutch);
    }
    json["moves"] = std::ranges::count(hints_on(section), Hint::moves) > 0;
    json["moved_before_trigger"] = moved_before_trigger(section);
    json["flood"] = section.is_solved ? flood_json(section.summary) : Json(nullptr);
    json["residual_height"] = value_of(section.is_solved ? section.summary.residual_height : std::nullopt);
    json["first_slide_time"] = value_of(section.is_solved ? section.summary.first_slide_time : std::nullopt);
    if (with_ground) json["ground"] = section.profile;
    list.push_back(std::move(json));
  }
  return text_of({{"format", reach_format}, {"terp_version", TERP_VERSION}, {"written", written}, {"sections", list}});
}

}  // namespace terp
