// Water as the user describes it, in plain numbers: lines of heads, a formula, or values on a grid.
// Not for: the pressure that follows from it (water_pressure.hpp).
#pragma once

#include "math/types.hpp"

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

inline constexpr std::string_view phreatic_head = "phreatic";  ///< name of the head of the phreatic line
inline constexpr std::string_view name_of_start = "start";     ///< name of the water of [water]

/// The head of a layer: elevation to which its water rises, over x.
struct HeadLine {
  std::string name;
  std::vector<Vec<2>> places;  ///< x ascending, constant beyond both ends [m]
};

/// A line in the soil at which the water has a head of its own. Names: of head lines, or phreatic_head.
struct ReferenceLine {
  std::vector<Vec<2>> places;     ///< as in HeadLine [m]
  std::string head, head_bottom;  ///< names of the heads just above the line and just below it
};

/// Pressure at a place and a time [Pa]; more than zero where there is water.
using PressureFormula = std::function<Real(Vec<2>, Real)>;

enum class WaterKind { lines, seepage };

enum class SectionSide { left, right, bottom };

/// Free water at an end of the section, as far as the ground lies below its level.
struct RiverCase {
  SectionSide side = SectionSide::left;
  Real level = 0.0;  ///< [m]

  bool operator==(const RiverCase&) const = default;
};

/// Free water on a stretch of the ground [m].
struct PondCase {
  std::string name;
  Real from = 0.0, to = 0.0, level = 0.0;

  bool operator==(const PondCase&) const = default;
};

/// The head that the soil has at a side of the section.
struct SideHead {
  std::string name;
  SectionSide side = SectionSide::left;
  Real from = -std::numeric_limits<Real>::infinity();  ///< elevation, at the bottom x [m]
  Real to = std::numeric_limits<Real>::infinity();
  std::vector<Vec<2>> head;   ///< over x, constant beyond both ends; at a side its only place counts [m]
  Real leakage_length = 0.0;  ///< of a layer that goes on beyond the section [m]; 0: the head is right there

  bool operator==(const SideHead&) const = default;
};

/// Lets no water through.
struct WallCase {
  std::string name;
  std::vector<Vec<2>> line;  ///< along sides of cells [m]

  bool operator==(const WallCase&) const = default;
};

/// What flowing water is computed from. Ground where no water stands is a seepage face; what has no head has no flow.
struct SeepageCase {
  std::optional<RiverCase> river;
  std::vector<PondCase> ponds;
  std::vector<SideHead> boundary;

  bool operator==(const SeepageCase&) const = default;
};

/// Water at one moment: lines, or a formula; a grid of values is a formula, too. Computed water has both: the line of
/// its table, and its heads as a formula.
struct WaterSituation {
  std::string name = {};
  Real time = std::numeric_limits<Real>::quiet_NaN();  ///< at which it is reached, linearly from the one before [s]
  std::vector<Vec<2>> phreatic_line = {};              ///< as in HeadLine [m]
  std::vector<HeadLine> head_lines = {};
  std::vector<ReferenceLine> reference_lines = {};
  PressureFormula formula = {};
  std::string formula_text = {};
  bool formula_changes = false;     ///< it speaks of the time
  bool formula_gives_head = false;  ///< its values are heads [m]; else pressures [Pa]
  std::string grid_file = {};       ///< that the formula takes its values from; empty: none
  Vec<2> grid_low{}, grid_high{};   ///< box about its places; beyond it the values of its edge hold [m]
  SeepageCase seepage = {};         ///< of water that is computed

  bool is_given() const { return !phreatic_line.empty() || formula; }
};

/// Which end of the section the river is at.
enum class RiverSide { deduced, left, right };

/// Levels of the river over time.
struct LevelSeries {
  std::vector<Real> times;   ///< ascending, as the table has them [s]
  std::vector<Real> levels;  ///< [m]
  Real shorten = 3600.0;     ///< seconds of the series that take one second of the run
  RiverSide side = RiverSide::left;
  std::vector<std::array<std::function<Real(Real)>, 2>> line = {};  ///< places of the phreatic line by the level [m]
};

struct WaterCase {
  WaterKind kind = WaterKind::lines;
  Real suction_band = 0.0;                 ///< height over which soil dries above computed water [m]; 0: half a cell
  std::vector<WallCase> walls;             ///< in computed water
  Real unit_weight = 9810.0;               ///< of water [N/m^3]
  Real suction = 0.0;                      ///< largest tension in the water above the phreatic line [Pa]
  std::optional<LevelSeries> series = {};  ///< that the situations in time follow from
  bool follow_soil = true;                 ///< the table goes with soil that moves, free water stays where it is fed
  WaterSituation start;                    ///< at t = 0
  std::vector<WaterSituation> situations;  ///< others, in the order of the file
  std::optional<std::size_t> standing;     ///< number of the situation that always holds; none: they have times

  bool is_given() const { return start.is_given() || kind == WaterKind::seepage; }
};

}  // namespace terp
