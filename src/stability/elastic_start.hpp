// Where all trials of a search begin: the soil at rest under its weight, with stresses that no strength limits.
#pragma once

#include "simulation/model.hpp"
#include "simulation/observer.hpp"

#include <atomic>

namespace terp {

/// The soil at rest, and the scales by which motion is judged.
struct ElasticStart {
  StateImage rest;            ///< at t = 0, no velocity, no strain, no history
  std::int64_t steps = 0;     ///< that the search for it took
  Real height = 0.0;          ///< H, extent of the soil along gravity [m]
  Real traversal = 0.0;       ///< time in which a shear wave crosses H in the softest soil [s]
  Real displacement = 0.0;    ///< rho g H^2 / E of the softest soil, which motion is measured in [m]
};

/// The case as its trials solve it: nothing moves but by its weight. Footings are left out, driven sides stand still.
Case quiet_case(Case c);

/// Settles the case with every law that has a strength replaced by linear_elastic of the same stiffness. Throws RunError if that fails, or is
/// stopped, and InputError without gravity.
ElasticStart settle_elastically(const Case& quiet, const Mesh<2>& mesh, int threads, const std::atomic<bool>& stop);

}  // namespace terp
