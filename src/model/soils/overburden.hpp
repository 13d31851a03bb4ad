// What lies above a place at t = 0: weight of soil, free water and loads, pore pressure, and the effective vertical
// stress that is left. A load counts where it stands, not beside it. Pressures are positive here. docs/methods.md,
// "Start".
// Not for: stress that points already have.
#pragma once

#include "model/bodies/drawn_columns.hpp"
#include "model/parts/model.hpp"

#include <functional>
#include <optional>

namespace terp {

class Overburden {
 public:
  /// Of the bodies that are there, with the gravity and the loads of a model.
  explicit Overburden(const Model& model) : Overburden(model, -model.gravity[1]) {}
  /// The same with another gravity, downwards [m/s^2].
  Overburden(const Model& model, Real gravity);
  /// Of a stage without its loads: whether undrained soil has settled under one, as under a road, or not, as under
  /// traffic, the case does not say, and strength that it may not have is not on the safe side.
  static Overburden without_loads(const StageSoil& soil);
  /// Of the bodies that were there before the stage of the model placed some or dug some away.
  static Overburden before_stage(const Model& model);

  /// False where a body came as a file of points, which has no outline: then its weight is not in the numbers below.
  bool is_known() const { return is_known_; }

  /// Mass per area of the soil above a place [kg/m^2]. Where bodies overlap, the last one is there.
  Real mass_above(Vec<2> x) const;

  const WaterCase& water() const { return water_; }

  /// Elevation of the highest soil on the vertical line through x [m]; none: no soil there.
  std::optional<Real> ground(Real x) const;

  /// Weight per area of all that is above a place: soil, the free water on it, and the loads of t = 0 [Pa].
  Real total(Vec<2> x, const WaterSituation& situation, Real time = 0.0) const;

  /// In the water at a place: p_w, at least zero and at most total() below the ground [Pa].
  Real pore_pressure(Vec<2> x, const WaterSituation& situation, Real time = 0.0) const;

  /// Effective vertical stress at a place: total() - pore_pressure(), at least zero [Pa]. Without water: the weight.
  Real effective(Vec<2> x, const WaterSituation& situation, Real time = 0.0) const;

 private:
  using IsThere = std::function<bool(const BodyCase&)>;
  Overburden(const StageSoil& soil, Real gravity, const IsThere& is_there);
  void add_loads(const Model& model);

  /// Density of a body below and above the phreatic line of the start [kg/m^3].
  struct DrawnBody {
    Real below, above;
  };

  Real mass_between(const DrawnBody& body, Real x, Real low, Real high) const;
  Real free_water(Vec<2> x, const WaterSituation& situation, Real time) const;
  Real loads_on(Vec<2> x) const;

  /// Of a load that stands on the ground at t = 0.
  struct LoadAbove {
    Real from, to;  // [m]
    Real pressure;  // [Pa]
  };

  WaterCase water_;
  Real gravity_;  // downwards [m/s^2]
  DrawnColumns columns_;
  std::vector<DrawnBody> drawn_;  // shape [n_bodies] of the columns
  std::vector<LoadAbove> loads_;
  bool is_known_ = true;
};

}  // namespace terp
