// What drawings and D-Stability files do not say of a soil: stiffness, K0, and of drawings weight and strength. A table
// by kind of soil, found by patterns and words in the soil's name; a user may give another one. docs/dstability.md,
// "Defaults".
#pragma once

#include "math/types.hpp"

#include <regex>
#include <string>
#include <vector>

namespace terp {

/// Numbers in the units of their columns.
struct SoilKind {
  std::string kind;
  std::vector<std::string> words;    ///< in lower case; any of them in the name makes the soil this kind
  std::vector<std::regex> patterns;  ///< of a whole name or code, in lower case
  Real weight;                       ///< of the wet soil [kN/m^3]
  Real stiffness_ratio;              ///< G over s_u, undrained [-]
  Real shear_modulus;                ///< drained [MPa]
  Real poisson_undrained, poisson_drained;
  Real k0;              ///< horizontal over vertical effective stress [-]
  Real friction;        ///< [deg]
  Real cohesion;        ///< [kPa]
  Real ratio;           ///< S of SHANSEP [-]; 0: the soil is drained where nothing else is known
  Real exponent;        ///< m of SHANSEP [-]
  Real pop;             ///< [kPa]
  Real least_strength;  ///< least s_u, where the effective stress tends to zero [kPa]
  /// Coefficients of variation of a study whose file has no distributions [-]; 0: not drawn.
  Real cov_ratio, cov_pop, cov_friction, cov_cohesion;
};

/// The table as text: a CSV file that `--soil-defaults` takes, with what each column is.
const std::string& soil_defaults_table();

/// Throws CsvError with up to ten faults. The last row is that of soils that no word fits.
std::vector<SoilKind> read_soil_defaults(const std::string& path, const std::string& text);

/// The first row with a pattern of the name, else of the code, else with a word in the name; else the last row.
const SoilKind& kind_of_soil(const std::vector<SoilKind>& kinds, const std::string& name, const std::string& code = {});

}  // namespace terp
