// What only a sound file can contradict, the estimator with its stop rule, is checked last. identity_text says whether
// kept realisations are of this study: all of the file counts but what is taken out there. So a new key that does not
// decide results must be taken out, or a study cannot go on with another value.

#include "batch/study_file.hpp"

#include "math/closest.hpp"
#include "io/case/case_file.hpp"
#include "io/case/expression.hpp"
#include "io/case/keys.hpp"
#include "io/case/printable.hpp"
#include "io/case/random_kind.hpp"
#include "io/case/render.hpp"
#include "io/files/files.hpp"
#include "batch/points.hpp"
#include "batch/study_inputs.hpp"
#include "batch/study_keys.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

constexpr Real most = 1e9;

/// Tables of a list [[name]]; a problem if it is another thing.
std::vector<std::pair<const Node*, std::string>> tables_of(const Node& root, const char* name, Findings& findings)
{
  std::vector<std::pair<const Node*, std::string>> tables;
  const Node* list = find_item(root, name);
  if (list == nullptr) return tables;
  if (list->kind != NodeKind::list) {
    findings.problems.push_back({name, fmt::format("write [[{}]], once for each", name),
        fmt::format("As in\n[[{}]]\nkey = \"material.clay.su_peak\"", name), ""});
    return tables;
  }
  for (std::size_t k = 0; k < list->items.size(); ++k)
    tables.emplace_back(&list->items[k], fmt::format("{}[{}]", name, k));
  return tables;
}

std::string text_of(const Node& table, const char* name)
{
  const Node* item = find_item(table, name);
  return item != nullptr && item->kind == NodeKind::text ? item->text : std::string();
}

/// Units follow from the key, so it must be one; its names are checked by the case.
void refuse_unknown_key(const std::string& key, const std::string& path, Findings& findings)
{
  if (key.empty() || !unit_at(key).empty()) return;
  const auto parts = split_path(key);
  Paths known;
  const auto take = [&](const KeyInfo& info) {
    auto names = split_path(info.path);
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const bool any = names[k] == "NAME" || names[k] == "SIDE" || names[k] == "[]";
      text += (k == 0 ? "" : ".") + (any && k < parts.size() ? parts[k] : names[k]);
    }
    known.push_back(text);
  };
  for (const KeyInfo& info : all_keys()) take(info);
  for (const MaterialType* law : all_materials())
    for (const KeyInfo& info : keys_of_law(*law)) take(info);
  if (std::ranges::find(known, fmt::format("{}", fmt::join(parts, "."))) != known.end()) {
    findings.problems.push_back({join_path(path, "key"), fmt::format("`{}` is not one number", key),
        "A number is drawn for one place of a list, as in `body[0].polygon[2][1]`. `terp explain` says what a key "
        "takes.",
        ""});
    return;
  }
  findings.problems.push_back({join_path(path, "key"), fmt::format("`{}` is no key of a case", key),
      did_you_mean(key, known) + "`terp explain` describes the keys.", ""});
}

/// A name that formulas can have: no function of theirs.
void refuse_name(const std::string& name, const std::string& path, Findings& findings)
{
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const auto is_of_word = [&](unsigned char c) { return is_letter(c) || std::isdigit(c) != 0 || c == '_'; };
  const bool is_word = !name.empty() && is_letter(static_cast<unsigned char>(name[0])) &&
                       std::ranges::all_of(name, is_of_word) && name != "h";
  const Paths taken = names_in_formulas();
  if (is_word && std::ranges::find(taken, name) == taken.end()) return;
  findings.problems.push_back({join_path(path, "name"), fmt::format("`{}` is no name for a number in formulas", name),
      "Letters, digits and _, a letter first, no function of formulas, and not h, the level of a load.", ""});
}

void read_numbers(const Node& root, StudySettings& s, Findings& findings)
{
  for (const auto& [table, path] : tables_of(root, "random", findings)) {
    RandomNumber number{.key = text_of(*table, "key"), .path = path};
    Paths others = distribution_keys();
    others.emplace_back("distribution");
    std::string name;
    number.is_name = find_item(*table, "name") != nullptr && find_item(*table, "key") == nullptr;
    read_section(*table, path,
        {{"key", "", any_number, !number.is_name, &number.key}, {"name", "", any_number, false, &name},
            {"unit", "", any_number, false, &number.unit}},
        others, findings);
    if (number.is_name) {
      number.key = name;
      refuse_name(name, path, findings);
    } else {
      refuse_unknown_key(number.key, path, findings);
      number.unit = unit_at(number.key);
    }
    if (table->kind == NodeKind::table && (number.is_name || !number.unit.empty()))
      number.distribution = read_distribution(*table, path, number.unit, findings);
    s.numbers.push_back(std::move(number));
  }
}

/// [follow] and [held]: keys of the case, whose values may have formulas of the names.
void read_key_values(const Node& root, const char* section, const StudySettings& s, KeyValues& keys, Findings& findings)
{
  const Node* table = find_item(root, section);
  if (table == nullptr) return;
  const auto fail = [&](const std::string& at, std::string what, std::string detail) {
    findings.problems.push_back({at, std::move(what), std::move(detail), ""});
  };
  if (table->kind != NodeKind::table)
    return fail(section, fmt::format("`{}` must be a table of keys and values", section),
        fmt::format("As in\n[{}]\n\"material.clay.su_peak\" = 8e3", section));
  for (const Node& item : table->items) {
    const std::string at = join_path(section, item.name);
    keys.emplace_back(item.name, item);
    try {
      for (const Real p : {0.001, 0.5, 0.999}) with_numbers(item, s.names(), s.named_values(s.quantiles(p)));
    } catch (const ExpressionError& error) {
      fail(at, "this is no formula of the numbers that have a name", error.what());
    }
  }
}

void read_follow(const Node& root, StudySettings& s, Findings& findings)
{
  if (!findings.problems.empty()) return;
  read_key_values(root, "follow", s, s.follow, findings);
  read_key_values(root, "held", s, s.held, findings);
  for (const auto& [key, value] : s.follow)
    if (!has_formula(value, s.names()))
      findings.problems.push_back({join_path("follow", key), fmt::format("`{}` follows no number", key),
          "Give a formula of a [[random]] with a `name`, as a text; or set the key in [set].", ""});
  for (const RandomNumber& number : s.numbers) {
    const auto follows = [&](const auto& item) { return has_formula(item.second, {number.key}); };
    if (number.is_name && std::ranges::none_of(s.follow, follows) && std::ranges::none_of(s.held, follows))
      findings.problems.push_back({join_path(number.path, "name"), fmt::format("no key follows `{}`", number.key),
          fmt::format("As in\n[follow]\n\"material.clay.su_peak\" = \"1000 * {}\"", number.key), ""});
  }
}

void read_fields(const Node& root, StudySettings& s, Findings& findings)
{
  for (const auto& [table, path] : tables_of(root, "field", findings)) {
    RandomFieldKey field{.path = path};
    Vec<2> low{}, high{};
    read_section(*table, path,
        {{"key", "", any_number, true, &field.key}, {"cov", "-", positive, true, &field.cov},
            {"theta", "m", positive, true, &field.scale}, {"box", "m", any_number, false, BoxCorners{&low, &high}},
            {"distribution", "", any_number, false, &field.distribution, random_distributions},
            {"correlation", "", any_number, false, &field.correlation, random_correlations}},
        {"mean", "known"}, findings);
    refuse_unknown_key(field.key, path, findings);
    if (table->kind != NodeKind::table) continue;
    if (find_item(*table, "box") != nullptr) field.box = {low, high};
    if (const Node* mean = find_item(*table, "mean")) field.mean = toml_value(*mean);
    if (const Node* known = find_item(*table, "known")) field.known = toml_value(*known);
    s.fields.push_back(std::move(field));
  }
}

void read_correlations(const Node& root, StudySettings& s, Findings& findings)
{
  for (const auto& [table, path] : tables_of(root, "correlation", findings)) {
    StudyCorrelation c{.path = path};
    std::vector<std::string> between_keys;
    read_section(*table, path,
        {{"between", "", any_number, true, NameList{&between_keys}},
            {"value", "-", {-1.0, 1.0, true, true}, true, &c.value}},
        {}, findings);
    if (between_keys.size() == 2)
      c.a = between_keys[0], c.b = between_keys[1];
    else if (find_item(*table, "between") != nullptr)
      findings.problems.push_back({join_path(path, "between"), "a correlation is between two keys",
          fmt::format("Got {}.", between_keys.size()), ""});
    s.correlations.push_back(std::move(c));
  }
}

void read_sweep(const Node& root, StudySettings& s, Findings& findings)
{
  for (const auto& [table, path] : tables_of(root, "sweep", findings)) {
    SweepKey sweep{.path = path};
    read_section(*table, path, {{"key", "", any_number, true, &sweep.key}}, {"values"}, findings);
    const Node* values = find_item(*table, "values");
    if (values == nullptr || values->kind != NodeKind::list || values->items.empty())
      findings.problems.push_back({values != nullptr ? join_path(path, "values") : path,
          "`values` must be a list of what the key takes in turn", "As in values = [10, 20, 40].", ""});
    else
      sweep.values = values->items;
    s.sweep.push_back(std::move(sweep));
  }
}

/// Changes of the case, KEY=VALUE: `set`, and `coarse` of [estimator]. path: of the table that has them.
void read_changes(
    const Node& table, const std::string& path, const char* name, std::vector<std::string>& changes, Findings& findings)
{
  const Node* set = find_item(table, name);
  if (set == nullptr) return;
  const std::string own = join_path(path, name);
  if (set->kind != NodeKind::table)
    return findings.problems.push_back({own, fmt::format("`{}` must be a table of keys and values", name),
        fmt::format("As in {} = {{ \"mesh.cell\" = 1.0 }}.", name), ""});
  for (const Node& item : set->items) {
    if (item.kind == NodeKind::table && find_key(item.name) == nullptr && item.name.find('.') == std::string::npos)
      findings.problems.push_back({join_path(own, item.name), "write the key in quotes",
          fmt::format("As in \"{}.KEY\" = VALUE.", item.name), "", true});
    changes.push_back(item.name + "=" + toml_value(item));
  }
}

void read_top(const Node& root, StudySettings& s, Findings& findings)
{
  read_section(root, "",
      {{"title", "", any_number, false, &s.title}, {"note", "", any_number, false, &s.note},
          {"case", "", any_number, true, &s.case_path}, {"seed", "-", {0.0, 2147483647.0}, false, &s.seed},
          {"confidence", "-", between(0.5, 0.9999), false, &s.confidence}},
      {"set", "random", "follow", "held", "field", "correlation", "sweep", "fragility", "estimator", "stop", "events"},
      findings);
  const auto section = [&](const char* name, const std::vector<StudyKey>& keys, const Paths& others = {}) {
    if (const Node* table = find_item(root, name)) read_section(*table, name, keys, others, findings);
  };
  section("estimator", keys_of_estimators(s), {"coarse"});
  section(
      "stop", {{"number", "-", {1.0, most}, false, &s.stop.number},
                  {"cov", "-", between(1e-3, 1.0), false, &s.stop.cov}, {"time", "s", positive, false, &s.stop.time}});
  section("events",
      {{"volume", "m^2", positive, false, &s.event.volume},
          {"displacement", "m", positive, false, &s.event.displacement}},
      {"ends_run"});
  if (find_node(root, "events.ends_run") != nullptr)
    findings.problems.push_back({"events.ends_run", "a realisation no longer ends with its events",
        "Remove the key. With until = \"verdict\" in the case a run ends as soon as the answer to [flood] is known, "
        "and "
        "what remains of the ground is known, too.",
        "time.until"});
}

/// Each key is drawn once, and correlations are between what is drawn, of one sort.
void check_keys(const StudySettings& s, Findings& findings)
{
  Paths numbers, fields, all;
  const auto take = [&](const std::string& key, const std::string& path, Paths* list) {
    if (key.empty()) return;
    if (s.estimator != Estimator::sweep && (key == "title" || key.starts_with("output.")))
      findings.problems.push_back({join_path(path, "key"), fmt::format("no result depends on `{}`", key),
          "It says what a run writes. Draw keys of the soil, the water or the loads; set this one in `set`.", ""});
    if (std::ranges::find(all, key) != all.end())
      findings.problems.push_back({join_path(path, "key"), fmt::format("`{}` is given twice", key), "", ""});
    all.push_back(key);
    if (list != nullptr) list->push_back(key);
  };
  for (const RandomNumber& number : s.numbers) take(number.key, number.path, &numbers);
  for (const auto& [key, value] : s.follow) take(key, join_path("follow", key), nullptr);
  for (const RandomFieldKey& field : s.fields) take(field.key, field.path, &fields);
  for (const SweepKey& sweep : s.sweep) take(sweep.key, sweep.path, nullptr);
  if (s.fragility)
    for (const auto& [key, value] : s.fragility->set) take(key, join_path("fragility.set", key), nullptr);
  const auto is_in = [](const Paths& list, const std::string& key) {
    return std::ranges::find(list, key) != list.end();
  };
  for (const StudyCorrelation& c : s.correlations) {
    const std::string at = join_path(c.path, "between");
    bool known = !c.a.empty();
    for (const std::string& key : {c.a, c.b}) {
      if (key.empty() || is_in(numbers, key) || is_in(fields, key)) continue;
      known = false;
      const std::string nearest = closest(key, all);
      findings.problems.push_back({at, fmt::format("`{}` is not random in this study", key),
          nearest.empty() ? "Name keys of [[random]] or [[field]]." : fmt::format("Did you mean `{}`?", nearest), ""});
    }
    for (const StudyCorrelation& other : s.correlations) {
      if (&other == &c) break;
      if (known && ((other.a == c.a && other.b == c.b) || (other.a == c.b && other.b == c.a)))
        findings.problems.push_back({at, fmt::format("`{}` and `{}` are correlated twice", c.a, c.b),
            fmt::format("{:g} and {:g}. Leave one of the two out.", other.value, c.value), ""});
    }
    if (known && c.a == c.b)
      findings.problems.push_back({at, "a correlation is between two keys", "Both are the same.", ""});
    if (known && is_in(numbers, c.a) != is_in(numbers, c.b))
      findings.problems.push_back(
          {at, "a number and a field cannot be correlated", "Correlate two of [[random]], or two of [[field]].", ""});
  }
}

void check_field_pairs(const StudySettings& s, Findings& findings)
{
  const auto field_of = [&](const std::string& key) { return std::ranges::find(s.fields, key, &RandomFieldKey::key); };
  for (const StudyCorrelation& c : s.correlations) {
    const auto a = field_of(c.a), b = field_of(c.b);
    if (a == s.fields.end() || b == s.fields.end()) continue;
    if (a->scale != b->scale)
      findings.problems.push_back({join_path(c.path, "between"), "correlated fields have the same `theta`",
          fmt::format("Got [{:g}, {:g}] and [{:g}, {:g}] m.", a->scale[0], a->scale[1], b->scale[0], b->scale[1]), ""});
    if (a->correlation != b->correlation)
      findings.problems.push_back({join_path(c.path, "between"), "correlated fields have the same `correlation`",
          fmt::format("Got \"{}\" and \"{}\".", a->correlation, b->correlation), ""});
    if (!a->known.empty() || !b->known.empty())
      findings.problems.push_back({join_path(c.path, "between"), "fields with `known` values cannot be correlated",
          "Leave out the correlation or the known values.", ""});
  }
}

void check_stop(const StudySettings& s, Findings& findings)
{
  const auto fail = [&](const std::string& at, std::string what, std::string detail) {
    findings.problems.push_back({at, std::move(what), std::move(detail), ""});
  };
  check_estimator(s, findings.problems);
  if (s.estimator == Estimator::sweep) {
    if (s.stop.number > 0 || s.stop.cov > 0.0)
      fail("stop", "a sweep ends with its last combination", "Leave [stop] out, or give `time` alone.");
    if (s.sweep.empty()) fail("estimator", "a sweep needs [[sweep]] with keys and values", "");
    if (!s.numbers.empty() || !s.fields.empty())
      fail("estimator", "a sweep draws nothing", "Leave [[random]] and [[field]] out, or choose monte_carlo.");
    for (const SweepKey& sweep : s.sweep)
      if (s.form == SweepForm::table && sweep.values.size() != s.sweep.front().values.size())
        fail(join_path(sweep.path, "values"), "columns of a table have the same length",
            fmt::format(
                "Got {}, and {} of `{}`.", sweep.values.size(), s.sweep.front().values.size(), s.sweep.front().key));
    return;
  }
  if (!s.sweep.empty()) fail("sweep", "[[sweep]] is of `kind = \"sweep\"`", "Give [estimator] that kind.");
  if (s.numbers.empty() && s.fields.empty())
    fail("", "nothing is random in this study", "Give [[random]] or [[field]]; for a table of keys, [[sweep]].");
  if (s.stop.number == 0)
    return fail("stop", "the stop rule cannot be met: `number` is missing",
        "Give the most realisations that may be made: a rare event may never reach `cov`.");
  if (const EstimatorInfo& info = info_of(s.estimator); !info.takes_cov && s.stop.cov > 0.0)
    fail("stop.cov", fmt::format("`{}` ends with its `number` of realisations", info.name),
        "Leave `cov` out, or choose monte_carlo.");
  if (s.estimator == Estimator::sobol && s.numbers.size() > most_sobol_numbers())
    fail("estimator.kind", fmt::format("Sobol points are known for {} random numbers", most_sobol_numbers()),
        fmt::format("Got {}. Choose monte_carlo or latin_hypercube.", s.numbers.size()));
  if (s.fragility && s.stop.cov > 0.0)
    return fail("stop.cov", "a fragility curve has the same number of realisations at each level",
        "Leave `cov` out; `number` is that of one level.");
  const Real events = static_cast<Real>(s.stop.events()), least = events / static_cast<Real>(s.stop.number);
  if (s.stop.cov > 0.0 && s.estimator == Estimator::monte_carlo && least > 0.5)
    fail("stop.cov", "the stop rule cannot be met by so few realisations",
        fmt::format("A coefficient of variation of {:g} takes {:g} events, which {} realisations {}.\nGive a larger "
                    "number: {:g} have them of P = 0.1.",
            s.stop.cov, events, s.stop.number,
            least < 1.0 ? fmt::format("have only where P is above {:.2g}", least) : "cannot have", 10.0 * events));
}

Document parse_study(const std::string& text, const std::string& path)
{
  try {
    return {path, text, parse_toml(text)};
  } catch (const SyntaxError& error) {
    throw CaseError(render_at(path, text, error.place, {"", "this is not valid TOML", error.what(), ""}) +
                    "\n1 error; nothing was run.\n");
  }
}

}  // namespace

void refuse_if_any(const std::vector<Problem>& problems, const StudySettings& settings)
{
  if (!problems.empty()) throw CaseError(render_errors(problems, settings.source));
}

StudySettings read_study_text(const std::string& text, const std::string& path)
{
  StudySettings s;
  s.source = parse_study(text, path);
  const fs::path file(path);
  s.name = file.stem().string();
  if (s.name == "study") s.name = fs::absolute(file).lexically_normal().parent_path().filename().string();
  s.folder = file.has_parent_path() ? file.parent_path().string() : ".";
  Findings findings;
  const Node& root = s.source.root;
  read_top(root, s, findings);
  read_changes(root, "", "set", s.set, findings);
  if (const Node* estimator = find_item(root, "estimator"))
    read_changes(*estimator, "estimator", "coarse", s.multilevel.coarse, findings);
  read_numbers(root, s, findings);
  read_follow(root, s, findings);
  read_fields(root, s, findings);
  read_correlations(root, s, findings);
  read_sweep(root, s, findings);
  s.fragility = read_fragility(root, findings);
  check_keys(s, findings);
  check_field_pairs(s, findings);
  if (findings.problems.empty()) check_stop(s, findings);
  refuse_if_any(findings.problems, s);
  s.warnings = findings.warnings;
  return s;
}

StudySettings read_study(const std::string& path)
{
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored))
    throw CaseError(
        printable(fmt::format("error: {}: there is no such file\n  Give the TOML file of a study.\n", path)));
  return read_study_text(read_file(path), path);
}

std::vector<std::string> StudySettings::names() const
{
  std::vector<std::string> list;
  for (const RandomNumber& number : numbers)
    if (number.is_name) list.push_back(number.key);
  return list;
}

std::vector<Real> StudySettings::named_values(const std::vector<Real>& values) const
{
  std::vector<Real> list;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (numbers[k].is_name) list.push_back(values[k]);
  return list;
}

std::vector<std::string> StudySettings::changes_at(const std::vector<Real>& values) const
{
  std::vector<std::string> changes;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (!numbers[k].is_name) changes.push_back(fmt::format("{}={:.12g}", numbers[k].key, values[k]));
  for (std::string& change : changes_with_numbers(follow, names(), named_values(values)))
    changes.push_back(std::move(change));
  return changes;
}

std::vector<std::string> StudySettings::held_changes_at(const std::vector<Real>& values) const
{
  return changes_with_numbers(held, names(), named_values(values));
}

std::vector<Real> StudySettings::quantiles(Real p) const
{
  std::vector<Real> list;
  for (const RandomNumber& number : numbers) list.push_back(number.distribution.quantile(p));
  return list;
}

bool SweepKey::is_of_numbers() const
{
  return std::ranges::all_of(
      values, [](const Node& value) { return value.kind == NodeKind::number || value.kind == NodeKind::integer; });
}

std::int64_t StopRule::events() const
{
  constexpr std::int64_t fewest = 10;  // before a coefficient of variation is believed
  constexpr Real rounding = 1e-9;
  return cov > 0.0 ? std::max(fewest, static_cast<std::int64_t>(std::ceil(1.0 / (cov * cov) - rounding))) : 0;
}

std::string identity_text(const StudySettings& settings)
{
  Node root = settings.source.root;
  std::erase_if(root.items, [&](const Node& item) {
    const bool keeps_number = settings.estimator == Estimator::latin_hypercube || info_of(settings.estimator).adaptive;
    return item.name == "title" || item.name == "note" || item.name == "confidence" || item.name == "case" ||
           (item.name == "stop" && !keeps_number);
  });
  name_digits_of_files(root, folder_of(path_of(settings.folder, settings.case_path)));
  if (Node* load = find_item(root, "fragility")) drop_distribution(*load);
  for (Node& item : root.items)
    if (item.name == "stop") std::erase_if(item.items, [](const Node& key) { return key.name != "number"; });
  return write_toml(root);
}

}  // namespace terp
