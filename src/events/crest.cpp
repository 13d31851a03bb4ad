#include "events/crest.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real crest_tolerance = 0.05;  // of the surface height [m]
constexpr Real settled_for = 0.3;       // the crest has not retreated by more than it may for this long [s]
constexpr Real settled_retreat = 0.05;  // what it may, in heights of the first surface [-]
constexpr Real slide_retreat = 0.25;    // retreat that counts as a slide, in heights of the first surface [-]
constexpr Real stopped = 0.1;           // of the largest kinetic energy of a slide: it has stopped [-]
constexpr Real round_off = 1e-9;        // of crest places, which are whole columns [m]

/// How far a crest that has settled may retreat, and in what time: a column at least, which of a wide column takes longer.
struct Rest {
  Real length;  ///< [m]
  Real time;    ///< [s]
};

Rest rest_of(const CrestHistory& crest)
{
  const Real length = settled_retreat * first_height(crest), width = crest.columns.width;
  return width <= length ? Rest{length, settled_for} : Rest{width, settled_for * width / length};
}

/// First row whose crest stays at rest; the number of rows if there is none.
std::size_t find_settled(const CrestHistory& crest, std::size_t k)
{
  const Rest rest = rest_of(crest);
  const auto& t = crest.time;
  for (std::size_t end = k; k < t.size(); ++k) {
    end = k;
    while (end < t.size() && crest.x[end] >= crest.x[k] - rest.length - round_off && t[end] - t[k] < rest.time - round_off) ++end;
    if (end == t.size()) return end;
    if (crest.x[end] >= crest.x[k] - rest.length - round_off) return end;
  }
  return k;
}

/// First row after k by which the crest has retreated by `length` within `settled_for`: a slide, not creep.
std::size_t find_slide(const CrestHistory& crest, std::size_t k, Real length)
{
  for (std::size_t end = k; end < crest.x.size(); ++end) {
    while (crest.time[end] - crest.time[k] > settled_for + round_off) ++k;
    for (std::size_t from = k; from < end; ++from)
      if (crest.x[end] <= crest.x[from] - length + round_off) return end;
  }
  return crest.x.size();
}

/// First row from k on whose crest lies at or left of x.
std::size_t find_retreat(const CrestHistory& crest, std::size_t k, Real x)
{
  while (k < crest.x.size() && crest.x[k] > x + round_off) ++k;
  return k;
}

/// Retreat of the crest that counts as a slide: a quarter of the height of the first surface, at least two columns [m].
Real slide_length(const CrestHistory& crest) { return std::max(slide_retreat * first_height(crest), 2.0 * crest.columns.width); }

/// First row, from `from` on, of the retreat that has come to row k: there the crest stood more than at rest behind its place at row `from`.
std::size_t find_begin(const CrestHistory& crest, std::size_t from, std::size_t k)
{
  while (k > from && crest.x[k - 1] < crest.x[from] - rest_of(crest).length - round_off) --k;
  return k;
}

/// Fills what the kinetic energy of the rows from `begin` to before `end` says.
void follow_motion(const CrestHistory& crest, std::size_t begin, std::size_t end, Slide& slide)
{
  end = std::min(end, crest.kinetic.size());
  std::size_t peak = begin;
  for (std::size_t k = begin; k < end; ++k)
    if (crest.kinetic[k] > slide.kinetic_peak) slide.kinetic_peak = crest.kinetic[k], peak = k;
  for (std::size_t k = peak; k < end && !slide.stops; ++k)
    if (crest.kinetic[k] <= stopped * slide.kinetic_peak) slide.stops = crest.time[k];
}

}  // namespace

Real first_height(const CrestHistory& crest)
{
  Real highest = 0.0;
  for (const Real h : crest.initial_heights)
    if (std::isfinite(h)) highest = std::max(highest, h - crest.base);
  return highest;
}

Real moved_distance(const CrestHistory& crest) { return settled_retreat * first_height(crest); }

CrestHistory start_crest_history(const PointBlocks<2>& points, Real left, Real right, Real column_width)
{
  CrestHistory crest;
  crest.columns = {left, column_width, static_cast<Index>(std::ceil((right - left) / column_width - 1e-9))};
  crest.initial_heights = surface_heights(points, crest.columns);
  crest.base = lowest(points);
  return crest;
}

Real find_crest(const CrestHistory& crest, const PointBlocks<2>& points)
{
  const auto heights = surface_heights(points, crest.columns);
  Index k = 0;
  const auto stands = [&](Index c) {
    return std::isfinite(crest.initial_heights[c]) && std::abs(heights[c] - crest.initial_heights[c]) <= crest_tolerance;
  };
  while (k < crest.columns.n && stands(k)) ++k;
  return crest.columns.left + k * crest.columns.width;
}

Real crest_height(const CrestHistory& crest, const PointBlocks<2>& points, Real crest_x)
{
  const auto column = static_cast<Index>(std::llround((crest_x - crest.columns.left) / crest.columns.width)) - 1;
  return column >= 0 ? surface_heights(points, crest.columns)[static_cast<std::size_t>(column)] : std::nan("");
}

std::vector<Slide> find_slides(const CrestHistory& crest)
{
  const auto& x = crest.x;
  std::vector<Slide> slides;
  std::vector<std::size_t> begins;
  std::size_t from = 0;  // row at which the crest last was at rest
  std::size_t k = x.empty() ? 0 : find_retreat(crest, 0, x[0] - slide_length(crest));
  while (k < x.size()) {
    begins.push_back(find_begin(crest, from, k));
    slides.push_back({.begins = crest.time[begins.back()], .stops = {}, .crest_from = x[from], .crest_to = x.back()});
    from = find_settled(crest, k);
    if (from == x.size()) break;
    slides.back().crest_to = x[from];
    k = find_slide(crest, from, slide_length(crest));
  }
  for (std::size_t s = 0; s < slides.size(); ++s) follow_motion(crest, begins[s], s + 1 < slides.size() ? begins[s + 1] : x.size(), slides[s]);
  return slides;
}

std::optional<Real> second_failure_time(const CrestHistory& crest)
{
  const auto slides = find_slides(crest);
  return slides.size() > 1 ? std::optional(slides[1].begins) : std::nullopt;
}

}  // namespace terp
