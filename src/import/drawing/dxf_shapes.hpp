// Bent lines of a drawing as chords, and places of blocks where they are inserted.
// Not for: reading the text (dxf_file.hpp).
#pragma once

#include "math/types.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace terp {

/// x to matrix x + shift.
struct DxfPlacement {
  Real xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
  Vec<2> shift{0.0, 0.0};

  Vec<2> operator()(Vec<2> x) const { return {xx * x[0] + xy * x[1] + shift[0], yx * x[0] + yy * x[1] + shift[1]}; }
  Real largest() const { return std::max({std::abs(xx), std::abs(xy), std::abs(yx), std::abs(yy), 1e-9}); }
};

/// First `inner`, then `outer`.
DxfPlacement joined(const DxfPlacement& outer, const DxfPlacement& inner);

/// Where an INSERT puts a block. rotation [degrees].
DxfPlacement placement_of(Vec<2> at, Vec<2> base, Vec<2> scale, Real rotation);

/// Appends chords of the arc from places.back() to b, without that place; bulge: the tangent of a quarter of its angle,
/// left is positive. No chord is farther than `tolerance` from the arc.
void append_arc(std::vector<Vec<2>>& places, Vec<2> b, Real bulge, Real tolerance);

/// Chords of an ARC, counter-clockwise from one angle to the other [degrees].
std::vector<Vec<2>> arc_chords(Vec<2> centre, Real radius, Real from, Real to, Real tolerance);

/// Chords of an ELLIPSE about its centre from one parameter to the other [rad]; `minor` is at a quarter of a turn.
std::vector<Vec<2>> ellipse_chords(Vec<2> centre, Vec<2> major, Vec<2> minor, Real from, Real to, Real tolerance);

struct DxfSpline {
  std::size_t degree = 3;
  std::vector<Real> knots = {}, weights = {};  ///< no weights: all are 1
  std::vector<Vec<2>> control = {}, fit = {};
};

/// Chords of a SPLINE; empty if its numbers do not fit together.
std::vector<Vec<2>> spline_chords(const DxfSpline& spline, Real tolerance);

/// An entity as it stands in the file, in units of the drawing.
struct DxfEntity {
  static constexpr Real missing = std::numeric_limits<Real>::quiet_NaN();

  std::string kind;
  std::string handle = {}, layer = "0", block = {};
  std::vector<Vec<2>> places = {};
  std::vector<Real> bulges = {};  ///< of the side that begins at each place
  Vec<2> end{missing, missing};
  std::vector<Real> z = {};  ///< all that are given
  int flags = 0, columns = 1, rows = 1;
  Real radius = 0.0, rotation = 0.0, to_angle = 0.0;
  Vec<2> scale{1.0, 1.0}, spacing{0.0, 0.0};  ///< of an ELLIPSE `scale` is from and to [rad], `radius` the ratio
  DxfSpline spline = {};
  std::vector<std::pair<int, Real>> hatch = {};  ///< code and value, from its paths on; NaN: no number
  bool on_paper = false, turned = false, mirrored = false, hidden = false;

  bool is_line() const { return is({"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "ELLIPSE", "SPLINE"}); }
  bool is(std::initializer_list<const char*> kinds) const { return std::ranges::find(kinds, kind) != kinds.end(); }
};

/// Codes of places, sizes and flags: their values are numbers.
constexpr bool is_number_of_shape(int code)
{
  return (code >= 10 && code < 60) || code == 70 || code == 71 || code == 230;
}

/// Takes a group of an entity that is a line, an insert or a part of these.
void take_group(DxfEntity& e, int code, Real value);

bool is_bent(const DxfEntity& entity);

/// Its places, bent sides as chords. closed: the last side leads to the first place.
std::vector<Vec<2>> chords_of(const DxfEntity& entity, bool closed, Real tolerance);

}  // namespace terp
