// Outlines of soils, names and stretches under loads that move with the material points.
// Not for: the outline at t = 0 and the water (backdrop).
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "page/shown.hpp"
#include "model/case/case.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace terp {

/// Lines of places that each go with a point: its place plus an offset that stays.
struct AttachedLines {
  static constexpr std::uint32_t gap = std::numeric_limits<std::uint32_t>::max();  ///< between two lines

  std::vector<std::uint32_t> points;  ///< number among the points shown, or gap
  std::vector<float> offsets;         ///< dx, dy [m], shape [n, 2]

  bool is_empty() const { return points.empty(); }
};

struct SoilLayer {
  std::string soil;      ///< its name in the case
  AttachedLines lines;   ///< outlines of its bodies
  AttachedLines middle;  ///< one place for its name; empty if none of its points is shown
};

/// Points shown at the start: where, and of which material; NaN: there is no soil of the point.
struct PointsAtStart {
  std::span<const Real> places;     ///< [m], shape [n, 2]
  std::span<const Real> materials;  ///< shape [n]
  Real spacing = 0.0;               ///< typical distance [m]
};

/// In the order of the bodies. What another body covers of an outline is left out: none of the soil's points is near.
std::vector<SoilLayer> attach_layers(const Case& description, const Mesh<2>& mesh, const PointsAtStart& points);

/// The surface of the soil from x = from to x = to, on the highest points there.
AttachedLines attach_surface(const PointsAtStart& points, Real from, Real to);

}  // namespace terp
