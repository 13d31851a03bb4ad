// The pore pressure on the nodes as a step asks for it.
// Not for: lines and situations of the water (nodal_water.hpp).
#pragma once

#include "mpm/kernels/nodal_pressure.hpp"
#include "mpm/step/stage.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

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

/// Water where soil has moved: what the soil carries in place of the water of the lines. By nodes, shape [n_nodes]; all
/// empty: no soil has moved.
struct CarriedWater {
  std::vector<Real> share = {};  ///< 0: the water as drawn, 1: as the soil carries it, or as it runs in from free water
  std::vector<Real> table = {};  ///< elevation to which its water rises [m]
  std::vector<Real> ground = {};  ///< elevation of the surface of the soil [m]
  std::vector<Real> mass = {};    ///< of the soil above, per area [kg/m^2]
  std::vector<Real> head = {};    ///< of water that was computed [m]; empty: the water stands still below its table

  bool is_empty() const { return share.empty(); }
};

/// The soil is looked at now and then; from one look to the next the water goes from what the look before found to what
/// the last one did.
struct WaterState {
  std::int64_t looked = 0, next = 0;  ///< steps of the last look and of the next
  Real way = 0.0;                     ///< of the fastest soil since heads were found [m]
  CarriedWater before, last;
  std::vector<Real> places;  ///< for which the lines are drawn: of the points at the start, by id, shape [n_points, 2]
                             ///< [m]; NaN: not there yet
  std::vector<Real> ground;  ///< surface of the soil then, by columns [m]

  /// Of the way from `before` to `last`, in the middle of a step.
  Real share_at(std::int64_t step) const
  {
    return (static_cast<Real>(step - looked) + 0.5) / static_cast<Real>(next - looked);
  }
};

struct WaterModel {
  virtual ~WaterModel() = default;

  /// The moment of a time [s], with water that follows a stage or its own times. share: of the ramp of the stage;
  /// gravity: downwards [m/s^2]; holds_bodies: a stage of the run places or removes bodies.
  virtual WaterMoment moment_at(
      const StageWater& stage, Real time, Real share, Real gravity, bool holds_bodies) const = 0;

  /// Sets the pressures of a moment, cut to the weight that then lies above. loads: pressure of each [Pa]; bodies:
  /// share of the weight of those that have which the stage places, and those lack which it digs away. carried: what
  /// soil that moves does to it, in the middle of `step`; nullptr: nothing. anew: not only the soil has changed.
  virtual void set(const WaterMoment& moment, std::span<const Real> loads, Real bodies, const WaterState* carried,
      std::int64_t step, bool anew, PorePressure& pore) const = 0;
};

struct WaterScratch {
  PorePressure pore;        ///< on the nodes
  WaterMoment moment;       ///< that `pore` is of, with
  std::vector<Real> loads;  ///< the pressures of the loads [Pa]
};

/// nullptr: no soil has moved so far that its water differs from that of the lines.
const WaterState* carried_water(const StepState& state);

/// Water of the time of the step, or of the stage, under the gravity and the loads of the step; set anew only where any
/// of these changes.
void set_water(const StepModel& model, const StepState& state, Workspace& work);

/// Pressures on the nodes in this step [Pa]; empty: no water.
std::span<const Real> node_pressures(const Workspace& work);

/// The pressures on the nodes are of another stage, or of another time: the next step sets them.
void forget_water(Workspace& work);

}  // namespace terp
