// Kinds of fields: how a value may follow from the place, the depth, or the effective vertical stress there.
// docs/strength.md. Not for: how a case file writes them (io/case/field_kinds).
#pragma once

#include "soil/laws/material.hpp"
#include "model/bodies/values_csv.hpp"
#include "model/case/parameter_field.hpp"

#include <string>
#include <vector>

namespace terp {

/// Of the highest soil at that x, downwards [m]. Not a number where there is no soil.
FieldValue depth_below_ground();
FieldValue elevation_in_soil();  ///< y [m]
/// Effective, in a water situation; its name, empty: that of the start [Pa].
FieldValue vertical_stress(std::string water);

/// Linear in what a place is asked for; constant beyond both ends. line: (argument, value), arguments ascending.
FieldValue by_line(std::vector<Vec<2>> line, FieldValue argument);
inline FieldValue by_depth(std::vector<Vec<2>> line) { return by_line(std::move(line), depth_below_ground()); }
inline FieldValue by_elevation(std::vector<Vec<2>> line) { return by_line(std::move(line), elevation_in_soil()); }
inline FieldValue by_stress(std::vector<Vec<2>> line, std::string water)
{
  return by_line(std::move(line), vertical_stress(std::move(water)));
}

FieldValue by_map(ValueMap map);

/// S_u = S sigma'_v (sigma'_p / sigma'_v)^m, at least `minimum`. sigma'_p = sigma'_v,daily + pop, or ocr times
/// sigma'_v,daily, or yield_stress, to which a pop is added: one of the three is given, or yield_stress and pop.
struct Shansep {
  FieldValue S, m;                                   ///< [-]
  FieldValue pop = {}, ocr = {}, yield_stress = {};  ///< [Pa], [-], [Pa]
  FieldValue minimum = {};                           ///< [Pa]; may be empty
  std::string water = {}, daily = {};                ///< situations of sigma'_v and of sigma'_v,daily; empty: the start
};
FieldValue by_shansep(const Shansep& soil);
/// sigma'_p of it [Pa].
FieldValue yield_stress_of(const Shansep& soil);

/// Not a number where the value does not lie in the range.
FieldValue within(Range range, FieldValue value);

}  // namespace terp
