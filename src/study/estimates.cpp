#include "study/estimates.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// Of F where floods are judged, else of I.
bool meets_rule(const Study& study, const EventCounts& c)
{
  const std::int64_t needed = study.settings.stop.events();
  return needed > 0 && (c.judged > 0 ? c.flooded : c.slid) >= needed;
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
    faults.push_back({r.fault, r.number, 1});
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
      if (!r.solved()) continue;
      all.push_back(r.inputs[k]), slid.push_back(r.slid ? 1.0 : 0.0);
      if (std::isfinite(r.outcomes[height])) with_height.push_back(r.inputs[k]), heights.push_back(r.outcomes[height]);
    }
    list.push_back({names[k], spearman(all, slid), spearman(with_height, heights)});
  }
  return list;
}

}  // namespace

void EventCounts::take(const Realisation& r)
{
  if (!r.solved()) {
    ++failed;
    return;
  }
  ++solved;
  slid += r.slid, flooded += r.flooded, flooded_after_slide += r.slid && r.flooded, judged += r.judges_flood;
}

EventEstimate EventCounts::slide(Real confidence) const { return estimate_event(slid, solved, failed, confidence); }
EventEstimate EventCounts::flood(Real confidence) const { return estimate_event(flooded, solved, failed, confidence); }
EventEstimate EventCounts::flood_after_slide(Real confidence) const
{
  return estimate_event(flooded_after_slide, slid, failed, confidence);
}

std::optional<Real> EventEstimate::probability() const
{
  if (solved == 0) return std::nullopt;
  return static_cast<Real>(happened) / static_cast<Real>(solved);
}

std::optional<Real> EventEstimate::cov() const
{
  const auto p = probability();
  if (!p || *p == 0.0) return std::nullopt;
  return std::sqrt((1.0 - *p) / (static_cast<Real>(solved) * *p));
}

EventEstimate estimate_event(std::int64_t happened, std::int64_t solved, std::int64_t failed, Real confidence)
{
  EventEstimate e{happened, solved, failed};
  e.bounds.low = clopper_pearson(happened, solved + failed, confidence).low;
  e.bounds.high = clopper_pearson(happened + failed, solved + failed, confidence).high;
  return e;
}

Index count_in_table(const Study& study, const Realisations& rows, bool& rule_met)
{
  EventCounts counts;
  Index n = 0;
  rule_met = false;
  while (n < study.n_realisations && !rule_met) {
    const auto row = rows.find(n);
    if (row == rows.end()) return n;
    counts.take(row->second);
    ++n;
    rule_met = n == study.n_realisations || meets_rule(study, counts);
  }
  return n;
}

StudyEstimates estimate(const Study& study, const Realisations& rows)
{
  StudyEstimates e;
  e.n_made = count_in_table(study, rows, e.rule_met);
  e.n_beyond = static_cast<Index>(rows.size()) - e.n_made;
  EventCounts c;
  for (Index n = 0; n < e.n_made; ++n) {
    const Realisation& r = rows.at(n);
    c.take(r);
    e.mean_wall_s += r.wall_s / e.n_made;
    if (!r.solved()) count_fault(r, e.faults);
  }
  const Real confidence = study.settings.confidence;
  e.judges_flood = c.judged > 0;
  e.slide = c.slide(confidence), e.flood = c.flood(confidence), e.flood_after_slide = c.flood_after_slide(confidence);
  e.sensitivities = find_sensitivities(study, rows, e.n_made);
  return e;
}

std::vector<RunningEstimate> running_estimates(
    const Study& study, const Realisations& rows, bool of_flood, std::size_t most)
{
  bool met = false;
  const Index n_made = count_in_table(study, rows, met);
  const Index stride = 1 + n_made / static_cast<Index>(most);
  std::vector<RunningEstimate> list;
  EventCounts c;
  for (Index n = 0; n < n_made; ++n) {
    c.take(rows.at(n));
    if ((n + 1) % stride == 0 || n + 1 == n_made)
      list.push_back({n + 1, of_flood ? c.flood(study.settings.confidence) : c.slide(study.settings.confidence)});
  }
  return list;
}

}  // namespace terp
