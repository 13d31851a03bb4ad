// Rows that Gauss points leave for the points around them, with shares that overlap; rows of the law and the excess
// pressure follow. `ratio` is 1, weighed as the strain is: what points divide by (share_ratio.hpp).
#pragma once

#include "mpm/kernels/overlap.hpp"

namespace terp {

/// Of schemes whose points own the history.
struct StrainRows {
  static constexpr int spin = 0, strain = 1, ratio = strain + n_sym<2>, pressure = ratio + 1, end = pressure + 1;
};

/// Of schemes whose Gauss points own it.
struct HistoryRows {
  static constexpr int strain = 0, change = n_sym<2>, stress = 2 * n_sym<2>, ratio = 3 * n_sym<2>, spin = ratio + 1,
                       end = spin + 1;
};

}  // namespace terp
