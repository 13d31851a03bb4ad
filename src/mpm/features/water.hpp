// The pore pressure on the nodes as a step asks for it.
// Not for: lines and situations of the water (nodal_water.hpp).
#pragma once

#include "mpm/kernels/nodal_pressure.hpp"
#include "mpm/step/stage.hpp"

#include <limits>
#include <span>

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;

/// The water on its way from one situation to another, by their numbers.
struct WaterWay {
  std::size_t from = 0, to = 0;
  Real share = 0.0;  ///< of the second

  bool operator==(const WaterWay&) const = default;
};

/// What the pressure of the water on the nodes follows from, beside the loads.
struct WaterMoment {
  WaterWay way;
  Real time = std::numeric_limits<Real>::quiet_NaN();  ///< of formulas [s]; 0: none speaks of it; NaN: no moment
  Real gravity = 0.0;                                  ///< downwards [m/s^2]

  bool operator==(const WaterMoment&) const = default;
};

struct WaterModel {
  virtual ~WaterModel() = default;

  /// The moment of a time [s], with water that follows a stage or its own times. share: of the ramp of the stage;
  /// gravity: downwards [m/s^2]; holds_bodies: a stage of the run places or removes bodies.
  virtual WaterMoment moment_at(
      const StageWater& stage, Real time, Real share, Real gravity, bool holds_bodies) const = 0;

  /// Sets the pressures of a moment, cut to the weight that then lies above. loads: pressure of each [Pa]; bodies:
  /// share of the weight of those that have which the stage places, and those lack which it digs away.
  virtual void set(const WaterMoment& moment, std::span<const Real> loads, Real bodies, PorePressure& pore) const = 0;
};

struct WaterScratch {
  PorePressure pore;        ///< on the nodes
  WaterMoment moment;       ///< that `pore` is of, with
  std::vector<Real> loads;  ///< the pressures of the loads [Pa]
};

/// Water of the time of the step, or of the stage, under the gravity and the loads of the step; set anew only where any
/// of these changes.
void set_water(const StepModel& model, const StepState& state, Workspace& work);

/// Pressures on the nodes in this step [Pa]; empty: no water.
std::span<const Real> node_pressures(const Workspace& work);

/// The pressures on the nodes are of another stage, or of another time: the next step sets them.
void forget_water(Workspace& work);

}  // namespace terp
