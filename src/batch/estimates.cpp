// A realisation without a result counts in both bounds of an event. Which it lacks depends on the event
// (EventCounts::unknown): soil that slides as drawn has I and not F, and without a water level F is not known. An event
// is a pointer to its member, so that all estimators share one text.

#include "batch/adaptive.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

bool meets_rule(const Study& study, const Sample& sample)
{
  if (info_of(study.settings.estimator).adaptive) return false;
  const std::int64_t needed = study.settings.stop.events();
  return needed > 0 && sample.rule_events() >= needed;
}

/// What stays the same in a message: before its numbers.
std::string kind_of_fault(const std::string& fault)
{
  const std::size_t digit = fault.find_first_of("0123456789");
  return fault.substr(0, digit == std::string::npos || digit < 20 ? std::min<std::size_t>(fault.size(), 100) : digit);
}

void count_fault(const Realisation& r, std::vector<FaultCount>& faults)
{
  const std::string kind = kind_of_fault(r.fault);
  const auto found = std::ranges::find_if(faults, [&](const FaultCount& f) { return kind_of_fault(f.what) == kind; });
  if (found == faults.end())
    faults.push_back({r.fault, r.number, 1, r.slid});
  else
    ++found->n;
}

std::vector<Sensitivity> find_sensitivities(const Study& study, const Realisations& rows, Index n)
{
  const std::vector<std::string> names = study.input_names();
  const std::size_t height = outcome_number("residual_height");
  std::vector<Sensitivity> list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<Real> all, slid, with_height, heights;
    for (Index i = 0; i < n; ++i) {
      const Realisation& r = rows.at(i);
      if (r.failed() || (study.coarse && !study.is_coarse(i))) continue;  // each sample of two levels once
      const bool falls = study.settings.estimator == Estimator::two_stage ? r.screening == Screening::falls : r.slid;
      all.push_back(r.inputs[k]), slid.push_back(falls ? 1.0 : 0.0);
      if (r.solved() && std::isfinite(r.outcomes[height]))
        with_height.push_back(r.inputs[k]), heights.push_back(r.outcomes[height]);
    }
    list.push_back({names[k], spearman(all, slid), spearman(with_height, heights)});
  }
  return list;
}

}  // namespace

void EventCounts::take(const Realisation& r)
{
  if (r.failed()) {
    ++failed;
    return;
  }
  (r.solved() ? solved : slid_as_drawn) += 1;
  slid += r.slid, flooded += r.flooded, flooded_after_slide += r.slid && r.flooded;
  if (r.knows_flood()) ++judged, slid_judged += r.slid;
}

std::int64_t EventCounts::unknown(std::int64_t EventCounts::*event) const
{
  if (event == &EventCounts::slid) return failed;
  return event == &EventCounts::flooded ? n() - judged : failed + slid - slid_judged;
}

EventCounts operator+(const EventCounts& a, const EventCounts& b)
{
  EventCounts sum;
  for (const auto member : {&EventCounts::solved, &EventCounts::failed, &EventCounts::slid, &EventCounts::flooded,
           &EventCounts::flooded_after_slide, &EventCounts::judged, &EventCounts::slid_judged,
           &EventCounts::slid_as_drawn})
    sum.*member = a.*member + b.*member;
  return sum;
}

EventCounts Sample::counts() const { return all_ + audited_; }

void Sample::take(const Realisation& r, bool is_coarse)
{
  judges_flood_ = judges_flood_ || r.judges_flood;
  if (settings_->estimator == Estimator::multilevel) levels_.take(r, is_coarse);
  if (is_coarse)
    coarse_.take(r);
  else if (r.skipped())
    ++n_skipped_;
  else
    (r.screening == Screening::audited ? audited_ : all_).take(r);
}

EventEstimate Sample::estimate(std::int64_t EventCounts::*event, Real confidence) const
{
  if (settings_->estimator == Estimator::two_stage) return weigh(event, confidence);
  if (settings_->estimator == Estimator::multilevel)
    return levels_
        .of(event == &EventCounts::slid      ? StudyEvent::slide
            : event == &EventCounts::flooded ? StudyEvent::flood
                                             : StudyEvent::slide_and_flood)
        .estimate(confidence);
  return estimate_event(all_.*event, all_.n() - all_.unknown(event), all_.unknown(event), confidence);
}

// The audit is a random part of what stands at the factor, so its share of events is that of all of these. Both numbers
// of events, below the factor and in the audit, are binomial out of all n: each takes half of what the bounds may err.
EventEstimate Sample::weigh(std::int64_t EventCounts::*event, Real confidence) const
{
  const Real audit = settings_->two_stage.audit, of_each = 0.5 + 0.5 * confidence;
  const std::int64_t n = all_.n() + audited_.n() + n_skipped_, unknown = all_.unknown(event),
                     unknown_of_audit = audited_.unknown(event);
  EventEstimate e{
      all_.*event + audited_.*event, n - n_skipped_ - unknown - unknown_of_audit, unknown + unknown_of_audit};
  e.counts_alike = false;
  const auto part = [&](const EventCounts& c, std::int64_t size) -> std::optional<Real> {
    const std::int64_t known = c.n() - c.unknown(event);
    if (size == 0) return 0.0;
    if (known == 0) return std::nullopt;
    return static_cast<Real>(size) / static_cast<Real>(n) * static_cast<Real>(c.*event) / static_cast<Real>(known);
  };
  const auto falls = part(all_, all_.n()), stands = part(audited_, audited_.n() + n_skipped_);
  if (n > 0 && falls && stands) e.weighted = *falls + *stands;
  const auto bounds = [&](const EventCounts& c) {
    return Bounds{
        clopper_pearson(c.*event, n, of_each).low, clopper_pearson(c.*event + c.unknown(event), n, of_each).high};
  };
  const Bounds below = bounds(all_), above = bounds(audited_);
  e.bounds = {std::min(1.0, below.low + above.low / audit), std::min(1.0, below.high + above.high / audit)};
  return e;
}

/// Of the slides below the factor and of those above it, each with its weight; none: the audit does not tell.
std::optional<Real> Sample::weighted_worth() const
{
  const std::int64_t below = all_.slid_judged, above = audited_.slid_judged, audited = audited_.n() - audited_.failed;
  if (below + above == 0 || (audited == 0 && n_skipped_ > 0)) return std::nullopt;
  const Real weight = audited > 0 ? static_cast<Real>(audited_.n() + n_skipped_) / static_cast<Real>(audited) : 0.0;
  const std::int64_t known = all_.n() - all_.failed;
  const Real weight_below = known > 0 ? static_cast<Real>(all_.n()) / static_cast<Real>(known) : 1.0;
  const auto sum = [&](std::int64_t falls, std::int64_t stands) {
    return weight_below * static_cast<Real>(falls) + weight * static_cast<Real>(stands);
  };
  return sum(all_.flooded_after_slide, audited_.flooded_after_slide) / sum(below, above);
}

EventEstimate Sample::flood_after_slide(Real confidence) const
{
  const bool two_stage = settings_->estimator == Estimator::two_stage;
  if (!two_stage && settings_->estimator != Estimator::multilevel)
    return estimate_event(
        all_.flooded_after_slide, all_.slid_judged, all_.unknown(&EventCounts::flooded_after_slide), confidence);
  const Real of_each = 0.5 + 0.5 * confidence;
  const EventEstimate both = estimate(&EventCounts::flooded_after_slide, of_each),
                      slide = estimate(&EventCounts::slid, of_each);
  EventEstimate e{both.happened, all_.slid_judged + audited_.slid_judged, both.failed};
  e.counts_alike = false;
  if (two_stage)
    e.weighted = weighted_worth();
  else if (both.weighted && slide.weighted && *slide.weighted > 0.0)
    e.weighted = std::min(1.0, *both.weighted / *slide.weighted);  // each has groups of its own
  e.bounds.low = slide.bounds.high > 0.0 ? both.bounds.low / slide.bounds.high : 0.0;
  e.bounds.high = slide.bounds.low > 0.0 ? std::min(1.0, both.bounds.high / slide.bounds.low) : 1.0;
  return e;
}

EventEstimate Sample::trusting(bool of_flood) const
{
  const auto event = of_flood ? &EventCounts::flooded : &EventCounts::slid;
  const std::int64_t unknown = all_.unknown(event) + audited_.unknown(event);
  return estimate_event(all_.*event, all_.n() + audited_.n() + n_skipped_ - unknown, unknown, settings_->confidence);
}

std::optional<Real> EventEstimate::probability() const
{
  if (!counts_alike) return weighted;
  if (solved == 0) return std::nullopt;
  return static_cast<Real>(happened) / static_cast<Real>(solved);
}

EventEstimate estimate_event(std::int64_t happened, std::int64_t solved, std::int64_t failed, Real confidence)
{
  EventEstimate e{happened, solved, failed};
  e.bounds.low = clopper_pearson(happened, solved + failed, confidence).low;
  e.bounds.high = clopper_pearson(happened + failed, solved + failed, confidence).high;
  return e;
}

void TableCounter::take(const Realisations& rows)
{
  for (auto row = rows.find(n_); row != rows.end() && row->first == n_ && !rule_met_; ++row) {
    counts_.take(row->second, study_.is_coarse(n_));
    ++n_;
    rule_met_ = n_ == study_.n_realisations || meets_rule(study_, counts_);
  }
}

StudyEstimates estimate(const Study& study, const Realisations& rows)
{
  StudyEstimates e(study.settings);
  const TableCounter table(study, rows);
  e.n_made = table.n(), e.rule_met = table.rule_met();
  e.n_beyond = static_cast<Index>(rows.size()) - e.n_made;
  const std::size_t moves = outcome_number("still_moves"), near = outcome_number("near"), held = outcome_number("held");
  Index n_skipped = 0, n_coarse = 0;
  double skipped_s = 0.0, coarse_s = 0.0;
  for (Index n = 0; n < e.n_made; ++n) {
    const Realisation& r = rows.at(n);
    const bool is_coarse = study.is_coarse(n);
    e.sample.take(r, is_coarse);
    e.mean_wall_s += r.wall_s / e.n_made;
    e.mean_processor_s += r.processor_s / e.n_made;
    if (r.skipped()) ++n_skipped, skipped_s += r.processor_s;
    if (is_coarse) ++n_coarse, coarse_s += r.processor_s;
    if (!r.fault.empty()) count_fault(r, e.faults);
    if (r.solved() && !is_coarse && r.outcomes[near] == 1.0) ++e.n_near;
    if (r.solved() && !is_coarse && r.outcomes[held] == 1.0) ++e.n_held, e.n_held_slid += r.slid;
    if (r.solved() && !is_coarse && r.outcomes[moves] == 1.0)
      e.n_moving_without_slide += !r.slid, e.n_moving_without_flood += r.judges_flood && !r.flooded;
  }
  if (n_skipped > 0 && n_skipped < e.n_made) {
    e.screening_s = skipped_s / n_skipped;
    e.full_s = (e.mean_processor_s * e.n_made - skipped_s) / (e.n_made - n_skipped) - e.screening_s;
  }
  if (n_coarse > 0 && n_coarse < e.n_made) {
    e.coarse_s = coarse_s / n_coarse;
    e.fine_s = (e.mean_processor_s * e.n_made - coarse_s) / (e.n_made - n_coarse);
  }
  e.counts = e.sample.counts() + e.sample.coarse();
  e.judges_flood = e.sample.judges_flood();
  e.slide = e.sample.slide(), e.flood = e.sample.flood(), e.flood_after_slide = e.sample.flood_after_slide();
  e.sensitivities = find_sensitivities(study, rows, e.n_made);
  if (info_of(study.settings.estimator).adaptive) e.adaptive = replay_adaptive(study, rows);
  return e;
}

}  // namespace terp
