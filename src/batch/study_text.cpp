// Remarks are made once, and terminal, page and JSON show the same ones. First come those of the realisations and the
// case, which hold for any estimator, then those of the estimator. An adaptive method has remarks of its own instead.
// The table ends where TableCounter ends it, so rows behind a gap or behind the stop rule are not in it.

#include "batch/study_text.hpp"

#include "os/csv.hpp"
#include "batch/adaptive.hpp"
#include "batch/failure_path.hpp"
#include "batch/fragility_text.hpp"
#include "batch/height_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace terp {
namespace {

constexpr std::array<const char*, 4> words_of_screening = {"none", "falls", "audited", "skipped"};

std::string p_text(Real p) { return fmt::format("{:.3g}", p); }

std::string line_of_event(const Study& study, const char* name, const EventEstimate& e, const std::string& words)
{
  return fmt::format("  {:<8}{:<36}{} of {}{}{}  {}\n", name, estimate_text(e), e.happened, e.solved,
      words_of_counted(study), e.failed > 0 ? fmt::format(", {} unknown", e.failed) : "", words);
}

std::string rho(const std::optional<Real>& value) { return value ? fmt::format("{:+.2f}", *value) : "-"; }

std::string sensitivity_lines(const Study& study, const StudyEstimates& e)
{
  std::string out =
      fmt::format("  what matters: rank correlation of inputs with {}, and with the height that remains\n",
          info_of(study.settings.estimator).inputs_go_with);
  for (const Sensitivity& s : e.sensitivities)
    out += fmt::format("    {:>6}{:>8}  {}\n", rho(s.with_slide), rho(s.with_height), s.input);
  return out;
}

std::string sweep_lines(const Study& study, const Realisations& rows, Index n)
{
  const auto names = study.input_names();
  std::string out = "  " + std::string("run");
  for (const std::string& name : names) out += "  " + name;
  out += "  slide  flood  slid m^2  remains m\n";
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    out += fmt::format("  {:>3}", k);
    for (std::size_t i = 0; i < names.size(); ++i)
      out += fmt::format("  {:>{}}", input_text(study, i, r.inputs[i]), names[i].size());
    out += r.solved() ? fmt::format("  {:>5}  {:>5}  {:>8.3g}  {:>9.4g}\n", r.slid ? "yes" : "no",
                            !r.judges_flood ? "-"
                            : r.flooded     ? "yes"
                                            : "no",
                            r.outcomes[outcome_number("slide_volume")], r.outcomes[outcome_number("residual_height")])
                      : fmt::format("  {:>5}  {}\n", r.slid ? "yes" : "-", r.fault);
  }
  return out;
}

void add_two_stage_remarks(const Study& study, const StudyEstimates& e, std::vector<std::string>& remarks)
{
  const Sample& s = e.sample;
  const TwoStageRule& rule = study.settings.two_stage;
  const EventCounts &falling = s.run_for_falling(), &audited = s.audited();
  remarks.push_back(fmt::format(
      "At the factor {:g} {} of {} realisations do not stand, and are run. Of those that stand {} are run as "
      "the audit, a share of {:g}, and stand for the rest.",
      rule.factor, falling.n(), e.n_made, audited.n(), rule.audit));
  const EventEstimate trusting = s.trusting(e.judges_flood);
  remarks.push_back(fmt::format("{} in the audit. If nothing above the factor can {}, {} is {}.",
      audited.slid == 0 ? std::string("Nothing slid")
                        : fmt::format("{} slid, {} flooded", audited.slid, audited.flooded),
      e.judges_flood ? "flood" : "slide", e.judges_flood ? "P(F)" : "P(I)", estimate_text(trusting)));
  if (e.full_s > 0.0)
    remarks.push_back(
        fmt::format("The first stage took {:.2g} s of processor time each, a run {:.2g} s; Monte Carlo would have "
                    "taken {:.2g} times as long.",
            e.screening_s, e.full_s, e.full_s / e.mean_processor_s));
}
const char* zero_or_one(bool value) { return value ? "1" : "0"; }

std::string head_line(const StudySettings& s, const StudyEstimates& e)
{
  return fmt::format("{}: {} realisations, {}, {:.2g} s each\n", s.title.empty() ? s.name : s.title, e.n_made,
      counts_text(e.counts), e.mean_wall_s);
}

/// What the realisations and the case say against the numbers, whatever the estimator.
std::vector<std::string> remarks_on_realisations(const Study& study, const StudyEstimates& e)
{
  std::vector<std::string> remarks;
  for (const FaultCount& fault : e.faults)
    remarks.push_back(fmt::format("{} realisation{} {}, first {}: {}", fault.n, fault.n == 1 ? "" : "s",
        fault.slides ? fault.n == 1 ? "slides" : "slide" : "failed", fault.first, fault.what));
  const bool adaptive = info_of(study.settings.estimator).adaptive, of_flood = study.settings.adaptive.of_flood;
  const auto add_moving = [&](Index n, const char* event, const char* what) {
    if (n > 0)
      remarks.push_back(fmt::format(
          "{} realisations end without a {} while their soil still moves: {}. "
          "End the case and each of its stages at rest, or later; `stage_moving` of a kept run names the stage.",
          n, event, what));
  };
  if (!adaptive || !of_flood) add_moving(e.n_moving_without_slide, "slide", "P(I) may be too low");
  if (adaptive && of_flood) add_moving(e.n_moving_without_flood, "flood", "P(F) may be too low");
  if (!adaptive) add_moving(e.n_moving_without_flood, "flood", "they count as unknown in P(F) and P(F|I)");
  if (e.n_near > 0)
    remarks.push_back(
        fmt::format("{} of the floods {} brief or small: the ground was below the water by little, for less than 2 s, "
                    "or not to the "
                    "end. On the safe side {} as F (docs/flood.md).",
            e.n_near, e.n_near == 1 ? "is" : "are", e.n_near == 1 ? "it counts" : "they count"));
  if (e.n_held > 0)
    remarks.push_back(fmt::format(
        "{} realisation{} cannot stand as drawn, and {} solved once more with [held]: what happens when the "
        "soil is released counts. So many of them slide then: {}.",
        e.n_held, e.n_held == 1 ? "" : "s", e.n_held == 1 ? "was" : "were", e.n_held_slid));
  if (const std::int64_t n = e.counts.flooded - e.counts.flooded_after_slide; n > 0)
    remarks.push_back(
        fmt::format("{} realisation{} flood{} without a slide: ground sinks below the water, and less than {:g} m^2 of "
                    "soil moves by more than {:g} m. Take a smaller slide in [events], or read P(F|I) as a share of "
                    "these slides alone.",
            n, n == 1 ? "" : "s", n == 1 ? "s" : "", study.settings.event.volume, study.settings.event.displacement));
  const Case& base = study.base.values;
  if (base.at_strength != 1.0)
    remarks.push_back(
        fmt::format("All strengths are divided by {:g} (at_strength): P is that of weaker soil, not of the "
                    "section as it is.",
            base.at_strength));
  if (const auto stage = std::ranges::find_if(base.stages, [](const StageCase& s) { return s.trigger; });
      stage != base.stages.end())
    remarks.push_back(
        fmt::format("The case has the trigger `{}`: P is that of a slide or a flood once the trigger acts, "
                    "not of the section as it is.",
            stage->name));
  return remarks;
}

}  // namespace

std::string estimate_text(const EventEstimate& event)
{
  if (event.solved + event.failed == 0) return "-";
  const auto p = event.probability();
  return fmt::format("{}, {} to {}", p ? p_text(*p) : "-", p_text(event.bounds.low), p_text(event.bounds.high));
}

std::string counts_text(const EventCounts& c)
{
  return fmt::format("{} solved, {}{} failed", c.solved,
      c.slid_as_drawn > 0 ? fmt::format("{} slide as drawn, ", c.slid_as_drawn) : "", c.failed);
}

std::vector<RowLabel> row_labels(const Study& study)
{
  if (study.settings.estimator == Estimator::two_stage)
    return {{"screening", [](const Study&, const Realisation& r) {
               return std::string(words_of_screening[static_cast<std::size_t>(r.screening)]);
             }}};
  if (study.coarse)
    return {{"sample", [](const Study& s, const Realisation& r) { return fmt::format("{}", s.sample_of(r.number)); }},
        {"resolution", [](const Study& s, const Realisation& r) {
           return std::string(s.is_coarse(r.number) ? "coarse" : "fine");
         }}};
  return {};
}

const char* words_of_counted(const Study& study) { return study.coarse ? " pairs" : ""; }

std::string slide_words(const StudySettings& s)
{
  return fmt::format("a slide: {:g} m^2 or more moved by more than {:g} m", s.event.volume, s.event.displacement);
}

std::string worth_of_residual_strength(const StudyEstimates& e)
{
  if (!e.judges_flood || e.slide.happened == 0) return "";
  const auto p = e.flood_after_slide.probability();
  const std::string bounds =
      fmt::format("{:.0f} to {:.0f}", 100.0 * e.flood_after_slide.bounds.low, 100.0 * e.flood_after_slide.bounds.high);
  if (!p) return fmt::format("How many of 100 slides flood the land is not known: {}.", bounds);
  return fmt::format(
      "Of 100 slides {:.0f} flood the land ({}): that is what the residual strength is worth.", 100.0 * *p, bounds);
}

std::vector<std::string> remarks_on_study(const Study& study, const Realisations& rows, const StudyEstimates& e)
{
  std::vector<std::string> remarks = remarks_on_realisations(study, e);
  if (!study.settings.note.empty()) remarks.insert(remarks.begin(), study.settings.note);
  if (info_of(study.settings.estimator).adaptive) {
    std::ranges::move(remarks_on_adaptive(study, rows, e), std::back_inserter(remarks));
    return remarks;
  }
  const EventCounts counted = e.sample.counts();  // what of them is not known bounds P
  if (counted.slid_as_drawn > 0)
    remarks.push_back(
        "Soil that cannot stand in the section as it is drawn slides before the run begins: it is a slide in P(I), "
        "whatever its volume. What is left then is not known, so it counts as unknown in P(F) and P(F|I), and "
        "histograms leave it out. A study with [held] solves it, too; so does a case with initial.stress = \"k0\".");
  if (counted.failed > 0)
    remarks.push_back(
        "Failed realisations count in both bounds: as if nothing happened in the lower one, as if it did in "
        "the upper one. They are no random sample: the estimates are of the others alone.");
  if (const std::int64_t n = counted.solved - counted.judged - e.n_moving_without_flood; e.judges_flood && n > 0)
    remarks.push_back(fmt::format(
        "In {} realisations no water stands above the ground, so that no level is known: each counts as unknown in "
        "P(F) and P(F|I). Give the case flood.water_level.",
        n));
  if (!e.rule_met)
    remarks.push_back(
        fmt::format("The stop rule is not met yet: {} of at most {} realisations. The same command goes on.", e.n_made,
            study.n_realisations));
  if (e.n_beyond > 0)
    remarks.push_back(
        fmt::format("{} more realisations are solved, but lie behind a gap or behind the stop rule; they "
                    "are not in the table.",
            e.n_beyond));
  const StopRule& rule = study.settings.stop;
  const EventEstimate& of_rule = e.judges_flood ? e.flood : e.slide;
  if (rule.events() > 0 && of_rule.happened >= rule.events() && of_rule.failed == 0)
    remarks.push_back(fmt::format(
        "The rule ends the study with an event, so k/n is on average too large by a share of (1 - P)/k; (k - 1)/(n - "
        "1) = {:.3g} is not. The bounds hold.",
        static_cast<Real>(of_rule.happened - 1) / static_cast<Real>(of_rule.solved - 1)));
  if (const std::string_view remark = info_of(study.settings.estimator).remark; !remark.empty())
    remarks.emplace_back(remark);
  if (study.settings.estimator == Estimator::two_stage) add_two_stage_remarks(study, e, remarks);
  for (std::string& remark : remarks_on_levels(study, e)) remarks.push_back(std::move(remark));
  if (study.settings.fragility)
    for (std::string& remark : remarks_on_fragility(study, estimate_fragility(study, rows)))
      remarks.push_back(std::move(remark));
  if (!e.judges_flood && e.sample.counts().n() > 0)
    remarks.push_back("Nothing is said of a flood: the case has no water level (docs/flood.md).");
  return remarks;
}

std::string study_text(const Study& study, const Realisations& rows)
{
  const StudySettings& s = study.settings;
  const StudyEstimates e = estimate(study, rows);
  std::string out = head_line(s, e);
  if (s.estimator == Estimator::sweep) {
    out += sweep_lines(study, rows, e.n_made);
  } else if (info_of(s.estimator).adaptive) {
    if (e.adaptive.result) out += adaptive_text(study, rows, *e.adaptive.result);
  } else if (s.fragility) {
    out += fragility_text(study, estimate_fragility(study, rows)) + failure_path_text(study, rows) +
           height_curve_text(flood_after_slide_over_level(study, rows)) + sensitivity_lines(study, e);
  } else {
    out += fmt::format("  probabilities with {:g} % bounds{}\n", 100.0 * s.confidence,
        is_of_points(s.estimator) ? " of independent realisations" : "");
    out += line_of_event(study, "P(I)", e.slide, slide_words(s));
    if (e.judges_flood) {
      out += line_of_event(study, "P(F)", e.flood, flood_words);
      out += line_of_event(study, "P(F|I)", e.flood_after_slide, "of the slides");
    }
    if (const std::string worth = worth_of_residual_strength(e); !worth.empty()) out += "  " + worth + '\n';
    out += failure_path_text(study, rows);
    out += height_curve_text(flood_after_slide_over_level(study, rows));
    out += sensitivity_lines(study, e);
  }
  for (const std::string& remark : remarks_on_study(study, rows, e)) out += "  note: " + remark + '\n';
  return out;
}

std::string study_csv(const Study& study, const Realisations& rows)
{
  const Index n = TableCounter(study, rows).n();
  const std::vector<RowLabel> labels = row_labels(study);
  std::string out = "realisation,solved";
  for (const RowLabel& label : labels) out += fmt::format(",{}", label.name);
  out += ",slide,flood";
  for (const std::string& name : study.input_names()) out += ',' + csv_cell(name);
  for (const OutcomeInfo& outcome : study_outcomes()) out += fmt::format(",{}", outcome.info.name);
  out += ",fault\n";
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    out += fmt::format("{},{:d}", k, r.solved());
    for (const RowLabel& label : labels) out += ',' + label.word(study, r);
    out += fmt::format(",{},{}", r.failed() || r.skipped() ? "nan" : zero_or_one(r.slid),
        r.solved() && r.judges_flood ? zero_or_one(r.flooded) : "nan");
    for (std::size_t i = 0; i < r.inputs.size(); ++i)
      out += i < study.settings.sweep.size() ? ',' + csv_cell(input_text(study, i, r.inputs[i]))
                                             : fmt::format(",{}", r.inputs[i]);
    for (std::size_t i = 0; i < study_outcomes().size(); ++i)
      out += r.solved() ? fmt::format(",{}", r.outcomes[i]) : ",nan";
    out += ',' + csv_cell(r.fault) + '\n';
  }
  return out;
}

}  // namespace terp
