// A slide floods the land at a level that lies above the ground which it left. That ground is known of each slide, at
// the level of the water with which it was solved; at other levels it is taken to be the same. So between two levels of
// a load the share goes over from the slides of the lower one to those of the higher one, linearly, as its bounds do.

#include "batch/height_curve.hpp"

#include "batch/fragility_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr int n_places = 60;

/// Heights that the slides of one level of a load left [m], ascending, and slides of which it is not known.
struct SlideHeights {
  std::vector<Real> heights = {};
  std::int64_t unknown = 0;

  EventEstimate at(Real level, Real confidence) const
  {
    const auto below = std::ranges::lower_bound(heights, level) - heights.begin();
    return estimate_event(below, std::ssize(heights), unknown, confidence);
  }
};

std::vector<SlideHeights> heights_of(const Study& study, const Realisations& rows)
{
  static const std::size_t height = outcome_number("residual_height");
  std::vector<SlideHeights> levels(static_cast<std::size_t>(study.n_levels()));
  const Index n = TableCounter(study, rows).n();
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    if (!r.slid || study.is_coarse(k)) continue;
    SlideHeights& level = levels[static_cast<std::size_t>(study.level_of(k))];
    if (r.solved() && r.judges_flood && !std::isnan(r.outcomes[height]))
      level.heights.push_back(r.outcomes[height]);
    else
      ++level.unknown;
  }
  for (SlideHeights& level : levels) std::ranges::sort(level.heights);
  return levels;
}

/// Between that of two levels, at w of the way.
EventEstimate interpolated(const EventEstimate& a, const EventEstimate& b, Real w)
{
  EventEstimate e = w < 0.5 ? a : b;
  e.counts_alike = false;
  e.weighted = std::lerp(*a.probability(), *b.probability(), w);
  e.bounds = {std::lerp(a.bounds.low, b.bounds.low, w), std::lerp(a.bounds.high, b.bounds.high, w)};
  return e;
}

std::vector<HeightPlace> curve_of_load(
    const std::vector<Real>& levels, const std::vector<SlideHeights>& slides, Real confidence)
{
  std::vector<HeightPlace> curve;
  for (int k = 0; k <= n_places; ++k) {
    const Real h = std::lerp(levels.front(), levels.back(), static_cast<Real>(k) / n_places);
    const auto above =
        std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(levels, h) - levels.begin(), 1, std::ssize(levels) - 1);
    const auto b = static_cast<std::size_t>(above), a = b - 1;
    if (slides[a].heights.empty() || slides[b].heights.empty()) continue;
    curve.push_back({h, interpolated(slides[a].at(h, confidence), slides[b].at(h, confidence),
                            (h - levels[a]) / (levels[b] - levels[a]))});
  }
  return curve;
}

std::vector<HeightPlace> curve_of_one_level(const SlideHeights& slides, Real confidence)
{
  std::vector<HeightPlace> curve;
  if (slides.heights.empty()) return curve;
  const Real low = slides.heights.front(), high = slides.heights.back();
  const Real margin = 0.05 * std::max(high - low, 0.1);  // so that it begins at 0 and ends at 1
  for (int k = 0; k <= n_places; ++k) {
    const Real h = std::lerp(low - margin, high + margin, static_cast<Real>(k) / n_places);
    curve.push_back({h, slides.at(h, confidence)});
  }
  return curve;
}

}  // namespace

std::vector<HeightPlace> flood_after_slide_over_level(const Study& study, const Realisations& rows)
{
  const StudySettings& s = study.settings;
  if (s.estimator == Estimator::sweep || s.estimator == Estimator::two_stage || info_of(s.estimator).adaptive)
    return {};
  const std::vector<SlideHeights> slides = heights_of(study, rows);
  if (!s.fragility) return curve_of_one_level(slides.front(), s.confidence);
  if (!is_water_level(*s.fragility) || s.fragility->levels.size() < 2) return {};
  return curve_of_load(s.fragility->levels, slides, s.confidence);
}

std::string height_curve_text(const std::vector<HeightPlace>& curve)
{
  std::string out;
  for (const Real p : {0.1, 0.5, 0.9}) {
    const auto place =
        std::ranges::find_if(curve, [&](const HeightPlace& at) { return at.event.probability().value_or(0.0) >= p; });
    if (place != curve.end() && place != curve.begin())
      out += fmt::format("{}{:g} at {:.2f} m", out.empty() ? "" : ", ", p, place->level);
  }
  return out.empty() ? "" : "  P(F|I) by the ground that slides leave: " + out + '\n';
}

std::string height_curve_csv(const std::vector<HeightPlace>& curve)
{
  std::string out = "level,P,low,high\n";
  for (const HeightPlace& at : curve)
    out += fmt::format("{},{},{},{}\n", at.level, at.event.probability().value_or(std::nan("")), at.event.bounds.low,
        at.event.bounds.high);
  return out;
}

}  // namespace terp
