// What changes during a run and must survive it: exactly what a checkpoint holds.
#pragma once

#include "run/loop/follower.hpp"
#include "mpm/step/stage.hpp"
#include "mpm/step/step_state.hpp"

#include <map>

namespace terp {

/// Of the balance of energy, over the rows of the ledger so far [J per m].
struct EnergyMarks {
  Real most_lost = 0.0;        ///< by the soil, all in all
  Real most_dissipated = 0.0;  ///< plastic work
  Real most_unexplained = 0.0;
};

/// The soil, and how far the run is.
struct State : StepState {
  /// By id: how far it had come in one of the sections before displacement was counted anew [m]; empty: it never was.
  std::vector<Real> moved_before;
  std::int64_t equilibrium_steps = 0;  ///< made in the search for equilibrium, while the clock stands at 0
  bool has_no_start = false;           ///< the search found no equilibrium, so that nothing can be judged
  Real mass_placed = 0.0;              ///< of bodies that stages placed so far [kg per m]
  Real mass_removed = 0.0;             ///< of bodies that stages dug away so far [kg per m]
  Real start_energy = 0.0;             ///< kinetic + stored at t = 0 [J per m]
  EnergyMarks energy_marks;
  std::int64_t first_step = 0;           ///< Model::first_step and first_time
  Real first_time = 0.0;                 ///< [s]
  std::int64_t stage = 0;                ///< number of the stage that the run is in
  std::int64_t quiet_steps = 0;          ///< steps in a row in which no node was fast (Stage::rest)
  RestMarks rest_marks;                  ///< of rest by mean motion
  std::vector<StageRecord> stages_done;  ///< in their order
  std::map<std::string, std::int64_t, std::less<>> rows_reported;  ///< so far, by table
  std::int64_t frames_reported = 0;
  std::vector<ActiveFollower> followers;  ///< of the model, in its order; each saves itself
  Real largest_v_999 = 0.0;               ///< [m/s]
  double wall_s = 0.0;                    ///< spent solving, over all processes
  double search_s = 0.0;                  ///< of it, in the search for equilibrium
  std::string instructions = {};  ///< sets that the run was solved with, in their order; empty: that of this process
};

/// The state with which a run begins, and its followers: seeds the points and sets the initial stress (none or k0;
/// "equilibrium" is sought by the run). Throws InputError.
State build_state(Model& model);

}  // namespace terp
