// A change between two frames is what nearly all points stay below: a few that fly about decide nothing. Noise of a
// field at rest does not add up from frame to frame, so frames are compared with the last that is kept.

#include "page/thin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real a_move = 1.0 / 100.0;           // of the width of the section: some 12 pixels
constexpr Real a_colour = 1.0 / 10.0;          // of a colour scale
constexpr Real longest_gap = 1.0 / 16.0;       // of the time of the run
constexpr Real moving = 0.99, changing = 0.9;  // share of the points that stay below the change
constexpr std::size_t every = 7;               // which points are compared

/// The change that a share of the points stay below, in steps; where a point comes or goes it is without bounds.
Real change(const Codes& a, const Codes& b, Real share)
{
  std::vector<Real> changes;
  for (std::size_t p = 0; p < a.size(); p += every)
    changes.push_back((a[p] == no_value) != (b[p] == no_value) ? std::numeric_limits<Real>::infinity()
                                                               : std::abs(static_cast<Real>(a[p] - b[p])));
  if (changes.empty()) return 0.0;
  const auto at = changes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<Real>(changes.size() - 1));
  std::nth_element(changes.begin(), at, changes.end());
  return *at;
}

bool is_seen(const ShownRun& run, std::size_t from, std::size_t to)
{
  const Real move = a_move * (run.bounds[2] - run.bounds[0]);
  if (run.x.step * change(run.x_codes[from], run.x_codes[to], moving) > move) return true;
  if (run.y.step * change(run.y_codes[from], run.y_codes[to], moving) > move) return true;
  return std::ranges::any_of(run.fields, [&](const ShownField& field) {
    return field.frames.size() > 1 && field.scale.step * change(field.frames[from], field.frames[to], changing) >
                                          a_colour * (field.high - field.low);
  });
}

std::size_t nearest(const std::vector<Real>& times, Real time)
{
  return static_cast<std::size_t>(
      std::ranges::min_element(times, {}, [&](Real t) { return std::abs(t - time); }) - times.begin());
}

/// Which frames of runs of the same times are missed if they go.
std::vector<std::size_t> missed(const std::vector<const ShownRun*>& runs)
{
  const std::vector<Real>& times = runs[0]->times;
  std::vector<bool> is_moment(times.size());
  for (const ShownRun* run : runs)
    for (const Real moment : run->moments) is_moment[nearest(times, moment)] = true;
  std::vector<std::size_t> kept{0};
  for (std::size_t k = 1; k < times.size(); ++k) {
    const bool is_last = k + 1 == times.size();
    if (is_last || is_moment[k] || times[k + 1] - times[kept.back()] > longest_gap * (times.back() - times.front()) ||
        std::ranges::any_of(runs, [&](const ShownRun* run) { return is_seen(*run, kept.back(), k + 1); }))
      kept.push_back(k);
  }
  return kept;
}

}  // namespace

std::vector<Real> moments_of(const Summary& summary)
{
  std::vector<Real> moments;
  for (const SlideSummary& slide : summary.slides) {
    moments.insert(moments.end(), {slide.slide.begins, slide.slip.time});
    if (slide.slide.stops) moments.push_back(*slide.slide.stops);
  }
  for (const StageSummary& stage : summary.stages)
    moments.insert(moments.end(), {stage.record.start, stage.record.end});
  if (summary.flood)
    for (const auto& time : {summary.flood->first_time_damaged, summary.flood->first_time_below})
      if (time) moments.push_back(*time);
  std::erase_if(moments, [](Real time) { return std::isnan(time); });
  return moments;
}

void leave_out_unmissed_frames(std::vector<ShownRun>& runs)
{
  std::vector<bool> done(runs.size());
  for (std::size_t first = 0; first < runs.size(); ++first) {
    if (done[first]) continue;
    std::vector<const ShownRun*> alike;
    const std::vector<Real> times = runs[first].times;
    const auto is_alike = [&](const ShownRun& run) { return run.times == times; };
    for (const ShownRun& run : runs)
      if (is_alike(run)) alike.push_back(&run);
    const std::vector<std::size_t> kept = missed(alike);
    for (std::size_t k = first; k < runs.size(); ++k)
      if (is_alike(runs[k])) keep_frames(runs[k], kept), done[k] = true;
  }
}

}  // namespace terp
