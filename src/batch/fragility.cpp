// Levels of one sample follow each other, which shows where an event is gone at a higher level. The integral over the
// load is taken by parts, so that the distribution function is enough, between its knots. Bounds of all levels hold at
// once (Bonferroni); only so may they be added up.

#include "batch/fragility.hpp"

#include "model/soils/gaussian_field.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <limits>

namespace terp {
namespace {

using OfLevel = EventEstimate (Sample::*)(Real) const;

/// Loads between which a distribution function is smooth and changes little: its kinks, and quantiles of it.
std::vector<Real> knots_of(const Distribution& g)
{
  std::vector<Real> knots;
  for (const Vec<2>& row : g.table) knots.push_back(row[1]);
  constexpr int n = 32;
  for (int k = 1; k < n; ++k) knots.push_back(g.quantile(static_cast<Real>(k) / n));
  for (const Real p : {1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2}) {
    knots.push_back(g.quantile(p));
    knots.push_back(g.quantile(1.0 - p));
  }
  std::ranges::sort(knots);
  return knots;
}

/// int_a^b G(h) dh of a distribution function G, which may rise within a small part of the way.
Real integral_of_probability(const Distribution& g, const std::vector<Real>& knots, Real a, Real b)
{
  Real sum = 0.0;
  const auto add = [&](Real low, Real high) {
    sum += boost::math::quadrature::gauss<Real, 15>::integrate([&g](Real h) { return g.probability(h); }, low, high);
  };
  Real from = a;
  for (const Real knot : knots)
    if (knot > from && knot < b) {
      add(from, knot);
      from = knot;
    }
  add(from, b);
  return sum;
}

struct LevelCounts {
  std::vector<Sample> levels;
  Index n_falling_slides = 0, n_falling_floods = 0;
  bool judges_flood = false;
};

LevelCounts count_levels(const Study& study, const Realisations& rows)
{
  LevelCounts counts;
  counts.levels.assign(static_cast<std::size_t>(study.n_levels()), Sample(study.settings));
  const Index n = TableCounter(study, rows).n();
  bool slid = false, flooded = false;  // of this sample, at the last level where it is known
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    counts.levels[study.level_of(k)].take(r, study.is_coarse(k));
    counts.judges_flood = counts.judges_flood || r.judges_flood;
    if (study.is_coarse(k)) continue;                    // P is of the fine ones
    if (study.level_of(k) == 0) slid = flooded = false;  // another sample
    counts.n_falling_slides += r.solved() && slid && !r.slid;
    counts.n_falling_floods += r.knows_flood() && flooded && !r.flooded;
    if (r.solved() || r.slid) slid = r.slid;  // a level that failed says nothing
    if (r.knows_flood()) flooded = r.flooded;
  }
  return counts;
}

/// Bounds of a curve that does not fall: those of lower levels hold from below, those of higher ones from above.
void narrow_to_rising(std::vector<Bounds>& bounds)
{
  for (std::size_t k = 1; k < bounds.size(); ++k) bounds[k].low = std::max(bounds[k].low, bounds[k - 1].low);
  for (std::size_t k = bounds.size() - 1; k-- > 0;) bounds[k].high = std::min(bounds[k].high, bounds[k + 1].high);
}

CurveIntegral integrate(const FragilityLoad& load, const LevelCounts& counts, OfLevel event, Real confidence)
{
  const std::vector<Real>& h = load.levels;
  const std::size_t n = h.size();
  const std::vector<Real> weights = level_weights(h, *load.distribution);
  const Real confidence_of_each = 1.0 - (1.0 - confidence) / static_cast<Real>(n);
  CurveIntegral integral;
  integral.of_line = {0.0, 0.0};
  std::vector<Bounds> bounds;
  std::vector<Real> p;
  for (std::size_t k = 0; k < n; ++k) {
    const EventEstimate e = (counts.levels[k].*event)(confidence_of_each);
    p.push_back(e.probability().value_or(std::numeric_limits<Real>::quiet_NaN()));
    bounds.push_back(e.bounds);
    integral.probability += weights[k] * p[k];
    integral.of_line.low += weights[k] * e.bounds.low, integral.of_line.high += weights[k] * e.bounds.high;
  }
  const auto up_to = [&](std::size_t k) { return load.distribution->probability(h[k]); };
  const auto beyond = [&](Real first, Real last) { return up_to(0) * first + (1.0 - up_to(n - 1)) * last; };
  integral.beyond = beyond(p.front(), p.back());
  integral.beyond_at_most = beyond(bounds.front().high, bounds.back().high);
  narrow_to_rising(bounds);
  if (std::ranges::any_of(bounds, [](const Bounds& b) { return b.low > b.high; })) return integral;  // it falls
  integral.rising = {(1.0 - up_to(n - 1)) * bounds[n - 1].low, up_to(0) * bounds[0].high + 1.0 - up_to(n - 1)};
  for (std::size_t k = 1; k < n; ++k) {
    const Real share = up_to(k) - up_to(k - 1);
    integral.rising->low += share * bounds[k - 1].low, integral.rising->high += share * bounds[k].high;
  }
  return integral;
}

}  // namespace

Real reliability_index(Real p)
{
  constexpr Real infinite = std::numeric_limits<Real>::infinity();
  return p <= 0.0 ? infinite : p >= 1.0 ? -infinite : -normal_quantile(p);
}

// int (h - a)/(b - a) dG = G(b) - int G dh / (b - a), by parts.
std::vector<Real> level_weights(const std::vector<Real>& h, const Distribution& distribution)
{
  std::vector<Real> weights(h.size(), 0.0);
  const std::vector<Real> knots = knots_of(distribution);
  weights.front() += distribution.probability(h.front());
  weights.back() += 1.0 - distribution.probability(h.back());
  for (std::size_t k = 1; k < h.size(); ++k) {
    const Real mean = integral_of_probability(distribution, knots, h[k - 1], h[k]) / (h[k] - h[k - 1]);
    weights[k] += distribution.probability(h[k]) - mean;
    weights[k - 1] += mean - distribution.probability(h[k - 1]);
  }
  return weights;
}

FragilityCurve estimate_fragility(const Study& study, const Realisations& rows)
{
  const FragilityLoad& load = *study.settings.fragility;
  const Real confidence = study.settings.confidence;
  const LevelCounts counts = count_levels(study, rows);
  FragilityCurve curve;
  curve.n_falling_slides = counts.n_falling_slides, curve.n_falling_floods = counts.n_falling_floods;
  curve.judges_flood = counts.judges_flood;
  bool has_all = true, has_all_floods = true;
  for (std::size_t k = 0; k < load.levels.size(); ++k) {
    const Sample& c = counts.levels[k];
    curve.levels.push_back({load.levels[k], c.slide(), {}, {}});
    if (curve.judges_flood)
      curve.levels.back().flood = c.flood(), curve.levels.back().flood_after_slide = c.flood_after_slide();
    has_all = has_all && curve.levels.back().slide.probability().has_value();
    has_all_floods = has_all_floods && curve.levels.back().flood.probability().has_value();
  }
  if (!load.distribution || !has_all) return curve;
  curve.slide = integrate(load, counts, &Sample::slide, confidence);
  if (curve.judges_flood && has_all_floods) curve.flood = integrate(load, counts, &Sample::flood, confidence);
  return curve;
}

}  // namespace terp
