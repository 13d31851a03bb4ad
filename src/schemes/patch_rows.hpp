// Rows that Gauss points leave for the points around them, with shares that overlap; rows of the law and the excess
// pressure follow.
#pragma once

#include "transfer/overlap.hpp"

namespace terp {

/// Of schemes whose points own the history.
struct StrainRows {
  static constexpr int strain = 0, pressure = n_sym<2>, spin = pressure + 1, end = spin + 1;
};

/// Of schemes whose Gauss points own it.
struct HistoryRows {
  static constexpr int strain = 0, change = n_sym<2>, stress = 2 * n_sym<2>, spin = 3 * n_sym<2>, end = spin + 1;
};

}  // namespace terp
