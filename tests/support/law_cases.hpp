// Soil of libraries that the build of the tests makes, and boxes of it that move.
#pragma once

#include "support/laws.hpp"
#include "support/simulations.hpp"
#include "soil/libraries/user_law.hpp"

namespace terp::test {

/// PROPS(3) of wrong_umat.c, in its order.
enum Kind {
  elastic_law,
  nan_stress,
  nan_state,
  bad_memory,
  divides,
  aborts,
  leaves,
  never_small,
  small_parts,
  overflows,
  counts,
  turns,
  changes_rounding,
  tenths,
  nan_answer,
  beyond_state,
  beyond_props,
  reads_props,
  breaks_at_stress,
  has_size,
  crashes_in_c,
  tensorial_shear,
  counts_to_six,
  no_strength,
  adds_beyond_state,
  compares_beyond_props,
  compares_beyond_state,
  compares_in_extension,
  loops,
  leaves_at_once,
  copies_itself,
};

inline constexpr Real shear = 3.0e6, poisson = 0.3;

inline MaterialCase of_library(LibraryCase library, const LawTerms& terms = {})
{
  MaterialCase material = elastic(shear, poisson, 1900.0);
  material.model = "library";
  material.library = std::move(library);
  material.from_library = load_user_law("soft clay", law_folder(), material.parameters, material.library, terms);
  return material;
}

/// A law whose parameters have no names.
inline LibraryCase library_case(const std::string& file, LawInterface interface, std::initializer_list<Real> parameters,
    std::vector<NamedNumber> state = {})
{
  LibraryCase library{.file = file, .interface = interface, .state = std::move(state)};
  for (const Real value : parameters) library.parameters.push_back({"", value});
  return library;
}

/// A law of wrong_native.c.
inline LibraryCase native(const std::string& symbol, Real modulus = 1.0, Real limit = 1.0)
{
  LibraryCase library = library_case("wrong_native.so", LawInterface::native, {modulus, limit});
  library.symbol = symbol;
  return library;
}

/// A law of wrong_umat.c that goes wrong from a time [s] on, right of x [m].
inline MaterialCase wrong_umat(Kind kind, Real time = 0.0, Real x = -100.0, std::size_t n_state = 1, Real limit = 0.0)
{
  LibraryCase library = library_case("wrong_umat.so", LawInterface::umat, {shear, poisson, Real(kind), time, x, limit});
  for (std::size_t k = 0; k < n_state; ++k) library.state.push_back({"state_" + std::to_string(k + 1), 0.0});
  return of_library(library);
}

/// Soil that falls and hits the ground.
inline Case moving_box(const std::string& scheme, const MaterialCase& material)
{
  Case c = free_box(scheme, {0.5, 0.0}, {3.5, 1.0}, material);
  c.bodies[0].velocity = {0.0, -1.0};
  c.sides = {side("bottom", SideKind::fixed)};
  return c;
}

/// What stops the run.
inline std::string fault_of(const std::string& scheme, const MaterialCase& material)
{
  Simulation s(moving_box(scheme, material), 2);
  return refusal<RunError>([&] { s.step(20); });
}

/// The stresses of two runs are the same but for this part of the largest.
inline void expect_same_stresses(const Simulation& mine, const Simulation& own, Real part = 1e-12)
{
  const std::vector<Point> a = points_by_id(mine.state), b = points_by_id(own.state);
  ASSERT_EQ(a.size(), b.size());
  Real scale = 0.0;
  for (const Point& p : b) scale = std::max(scale, std::abs(p.sigma[1]));
  EXPECT_GT(scale, 1e4);
  for (std::size_t k = 0; k < a.size(); ++k)
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[k].sigma[c], b[k].sigma[c], part * scale);
}

/// A box that turns by 0.4 rad/s about (2, 1), with or without a rate that turns its stress.
inline Case turning_box(const MaterialCase& soil, bool stress_turns)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {3.0, 1.5}, soil);
  c.method.objective_rate = stress_turns ? ObjectiveRate::jaumann : ObjectiveRate::none;
  c.bodies[0].velocity_at = [](Vec<2> x) -> Vec<2> { return {-0.4 * (x[1] - 1.0), 0.4 * (x[0] - 2.0)}; };
  return c;
}

}  // namespace terp::test
