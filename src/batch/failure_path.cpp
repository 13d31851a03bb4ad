// What is not known counts as in P(F|I): without the event in the lower bound, with it in the upper one. A failed
// realisation may be a slide; of soil that slides as drawn nothing but the slide is known. Follow-up slides are those
// of the crest (docs/formats.md), so a slide of the event's volume that leaves the crest alone has none.

#include "batch/failure_path.hpp"

#include "os/csv.hpp"
#include "batch/study_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace terp {
namespace {

struct PathStep {
  std::string_view key, given_key;
  Sentence name, given;
};
enum Step { first_slide, follow_up, below_after, below_without, overflow, without_slide, n_steps };

const std::array<PathStep, n_steps>& steps()
{
  static const Sentence all{"all realisations", "alle realisaties"}, slide{"first slide", "eerste afschuiving"},
      more{"follow-up slides", "vervolgafschuivingen"}, no_more{"no follow-up slide", "geen vervolgafschuiving"},
      no_slide{"no slide", "geen afschuiving"}, below{"ground below the water", "grond onder het waterpeil"};
  static const std::array<PathStep, n_steps> list{{{"first_slide", "", slide, all},
      {"follow_up_slides", "first_slide", more, slide}, {"below_after_follow_up", "follow_up_slides", below, more},
      {"below_without_follow_up", "no_follow_up_slide", below, no_more},
      {"overflow", "below", {"water flows over, to the end", "water loopt over, tot het einde"}, below},
      {"flood_without_slide", "no_slide", {"flood without a slide", "overstroming zonder afschuiving"}, no_slide}}};
  return list;
}

struct Counts {
  std::int64_t happened = 0, known = 0, unknown = 0;

  void take(bool so) { ++known, happened += so; }
};

void count(const Realisation& r, std::array<Counts, n_steps>& counts)
{
  static const std::size_t slides = outcome_number("slides"), near = outcome_number("near"),
                           flood_time = outcome_number("flood_time");
  if (r.failed()) {
    for (Counts& of : counts) ++of.unknown;
    return;
  }
  counts[first_slide].take(r.slid);
  if (!r.slid) {
    if (r.knows_flood())
      counts[without_slide].take(r.flooded);
    else
      ++counts[without_slide].unknown;
    return;
  }
  if (!r.solved()) {
    for (int step = follow_up; step <= overflow; ++step) ++counts[step].unknown;
    return;
  }
  const bool follows = r.outcomes[slides] > 1.0;
  counts[follow_up].take(follows);
  Counts& of_ground = counts[follows ? below_after : below_without];
  if (!r.knows_flood()) {
    ++of_ground.unknown, ++counts[overflow].unknown;
    return;
  }
  const bool is_below = std::isfinite(r.outcomes[flood_time]);
  of_ground.take(is_below);
  if (is_below) counts[overflow].take(r.flooded && r.outcomes[near] != 1.0);
}

std::string level_text(const Study& study, std::size_t level)
{
  return study.settings.fragility ? fmt::format("{}", study.settings.fragility->levels[level]) : "nan";
}

}  // namespace

bool has_failure_path(const Study& study)
{
  const Estimator kind = study.settings.estimator;
  return !info_of(kind).adaptive && kind != Estimator::sweep && kind != Estimator::two_stage && !study.coarse;
}

std::vector<PathEvent> failure_path(const Study& study, const Realisations& rows, std::size_t level)
{
  if (!has_failure_path(study)) return {};
  std::array<Counts, n_steps> counts{};
  const Index n = TableCounter(study, rows).n();
  for (Index k = 0; k < n; ++k)
    if (study.level_of(k) == level) count(rows.at(k), counts);
  std::vector<PathEvent> path;
  for (int step = 0; step < n_steps; ++step) {
    const PathStep& of = steps()[step];
    const Counts& c = counts[step];
    path.push_back({of.key, of.given_key, of.name, of.given,
        estimate_event(c.happened, c.known, c.unknown, study.settings.confidence)});
  }
  return path;
}

std::string failure_path_text(const Study& study, const Realisations& rows)
{
  if (!has_failure_path(study)) return "";
  std::string out =
      fmt::format("  failure path (faalpad) of a slide, each event given the one before it, {:g} % bounds\n",
          100.0 * study.settings.confidence);
  for (std::size_t level = 0; level < static_cast<std::size_t>(study.n_levels()); ++level) {
    if (study.settings.fragility)
      out += fmt::format("   {} {}\n", study.settings.fragility->label(), level_text(study, level));
    for (const PathEvent& event : failure_path(study, rows, level))
      out += fmt::format("    {:<30}given {:<24}{:<26}{} of {}{}\n", event.name.en, event.given.en,
          estimate_text(event.estimate), event.estimate.happened, event.estimate.solved,
          event.estimate.failed > 0 ? fmt::format(", {} unknown", event.estimate.failed) : "");
  }
  return out;
}

std::string failure_path_csv(const Study& study, const Realisations& rows)
{
  std::string out = "level,event,event_nl,given,given_nl,happened,of,unknown,P,P_low,P_high\n";
  for (std::size_t level = 0; level < static_cast<std::size_t>(study.n_levels()); ++level)
    for (const PathEvent& event : failure_path(study, rows, level)) {
      const EventEstimate& e = event.estimate;
      const auto p = e.probability();
      out += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", level_text(study, level), csv_cell(event.name.en),
          csv_cell(event.name.nl), csv_cell(event.given.en), csv_cell(event.given.nl), e.happened, e.solved, e.failed,
          p ? fmt::format("{}", *p) : "nan", e.bounds.low, e.bounds.high);
    }
  return out;
}

}  // namespace terp
