// The factor of safety of a case: settle it, then bisect by trials. The whole way from a case to a result.
// Not for: files and terminal (io, cli).
#pragma once

#include "model/parts/reduce.hpp"
#include "run/stability/bisection.hpp"
#include "run/stability/mesh_error.hpp"

#include <functional>

namespace terp {

struct StabilityOptions {
  BisectionOptions search;
  TrialRules rules;
  int threads = 1;
  bool cracks = false;  ///< no tension in soil whose law could limit it and has no limit (leave_out_tension)
  FlowRule flow = FlowRule::as_given;
};

/// What a search leaves behind.
struct StabilityResult {
  std::vector<Strength> strengths;  ///< that were reduced, unreduced
  StabilityOptions options;
  std::string water;         ///< name of the situation that is judged, "start" for that of t = 0; empty: no water
  bool later_water = false;  ///< situations with a time are not looked at
  Real height = 0.0;         ///< H [m]
  Real relief = 0.0;         ///< height of the slope [m]
  Real cell = 0.0;           ///< size of a typical cell [m]
  Real given_cell = 0.0;     ///< as --cells takes it; 0: the mesh has no size [m]
  Real displacement = 0.0;   ///< rho g H^2 / E [m]
  std::int64_t n_points = 0, rest_steps = 0;
  Bisection search;
  SharedMesh mesh;
  std::vector<SizedFactor> sizes;  ///< of searches on several sizes of cells, of which this is the finest; else empty
  std::vector<SlipPlaneCase> slip_planes;  ///< that the case has from other methods
  bool stopped = false;                    ///< from outside, before the bracket was as narrow as asked for

  std::shared_ptr<const Mechanism> mechanism = {};  ///< at search.failed; null: nothing failed, or not known
  std::shared_ptr<const Mechanism> creep = {};      ///< at search.not_stable where that one only crept; else null
  std::optional<SizedFactor> with_tension = {};     ///< of soil that does not crack, where it is well above

  /// Of the least factor that failed or, where none did, of the least that crept; null: none.
  std::shared_ptr<const Mechanism> what_moves() const { return mechanism ? mechanism : creep; }

  /// Middle between the largest factor that stood and the smallest that did not. Not a number without both ends.
  Real factor() const;
  /// From there to the farther of the largest that stood and the smallest that failed: what creeps may do either.
  Real uncertainty() const;
  /// On cells of no size, of searches on several that have ended; none: of fewer than two, or is_upper_bound().
  std::optional<FactorLimit> limit() const;
  /// What moves is fewer than five cells deep, on one of the two finest sizes. Then the least that failed counts.
  bool is_upper_bound() const;
  /// At most this, or the limit on cells of no size, or factor(). Not a number without both ends.
  Real answer() const;
  /// From there to the farther end.
  Real answer_uncertainty() const;
  /// Cells over the depth of what moves or, where that is not known, over the height of the slope [-].
  Real cells_over_depth() const;
};

/// What a search on one size of cells found.
SizedFactor size_of(const StabilityResult& result);

/// The case that the trials of a search solve, before it is made quiet.
Case judged_case(Case c, const StabilityOptions& options);

/// Told after each window of a trial, and with the trials still to come after this one, at a guess.
using TrialCallback = std::function<void(const Trial&, const StabilityResult& so_far, int trials_left)>;

/// Throws InputError for a case without strength or gravity, RunError if the soil cannot be settled or `stop` was set
/// before that. Stopped later, the search ends with the trials that it has.
StabilityResult find_factor_of_safety(
    const Case& c, const StabilityOptions& options, const std::atomic<bool>& stop, const TrialCallback& report = {});

/// By how much the factor, between its ends, may be larger with tension before that is told [-].
inline constexpr Real much_tension = 0.05;

/// The factor of the same case, of which `cracked` is that of soil that cracks, without that. None: the case has no
/// soil that could crack, or the factor is not larger by `much_tension`, which takes one trial to find out.
std::optional<SizedFactor> find_factor_with_tension(
    const Case& c, const StabilityResult& cracked, const std::atomic<bool>& stop, const TrialCallback& report = {});

/// Throws InputError for a case without strength, or with soil that is not judged.
void check_may_be_judged(const Case& c);

/// One trial at a factor, from the start that a search has. Throws as find_factor_of_safety does.
Trial try_factor(const Case& c, Real factor, const StabilityOptions& options, const std::atomic<bool>& stop);

}  // namespace terp
