// The top of drained soil without cohesion, where water pushes from below: a slip plane runs in its upper centimetres,
// which carry less than a row of cells does. docs/limits.md, "The top of an aquifer".
// Not for: the film that an import draws there (import/dstability/film.hpp).
#pragma once

#include "model/parts/model.hpp"

#include <vector>

namespace terp {

/// In the middle of a column of the section.
struct BorderPlace {
  Vec<2> x{};              ///< on the border [m]
  Real stress = 0.0;       ///< effective vertical stress there [Pa]
  Real weight = 0.0;       ///< of the soil below in water [N/m^3]
  Real friction = 0.0;     ///< tan of its friction angle [-]
  bool is_pushed = false;  ///< by water of more pressure than that of the phreatic line
  /// What a row of cells of this height [m] carries more than its top [Pa]; zero where that is less than a tenth.
  Real carried_more(Real row) const;
};

struct WeakBorder {
  Index material = -1;              ///< of the soil below
  Real width = 0.0;                 ///< of the columns [m]
  std::vector<BorderPlace> places;  ///< from left to right

  Real from() const { return places.front().x[0] - 0.5 * width; }
  Real to() const { return places.back().x[0] + 0.5 * width; }
  /// Summed over the places [N per m].
  Real carried_more(Real row) const;
};

/// Stretches on which a row of cells of this height [m] carries at least a tenth more than its top, in this water.
/// Soil whose friction angle varies from place to place is taken as meant, as that of a film. None with a body that
/// came as points, nor in water of a formula that speaks of the time.
std::vector<WeakBorder> find_weak_borders(const Model& model, const WaterSituation& situation, Real row);

}  // namespace terp
