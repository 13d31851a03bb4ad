// Numbers with a unit, as a case file may give them: "13 kPa". One table says what each unit is in that of a key.
// Not for: which unit a key has (keys.hpp), nor for numbers without a unit, which are in SI.
#pragma once

#include "io/case/document.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// A unit of the table: a number in it, times 10^power, times `times`, over `over`, is in the unit `of_key`.
struct Unit {
  std::string_view name;    ///< as people write it, but for powers: "kN/m3" stands for kN/m^3 and kN/m³ too
  std::string_view of_key;  ///< unit of the keys that take it, as their tables have it: "kg/m^3"
  int power = 0;
  Real times = 1.0;
  Real over = 1.0;
  bool is_weight = false;  ///< of a volume of soil, where the key takes its mass
};

/// Acceleration of gravity that unit weights are divided by [m/s^2]: that of the tables which give them, whatever the
/// case has. A centrifuge at 50 g keeps the density of its soil.
inline constexpr Real standard_gravity = 9.81;

/// A text that reads as a number and a unit.
struct NumberWithUnit {
  std::string number;          ///< "19.5"
  std::string name;            ///< of the unit, as written: "kN/m^3"
  const Unit* unit = nullptr;  ///< none: no such unit is known
  Real value() const;          ///< in the unit of the key that takes it; 19.5e3 and "19.5 k..." are the same to the bit
};

/// Number and unit of a text; none if it does not begin with a number, or ends with it.
std::optional<NumberWithUnit> parse_quantity(std::string_view text);

/// The number of a value for a key of that unit, written as a number or with a unit; none if it is neither.
std::optional<Real> number_of(const Node& node, std::string_view unit_of_key);

/// Names of the units that a key of that unit takes, the most usual first; none of one that takes plain numbers alone.
std::vector<std::string> units_of_key(std::string_view unit_of_key);

/// Names of all units.
std::vector<std::string> all_unit_names();

}  // namespace terp
