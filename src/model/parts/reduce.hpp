// The strengths of a case, and the case with all of them divided by one factor: of `terp stability`, and of the case
// itself (Case::at_strength).
// Not for: which parameter is a strength (the table of the law says so: ParameterInfo::reduction).
#pragma once

#include "math/errors.hpp"
#include "model/case/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace terp {

/// One strength of a case.
struct Strength {
  std::string key;  ///< "material.clay.su_peak", "boundary.bottom.adhesion"
  std::string unit;
  Real value = 0.0;  ///< not a number if it varies from point to point
};

/// Every strength that the case has: of materials that bodies use, and of contact planes that have any.
std::vector<Strength> strengths_of(const Case& c);

/// The case with stresses divided by `factor`, and angles whose tangents are. What only fast shearing gives stays.
Case reduce_strength(Case c, Real factor);

/// The case without what only fast shearing gives (Reduction::zero).
Case leave_out_rate(Case c);

/// Soil of a law with friction that has no cohesion: it carries no tension in any case.
bool is_sand(const MaterialCase& material);

/// Tension beyond which a limit of it does not act [Pa]: the apex c cot(phi) of a law with friction; of soil without,
/// twice its strength, which is what it carries where it is not pulled in all directions. parameters: all of the law.
Real largest_tension(const MaterialType& law, std::span<const Real> parameters);

/// What to say of a limit that does not act. most: largest_tension(), at the places that vary the largest.
Problem idle_cutoff(const MaterialCase& material, Real cutoff, Real most);

/// The case whose soil cracks: no tension where the law could limit it and no limit was given, or none that acts.
Case leave_out_tension(Case c);

/// Names of the soils with a limit of their own, which leave_out_tension() leaves.
std::vector<std::string> soils_that_limit_tension(const Case& c);

/// How soil with friction flows: as it is given; by its friction angle; or by the reduced pair of Davis (1968), whose
/// flow is associated, too: tan phi* = cos psi sin phi/d, c* = c cos psi cos phi/d, d = 1 - sin psi sin phi.
enum class FlowRule { as_given, associated, davis };

/// The case with another rule of flow in all soil that has one. Throws InputError where Davis' pair would need an angle
/// or a cohesion that varies from place to place.
Case with_flow(Case c, FlowRule rule);

/// A material that a body is of, whose law has no strength that a factor could divide; nullptr: none. The law says why:
/// MaterialType::not_judged.
const MaterialCase* find_not_judged(const Case& c);

/// What the laws find wrong with the parameters of a reduced case, in one line each.
std::vector<std::string> check_reduced(const Case& c);

/// The case whose strains and displacements are s times smaller and whose times are sqrt(s) times shorter, with the
/// same stresses, forces and accelerations: dynamic similarity in the limit of small displacements (decision 0035). The
/// laws' tables say what that takes (ParameterInfo::strain_exponent).
Case stiffen(Case c, Real s);

}  // namespace terp
