// Slip planes of other methods that a case names: in words, and their undrained strength beside that of the soil.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <string>

namespace terp {

/// "High Water, Bishop, 1.004", of what is given.
std::string words_of(const SlipPlaneCase& plane);

/// Undrained strength of the soil over that which another method took, at the places that it names.
struct StrengthComparison {
  std::size_t n = 0, n_all = 0;            ///< places whose nearest point has an undrained strength; places
  Real mean = 0.0, low = 0.0, high = 0.0;  ///< of the ratios [-]
  Vec<2> x_low{}, x_high{};                ///< where they are smallest and largest [m]
};

/// Of the material point nearest to each place, before `at_strength` divides. State at t = 0.
StrengthComparison compare_strength(const Model& model, const State& state, const SlipPlaneCase& plane);

}  // namespace terp
