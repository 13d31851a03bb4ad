// Allocations of this test program, which workspace_test.cpp counts.
#pragma once

#include "support/simulations.hpp"

namespace terp::test {

int allocations_during(Simulation& s, std::int64_t n_steps);

}  // namespace terp::test
