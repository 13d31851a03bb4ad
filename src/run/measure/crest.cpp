// Rows are read forwards; the begin of a slide is then sought backwards. The first slide is measured from the first
// place of the crest, whatever time it takes. Later ones are measured from where the crest had settled, and within a
// short time, so that creep is no slide. Places are whole columns, so each comparison has a margin for round-off.

#include "run/measure/crest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real crest_tolerance = 0.05;  // of the surface height [m]; or
constexpr Real settlement = 0.025;      // in heights of the section [-]
constexpr Real settled_for = 0.3;       // the crest has not retreated by more than it may for this long [s]
constexpr Real settled_retreat = 0.05;  // what it may, in heights of the slope [-]
constexpr Real slide_retreat = 0.25;    // retreat that counts as a slide, in heights of the slope [-]
constexpr Real stopped = 0.1;           // of the largest kinetic energy of a slide: it has stopped [-]
constexpr Real crest_round_off = 1e-9;  // of crest places, which are whole columns [m]

/// How far a crest that has settled may retreat, and in what time: a column at least, which of a wide column takes
/// longer.
struct Rest {
  Real length;  ///< [m]
  Real time;    ///< [s]
};

Rest rest_of(const CrestHistory& crest)
{
  const Real length = settled_retreat * crest.slope.height, width = crest.width;
  return width <= length ? Rest{length, settled_for} : Rest{width, settled_for * width / length};
}

/// Place of the crest, larger the farther out [m].
Real place(const CrestHistory& crest, std::size_t row) { return outwards(crest.slope.facing) * crest.x[row]; }

/// The crest as far out as it stands at any row of the next `settled_for`: a surface that leaves its height and comes
/// back did not fail.
std::vector<Real> lasting_places(const CrestHistory& crest)
{
  std::vector<Real> x = crest.x;
  const Real out = outwards(crest.slope.facing);
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t later = k + 1;
         later < x.size() && crest.time[later] - crest.time[k] <= settled_for + crest_round_off; ++later)
      if (out * crest.x[later] > out * x[k]) x[k] = crest.x[later];
  return x;
}

/// First row whose crest stays at rest; the number of rows if there is none.
std::size_t find_settled(const CrestHistory& crest, std::size_t k)
{
  const Rest rest = rest_of(crest);
  const auto& t = crest.time;
  for (std::size_t end = k; k < t.size(); ++k) {
    end = k;
    while (end < t.size() && place(crest, end) >= place(crest, k) - rest.length - crest_round_off &&
           t[end] - t[k] < rest.time - crest_round_off)
      ++end;
    if (end == t.size()) return end;
    if (place(crest, end) >= place(crest, k) - rest.length - crest_round_off) return end;
  }
  return k;
}

/// First row after k by which the crest has retreated by `length` within `settled_for`, or from one row to the next if
/// rows are rarer: a slide, not creep.
std::size_t find_slide(const CrestHistory& crest, std::size_t k, Real length)
{
  for (std::size_t end = k; end < crest.x.size(); ++end) {
    while (k + 1 < end && crest.time[end] - crest.time[k] > settled_for + crest_round_off) ++k;
    for (std::size_t from = k; from < end; ++from)
      if (place(crest, end) <= place(crest, from) - length + crest_round_off) return end;
  }
  return crest.x.size();
}

/// First row whose crest lies by `length` behind its first place.
std::size_t find_retreat(const CrestHistory& crest, Real length)
{
  std::size_t k = 0;
  while (k < crest.x.size() && place(crest, k) > place(crest, 0) - length + crest_round_off) ++k;
  return k;
}

/// Retreat of the crest that counts as a slide: a quarter of the height of the slope, at least two columns [m].
Real slide_length(const CrestHistory& crest) { return std::max(slide_retreat * crest.slope.height, 2.0 * crest.width); }

/// First row, from `from` on, of the retreat that has come to row k: there the crest stood more than at rest behind its
/// place at row `from`.
std::size_t find_begin(const CrestHistory& crest, std::size_t from, std::size_t k)
{
  while (k > from && place(crest, k - 1) < place(crest, from) - rest_of(crest).length - crest_round_off) --k;
  return k;
}

void follow_motion(const CrestHistory& crest, std::size_t begin, std::size_t end, Slide& slide)
{
  end = std::min(end, crest.kinetic.size());
  std::size_t peak = begin;
  for (std::size_t k = begin; k < end; ++k)
    if (crest.kinetic[k] > slide.kinetic_peak) slide.kinetic_peak = crest.kinetic[k], peak = k;
  for (std::size_t k = peak; k < end && !slide.stops; ++k)
    if (crest.kinetic[k] <= stopped * slide.kinetic_peak) slide.stops = crest.time[k];
}

/// Columns seen from behind a slope: the k-th of n.
Index from_behind(const Slope& slope, Index n, Index k) { return slope.facing == Facing::right ? k : n - 1 - k; }

/// A run of columns from behind, as columns from the left.
Standing as_columns(const Slope& slope, Index n, Index begin, Index end)
{
  return slope.facing == Facing::right ? Standing{begin, end} : Standing{n - end, n - begin};
}

}  // namespace

Real standing_tolerance(Real relief) { return std::max(crest_tolerance, settlement * relief); }

Standing find_standing(const Section& section, const Slope& slope, bool alone, const std::vector<Real>& heights,
    std::span<const std::uint8_t> kept)
{
  const Real tolerance = standing_tolerance(slope.relief);
  const Index n = section.columns.n;
  const auto first_height = [&](Index k) { return section.heights[from_behind(slope, n, k)]; };
  const auto stands = [&](Index k) {
    const Index column = from_behind(slope, n, k);
    if (!kept.empty() && kept[column] != 0) return true;
    return std::isfinite(first_height(k)) && std::abs(heights[column] - first_height(k)) <= tolerance;
  };
  const Index end = slope.facing == Facing::right ? slope.last : n - slope.first;
  Index begin = 0;
  while (begin < end && !std::isfinite(first_height(begin)))
    ++begin;  // the last column may hold no soil where the mesh ends in it
  Standing best;
  Real highest = 0.0;
  for (Index k = begin; k < end; ++k) {
    Index stop = k;
    Real top = -std::numeric_limits<Real>::infinity();
    for (; stop < end && stands(stop); ++stop) top = std::max(top, first_height(stop));
    const bool longer = stop - k > best.last - best.first;
    const bool higher = best.last == best.first || top > highest + crest_tolerance;
    if (stop > k && (higher || (longer && top > highest - crest_tolerance))) best = {k, stop}, highest = top;
    if (alone) break;
    k = stop;
  }
  return as_columns(slope, n, best.first, best.last);
}

Real find_crest(const Section& section, const Slope& slope, const Standing& standing)
{
  if (standing.first == standing.last) return std::nan("");
  const Index edge =
      slope.facing == Facing::right ? std::min(standing.last, slope.last) : std::max(standing.first, slope.first);
  return section.columns.left + edge * section.columns.width;
}

Real crest_height(
    const Section& section, const Slope& slope, const Standing& standing, const std::vector<Real>& heights)
{
  if (standing.first == standing.last) return std::nan("");
  const Index column =
      slope.facing == Facing::right ? std::min(standing.last, slope.last) - 1 : std::max(standing.first, slope.first);
  return column >= 0 && column < section.columns.n ? heights[column] : std::nan("");
}

Real back_of(const Section& section, const Slope& slope)
{
  return section.columns.left + (slope.facing == Facing::right ? 0 : section.columns.n) * section.columns.width;
}

std::vector<Slide> find_slides(const CrestHistory& history)
{
  CrestHistory crest = history;
  crest.x = lasting_places(history);
  const auto& x = crest.x;
  std::vector<Slide> slides;
  std::vector<std::size_t> begins;
  std::size_t from = 0;  // row at which the crest last was at rest
  std::size_t k = x.empty() ? 0 : find_retreat(crest, slide_length(crest));
  while (k < x.size()) {
    begins.push_back(find_begin(crest, from, k));
    slides.push_back({.begins = crest.time[begins.back()],
        .stops = {},
        .crest_from = x[from],
        .crest_to = x.back(),
        .facing = crest.slope.facing});
    from = find_settled(crest, k);
    if (from == x.size() || (crest.ends && outwards(crest.slope.facing) * (x[from] - *crest.ends) <= crest_round_off))
      break;
    k = find_slide(crest, from, slide_length(crest));
  }
  for (std::size_t s = 1; s < slides.size(); ++s) slides[s].crest_from = slides[s - 1].crest_to = x[begins[s] - 1];
  for (std::size_t s = 0; s < slides.size(); ++s)
    follow_motion(crest, begins[s], s + 1 < slides.size() ? begins[s + 1] : x.size(), slides[s]);
  return slides;
}

std::optional<Real> second_failure_time(const CrestHistory& crest)
{
  const auto slides = find_slides(crest);
  return slides.size() > 1 ? std::optional(slides[1].begins) : std::nullopt;
}

}  // namespace terp
