// A path is a polyline (bit 2 of code 92), or edges: lines, arcs, ellipses, splines. Angles of arcs that run clockwise
// are mirrored in the file.

#include "import/drawing/dxf_hatch.hpp"

#include "math/nan.hpp"
#include "math/plane.hpp"
#include "model/bodies/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terp {
namespace {

using Path = std::vector<Vec<2>>;
using HatchGroups = std::vector<std::pair<int, Real>>;

class HatchReader {
 public:
  HatchReader(const HatchGroups& groups, Real tolerance) : groups_(groups), tolerance_(tolerance) {}

  /// The next path; empty if it is not whole.
  bool next(Path& path)
  {
    while (at_ < groups_.size() && groups_[at_].first != 92) ++at_;
    if (at_ == groups_.size()) return false;
    const Real flags = groups_[at_++].second;
    const bool is_polyline = flags >= 0.0 && flags < 1e6 && (static_cast<int>(flags) & 2) != 0;
    path = is_polyline ? polyline() : edges();
    if (path.size() > 1 && distance(path.front(), path.back()) <= tolerance_) path.pop_back();
    const bool is_whole =
        path.size() >= 3 && std::ranges::none_of(path, [](Vec<2> x) { return !std::isfinite(x[0] + x[1]); });
    if (!is_whole) path.clear();
    return true;
  }

 private:
  /// The value of the next group if it has this code, else NaN.
  Real take(int code) { return at_ < groups_.size() && groups_[at_].first == code ? groups_[at_++].second : nan; }

  Vec<2> take_place(int code)
  {
    const Real x = take(code);
    return {x, take(code + 10)};
  }

  /// A number of things that follow, each of at least one group.
  std::size_t take_count(int code)
  {
    const Real n = take(code);
    return n >= 0.0 && n <= static_cast<Real>(groups_.size() - at_) ? static_cast<std::size_t>(n) : 0;
  }

  Path polyline()
  {
    take(72), take(73);
    const std::size_t n = take_count(93);
    DxfEntity line{"LWPOLYLINE"};
    for (std::size_t k = 0; k < n; ++k) {
      line.places.push_back(take_place(10));
      const Real bulge = take(42);
      line.bulges.push_back(std::isnan(bulge) ? 0.0 : bulge);
    }
    return chords_of(line, true, tolerance_);
  }

  Path edges()
  {
    const std::size_t n = take_count(93);
    Path path;
    for (std::size_t k = 0; k < n; ++k) {
      Path edge = this->edge();
      if (edge.empty()) return {};
      const bool begins_here =
          path.empty() || distance(path.back(), edge.front()) <= distance(path.back(), edge.back());
      if (!begins_here) std::ranges::reverse(edge);
      path.insert(path.end(), edge.begin() + (path.empty() ? 0 : 1), edge.end());
    }
    return path;
  }

  Path edge()
  {
    switch (const Real kind = take(72); kind >= 1.0 && kind <= 4.0 ? static_cast<int>(kind) : 0) {
      case 1: {
        const Vec<2> from = take_place(10);
        return {from, take_place(11)};
      }
      case 2: {
        const Vec<2> centre = take_place(10);
        const Real radius = take(40), from = take(50), to = take(51);
        const bool is_mirrored = take(73) == 0.0;
        if (!(radius > 0.0) || !std::isfinite(from + to)) return {};
        Path chords = arc_chords({0.0, 0.0}, radius, from, to, tolerance_);
        for (Vec<2>& x : chords) x = {centre[0] + x[0], centre[1] + (is_mirrored ? -x[1] : x[1])};
        return chords;
      }
      case 3: return ellipse();
      case 4: return spline();
      default: return {};
    }
  }

  Path ellipse()
  {
    const Vec<2> centre = take_place(10), major = take_place(11);
    const Real ratio = take(40), from = take(50), to = take(51);
    const Real side = take(73) == 0.0 ? -ratio : ratio;
    if (!(ratio > 0.0) || !(length(major) > 0.0) || !std::isfinite(from + to)) return {};
    const auto parameter = [&](Real degrees) {  // of the place that is seen at this angle
      const Real angle = degrees * std::numbers::pi / 180.0, turn = 2.0 * std::numbers::pi;
      return std::atan2(std::sin(angle) / ratio, std::cos(angle)) + turn * std::round(angle / turn);
    };
    return ellipse_chords(
        centre, major, {-side * major[1], side * major[0]}, parameter(from), parameter(to), tolerance_);
  }

  Path spline()
  {
    DxfSpline spline;
    const Real degree = take(94);
    spline.degree = degree >= 1.0 && degree <= 10.0 ? static_cast<std::size_t>(degree) : 0;
    take(73), take(74);
    const std::size_t n_knots = take_count(95), n_control = take_count(96);
    for (std::size_t k = 0; k < n_knots; ++k) spline.knots.push_back(take(40));
    for (std::size_t k = 0; k < n_control; ++k) {
      spline.control.push_back(take_place(10));
      if (const Real weight = take(42); !std::isnan(weight)) spline.weights.push_back(weight);
    }
    const std::size_t n_fit = take_count(97);  // or that of the path's sources, which follows the last edge
    for (std::size_t k = 0; k < n_fit; ++k) take_place(11);
    while (at_ < groups_.size() && (groups_[at_].first % 10 == 2 || groups_[at_].first % 10 == 3) &&
           groups_[at_].first < 30)
      ++at_;  // tangents, 12 to 23
    return std::ranges::any_of(spline.knots, [](Real knot) { return std::isnan(knot); })
               ? Path()
               : spline_chords(spline, tolerance_);
  }

  const HatchGroups& groups_;
  Real tolerance_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<std::vector<Vec<2>>> hatch_outlines(
    const std::vector<std::pair<int, Real>>& groups, Real tolerance, std::size_t& n_holes)
{
  std::vector<Path> paths, outlines;
  HatchReader reader(groups, tolerance);
  for (Path path; reader.next(path);)
    if (!path.empty()) paths.push_back(std::move(path));
  for (const Path& path : paths) {
    const auto n_around =
        std::ranges::count_if(paths, [&](const Path& other) { return &other != &path && contains(other, path[0]); });
    if (n_around % 2 == 0)
      outlines.push_back(path);
    else
      ++n_holes;
  }
  return outlines;
}

}  // namespace terp
