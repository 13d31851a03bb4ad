// Stored slices beside what Terp computes at their feet: the proof that a file was understood. docs/dstability.md.
#pragma once

#include "import/dstability/project.hpp"

#include <string>
#include <vector>

namespace terp {

/// The middle of the foot of a slice [m, Pa]; not a number where there is none.
struct SliceRow {
  Vec<2> place{};
  Real total_stress[2], pore_pressure[2], yield_stress[2], su[2];  ///< computed, stored
  Real carried = not_given;  ///< the largest effective stress of all stages so far, computed
};

struct ResultSlices {
  std::size_t scenario = 0, calculation = 0;  ///< numbers in the project
  std::string name;                           ///< of the result
  std::vector<SliceRow> rows;
  std::string stale;    ///< why the result belongs to another section or other stages than the file; empty: it fits
  std::string trouble;  ///< why nothing could be computed; empty: it was
};

inline constexpr Real stale_total_stress = 100.0;   ///< difference from which on a slice is of another section [Pa]
inline constexpr Real stale_yield_stress = 1000.0;  ///< by which a yield stress may be below the stress of its history

/// All results with slices, in the order of the calculations.
std::vector<ResultSlices> compare_slices(const StixProject& project);

/// result,x,z,stale,total_stress_computed,total_stress_stored,...: docs/dstability.md. Numbers read back to the same
/// bits; not a number is `nan`.
std::string slices_csv(const std::vector<ResultSlices>& results);

/// The largest difference of each quantity over the slices that both have, and how many stored numbers have no computed
/// one beside them.
struct SliceDeviation {
  Real total_stress = 0.0, pore_pressure = 0.0, yield_stress = 0.0;  ///< [Pa]
  Real su = 0.0;                                                     ///< relative
  std::size_t missing = 0, compared = 0;                             ///< numbers of all quantities
};
SliceDeviation largest_deviation(const ResultSlices& result);

}  // namespace terp
