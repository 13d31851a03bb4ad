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
  Real strength[2];   ///< in shear, of drained soil under the stored normal stress; computed, stored
  Real length = 0.0;  ///< of the foot [m]
};

/// What the section of the file is to a stored result, which stays when the section is edited afterwards.
enum class SliceState {
  fits,
  other_strengths,  ///< the same section; its factor is of other strengths
  other_section,
};

/// "fits", "strengths differ", "other section".
const char* words_of(SliceState state);

struct ResultSlices {
  std::size_t scenario = 0, calculation = 0;  ///< numbers in the project
  std::string name;                           ///< of the result
  std::vector<SliceRow> rows;
  SliceState state = SliceState::fits;
  std::string why;              ///< the state in words; empty: it fits
  Real resistance = not_given;  ///< R: strength along the slip plane, computed over stored [-]
  std::string trouble;          ///< why nothing could be computed; empty: it was
};

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
