// A spline is sampled by de Boor's algorithm in each of its spans, and samples that the others show are left out.

#include "import/drawing/dxf_shapes.hpp"

#include "math/plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terp {
namespace {

constexpr int samples_per_span = 32;
constexpr Real most_chords = 720.0;  // of an arc

int n_chords(Real radius, Real angle, Real tolerance)
{
  const Real most = 2.0 * std::acos(std::max(0.0, 1.0 - tolerance / radius));
  return static_cast<int>(std::clamp(std::ceil(std::abs(angle) / most), 1.0, most_chords));
}

/// Leaves out places between `first` and `last` that lie within `tolerance` of the chords that remain.
void keep_corners(
    const std::vector<Vec<2>>& all, std::size_t first, std::size_t last, Real tolerance, std::vector<Vec<2>>& kept)
{
  const Vec<2> a = all[first], b = all[last];
  const Real length = distance(a, b);
  std::size_t farthest = first;
  Real most = tolerance;
  for (std::size_t k = first + 1; k < last; ++k) {
    const Real off = length > 0.0 ? std::abs(cross(a, b, all[k])) / length : distance(a, all[k]);
    if (off > most) most = off, farthest = k;
  }
  if (farthest != first) {
    keep_corners(all, first, farthest, tolerance, kept);
    keep_corners(all, farthest, last, tolerance, kept);
  } else {
    kept.push_back(b);
  }
}

/// The place at t in the span from knots[k] on.
Vec<2> de_boor(const DxfSpline& s, std::size_t k, Real t)
{
  std::vector<std::array<Real, 3>> d(s.degree + 1);
  for (std::size_t j = 0; j <= s.degree; ++j) {
    const std::size_t at = j + k - s.degree;
    const Real w = s.weights.empty() ? 1.0 : s.weights[at];
    d[j] = {w * s.control[at][0], w * s.control[at][1], w};
  }
  for (std::size_t r = 1; r <= s.degree; ++r)
    for (std::size_t j = s.degree; j >= r; --j) {
      const Real low = s.knots[j + k - s.degree], high = s.knots[j + 1 + k - r];
      const Real part = high > low ? (t - low) / (high - low) : 0.0;
      for (std::size_t c = 0; c < 3; ++c) d[j][c] = std::lerp(d[j - 1][c], d[j][c], part);
    }
  return {d[s.degree][0] / d[s.degree][2], d[s.degree][1] / d[s.degree][2]};
}

}  // namespace

DxfPlacement joined(const DxfPlacement& outer, const DxfPlacement& inner)
{
  return {outer.xx * inner.xx + outer.xy * inner.yx, outer.xx * inner.xy + outer.xy * inner.yy,
      outer.yx * inner.xx + outer.yy * inner.yx, outer.yx * inner.xy + outer.yy * inner.yy, outer(inner.shift)};
}

DxfPlacement placement_of(Vec<2> at, Vec<2> base, Vec<2> scale, Real rotation)
{
  const Real angle = rotation * std::numbers::pi / 180.0, c = std::cos(angle), s = std::sin(angle);
  DxfPlacement place{c * scale[0], -s * scale[1], s * scale[0], c * scale[1], {0.0, 0.0}};
  const Vec<2> moved = place(base);
  place.shift = {at[0] - moved[0], at[1] - moved[1]};
  return place;
}

void append_arc(std::vector<Vec<2>>& places, Vec<2> b, Real bulge, Real tolerance)
{
  const Vec<2> a = places.back();
  const Real chord = distance(a, b), angle = 4.0 * std::atan(bulge);
  if (!(chord > 0.0)) return;
  const Real radius = chord / (2.0 * std::abs(std::sin(0.5 * angle)));
  const Real off = 0.25 * (1.0 - bulge * bulge) / bulge;  // of the centre from the chord, to its left, in chords
  const Vec<2> centre{0.5 * (a[0] + b[0]) - off * (b[1] - a[1]), 0.5 * (a[1] + b[1]) + off * (b[0] - a[0])};
  const Real from = std::atan2(a[1] - centre[1], a[0] - centre[0]);
  const int n = n_chords(radius, angle, tolerance);
  for (int k = 1; k < n; ++k) {
    const Real at = from + angle * k / n;
    places.push_back({centre[0] + radius * std::cos(at), centre[1] + radius * std::sin(at)});
  }
}

std::vector<Vec<2>> arc_chords(Vec<2> centre, Real radius, Real from, Real to, Real tolerance)
{
  const Real turn = 2.0 * std::numbers::pi, first = from * std::numbers::pi / 180.0;
  Real angle = std::fmod(to - from, 360.0) * std::numbers::pi / 180.0;
  if (angle <= 0.0) angle += turn;
  const int n = n_chords(radius, angle, tolerance);
  std::vector<Vec<2>> places;
  for (int k = 0; k <= n; ++k) {
    const Real at = first + angle * k / n;
    places.push_back({centre[0] + radius * std::cos(at), centre[1] + radius * std::sin(at)});
  }
  return places;
}

std::vector<Vec<2>> ellipse_chords(Vec<2> centre, Vec<2> major, Vec<2> minor, Real from, Real to, Real tolerance)
{
  const Real degree = 180.0 / std::numbers::pi, length = std::max(distance(major, {0, 0}), distance(minor, {0, 0}));
  std::vector<Vec<2>> places = arc_chords({0.0, 0.0}, 1.0, degree * from, degree * to, tolerance / length);
  for (Vec<2>& p : places)
    p = {centre[0] + p[0] * major[0] + p[1] * minor[0], centre[1] + p[0] * major[1] + p[1] * minor[1]};
  if (distance(places.front(), places.back()) < 1e-6 * length) places.back() = places.front();  // a whole one
  return places;
}

std::vector<Vec<2>> spline_chords(const DxfSpline& s, Real tolerance)
{
  if (s.control.empty()) return s.fit;
  const bool is_whole = s.degree >= 1 && s.degree <= 10 && s.control.size() > s.degree &&
                        s.knots.size() == s.control.size() + s.degree + 1 && std::ranges::is_sorted(s.knots) &&
                        (s.weights.empty() || (s.weights.size() == s.control.size() &&
                                                  std::ranges::all_of(s.weights, [](Real w) { return w > 0.0; })));
  if (!is_whole) return {};
  std::vector<Vec<2>> all, kept;
  for (std::size_t k = s.degree; k < s.control.size(); ++k)
    if (s.knots[k + 1] > s.knots[k])
      for (int i = all.empty() ? 0 : 1; i <= samples_per_span; ++i)
        all.push_back(de_boor(s, k, std::lerp(s.knots[k], s.knots[k + 1], static_cast<Real>(i) / samples_per_span)));
  if (all.size() < 2) return {};
  const std::size_t middle = all.size() / 2;  // a closed one has no chord from end to end
  kept.push_back(all.front());
  keep_corners(all, 0, middle, tolerance, kept);
  keep_corners(all, middle, all.size() - 1, tolerance, kept);
  return kept;
}

void take_group(DxfEntity& e, int code, Real value)
{
  switch (code) {
    case 10: e.places.push_back({value, DxfEntity::missing}), e.bulges.push_back(0.0); break;
    case 20:
      if (!e.places.empty()) e.places.back()[1] = value;
      break;
    case 11:
      e.end[0] = value;
      if (e.kind == "SPLINE") e.spline.fit.push_back({value, DxfEntity::missing});
      break;
    case 21:
      e.end[1] = value;
      if (!e.spline.fit.empty()) e.spline.fit.back()[1] = value;
      break;
    case 30: e.z.push_back(value); break;
    case 31:
      if (e.kind == "ELLIPSE")
        e.turned = e.turned || value != 0.0;  // its major axis leaves the plane
      else
        e.z.push_back(value);
      break;
    case 40: (e.kind == "SPLINE" ? e.spline.knots.emplace_back() : e.radius) = value; break;
    case 41:
      if (e.kind == "SPLINE") e.spline.weights.push_back(value);
      e.scale[0] = value;
      break;
    case 42:
      e.scale[1] = value;
      if (!e.bulges.empty() && e.is({"LWPOLYLINE", "VERTEX"})) e.bulges.back() = value;
      break;
    case 44: e.spacing[0] = value; break;
    case 45: e.spacing[1] = value; break;
    case 50: e.rotation = value; break;
    case 51: e.to_angle = value; break;
    case 70:
      e.flags = static_cast<int>(value);
      e.columns = std::max(1, e.flags);
      break;
    case 71:
      e.rows = std::max(1, static_cast<int>(value));
      e.spline.degree = static_cast<std::size_t>(e.rows);
      break;
    case 230:
      e.mirrored = std::abs(value + 1.0) < 1e-9;
      e.turned = e.turned || (!e.mirrored && std::abs(value - 1.0) > 1e-9);
      break;
    default: break;
  }
}

bool is_bent(const DxfEntity& entity)
{
  return entity.is({"ARC", "ELLIPSE", "SPLINE"}) || std::ranges::any_of(entity.bulges, [](Real b) { return b != 0.0; });
}

std::vector<Vec<2>> chords_of(const DxfEntity& entity, bool closed, Real tolerance)
{
  if (entity.kind == "SPLINE") {
    DxfSpline spline = entity.spline;
    spline.control = entity.places;
    return spline_chords(spline, tolerance);
  }
  if (entity.kind == "ARC")
    return entity.places.empty() || !(entity.radius > 0.0)
               ? std::vector<Vec<2>>()
               : arc_chords(entity.places[0], entity.radius, entity.rotation, entity.to_angle, tolerance);
  if (entity.kind == "ELLIPSE") {
    const Vec<2> major = entity.end;
    const Real turn = entity.mirrored ? -entity.radius : entity.radius;
    if (entity.places.empty() || !(distance(major, {0, 0}) > 0.0) || !(entity.radius > 0.0)) return {};
    return ellipse_chords(
        entity.places[0], major, {-turn * major[1], turn * major[0]}, entity.scale[0], entity.scale[1], tolerance);
  }
  std::vector<Vec<2>> places;
  const std::size_t n = entity.places.size();
  for (std::size_t k = 0; k < n; ++k) {
    places.push_back(entity.places[k]);
    if (entity.bulges[k] != 0.0 && (closed || k + 1 < n))
      append_arc(places, entity.places[(k + 1) % n], entity.bulges[k], tolerance);
  }
  return places;
}

}  // namespace terp
