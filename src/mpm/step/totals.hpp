// What a ledger row needs of all points, from one walk over the blocks on the threads of the run.
// Part of the kernels: each copy walks with its own instructions; call by way of kernels() (kernels.hpp).
// Not for: what follows from it (ledger, failure).
#pragma once

#include "mpm/points/moved.hpp"
#include "mpm/points/surface.hpp"
#include "os/threads.hpp"
#include "mpm/step/stored_energy.hpp"

namespace terp {

inline constexpr int most_slopes = 2;  ///< a section falls to the left, to the right, or both

/// The strain and the strength of each point at the last ledger row; by id.
struct StrainMemory {
  std::vector<Real> last_eps_eq_p;
  std::vector<Real> last_su;  ///< S_u [Pa], or of soil with a softening length the strain that it follows [-]; empty
                              ///< where no material needs it: eps_eq_p alone tells S_u
};

/// What followers want of the walk over the points.
struct TotalsRequest {
  Real moved_distance = std::numeric_limits<Real>::infinity();  ///< from where on soil counts as moved [m]
  Ground ground = {};                                           ///< what may count as moved; empty: all
  std::vector<Columns> shear;                                   ///< in which the growth of strain counts, of each slope
  StrainMemory* memory = nullptr;  ///< none: neither growth nor audit. Of it the walk renews last_su alone
};

/// Sums and extremes over the points.
struct Totals {
  Real mass = 0.0;                                        ///< [kg per m]
  Vec<2> momentum{0.0, 0.0};                              ///< [N s per m]
  Real kinetic = 0.0, elastic = 0.0, pore_elastic = 0.0;  ///< of the points [J per m]
  Real v_max = 0.0, v_999 = 0.0;  ///< largest speed, and that which 99.9 % of the points do not exceed [m/s]
  MovedSoil moved;
  std::array<Real, most_slopes>
      growth{};  ///< growth of eps_eq_p since the last row, summed over the volume, of each slope [m^2]
  std::vector<std::size_t> fell, rose;  ///< ids of points whose eps_eq_p fell, whose S_u rose since the last row
  std::vector<std::uint8_t>
      strained;  ///< 1: eps_eq_p of some point of the block changed since the last row; by block number
};

/// Walks over all points. Sums go by chunks of cells in their order: the same bits on any number of threads. Of this
/// copy of the kernels: call by way of kernels().add_up.
Totals add_up_compiled(const StepModel& model, const StepState& state, Threads& threads, const TotalsRequest& request);

}  // namespace terp
