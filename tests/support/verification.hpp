// Simulations on meshes that no case file describes, and what verification measures on them.
#pragma once

#include "model/case/case.hpp"
#include "support/simulations.hpp"

namespace terp::test {

/// The case on this mesh instead of its own.
Simulation simulate_on(Mesh<2> mesh, const Case& description, int threads = 1);

/// A place turned about the origin by an angle [rad].
Vec<2> turned(Vec<2> x, Real angle);

Mesh<2> turned(const Mesh<2>& mesh, Real angle);

/// Nodes, cells and sides, connected anew.
Mesh<2> reconnected(const Mesh<2>& mesh);

Vec<2> centre_of_mass(const State& state);

/// Velocity of the centre of mass [m/s].
Vec<2> mean_velocity(const State& state);

}  // namespace terp::test
