// Strength, stiffness and vertical stress at t = 0 along a vertical line: what an engineer checks first.
// Not for: printing it (cli/check), nor values at other times (frames).
#pragma once

#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

struct ProfileStrength {
  std::string_view name, unit;  ///< of the law's table
  Real value;
};

struct ProfileRow {
  Vec<2> x;     ///< [m]
  Real depth;   ///< below the ground at its x [m]; not a number if that is not known
  Real stress;  ///< sigma'_v in the water at the start [Pa]; not a number if the weight above is not known
  Real pore;    ///< p_w in that water [Pa]
  Real last_stress = std::numeric_limits<Real>::quiet_NaN();   ///< sigma'_v in the water of the last stage [Pa]
  Real yield_stress = std::numeric_limits<Real>::quiet_NaN();  ///< sigma'_p of SHANSEP [Pa]
  Real shear;                                                  ///< G [Pa]
  std::string material;
  std::vector<ProfileStrength> strengths;  ///< those that have no default
};

/// The point nearest to the line in each cell that it crosses, from the top down; of every material. StepState at t =
/// 0.
std::vector<ProfileRow> strength_profile(const Model& model, const StepState& state, Real x);

/// About n rows at even distances, the last one, and those where the material changes.
std::vector<ProfileRow> thinned(const std::vector<ProfileRow>& rows, std::size_t n);

/// Where profiles are of use if nobody says: the middle of the highest ground, and the quarters of the section [m].
std::vector<Real> usual_profiles(const Model& model, const StepState& state);

}  // namespace terp
