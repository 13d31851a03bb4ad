// The pore pressure that the lines of a water situation give at a place. docs/methods.md, "Water".
// Not for: nodes, soil, caps.
#pragma once

#include "mpm/features/water.hpp"
#include "model/water/water_case.hpp"

#include <array>
#include <span>

namespace terp {

inline constexpr Real least_free_depth = 1e-6;  ///< of water over the ground that counts as free [m]

/// Elevation of a line at x [m]; constant beyond its ends. At a vertical step: of the place that comes last.
Real elevation_at(std::span<const Vec<2>> line, Real x);

/// A head that may follow the water table.
struct Head {
  Real own = 0.0;       ///< [m]
  Real of_table = 0.0;  ///< share of the elevation of the table that comes to it

  Real at(Real table) const { return own + of_table * table; }
};

/// Water along the vertical line through x.
class WaterColumn {
 public:
  WaterColumn(const WaterSituation& situation, Real x);

  Real phreatic() const { return phreatic_; }  ///< elevation [m]
  /// Elevation to which the water at a place of elevation y rises [m]. Above the phreatic line, and from it down to the
  /// first reference line, that of the phreatic line; between two reference lines linear in y; below the last its own.
  Real head(Real y) const;
  /// The same where the table lies elsewhere: from there down to the first reference line that of the table, then as
  /// above.
  Head head_with_table(Real y) const;

 private:
  struct Level {
    Real y;  // [m]
    Head head, head_bottom;
  };
  /// The levels next to a place that lies below the first; the second may be the end.
  std::array<std::vector<Level>::const_iterator, 2> levels_about(Real y) const;

  Real phreatic_;
  std::vector<Level> levels_;  // from the highest down
};

/// gamma_w (head - y), or the formula's value, without any limit: negative above the water [Pa].
Real unlimited_pressure(const WaterCase& water, const WaterSituation& situation, Vec<2> x, Real time);

/// The same, at least zero [Pa].
Real water_pressure(const WaterCase& water, const WaterSituation& situation, Vec<2> x, Real time);

/// To which the water at the ground of an elevation rises: the phreatic line, or what the pressure of a formula says
/// there at t = 0 [m].
Real level_at(Real x, Real ground, const WaterCase& water, const WaterSituation& situation);

/// Where the water of a situation stands, for pictures: its phreatic line, or that of a formula or grid between two
/// corners [m], below which its pressure is more than zero. Empty if there is no water, or the formula speaks of time.
std::vector<Vec<2>> water_table(const WaterCase& water, const WaterSituation& situation, Vec<2> low, Vec<2> high);

/// Number of a situation of a case: 0 is that of the start, k + 1 the k-th of the others.
inline const WaterSituation& situation_of(const WaterCase& water, std::size_t number)
{
  return number == 0 ? water.start : water.situations[number - 1];
}

/// The water at t = 0.
inline const WaterSituation& first_water(const WaterCase& water)
{
  return situation_of(water, water.standing.value_or(0));
}

/// A moment from which on a situation holds: the pressure runs linearly from knot to knot, and stays after the last.
struct WaterKnot {
  Real time;              ///< [s]
  std::size_t situation;  ///< its number
};

/// The start, then the situations that have a time, in the order of their times.
std::vector<WaterKnot> knots_of(const WaterCase& water);

/// Between the knots about a time [s].
WaterWay way_at(std::span<const WaterKnot> knots, Real time);

/// Number of the situation of a name; that of the start where there is none, as for name_of_start.
std::size_t situation_number(const WaterCase& water, std::string_view name);

}  // namespace terp
