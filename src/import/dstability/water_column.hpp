// The water of a stage along a vertical line. docs/dstability.md.
// Not for: the cap by the total stress and the pressure of loads (section.hpp), the water of a case (water/).
#pragma once

#include "import/dstability/project.hpp"

#include <vector>

namespace terp {

class StixWaterColumn {
 public:
  /// ground: elevation of the surface at x [m].
  StixWaterColumn(const StixWater& water, Real x, Real ground);

  /// Elevation up to which there is water, free water included [m]; minus infinity without any.
  Real phreatic() const { return phreatic_; }
  /// Height of the water above the ground [m].
  Real free_water() const;
  Real unit_weight() const { return unit_weight_; }  ///< [N/m^3]
  /// Pressure of the water alone, before any cap [Pa]; zero above the phreatic line.
  Real pressure(Real z) const;
  /// Whether the soil at z counts as below the water: below the phreatic line, in a mesh where there is pressure.
  bool is_below(Real z) const { return is_mesh_ ? pressure(z) > 0.0 : z < phreatic_; }

 private:
  /// An elevation with the pressure just above and just below it.
  struct Level {
    Real z, above, below;
  };
  void read_lines(const StixWater& water, Real x);
  void read_mesh(const StixWater& water, Real x);

  bool is_mesh_;
  Real unit_weight_, ground_, phreatic_;
  std::vector<Level> levels_;  ///< from the highest down; the pressure is linear between two, hydrostatic beyond
};

}  // namespace terp
