// Results of several runs with refined cells: order of convergence, the limit to which they tend, and how far from it
// they may be.
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

/// How the results on the three finest sizes follow each other.
enum class Trend {
  unknown,      ///< fewer than three sizes
  unchanged,    ///< the two finest are equal
  monotone,     ///< the differences have one sign, and fall as those of a positive order do
  diverging,    ///< they have one sign, and do not fall so
  oscillating,  ///< they have two signs
};

/// Safety factors on the distance from a limit that was extrapolated from three runs: with an order from least_order to
/// most_order (P. J. Roache, J. Fluids Eng. 116 (1994) 405-413), and where the order had to be put back into that range
/// (W. L. Oberkampf and C. J. Roy, Verification and Validation in Scientific Computing, Cambridge 2010, section 8.7).
inline constexpr Real safety_of_limit = 1.25, safety_of_bounded_order = 3.0;
inline constexpr Real least_order = 0.5, most_order = 2.0;

/// What three runs say of their limit.
struct RefinementEstimate {
  Trend trend = Trend::unknown;
  Real order;        ///< observed, p [-]; NaN unless monotone
  Real limit;        ///< y as x tends to 0; NaN unless monotone
  Real uncertainty;  ///< of the finest y, as a difference (estimate_limit); NaN with fewer than three sizes

  bool order_is_usable() const { return order >= least_order && order <= most_order; }
};

/// Of the three finest runs, whatever their ratios r_21 = x_2/x_1, r_32 = x_3/x_2 (I. B. Celik et al., J. Fluids Eng.
/// 130 (2008) 078001): p from (y_3 - y_2)/(y_2 - y_1) = r_21^p (r_32^p - 1)/(r_21^p - 1), the limit y_1 + (y_1 -
/// y_2)/(r_21^p - 1), the uncertainty, or grid convergence index, F |y_1 - y_2|/(r_21^p - 1). For these two, p is taken
/// to be at least least_order and at most most_order, and least_order where the differences do not fall. Of what
/// oscillates the uncertainty is half of its range (F. Stern et al., J. Fluids Eng. 123 (2001) 793-802). x: positive
/// and different; y: finite.
RefinementEstimate estimate_limit(const std::vector<Real>& x, const std::vector<Real>& y);

}  // namespace terp
