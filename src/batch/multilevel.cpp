// In a table the coarse realisation of a pair comes just before the fine one, so one remembered result is enough to
// sort it. From the same counts come two kinds of bounds. Proven ones add up exact binomial bounds; rough ones use the
// variance to first order, as does the time for the same variance. A coarse case that is refused is tried again with
// each change alone, to name the one at fault.

#include "batch/multilevel.hpp"

#include "io/case/case_record.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "batch/case_refusal.hpp"
#include "batch/estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr std::array<StudyEvent, 3> all_events = {StudyEvent::slide, StudyEvent::flood, StudyEvent::slide_and_flood};

bool happened(const Realisation& r, StudyEvent event)
{
  switch (event) {
    case StudyEvent::slide: return r.slid;
    case StudyEvent::flood: return r.flooded;
    case StudyEvent::slide_and_flood: return r.slid && r.flooded;
  }
  return false;
}

bool is_known(const Realisation& r, StudyEvent event)
{
  const bool flood = r.knows_flood();
  switch (event) {
    case StudyEvent::slide: return !r.failed();
    case StudyEvent::flood: return flood;
    case StudyEvent::slide_and_flood: return flood || (!r.failed() && !r.slid);
  }
  return false;
}

Real share(std::int64_t k, std::int64_t n) { return static_cast<Real>(k) / static_cast<Real>(n); }

Bounds bounds_of(const PairGroup& pairs, Real confidence)
{
  return {clopper_pearson(pairs.happened, pairs.n, confidence).low,
      clopper_pearson(pairs.happened + pairs.unknown, pairs.n, confidence).high};
}

std::string record_of(const CaseFile& file, const SharedMesh& mesh)
{
  return record_text(make_case_record(file, *mesh));
}

/// Fine realisations of Monte Carlo whose bounds are as narrow about P.
Real fine_alone_for_width(Real p, Real width, Real confidence)
{
  const auto is_narrow = [&](Real n) {
    const Bounds b = clopper_pearson_of(p * n, n, confidence);
    return b.high - b.low <= width;
  };
  Real low = 0.0, high = 1.0;
  constexpr Real most = 1e12;
  constexpr int n_halvings = 40;
  while (high < most && !is_narrow(high)) low = high, high *= 2.0;
  for (int k = 0; k < n_halvings; ++k) {
    const Real middle = 0.5 * (low + high);
    (is_narrow(middle) ? high : low) = middle;
  }
  return high;
}

/// Of the estimate, to first order: between / n + within / m for n coarse realisations and m pairs.
struct Variance {
  Real p = 0.0, between = 0.0, within = 0.0;
};

// Sampling in two phases for groups: Cochran, Sampling Techniques, 3rd ed. 1977, section 12.2. Shares of fine events
// take half an event more, and one pair (Jeffreys), so that pairs without a difference do not make P certain.
std::optional<Variance> variance_of(const TwoLevelCounts& counts)
{
  const PairGroup &with = counts.with, &without = counts.without;
  if (counts.coarse == 0 || counts.coarse == counts.n || with.known() == 0 || without.known() == 0) return std::nullopt;
  const auto fine = [](const PairGroup& pairs) {
    return (static_cast<Real>(pairs.happened) + 0.5) / (static_cast<Real>(pairs.known()) + 1.0);
  };
  const Real c = share(counts.coarse, counts.n), a = fine(with), b = fine(without);
  return Variance{.p = c * a + (1.0 - c) * b,
      .between = c * (1.0 - c) * (a - b) * (a - b),
      .within = c * a * (1.0 - a) + (1.0 - c) * b * (1.0 - b)};
}

/// Why a case without any draw cannot begin, as the mesh does not go with it; empty: it can, or its run says why not.
std::string why_not_begun(const CaseFile& file, const SharedMesh& mesh)
{
  try {
    const Simulation simulation(file.values, mesh, 1);
  } catch (const InputError& error) {
    return error.what();
  } catch (const RunError&) {
  }
  return "";
}

}  // namespace

void TwoLevels::take(const Realisation& r, bool is_coarse)
{
  for (const StudyEvent event : all_events) {
    const auto k = static_cast<std::size_t>(event);
    TwoLevelCounts& counts = events_[k];
    if (is_coarse) {
      last_coarse_[k] = happened(r, event);
      ++counts.n, counts.coarse += last_coarse_[k];
    } else {
      PairGroup& pairs = last_coarse_[k] ? counts.with : counts.without;
      ++pairs.n, pairs.happened += happened(r, event) && is_known(r, event), pairs.unknown += !is_known(r, event);
    }
  }
}

// Which samples are pairs has nothing to do with their results. So, whatever the coarse level says of the pairs, fine
// events are binomial in each of the two groups, and in both together. P rises with the shares of the groups, and is
// linear in P(C). Bounds of three shares add up; with few pairs those of the fine realisations alone are narrower.
EventEstimate TwoLevelCounts::estimate(Real confidence) const
{
  const PairGroup all{with.n + without.n, with.happened + without.happened, with.unknown + without.unknown};
  EventEstimate e{all.happened, all.known(), all.unknown};
  e.counts_alike = false;
  const Real of_half = 0.5 + 0.5 * confidence, of_each = 1.0 - (1.0 - of_half) / 3.0;
  const Bounds of_coarse = clopper_pearson(coarse, n, of_each), a = bounds_of(with, of_each),
               b = bounds_of(without, of_each), alone = bounds_of(all, of_half);
  const auto mix = [](Real p, Real of_with, Real of_without) { return p * of_with + (1.0 - p) * of_without; };
  e.bounds = {std::max(alone.low, std::min(mix(of_coarse.low, a.low, b.low), mix(of_coarse.high, a.low, b.low))),
      std::min(alone.high, std::max(mix(of_coarse.low, a.high, b.high), mix(of_coarse.high, a.high, b.high)))};
  const bool tells = (coarse == 0 || with.known() > 0) && (coarse == n || without.known() > 0);
  if (n == 0 || !tells) return e;
  const auto fine = [](const PairGroup& pairs) {
    return pairs.known() > 0 ? share(pairs.happened, pairs.known()) : 0.0;
  };
  e.weighted = mix(share(coarse, n), fine(with), fine(without));
  return e;
}

// Korn & Graubard, Survey Methodology 24 (1998) 193-201.
std::optional<Bounds> TwoLevelCounts::rough_bounds(Real confidence) const
{
  const auto v = variance_of(*this);
  const auto p = estimate(confidence).weighted;
  if (!v || !p) return std::nullopt;
  const Real pairs = static_cast<Real>(with.known() + without.known()),
             as_many = v->p * (1.0 - v->p) / (v->between / static_cast<Real>(n) + v->within / pairs);
  return clopper_pearson_of(*p * as_many, as_many, confidence);
}

EventEstimate TwoLevelCounts::coarse_alone(Real confidence) const { return estimate_event(coarse, n, 0, confidence); }

// With the times t_c and t_f of a coarse and a fine realisation the variance of a given time is least for m/n =
// sqrt(within t_c / (between t_f)).
std::optional<LevelSavings> find_savings(const TwoLevelCounts& counts, Real coarse_s, Real fine_s, Real confidence)
{
  const auto v = variance_of(counts);
  if (!v || !(coarse_s > 0.0 && fine_s > 0.0)) return std::nullopt;
  const auto n = static_cast<Real>(counts.n), m = static_cast<Real>(counts.with.n + counts.without.n),
             m_known = static_cast<Real>(counts.with.known() + counts.without.known());
  const Real cost = n * coarse_s + m * fine_s,
             alone = v->p * (1.0 - v->p) * fine_s;  // Monte Carlo: time times variance
  LevelSavings s{.coarse_s = coarse_s, .fine_s = fine_s};
  s.same_variance = alone / (cost * (v->between / n + v->within / m_known));
  s.best_share = v->between > 0.0 ? std::min(1.0, std::sqrt(v->within * coarse_s / (v->between * fine_s))) : 1.0;
  s.best_same_variance = alone / ((coarse_s + s.best_share * fine_s) * (v->between + v->within / s.best_share));
  const EventEstimate e = counts.estimate(confidence);
  if (e.failed == 0 && e.weighted)
    s.same_bounds = fine_alone_for_width(*e.weighted, e.bounds.high - e.bounds.low, confidence) * fine_s / cost;
  return s;
}

void prepare_coarse(Study& study, std::vector<Problem>& problems)
{
  const StudySettings& s = study.settings;
  if (s.estimator != Estimator::multilevel) return;
  const std::vector<std::string>& changes = s.multilevel.coarse;
  if (std::string why = refusal_of(study, changes_with(study, changes)); !why.empty()) {
    std::string at = "estimator.coarse";
    for (const std::string& change : changes)
      if (const std::string own = refusal_of(study, changes_with(study, {change})); !own.empty()) {
        at = join_path(at, change.substr(0, change.find('='))), why = own;
        break;
      }
    return problems.push_back({at, "the case does not take `coarse`", why, ""});
  }
  try {
    study.coarse.emplace();
    study.coarse->base = read_case_text(study.case_text, study.case_path, changes_with(study, changes));
    study.coarse->mesh = std::make_shared<const Mesh<2>>(build_mesh(study.coarse->base.values));
  } catch (const InputError& error) {
    problems.push_back({"estimator.coarse", "the case does not take `coarse`", error.what(), ""});
  }
}

void check_levels_differ(const Study& study, std::vector<Problem>& problems)
{
  if (!study.coarse) return;
  if (record_of(study.coarse->base, study.coarse->mesh) == record_of(study.base, study.mesh))
    problems.push_back({"estimator.coarse", "`coarse` changes nothing of the case",
        "Both levels would be the same. Give keys that make a run cheap, as in coarse = { \"mesh.cell\" = 2.0 }.", ""});
  const std::string why = why_not_begun(study.coarse->base, study.coarse->mesh);
  if (!why.empty() && why_not_begun(study.base, study.mesh).empty())
    problems.push_back({"estimator.coarse", "the coarse case cannot be solved", why, ""});
}

std::string record_of_case(const Study& study)
{
  std::string record = record_of(study.base, study.mesh);
  if (study.coarse) record += '\n' + record_of(study.coarse->base, study.coarse->mesh);
  return record;
}

}  // namespace terp
