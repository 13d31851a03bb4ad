// A situation takes what it leaves out from the water at the start. So each one is checked only for the lines that its
// own table gives. Otherwise a fault of the start would be reported with every situation. Whether a key was given is
// seen in the tree, not in the values. Drainage and the parts of a soil are checked in a case without [water], too.

#include "math/closest.hpp"
#include "io/case/check_case.hpp"
#include "io/case/key_text.hpp"
#include "model/water/water_pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

/// Where two reference lines cross [m]; none if one lies above the other at every x. Both are straight between the
/// places of either.
std::optional<Real> crossing_of(const ReferenceLine& a, const ReferenceLine& b)
{
  std::vector<Real> places;
  for (const ReferenceLine* line : {&a, &b})
    for (const Vec<2>& x : line->places) places.push_back(x[0]);
  std::ranges::sort(places);
  Real x_before = 0.0, before = 0.0;  // the last place where they are apart
  for (const Real x : places) {
    const Real above = elevation_at(a.places, x) - elevation_at(b.places, x);
    if (above * before < 0.0) return x_before + (x - x_before) * before / (before - above);
    if (above != 0.0) x_before = x, before = above;
  }
  return std::nullopt;
}

/// given: the list of reference lines, and the table of head lines, that the situation has itself. It takes others from
/// the start, where they are checked.
void check_heads(const WaterSituation& situation, const std::string& path, const Node* given, Findings& findings)
{
  const bool own_lines = given != nullptr && find_item(*given, "reference_lines") != nullptr;
  const Node* own_heads = given != nullptr ? find_item(*given, "head_lines") : nullptr;
  std::vector<std::string> names{std::string(phreatic_head)};
  for (const HeadLine& line : situation.head_lines) names.push_back(line.name);
  const auto is_unknown_key = [&](const Problem& problem) {  // it may be the table of heads, misspelt
    return problem.key.starts_with(path + '.') && problem.what.starts_with("unknown key");
  };
  if (std::ranges::any_of(findings.problems, is_unknown_key)) return;
  const auto& lines = situation.reference_lines;
  for (std::size_t k = 0; own_lines && k < lines.size(); ++k) {
    const std::string here = fmt::format("{}.reference_lines[{}]", path, k);
    for (const std::string& head : {lines[k].head, lines[k].head_bottom}) {
      if (head.empty() || std::ranges::find(names, head) != names.end()) continue;
      findings.problems.push_back({here, fmt::format("there is no head line `{}`", head),
          did_you_mean(head, names) + fmt::format("Head lines of this water: {}", plain_list(names)),
          "water.reference_lines", false, {path + ".reference_lines"}});
      break;
    }
    for (std::size_t other = 0; other < k; ++other)
      if (const auto x = crossing_of(lines[k], lines[other]))
        findings.problems.push_back({here, fmt::format("the reference lines {} and {} cross", other, k),
            fmt::format("One is above the other on one side of x = {:.4g} m, below it on the other. Give each layer "
                        "its own line from one end to the other.",
                *x),
            "water.reference_lines", false, {path + ".reference_lines"}});
  }
  for (const HeadLine& line : situation.head_lines)
    if (own_heads != nullptr && find_item(*own_heads, line.name) != nullptr &&
        std::ranges::none_of(
            lines, [&](const ReferenceLine& r) { return r.head == line.name || r.head_bottom == line.name; }))
      findings.warnings.push_back({join_path(path + ".head_lines", line.name),
          fmt::format("no reference line uses the head line `{}`", line.name),
          fmt::format("Give reference_lines = [{{ line = [[x, y], ...], head = \"{}\" }}].", line.name),
          "water.reference_lines", true, {path + ".head_lines", "water"}});
}

void check_situation(const WaterSituation& situation, const Node* table, const std::string& path, Findings& findings)
{
  const auto has = [&](const char* key) { return table != nullptr && find_item(*table, key) != nullptr; };
  for (const char* all : {"pressure", "head"})
    for (const char* key : {"phreatic_line", "head_lines", "reference_lines", "head"})
      if (has(all) && has(key) && std::string_view(key) != all)
        findings.problems.push_back({path + '.' + key, fmt::format("`{}` does not go with `{}`", key, all),
            fmt::format("`{}` says what the water is everywhere. Remove one of the two.", all), "water.pressure",
            true});
  check_heads(situation, path, table, findings);
}

void check_times(const WaterCase& water, Findings& findings)
{
  const auto& list = water.situations;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string path = fmt::format("water.situation[{}]", k);
    if (std::isnan(list[k].time) && list[k].name.empty())
      findings.problems.push_back({path, "a water situation needs a `time` or a `name`",
          "Give time = T, in s, at which this water is reached; or a name by which something else asks for it.",
          "water.situation", true});
    if (list[k].name == name_of_start)
      findings.problems.push_back({path + ".name", "`start` is the name of the water of [water]",
          "Stages and strengths ask for that of t = 0 by it. Give this situation another name.", "water.situation"});
    for (std::size_t other = 0; other < k; ++other) {
      if (list[k].time == list[other].time)
        findings.problems.push_back({path + ".time", "two water situations have the same `time`",
            fmt::format(
                "Both hold at {} s. The pressure runs linearly from one to the next: give each its own.", list[k].time),
            "water.situation"});
      if (!list[k].name.empty() && list[k].name == list[other].name)
        findings.problems.push_back(
            {path + ".name", fmt::format("two water situations have the name `{}`", list[k].name), "Give each its own.",
                "water.situation"});
    }
  }
}

bool same_water(const WaterSituation& a, const WaterSituation& b)
{
  const auto same_head = [](const HeadLine& one, const HeadLine& other) {
    return one.name == other.name && one.places == other.places;
  };
  const auto same_reference = [](const ReferenceLine& one, const ReferenceLine& other) {
    return one.head == other.head && one.head_bottom == other.head_bottom && one.places == other.places;
  };
  return a.phreatic_line == b.phreatic_line && a.formula_text == b.formula_text && a.grid_file == b.grid_file &&
         a.seepage == b.seepage && std::ranges::equal(a.head_lines, b.head_lines, same_head) &&
         std::ranges::equal(a.reference_lines, b.reference_lines, same_reference);
}

/// Other water that is the water that was there: a situation without lines of its own, or a copy of them. A situation
/// with a time may hold the water until then.
void check_same_water(const Node* list, const Case& values, Problems& warnings)
{
  const WaterCase& water = values.water;
  const auto& others = water.situations;
  const bool none_differs =
      std::ranges::all_of(others, [&](const WaterSituation& s) { return same_water(s, water.start); });
  const auto warn = [&](const std::string& path, const std::string& what) {
    warnings.push_back({path, what,
        "What a situation leaves out is that of the start. Give its own, as phreatic_line = [[x, y], ...] in m.",
        "water.situation", true, {"stage"}});
  };
  const auto gives_lines = [&](std::size_t k) {
    return list != nullptr && std::ranges::any_of(list->items[k].items,
                                  [](const Node& item) { return item.name != "name" && item.name != "time"; });
  };
  for (std::size_t k = 0; k < others.size(); ++k)
    if (!gives_lines(k) && (std::isnan(others[k].time) || none_differs))
      warn(fmt::format("water.situation[{}]", k),
          fmt::format("the water{} is that of the start: it has no line",
              others[k].name.empty() ? "" : fmt::format(" `{}`", others[k].name)));
  std::string before(name_of_start);
  for (std::size_t k = 0; k < values.stages.size(); ++k) {
    const std::string& now = values.stages[k].water;
    if (now.empty() || now == before) continue;
    const std::size_t number = situation_number(water, now);
    if (same_water(situation_of(water, number), situation_of(water, situation_number(water, before))) &&
        (number == 0 || gives_lines(number - 1)))
      warn(fmt::format("stage[{}].water", k),
          fmt::format("the water `{}` has the lines of `{}`, which is there already", now, before));
    before = now;
  }
}

bool is_hydrostatic(const WaterCase& water)
{
  const auto is = [](const WaterSituation& s) { return !s.formula || s.formula_gives_head; };
  return is(water.start) || std::ranges::any_of(water.situations, is);
}

void check_parts(const Case& values, Findings& findings)
{
  for (const MaterialCase& material : values.materials) {
    if (material.zone == Zone::below && values.water.start.phreatic_line.empty() &&
        values.water.kind == WaterKind::lines)
      findings.problems.push_back(
          {join_path("material", material.soil), "soil below and above the phreatic line needs that line",
              "Give [water] with phreatic_line = [[x, y], ...], or one density and one model.", "water", true});
    const auto is_above = [&](const MaterialCase& other) {
      return other.zone == Zone::above && other.soil == material.soil;
    };
    if (const auto above = std::ranges::find_if(values.materials, is_above);
        material.zone == Zone::below && above != values.materials.end() && material.density < above->density)
      findings.warnings.push_back({join_path("material", material.soil),
          fmt::format("`{}` is lighter below the water than above", material.soil),
          fmt::format("Got {:.4g} kg/m^3 below and {:.4g} kg/m^3 above. Both are with the water in the pores, which "
                      "fills them below\nthe line: swap the two, or give the saturated density below.",
              material.density, above->density),
          "material.density", false, {"water"}});
    if (material.zone != Zone::all)
      for (const MaterialCase& other : values.materials)
        if (other.zone == Zone::all && other.name == material.name)
          findings.problems.push_back({join_path("material", other.name),
              fmt::format("the material `{}` has the name of a part of `{}`", other.name, material.soil),
              "The parts are called NAME below and NAME above. Give this one another name.", "material", true});
  }
}

/// A series of levels beside what it replaces, and levels that are no river.
void check_series(const Node& table, const Case& values, Findings& findings)
{
  const auto& series = values.water.series;
  if (!series) return;
  for (const char* key : {"phreatic_line", "pressure", "head", "river"})
    if (find_item(table, key) != nullptr)
      findings.problems.push_back({std::string("water.") + key, fmt::format("`{}` does not go with `level`", key),
          "The series of levels says where the water stands at each time. Remove one of the two; the line of a level "
          "is\nphreatic_line in the table of `level`.",
          "water.level", true, {"water.level"}});
  const Real run = (series->times.back() - series->times.front()) / series->shorten;
  if (values.stages.empty() && values.time.end < 0.99 * run)
    findings.warnings.push_back({"water.level", "the run ends before the series of levels does",
        fmt::format("The series takes {:.4g} s of the run, which ends at {:g} s. Give time.end = {:.4g}, or shorten = "
                    "{:.4g}.",
            run, values.time.end, run, series->shorten * run / values.time.end),
        "water.level", false, {"time"}});
}

/// Keys of the other kind of water in a table of [water].
void check_kind(const Node& table, const std::string& path, WaterKind kind, Problems& problems)
{
  const bool computed = kind == WaterKind::seepage;
  const auto keys = computed
                        ? std::vector<const char*>{"phreatic_line", "head_lines", "reference_lines", "pressure", "head"}
                        : std::vector<const char*>{"river", "ponds", "boundary", "suction_band", "walls"};
  for (const char* key : keys)
    if (find_item(table, key) != nullptr)
      problems.push_back({path + '.' + key,
          computed ? fmt::format("`{}` does not go with computed water", key)
                   : fmt::format("`{}` is for computed water", key),
          computed
              ? "With model = \"seepage\" the water follows from permeabilities, river, ponds and boundary. Remove "
                "one of the two."
              : "Give model = \"seepage\" in [water], and a permeability to each soil.",
          "water.model", true, {"water.model"}});
}

/// Two conditions at one place, and levels that nothing follows from.
void check_computed(const WaterSituation& situation, const std::string& path, Findings& findings)
{
  const SeepageCase& of = situation.seepage;
  if (!of.river && of.ponds.empty() && of.boundary.empty())
    findings.warnings.push_back({path, "no water enters the soil",
        "There is no river, no pond and no head at a side, so all soil is dry. Give river = { side = \"left\", level = "
        "4.5 }.",
        "water.river", true, {"water"}});
  for (std::size_t a = 0; a < of.ponds.size(); ++a)
    for (std::size_t b = a + 1; b < of.ponds.size(); ++b)
      if (of.ponds[a].from < of.ponds[b].to && of.ponds[b].from < of.ponds[a].to)
        findings.problems.push_back({fmt::format("{}.ponds[{}]", path, b), "two ponds lie at one place",
            fmt::format("From {:g} to {:g} m and from {:g} to {:g} m. Give each its own stretch.", of.ponds[a].from,
                of.ponds[a].to, of.ponds[b].from, of.ponds[b].to),
            "water.ponds"});
  std::vector<std::string> names{"seepage faces"};
  if (of.river) names.emplace_back("river");
  const auto check_name = [&](const std::string& name, const char* list, std::size_t k) {
    if (!name.empty() && std::ranges::find(names, name) != names.end())
      findings.problems.push_back({fmt::format("{}.{}[{}]", path, list, k), fmt::format("the name `{}` is taken", name),
          "Flows are printed and levels given by these names. Give each its own.", std::string("water.") + list});
    names.push_back(name);
  };
  for (std::size_t k = 0; k < of.ponds.size(); ++k) check_name(of.ponds[k].name, "ponds", k);
  for (std::size_t k = 0; k < of.boundary.size(); ++k) check_name(of.boundary[k].name, "boundary", k);
  for (std::size_t a = 0; a < of.boundary.size(); ++a)
    for (std::size_t b = a + 1; b < of.boundary.size(); ++b) {
      const SideHead &one = of.boundary[a], &other = of.boundary[b];
      if (one.side == other.side && one.from < other.to && other.from < one.to)
        findings.problems.push_back({fmt::format("{}.boundary[{}]", path, b), "two heads are given at one place",
            "Give each part of a side its own from and to, in m.", "water.boundary"});
    }
}

void check_soils_of_flow(const Case& values, Findings& findings)
{
  Real least = std::numeric_limits<Real>::infinity(), most = 0.0;
  std::string least_of, most_of;
  for (const MaterialCase& material : values.materials) {
    const Permeability& k = material.permeability;
    if (!k.is_given()) continue;
    const std::string path = material_path(material) + ".permeability";
    if (k.vertical > k.horizontal || k.vertical < 1e-3 * k.horizontal)
      findings.warnings.push_back({path, "the vertical permeability is unusual",
          fmt::format("It is {:.3g} of the horizontal one; layers give 0.01 to 1.", k.vertical / k.horizontal),
          "material.permeability"});
    if (std::min(k.horizontal, k.vertical) < least)
      least = std::min(k.horizontal, k.vertical), least_of = material.name;
    if (std::max(k.horizontal, k.vertical) > most) most = std::max(k.horizontal, k.vertical), most_of = material.name;
  }
  if (most > 1e9 * least)
    findings.warnings.push_back({"water.model", "permeabilities differ by more than a thousand million",
        fmt::format(
            "`{}` has {:.3g} m/s and `{}` {:.3g} m/s. Small heads are large flows then; the balance of the flow "
            "is less exact.",
            most_of, most, least_of, least),
        "material.permeability", false, {"material." + most_of, "material." + least_of}});
}

}  // namespace

void check_water(const Node& root, const Case& values, Findings& findings)
{
  check_drainage(root, values, findings);
  check_parts(values, findings);
  const Node* table = find_item(root, "water");
  if (table == nullptr || table->kind != NodeKind::table) return;
  const WaterCase& water = values.water;
  const bool read =
      std::ranges::none_of(findings.problems, [](const Problem& problem) { return problem.key.starts_with("water"); });
  if (!water.is_given() && read)
    findings.problems.push_back({"water", "[water] has no `phreatic_line`",
        "Give phreatic_line = [[x, y], ...] in m, or pressure = \"a formula of x, y and t\" in Pa.", "water", true});
  const Node* list = find_item(*table, "situation");
  check_kind(*table, "water", water.kind, findings.problems);
  check_series(*table, values, findings);
  for (std::size_t k = 0; list != nullptr && k < list->items.size(); ++k)
    check_kind(list->items[k], fmt::format("water.situation[{}]", k), water.kind, findings.problems);
  if (!water.is_given()) return;
  if (water.kind == WaterKind::seepage) {
    check_computed(water.start, "water", findings);
    for (std::size_t k = 0; k < water.situations.size(); ++k)
      if (!(water.situations[k].seepage == water.start.seepage))
        check_computed(water.situations[k], fmt::format("water.situation[{}]", k), findings);
    check_soils_of_flow(values, findings);
  }
  check_situation(water.start, table, "water", findings);
  for (std::size_t k = 0; k < water.situations.size(); ++k)
    check_situation(water.situations[k], list != nullptr ? &list->items[k] : nullptr,
        fmt::format("water.situation[{}]", k), findings);
  check_times(water, findings);
  check_same_water(list, values, findings.warnings);
  const Vec<2> g = values.forces.gravity;
  if (g[0] != 0.0 && is_hydrostatic(water))
    findings.problems.push_back({"water.phreatic_line", "the lines of water need gravity along y",
        fmt::format("Gravity is [{}, {}] m/s^2, and the pressure grows downwards in y. Turn the section instead of "
                    "gravity,\nor give pressure = \"a formula of x, y and t\".",
            g[0], g[1]),
        "water", false, {"water", "forces.gravity"}});
}

}  // namespace terp
