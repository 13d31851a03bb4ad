// Where all trials of a search begin: the soil at rest under its weight, with stresses that no strength limits.
#pragma once

#include "run/loop/observer.hpp"
#include "model/bodies/setup_points.hpp"

#include <atomic>

namespace terp {

/// Time of a window, in which a shear wave goes down the soil and up again, over `traversal`.
inline constexpr Real window_traversals = 2.0;

/// The soil at rest, and the scales by which motion is judged.
struct ElasticStart {
  StateImage rest;  ///< at t = 0, no velocity, no strain, no history
  Seeds seeds;
  std::int64_t steps = 0;  ///< that the search for it took
  Real height = 0.0;       ///< H, extent of the soil along gravity [m]
  Real relief = 0.0;  ///< height of the slope: of the highest ground over the lower of its feet; of level ground H [m]
  Real cell = 0.0;    ///< size of a typical cell [m]
  Real traversal = 0.0;     ///< time in which a shear wave crosses H in the softest soil [s]
  Real displacement = 0.0;  ///< rho g H^2 / E of the softest soil, which motion is measured in [m]
  Real free_motion = 0.0;   ///< g T^2, T a window: what soil under its whole weight moves more in each window than in
                            ///< the one before [m]
  Real stiffening = 1.0;    ///< s of stiffen() at which it was settled; the scales above are those of the soil as it is
};

/// The case as its trials solve it: nothing moves but by its weight and its loads, which are there from the start, in
/// full; of a case with stages that of the last stage, with the water at its end. Footings are left out, driven sides
/// stand still.
Case quiet_case(Case c);

/// Settles the case with every law that has a strength replaced by linear_elastic of the same stiffness, and contact
/// planes with adhesion or friction that never slip. Throws RunError if that fails, or is stopped, and InputError
/// without gravity. stiffening: see stiffen().
ElasticStart settle_elastically(
    const Case& quiet, const SharedMesh& mesh, Real stiffening, int threads, const std::atomic<bool>& stop);

}  // namespace terp
