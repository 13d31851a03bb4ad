// The summary of a run that goes on may be older than its ledger. Measures of the end are then not defined
// (summary_is_behind). compare_words.cpp finds rows by their labels here: a label that changes must change there too.

#include "io/results/measures.hpp"

#include "model/ground/section.hpp"
#include "run/measure/followers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace terp {
namespace {

using Run = const RunResults&;
using Value = std::optional<Real>;
using Measures = std::vector<RunMeasure>;

constexpr Real round_off_of_strength = 1e-9;  // of a strength, relative [-]
constexpr Real small_share = 0.1;             // of soil: 1 in 1000 points [%]
constexpr Real small_part_of_work = 1e-3;     // of the work of gravity, as an energy [-]

Value finite(Real value) { return std::isfinite(value) ? Value(value) : std::nullopt; }

Value times(Real factor, Value value) { return value ? Value(factor * *value) : std::nullopt; }

const std::vector<Real>* column(Run run, std::string_view name)
{
  const auto* values = run.ledger.find(name);
  return values != nullptr && !values->empty() ? values : nullptr;
}
Value first_in(Run run, std::string_view name)
{
  const auto* values = column(run, name);
  return values != nullptr ? finite(values->front()) : std::nullopt;
}
Value last_in(Run run, std::string_view name)
{
  const auto* values = column(run, name);
  return values != nullptr ? finite(values->back()) : std::nullopt;
}
Value largest_in(Run run, std::string_view name)
{
  const auto* values = column(run, name);
  return values != nullptr ? finite(*std::ranges::max_element(*values)) : std::nullopt;
}

/// Mean time between two rows of the ledger, which stand at the steps nearest to their times [s].
Real row_interval(Run run, Real)
{
  const auto* time = column(run, "time");
  if (time == nullptr || time->size() < 2) return 0.0;
  return (time->back() - time->front()) / static_cast<Real>(time->size() - 1) + run.summary.values.dt;
}
Real one_cell(Run, Real cell) { return cell; }
/// Where soil ends is seen by its outermost point: with 2 by 2 points in a cell it stands a quarter of a cell before.
Real quarter_of_a_cell(Run, Real cell) { return 0.25 * cell; }
Real little_share(Run, Real) { return small_share; }
Real little_work(Run run, Real)
{
  return small_part_of_work * 1e-3 * std::abs(last_in(run, "gravity_work").value_or(0.0));
}

RunMeasure of_summary(std::string_view name, int digits, Real factor = 1.0, std::string unit = {})
{
  const SummaryQuantity& quantity = *find_summary_quantity(name);
  return {.label = std::string(quantity.info.label),
      .unit = unit.empty() ? std::string(quantity.info.unit) : std::move(unit),
      .digits = digits,
      .value = [&quantity, factor](Run run) {
        return summary_is_behind(run) ? std::nullopt : times(factor, quantity.number(run.summary.values));
      }};
}

/// The same, followed from mesh to mesh.
RunMeasure followed(RunMeasure measure, std::string name, MeasureKind kind = MeasureKind::amount)
{
  measure.name = std::move(name);
  measure.kind = kind;
  return measure;
}

/// How far a coordinate of the slope that the summary names has come since the first row of the ledger.
Value distance_of(Run run, Value at_end, const char* to_the_right, const char* to_the_left)
{
  if (!run.summary.values.facing || !at_end) return std::nullopt;
  const Value start = first_in(run, *run.summary.values.facing == Facing::right ? to_the_right : to_the_left);
  return start ? Value(std::abs(*at_end - *start)) : std::nullopt;
}

/// How far the highest ground has come down since t = 0 [m].
Value fall_of_ground(Run run)
{
  const Value first = first_in(run, "residual_height"), last = run.summary.values.residual_height;
  return first && last ? Value(std::abs(*last - *first)) : std::nullopt;
}

void add_places(Measures& all)
{
  const auto add = [&](const char* name, auto distance, auto resolution, bool in_steps = false) {
    RunMeasure place = followed(of_summary(name, 2), name, MeasureKind::place);
    place.distance = distance, place.resolution = resolution, place.in_steps = in_steps;
    all.push_back(std::move(place));
  };
  add(
      "front_x", [](Run run) { return finite(run.summary.values.run_out); }, quarter_of_a_cell);
  all.push_back(of_summary("run_out", 2));
  const auto crest = [](Run run) { return distance_of(run, run.summary.values.crest_x, "crest_x", "crest_left_x"); };
  add("crest_x", crest, one_cell, true);  // the edge of a column, which has the width of a cell
  const auto height = [](Run run) { return distance_of(run, run.summary.values.crest_y, "crest_y", "crest_left_y"); };
  add("crest_y", height, quarter_of_a_cell);
  add("residual_height", fall_of_ground, quarter_of_a_cell);
}

/// The slides that the summary tells of: none while it is behind.
std::vector<SlideSummary> slides_in(Run run)
{
  return summary_is_behind(run) ? std::vector<SlideSummary>{} : run.summary.values.slides;
}

std::string ordinal(std::size_t k)
{
  constexpr const char* words[] = {"first", "second", "third", "fourth", "fifth"};
  return k < std::size(words) ? words[k] : fmt::format("{}th", k + 1);
}

void add_slides(Measures& all, const std::vector<RunResults>& runs)
{
  std::size_t most = 2;
  for (Run run : runs) most = std::max(most, slides_in(run).size());
  const auto add = [&](std::size_t k, const char* what, auto time_of) {
    all.push_back({.name = fmt::format("slide_{}_{}", k + 1, what),
        .label = fmt::format("{} slide {}", ordinal(k), what),
        .unit = "s",
        .kind = MeasureKind::time,
        .value =
            [=](Run run) {
              const auto slides = slides_in(run);
              return k < slides.size() ? time_of(slides[k].slide) : std::nullopt;
            },
        .resolution = row_interval,
        .in_steps = true});
  };
  for (std::size_t k = 0; k < most; ++k) {
    add(k, "begins", [](const Slide& slide) { return Value(slide.begins); });
    add(k, "stops", [](const Slide& slide) { return slide.stops; });
  }
  all.push_back(
      {.name = "slides", .label = "slides", .unit = "-", .digits = 0, .kind = MeasureKind::count, .value = [](Run run) {
         return summary_is_behind(run) ? std::nullopt : Value(static_cast<Real>(slides_in(run).size()));
       }});
  all.push_back({.name = "facing",
      .label = "side to which the slope slides",
      .unit = "-",
      .kind = MeasureKind::word,
      .value = [](Run run) -> Value {
        const auto facing = run.summary.values.facing;
        return facing ? Value(*facing == Facing::left ? 0.0 : 1.0) : std::nullopt;
      },
      .words = {"left", "right"}});
}

void add_volumes(Measures& all)
{
  all.push_back(followed(of_summary("moved_volume", 2), "moved_volume"));
  all.push_back(of_summary("moved_fraction", 1, 100.0, "%"));
  RunMeasure intact = followed(of_summary("intact_fraction", 1, 100.0, "%"), "intact_fraction");
  intact.resolution = little_share;
  all.push_back(std::move(intact));
  all.push_back(of_summary("max_eps_eq_p", 2));
}

/// Share of the volume that has lost more than half of what softening takes, at a time [%].
Value softened_at(Run run, Real time)
{
  for (const auto& [t, fraction] : run.summary.values.softened_fraction)
    if (std::abs(t - time) <= same_time) return 100.0 * fraction;
  return std::nullopt;
}

/// The stage in which a time of the verdict lies, as a word; none: the run has no stages, or there is no such time.
void add_stage_of(Measures& all, const std::vector<RunResults>& runs, const char* name, const char* label,
    std::string FloodSummary::*of)
{
  std::vector<std::string> words;
  const auto stage_in = [of](Run run) {
    const auto& flood = run.summary.values.flood;
    return flood && !summary_is_behind(run) ? (*flood).*of : std::string();
  };
  for (Run run : runs)
    if (const std::string stage = stage_in(run); !stage.empty() && std::ranges::find(words, stage) == words.end())
      words.push_back(stage);
  if (words.empty()) return;
  all.push_back({.name = name,
      .label = label,
      .unit = "-",
      .kind = MeasureKind::word,
      .value = [=](Run run) -> Value {
        const auto found = std::ranges::find(words, stage_in(run));
        return found == words.end() ? std::nullopt : Value(static_cast<Real>(found - words.begin()));
      },
      .words = words});
}

void add_flood(Measures& all, const std::vector<RunResults>& runs)
{
  if (std::ranges::none_of(runs, [](Run run) { return run.summary.values.flood.has_value(); })) return;
  const auto add = [&](RunMeasure measure, auto of) {
    measure.value = [of](Run run) -> Value {
      const auto& flood = run.summary.values.flood;
      return flood && !summary_is_behind(run) ? of(*flood) : std::nullopt;
    };
    all.push_back(std::move(measure));
  };
  std::vector<std::string> words;
  for (const FloodVerdictInfo& info : flood_verdicts) words.emplace_back(info.words);
  add({.name = std::string(flood_measure),
          .label = "does it flood",
          .unit = "-",
          .kind = MeasureKind::word,
          .words = words},
      [](const FloodSummary& f) { return f.verdict ? Value(static_cast<Real>(*f.verdict)) : std::nullopt; });
  RunMeasure freeboard{.name = "freeboard",
      .label = "freeboard that remains",
      .unit = "m",
      .kind = MeasureKind::place,
      .distance = fall_of_ground,
      .resolution = quarter_of_a_cell};
  add(std::move(freeboard), [](const FloodSummary& f) { return finite(f.freeboard); });
  const auto width = [&](const char* name, const char* label, auto of) {
    add({.name = name, .label = label, .unit = "m", .resolution = one_cell}, of);
  };
  width("width_at_level", "width at the water level", [](const FloodSummary& f) { return finite(f.width_at_level); });
  width(
      "intact_width", "intact width at the water level", [](const FloodSummary& f) { return finite(f.intact_width); });
  const auto time = [&](const char* name, const char* label, auto of) {
    add({.name = name,
            .label = label,
            .unit = "s",
            .kind = MeasureKind::time,
            .resolution = row_interval,
            .in_steps = true},
        of);
  };
  time("first_time_damaged", "damaged from", [](const FloodSummary& f) { return f.first_time_damaged; });
  add_stage_of(all, runs, "stage_damaged", "stage in which it is damaged", &FloodSummary::stage_damaged);
  time("first_time_below", "floods from", [](const FloodSummary& f) { return f.first_time_below; });
  add_stage_of(all, runs, "stage_moving", "stage at whose end soil moves", &FloodSummary::stage_moving);
  add_stage_of(all, runs, "stage_below", "stage in which it floods", &FloodSummary::stage_below);
}

void add_softened_soil(Measures& all, const std::vector<RunResults>& runs)
{
  Real end = std::numeric_limits<Real>::infinity();
  for (Run run : runs) end = std::min(end, last_in(run, "time").value_or(0.0));
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const Real time = end * quarter / 4.0;
    all.push_back({.name = quarter == 4 ? "softened_fraction" : "",
        .label = fmt::format("softened volume at {:.3g} s", time),
        .unit = "%",
        .digits = 1,
        .value = [=](Run run) { return softened_at(run, time); },
        .resolution = little_share});
  }
}

/// What a row of softening times says: the strain, if it is that of all runs in which anything softens.
std::string softening_label(const std::vector<RunResults>& runs)
{
  std::vector<Real> strains;
  for (Run run : runs)
    if (run.summary.values.softened_strain) strains.push_back(*run.summary.values.softened_strain);
  const bool same = !strains.empty() && std::ranges::count(strains, strains[0]) == std::ssize(strains);
  return same ? fmt::format(": eps_eq_p > {:g} from", strains[0]) : ": 95 % softened from";
}

void add_named_points(Measures& all, const std::vector<RunResults>& runs)
{
  std::vector<std::string> names;
  for (Run run : runs)
    for (const PointTable& point : run.history)
      if (std::ranges::find(names, point.point) == names.end()) names.push_back(point.point);
  for (const std::string& point : names)
    all.push_back({.label = point + softening_label(runs), .unit = "s", .value = [point](Run run) {
                     return softening_time(run, point);
                   }});
}

void add_audit(Measures& all)
{
  all.push_back({.label = "named points whose S_u ever rose", .unit = "-", .digits = 0, .value = [](Run run) -> Value {
                   if (run.history.empty()) return std::nullopt;
                   return static_cast<Real>(points_that_regained_strength(run).size());
                 }});
  for (const char* name : {"points_eps_eq_p_fell", "points_su_rose", "clamped_points"})
    all.push_back(of_summary(name, 0));
  all.push_back(of_summary("energy_balance_error", 2, 100.0, "%"));
  all.push_back(of_summary("v_999", 2));
}

void add_energies(Measures& all)
{
  const auto add = [&](std::string name, std::string label, auto of, const char* of_column) {
    all.push_back({.name = std::move(name),
        .label = std::move(label),
        .unit = "kJ/m",
        .digits = 1,
        .value = [=](Run run) { return times(1e-3, of(run, of_column)); },
        .resolution = little_work});
  };
  add("kinetic_peak", "largest kinetic energy", largest_in, "kinetic");
  add("gravity_work", "work of gravity", last_in, "gravity_work");
  add("plastic", "plastic dissipation", last_in, "plastic");
  add("", "work of damping", last_in, "damping_work");
  add("", "work at the sides", last_in, "boundary_work");
  all.push_back({.name = "damping_share",
      .label = "share of the work of gravity that damping takes",
      .unit = "%",
      .digits = 1,
      .value = [](Run run) -> Value {
        const Value damping = last_in(run, "damping_work"), gravity = last_in(run, "gravity_work");
        return damping && gravity && *gravity != 0.0 ? finite(0.0 - 100.0 * *damping / *gravity) : std::nullopt;
      },
      .resolution = little_share});
}

void add_followers(Measures& all, const std::vector<RunResults>& runs)
{
  std::vector<std::string> footings;
  for (Run run : runs)
    for (const FootingSummary& f : run.summary.values.footings)
      if (std::ranges::find(footings, f.name) == footings.end()) footings.push_back(f.name);
  for (const std::string& name : footings)
    all.push_back({.name = "footing_" + name,
        .label = name + ": largest reaction",
        .unit = "kN/m",
        .value = [name](Run run) -> Value {
          const auto& there = run.summary.values.footings;
          const auto found = std::ranges::find(there, name, &FootingSummary::name);
          return found == there.end() || summary_is_behind(run) ? std::nullopt : finite(1e-3 * found->largest);
        }});
  const auto known = [](Run run, std::string_view name) -> Value {
    const auto found = run.summary.values.numbers.find(name);
    const bool is_known = found != run.summary.values.numbers.end() && !summary_is_behind(run);
    return is_known ? finite(found->second) : std::nullopt;
  };
  for (const FollowerType* type : all_followers())
    for (const QuantityInfo& info : type->summary) {
      const auto has_none = [&](Run run) { return !known(run, info.name); };
      if (!runs.empty() && std::ranges::all_of(runs, has_none)) continue;  // such as water in a dry case
      all.push_back({.name = info.is_input ? "" : std::string(info.name),
          .label = std::string(info.label),
          .unit = std::string(info.unit),
          .value = [known, name = info.name](Run run) { return known(run, name); }});
    }
}

void add_cost(Measures& all)
{
  for (const char* name : {"points", "steps", "threads"}) all.push_back(of_summary(name, 0));
  all.push_back(of_summary("point_steps_per_s", 2, 1e-6, "10^6/s"));
  all.push_back(of_summary("wall_s", 1));
}

}  // namespace

std::vector<RunMeasure> measures_of(const std::vector<RunResults>& runs)
{
  Measures all;
  all.push_back(
      {.label = "time at the end", .unit = "s", .digits = 3, .value = [](Run run) { return last_in(run, "time"); }});
  add_flood(all, runs);
  add_places(all);
  add_slides(all, runs);
  add_volumes(all);
  add_softened_soil(all, runs);
  add_named_points(all, runs);
  add_audit(all);
  add_energies(all);
  add_followers(all, runs);
  add_cost(all);
  return all;
}

std::vector<std::string> points_that_regained_strength(const RunResults& run)
{
  std::vector<std::string> names;
  for (const PointTable& history : run.history) {
    const auto* su = history.table.find("su");
    if (su == nullptr) continue;
    const auto rises = [](Real before, Real after) { return after > before * (1.0 + round_off_of_strength); };
    if (std::adjacent_find(su->begin(), su->end(), rises) != su->end()) names.push_back(history.point);
  }
  return names;
}

std::optional<Real> softening_time(const RunResults& run, std::string_view point)
{
  const std::optional<Real> softened = run.summary.values.softened_strain;
  for (const PointTable& history : run.history) {
    if (!softened) break;
    const auto *time = history.table.find("time"), *strain = history.table.find("eps_softening");
    if (strain == nullptr) strain = history.table.find("eps_eq_p");  // of a run before there was such a column
    if (history.point != point || time == nullptr || strain == nullptr) continue;
    for (std::size_t k = 0; k < time->size(); ++k)
      if ((*strain)[k] > *softened) return (*time)[k];
  }
  return std::nullopt;
}

}  // namespace terp
