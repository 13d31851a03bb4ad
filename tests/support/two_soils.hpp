// A box of two soils whose border lies within cells.
#pragma once

#include "support/cases.hpp"

namespace terp::test {

constexpr Real soft = 2.0e6, stiff = 3.0e7;  // shear moduli [Pa]

/// A box on cells of 0.25 m: elastic soil below a line through `place` that rises by an angle, stiffer soil above.
Case two_soils(const std::string& scheme, Shares shares, Vec<2> place, Real degrees, Index points = 4);

/// The same of two clays that can yield, and do not by themselves.
Case two_clays(const std::string& scheme, Shares shares, Vec<2> place, Real degrees);

}  // namespace terp::test
