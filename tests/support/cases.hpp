// Cases for tests, small and coarse. What a test does not change is the paper's column.
#pragma once

#include "support/test.hpp"
#include "model/case/case.hpp"

namespace terp::test {

/// Parameters of tresca_softening in the order of its table.
struct Clay {
  Real shear_modulus = 2.0e6;  ///< [Pa]
  Real poisson_ratio = 0.48;
  Real su_peak = 8.0e3;      ///< [Pa]
  Real su_residual = 2.0e3;  ///< [Pa]
  Real eta = 50.0;
};

MaterialCase clay(const Clay& parameters = {});
MaterialCase elastic(Real shear_modulus, Real poisson_ratio, Real density);

/// A body that is a box, 5 x 5 points per cell: lower left and upper right corner [m].
BodyCase body(const std::string& material, Vec<2> low, Vec<2> high);
SideCondition side(const std::string& name, SideKind kind);

/// Model 2 of the paper on coarse cells [m]: softening clay on a base with adhesion.
Case column(const std::string& scheme, Real cell = 0.5);
/// Model 1: constant strength, smooth base.
Case column_without_softening(const std::string& scheme, Real cell = 0.5);

/// A box of one material alone in a mesh of 4 m x 2 m, cells of 0.25 m: no gravity, no damping, no sides.
Case free_box(const std::string& scheme, Vec<2> low, Vec<2> high, const MaterialCase& material = clay());

/// An elastic box of 4 m x 1.5 m between rollers, under gravity.
Case confined_box(InitialStress stress);

/// One cell of 1 m x 1 m, full of 2 x 2 points, whose nodes never move: a step averages as in the paper, and no more.
Case clamped_cell(const std::string& scheme);

}  // namespace terp::test
