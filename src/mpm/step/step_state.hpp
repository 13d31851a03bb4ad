// The soil during a run, as the steps change it.
// Not for: how far the run is (state.hpp).
#pragma once

#include "mpm/features/slots.hpp"
#include "mpm/points/point_blocks.hpp"
#include "mpm/step/outer_forces.hpp"

#include <cmath>
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
  Real outside() const
  {
    Real sum = gravity + boundary + clamps;
    for (int kind = 0; kind < n_kinds_around; ++kind) sum += outer[kind];
    return sum;
  }
  Real size_of_outside() const
  {
    Real sum = std::abs(gravity) + std::abs(boundary) + std::abs(clamps);
    for (int kind = 0; kind < n_kinds_around; ++kind) sum += std::abs(outer[kind]);
    return sum;
  }
  /// What the points and the slip of soils took more than the nodes gave.
  Real transfer() const { return taken + internal + slip; }
};

/// What the works moved so far [J per m].
inline Real energy_exchanged(const WorkTotals& w)
{
  Real of_forces = std::abs(w.gravity) + std::abs(w.damping) + std::abs(w.boundary);
  for (const Real work : w.outer) of_forces += std::abs(work);
  return std::max(w.exchanged, of_forces + w.plastic + std::abs(w.slip));
}

/// A point that crossed an open side.
struct LeftPoint {
  Real time;  ///< [s]
  std::int64_t id;
  Vec<2> x;            ///< where [m]
  Vec<2> v;            ///< how fast [m/s]
  Real mass;           ///< [kg per m]
  Real elastic = 0.0;  ///< elastic energy that it took along [J per m]
  Real volume = 0.0;   ///< [m^2]
};

struct StepState {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  std::int64_t stage_start = 0;  ///< step with which the stage began
  PointBlocks<2> points;
  std::vector<Real> x_initial;  ///< by id, shape [n_points, 2] [m]
  WorkTotals work;
  StateSlots with;              ///< the features
  std::int64_t clamped = 0;     ///< points that ever had to be put back at a wall
  std::vector<bool> put_back;   ///< which, by id
  std::vector<LeftPoint> left;  ///< points that crossed an open side, in the order in which they did

  /// Points of all bodies, also of those that are not there yet or no longer; ids run from 0 to this.
  std::int64_t n_ids() const { return static_cast<std::int64_t>(x_initial.size() / 2); }
};

}  // namespace terp
