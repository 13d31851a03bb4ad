// What changes during a run and must survive it: exactly what a checkpoint holds.
#pragma once

#include "points/point_blocks.hpp"
#include "simulation/follower.hpp"
#include "simulation/observer.hpp"
#include "simulation/outer_forces.hpp"
#include "simulation/stage.hpp"

#include <cmath>
#include <map>
#include <vector>

namespace terp {

/// Work done so far [J per m]; positive when it adds energy to the soil.
struct WorkTotals {
  Real gravity = 0.0, damping = 0.0, boundary = 0.0;
  Real clamps = 0.0;        ///< what points keep of the velocity that the boundary takes from nodes in pass 4
  OuterWork outer{};        ///< of forces from outside: loads, water
  Real plastic = 0.0;       ///< dissipated by the laws
  Real slip = 0.0;          ///< dissipated where soils slip along their border in cut cells
  Real internal = 0.0;      ///< of the internal forces on the nodes
  Real taken = 0.0;         ///< of the stress of the points, each step's at its start, on their strain
  Real reset = 0.0;         ///< gained by stored energy as pressures were set at the start of steps (reading R10)
  Real relaxation = 0.0;    ///< of velocities that the mesh does not see, as they fade
  Real exchanged = 0.0;     ///< largest sum of the sizes of gravity, damping, boundary, outer, plastic and slip so far:
                            ///< what swings to and fro was exchanged, too
  Real from_outside = 0.0;  ///< the same of the works from outside alone, so far
  Real last_step = 0.0;     ///< given() and internal, in the last step alone

  /// What the balance of energy counts as given to the soil.
  Real given() const
  {
    Real sum = gravity + damping + boundary + clamps + relaxation;
    for (const Real work : outer) sum += work;
    return sum;
  }
  /// What the soil was given by what is not part of the method, as far as that can be known without it.
  Real outside() const { return gravity + boundary + clamps + outer[outer_load] + outer[outer_water]; }
  Real size_of_outside() const
  {
    return std::abs(gravity) + std::abs(boundary) + std::abs(clamps) + std::abs(outer[outer_load]) +
           std::abs(outer[outer_water]);
  }
  /// What the points and the slip of soils took more than the nodes gave.
  Real transfer() const { return taken + internal + slip; }
};

/// Of the balance of energy, over the rows of the ledger so far [J per m].
struct EnergyMarks {
  Real most_lost = 0.0;        ///< by the soil, all in all
  Real most_dissipated = 0.0;  ///< plastic work
  Real most_unexplained = 0.0;
};

struct State {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  PointBlocks<2> points;
  std::vector<Real> x_initial;  ///< by id, shape [n_points, 2] [m]
  /// By id: how far it had come in one of the sections before displacement was counted anew [m]; empty: it never was.
  std::vector<Real> moved_before;
  WorkTotals work;
  /// Running mean of the out-of-balance force, of damping with an averaging time [N per m]; shape [n_nodes], or empty.
  std::vector<Vec<2>> mean_force;
  std::int64_t equilibrium_steps = 0;  ///< made in the search for equilibrium, while the clock stands at 0
  bool has_no_start = false;           ///< the search found no equilibrium, so that nothing can be judged
  Real mass_placed = 0.0;              ///< of bodies that stages placed so far [kg per m]
  Real mass_removed = 0.0;             ///< of bodies that stages dug away so far [kg per m]
  Real start_energy = 0.0;             ///< kinetic + stored at t = 0 [J per m]
  EnergyMarks energy_marks;
  std::int64_t first_step = 0;           ///< Model::first_step and first_time
  Real first_time = 0.0;                 ///< [s]
  std::int64_t stage = 0;                ///< number of the stage that the run is in
  std::int64_t stage_start = 0;          ///< step with which it began
  std::int64_t quiet_steps = 0;          ///< steps in a row in which no node was fast (Stage::rest)
  RestMarks rest_marks;                  ///< of rest by mean motion
  std::vector<StageRecord> stages_done;  ///< in their order
  std::int64_t clamped = 0;              ///< points that ever had to be put back at a wall
  std::vector<bool> put_back;            ///< which, by id
  std::vector<LeftPoint> left;           ///< points that crossed an open side, in the order in which they did
  std::map<std::string, std::int64_t, std::less<>> rows_reported;  ///< so far, by table
  std::int64_t frames_reported = 0;
  std::vector<ActiveFollower> followers;  ///< of the model, in its order; each saves itself
  Real largest_v_999 = 0.0;               ///< [m/s]
  /// Points of all bodies, also of those that are not there yet or no longer; ids run from 0 to this.
  std::int64_t n_ids() const { return static_cast<std::int64_t>(x_initial.size() / 2); }
  double wall_s = 0.0;            ///< spent solving, over all processes
  std::string instructions = {};  ///< sets that the run was solved with, in their order; empty: that of this process
};

}  // namespace terp
