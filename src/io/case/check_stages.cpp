// [time] of a run without stages and each [[stage]] end by the same rules, so one check serves both with other keys
// (EndKeys). Bodies are checked over all stages at once: a first pass notes in which stage each one comes and goes. A
// second pass compares the two, because a single stage does not show whether a body is there.

#include "math/closest.hpp"
#include "io/case/check_case.hpp"
#include "io/case/key_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>

namespace terp {
namespace {

struct EndKeys {
  std::string path;     ///< "time", "stage[0]"
  const char* end_key;  ///< "end", "duration"
  Until until;
};

void check_end(const Node& root, const EndKeys& end, Findings& findings)
{
  const auto has = [&](const char* key) { return find_node(root, end.path + '.' + key) != nullptr; };
  const bool early = end.until != Until::end;
  const Node* until = find_node(root, end.path + ".until");
  const std::string topic = end.path.starts_with("stage") ? "stage" : "time";
  if (early && has(end.end_key))
    findings.problems.push_back({fmt::format("{}.{}", end.path, end.end_key),
        fmt::format("`{}` does not go with until = \"{}\"", end.end_key, until->text),
        "Give the longest time as `at_most`.", topic, true, {end.path + ".until"}});
  const bool ends = !early && (until == nullptr || until->text == "end");  // no other word, which is reported elsewhere
  if (ends && has("at_most"))
    findings.problems.push_back({end.path + ".at_most", "`at_most` needs until = \"at_rest\" or \"verdict\"",
        fmt::format("Without it the time is `{}`.", end.end_key), topic, true, {end.path + ".until"}});
  const bool reported_by_reader = topic == "time" && !early && !has("until");
  if (const char* missing = early ? "at_most" : end.end_key;
      !has(missing) && (early || !has("at_most")) && !reported_by_reader)
    findings.problems.push_back(
        {end.path, fmt::format("the key `{}` is missing from {}", missing, topic == "stage" ? "[[stage]]" : "[time]"),
            end.until == Until::verdict ? "It is the time at which the run ends if its verdict is not known before."
            : early ? "It is the time at which the run ends or goes on if the soil does not come to rest."
                    : "Give it in s, or until = \"at_rest\" with `at_most`.",
            topic, true});
}

bool is_name(const std::string& text)
{
  return !text.empty() &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

void check_water_of_stage(const Case& values, std::size_t k, Findings& findings)
{
  const std::string &name = values.stages[k].water, path = fmt::format("stage[{}].water", k);
  if (name.empty()) return;
  std::vector<std::string> known;
  bool timed = false;
  if (values.water.is_given()) known.emplace_back(name_of_start);
  for (const WaterSituation& situation : values.water.situations) {
    known.push_back(situation.name);
    timed = timed || std::isfinite(situation.time);
  }
  if (std::ranges::find(known, name) == known.end())
    findings.problems.push_back({path, fmt::format("there is no water situation `{}`", name),
        known.empty() ? "The case has no [water]." : "Situations of this case: " + plain_list(known), "stage.water"});
  else if (timed)
    findings.problems.push_back({path, "water that changes with the time cannot change with the stages, too",
        "Remove `time` from every [[water.situation]], or `water` from every stage.", "stage.water", false, {"water"}});
}

/// A stage has the name of a water situation, and another water acts in it.
void check_namesake_of_stage(const Case& values, std::size_t k, std::vector<Problem>& warnings)
{
  const std::string& name = values.stages[k].name;
  std::string water(name_of_start);
  for (std::size_t i = 0; i <= k; ++i)
    if (!values.stages[i].water.empty()) water = values.stages[i].water;
  const auto& situations = values.water.situations;
  if (water == name || std::ranges::find(situations, name, &WaterSituation::name) == situations.end()) return;
  warnings.push_back({fmt::format("stage[{}]", k), fmt::format("the water of the stage `{}` is `{}`", name, water),
      fmt::format(
          "There is a water situation of the name of the stage. Give water = \"{}\" there, or another name.", name),
      "stage.water", false, {"water"}});
}

/// It ends before its soil could have been at rest for as long as that takes.
void check_time_for_rest(const StageCase& stage, Real rest_time, const std::string& key, std::vector<Problem>& warnings)
{
  if (stage.until != Until::at_rest || !(stage.at_most > 0.0) || stage.at_most >= stage.ramp + rest_time) return;
  warnings.push_back({key, "the longest time is too short for rest",
      fmt::format(
          "Got {:g} s; soil is at rest after {:g} s without motion{}. Give `at_most` more, or `rest_time` less.",
          stage.at_most, rest_time,
          stage.ramp > 0.0 ? fmt::format(", counted from the end of the ramp of {:g} s", stage.ramp) : ""),
      "time.rest_time", false, {"stage", "time"}});
}

struct BodyChange {
  StageNumber placed = 0, removed = never;
  std::string place_key, remove_key;  ///< where they say so
};

/// A name in a list of a stage: stage[k].place[number].
struct NamedInStage {
  std::size_t stage;
  const char* key;
  std::size_t number;
  const std::string& name;

  std::string path() const { return fmt::format("stage[{}].{}[{}]", stage, key, number); }
};

/// The number of the body that is named, if there is one of that name that may come or go.
std::optional<std::size_t> find_body(const Case& values, const NamedInStage& entry, Findings& findings)
{
  const std::string& name = entry.name;
  const auto refuse = [&](std::string what, std::string detail) {
    findings.problems.push_back({entry.path(), std::move(what), std::move(detail), fmt::format("stage.{}", entry.key)});
    return std::nullopt;
  };
  std::vector<std::string> names;
  for (const BodyCase& body : values.bodies)
    if (!body.name.empty()) names.push_back(body.name);
  const auto found = std::ranges::find(values.bodies, name, &BodyCase::name);
  if (name.empty() || found == values.bodies.end()) {
    return refuse(fmt::format("there is no body `{}`", name),
        did_you_mean(name, names) + (names.empty() ? "No [[body]] of this case has a name: give it name = \"berm\"."
                                                   : "Bodies with a name: " + plain_list(names)));
  }
  if (entry.stage == 0)
    return refuse(fmt::format("the first stage cannot {} a body", entry.key),
        "It begins with the soil as it is at the start. Draw the section so, or give a stage before it.");
  return static_cast<std::size_t>(found - values.bodies.begin());
}

void read_bodies_of_stage(
    const Case& values, std::size_t k, bool places, std::vector<BodyChange>& bodies, Findings& findings)
{
  const char* const key = places ? "place" : "remove";
  const std::vector<std::string>& names = places ? values.stages[k].place : values.stages[k].remove;
  for (std::size_t number = 0; number < names.size(); ++number) {
    const NamedInStage entry{k, key, number, names[number]};
    const auto b = find_body(values, entry, findings);
    if (!b) continue;
    std::string& said = places ? bodies[*b].place_key : bodies[*b].remove_key;
    if (!said.empty())
      findings.problems.push_back({entry.path(),
          fmt::format("the body `{}` is {} twice", entry.name, places ? "placed" : "removed"),
          "A body comes once and goes once: draw another one, with a name of its own.", fmt::format("stage.{}", key)});
    else
      said = entry.path(), (places ? bodies[*b].placed : bodies[*b].removed) = k + 1;
  }
}

void check_bodies_of_stages(const Case& values, Findings& findings)
{
  std::vector<BodyChange> bodies(values.bodies.size());
  for (std::size_t k = 0; k < values.stages.size(); ++k) {
    for (const bool places : {true, false}) read_bodies_of_stage(values, k, places, bodies, findings);
    const StageCase& stage = values.stages[k];
    if (!stage.remove.empty() && stage.longest() > 0.0 && stage.ramp == stage.longest())
      findings.problems.push_back({fmt::format("stage[{}].ramp", k), "a body is not gone before the stage ends",
          fmt::format("It goes at the end of the ramp, {:g} s, and that is the time of the stage. Give a shorter ramp.",
              stage.ramp),
          "stage.remove"});
    if (!stage.place.empty() && stage.ramp == 0.0)
      findings.warnings.push_back({fmt::format("stage[{}].place", k), "the weight of a body comes at once",
          "Soil below it then takes up to twice that weight for a moment. Give the stage a `ramp` of a second or more.",
          "stage.ramp"});
  }
  if (!bodies.empty() && std::ranges::all_of(bodies, [](const BodyChange& body) { return body.placed > 0; }))
    findings.problems.push_back({bodies[0].place_key, "no body is there at the start",
        "Stages place all of them. Leave one that the others come to lie on.", "stage.place"});
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyCase& body = values.bodies[b];
    if (bodies[b].placed > 0 && bodies[b].removed <= bodies[b].placed)
      findings.problems.push_back(
          {bodies[b].remove_key, fmt::format("the body `{}` is removed before it is there", body.name),
              "Remove it in a stage after the one that places it.", "stage.remove"});
    if (bodies[b].placed > 0 && (body.velocity != Vec<2>{0.0, 0.0} || body.velocity_at))
      findings.problems.push_back({fmt::format("body[{}].velocity", b),
          fmt::format("the body `{}` comes with a velocity", body.name),
          "A body that a stage places is at rest. Leave `velocity` out.", "stage.place", false, {bodies[b].place_key}});
  }
}

void check_stage(const Node& root, const Case& values, std::size_t k, Findings& findings)
{
  const StageCase& stage = values.stages[k];
  const std::string path = fmt::format("stage[{}]", k);
  check_end(root, {path, "duration", stage.until}, findings);
  if (stage.until == Until::verdict && k + 1 < values.stages.size())
    findings.problems.push_back({path + ".until", "the verdict ends the last stage alone",
        "It is one of all stages. Give until = \"at_rest\".", "stage.until"});
  const auto same_name = [&](const StageCase& other) { return other.name == stage.name; };
  if (find_node(root, path + ".name") != nullptr && !is_name(stage.name))
    findings.problems.push_back({path + ".name", "a stage has a name of letters, digits, - and _",
        fmt::format("Got \"{}\". A file is called by it.", stage.name), "stage.name"});
  else if (std::any_of(values.stages.begin(), values.stages.begin() + static_cast<std::ptrdiff_t>(k), same_name))
    findings.problems.push_back({path + ".name", fmt::format("two stages have the name `{}`", stage.name),
        "Give each its own, as in name = \"flood\".", "stage.name", false, {path}});
  check_water_of_stage(values, k, findings);
  check_namesake_of_stage(values, k, findings.warnings);
  check_time_for_rest(stage, values.time.rest_time, path + ".at_most", findings.warnings);
  if (k == 0 && stage.reset_displacement)
    findings.warnings.push_back({path + ".reset_displacement", "`reset_displacement` of the first stage has no effect",
        "Displacement and strain are zero at its start. Give it in the stage from whose start on they shall count.",
        "stage.reset_displacement"});
  if (k == 0 && stage.trigger)
    findings.warnings.push_back({path + ".trigger", "no stage comes before the trigger",
        "The verdict is then of a section that was never looked at as it is. Give a stage without `trigger` before, in "
        "which\nit stands or fails by itself.",
        "stage.trigger"});
  if (stage.longest() > 0.0 && stage.ramp > stage.longest())
    findings.problems.push_back({path + ".ramp", "the ramp is longer than the stage",
        fmt::format("Got {:g} s; allowed: at most {:g} s.", stage.ramp, stage.longest()), "stage.ramp", false, {path}});
}

/// Largest speed that the conditions of a case prescribe [m/s], and the key that does.
std::pair<Real, std::string> driven(const Case& values)
{
  std::pair<Real, std::string> fastest{0.0, ""};
  const auto look = [&](Vec<2> v, std::string key) {
    if (const Real speed = std::hypot(v[0], v[1]); speed > fastest.first) fastest = {speed, std::move(key)};
  };
  for (const SideCondition& side : values.sides)
    look(side.velocity_at ? Vec<2>{INFINITY, 0.0} : side.velocity, join_path("boundary", side.side) + ".velocity");
  for (std::size_t k = 0; k < values.footings.size(); ++k)
    look(values.footings[k].velocity, fmt::format("footing[{}].velocity", k));
  return fastest;
}

void check_rest(const Node& root, const Case& values, Findings& findings)
{
  const auto any_until = [&](Until until) {
    const auto ends_so = [&](const StageCase& stage) { return stage.until == until; };
    return values.time.until == until || std::ranges::any_of(values.stages, ends_so);
  };
  const bool any = any_until(Until::at_rest), verdict = any_until(Until::verdict);
  for (const std::string key : {"time.rest_by", "time.rest_speed", "time.rest_time"})
    if (!any && !(verdict && key != "time.rest_by") && find_node(root, key) != nullptr)
      findings.warnings.push_back({key, fmt::format("`{}` has no effect", key.substr(5)),
          "Nothing ends at rest: it counts with until = \"at_rest\".", key, true});
  if (verdict && !values.flood.given)
    findings.problems.push_back(
        {values.stages.empty() ? "time.until" : fmt::format("stage[{}].until", values.stages.size() - 1),
            "without [flood] there is no verdict", "Add [flood], or give until = \"at_rest\".", "flood"});
  if (values.stages.empty() && (any || verdict)) check_what_goes_on(values, findings.warnings);
  const bool damped = values.forces.local_damping > 0.0 || values.forces.viscous_damping > 0.0;
  if (any && !damped && values.time.rest_by == RestBy::fastest)
    findings.warnings.push_back(
        {values.time.until == Until::at_rest ? "time.until" : "stage", "without damping soil hardly comes to rest",
            "Elastic soil then vibrates on. Give forces.damping.local, say 0.05, in the case or in the stage.",
            "forces.damping.local", false, {"forces.damping"}});
}

}  // namespace

void check_what_goes_on(const Case& values, std::vector<Problem>& warnings)
{
  const auto changes = [](const WaterSituation& of) { return of.formula_changes; };
  if (changes(values.water.start) || std::ranges::any_of(values.water.situations, changes))
    warnings.push_back({"water", "water that follows a formula of t never stands still",
        "What ends at rest then ends with its longest time. Give the water as situations with a `time`, or a fixed "
        "time of the end.",
        "time.until", true});
  const auto [speed, key] = driven(values);
  if (speed == 0.0) return;
  if (speed < values.time.rest_speed)
    warnings.push_back({key, "soil that is pushed this slowly counts as at rest",
        fmt::format("It is {:.3g} m/s; time.rest_speed is {:.3g} m/s. What ends at rest ends while it is still pushed. "
                    "Give rest_speed below it, or a fixed time of the end.",
            speed, values.time.rest_speed),
        "time.rest_speed", false, {"time"}});
  else
    warnings.push_back({key, "soil that is pushed does not come to rest",
        "What ends at rest then ends with its longest time. Give a fixed time of the end.", "time.until", false,
        {"time"}});
}

void set_end_of_run(const Node& root, Case& values)
{
  const auto says = [&](const std::string& path, const char* end_key) {
    return find_node(root, path + ".until") != nullptr || find_node(root, path + '.' + end_key) != nullptr;
  };
  if (values.flood.given && values.stages.empty() && find_node(root, "time") != nullptr && !says("time", "end"))
    values.time.until = Until::verdict;
  if (values.flood.given && !values.stages.empty() &&
      !says(fmt::format("stage[{}]", values.stages.size() - 1), "duration"))
    values.stages.back().until = Until::verdict;
  if (!values.stages.empty()) {
    Real sum = 0.0;
    for (const StageCase& stage : values.stages) sum += stage.longest();
    values.time.end = std::stod(fmt::format("{:.12g}", sum));  // 0.1 s and 0.2 s are 0.3 s, to the bit
  } else if (values.time.until != Until::end) {
    values.time.end = values.time.at_most;
  }
}

void check_stages(const Node& root, const Case& values, Findings& findings)
{
  if (values.stages.empty()) {
    if (find_node(root, "time") != nullptr) check_end(root, {"time", "end", values.time.until}, findings);
    StageCase all;
    all.until = values.time.until, all.at_most = values.time.at_most;
    check_time_for_rest(all, values.time.rest_time, "time.at_most", findings.warnings);
  } else {
    for (const char* key : {"time.end", "time.until", "time.at_most"})
      if (find_node(root, key) != nullptr)
        findings.problems.push_back({key, fmt::format("`{}` does not go with [[stage]]", key + 5),
            "The stages say when they end, and the run ends with the last of them. Remove it here.", "stage", true,
            {"stage"}});
    for (std::size_t k = 0; k < values.stages.size(); ++k) check_stage(root, values, k, findings);
    check_bodies_of_stages(values, findings);
  }
  check_rest(root, values, findings);
}

}  // namespace terp
