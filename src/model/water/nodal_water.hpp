// The pore pressure on the nodes of the background mesh, of each water situation of a case, and between them in time.
// The mesh stays where it is, so that the field is renewed only when the water changes. docs/methods.md, "Water".
#pragma once

#include "model/parts/model.hpp"
#include "model/water/drawn_water.hpp"
#include "model/water/water_pressure.hpp"

#include <array>
#include <optional>
#include <span>

namespace terp {

/// Where the water had to be cut to the weight above it.
struct CappedWater {
  Index n = 0;                ///< nodes of cells with soil
  Real most = 0.0;            ///< largest part that was cut off [Pa]
  Vec<2> where{0.0, 0.0};     ///< there [m]
  std::size_t situation = 0;  ///< in which
};

class Overburden;
struct SeepageSection;

class NodalWater : public WaterModel {
 public:
  /// Of a model whose mesh, materials, gravity, loads and ramp are set.
  explicit NodalWater(const Model& model);

  WaterMoment moment_at(const StageWater& stage, Real time, Real share, Real gravity, bool holds_bodies) const override;
  void set(const WaterMoment& moment, std::span<const Real> loads, Real bodies, const WaterState* carried,
      std::int64_t step, bool anew, PorePressure& pore) const override;

  /// The section as the stage draws it; nullptr: points of files leave it open.
  const DrawnWater* drawn() const { return drawn_ ? &*drawn_ : nullptr; }

  bool follows_soil() const { return drawn_ && water_.follow_soil; }

  /// The section as computed water sees it; nullptr: the water is drawn, or does not follow the soil.
  const SeepageSection* section() const { return section_.get(); }

  /// Over all situations, at the given nodes, under gravity in full and the loads of t = 0.
  CappedWater find_capped(std::span<const Index> nodes) const;

  /// True if there is no water at any of the nodes, in no situation.
  bool is_dry(std::span<const Index> nodes) const;

 private:
  /// Unlimited pressures of a situation [Pa], shape [n_nodes].
  struct Field {
    std::vector<Real> at_node;
    std::vector<Head> heads;                     // where the table may lie elsewhere; empty: it does not
    std::array<std::vector<Real>, 2> at_ground;  // at the surface of the soil above the node, of both sections
  };

  /// The part of the surface that a load stands on.
  struct Stretch {
    Real from, to;  // [m]
  };

  /// What the soil carries at a node: as in CarriedWater.
  struct CarriedPlace {
    bool is_carried = false;  // in the look before or the last one
    Real share = 0.0, table = 0.0, ground = 0.0, mass = 0.0;
    std::optional<Real> head = std::nullopt;
  };

  /// What lies above each node, shape [n_nodes].
  struct Section {
    std::vector<Real> ground;      // elevation above or below the node [m]; -infinity: no soil
    std::vector<Real> mass_above;  // per area [kg/m^2]; infinite at nodes above the ground: no limit
  };

  Section section_of(const Overburden& overburden, bool has_weight) const;
  Field field_of(const WaterSituation& situation, Real time) const;
  /// Weight per area of soil and loads above a node [Pa]; infinite above the ground: no limit.
  Real weight_above(const Section& section, std::size_t node, Real gravity, std::span<const Real> loads) const;
  /// The weight of the soil above a place with that of the loads [Pa].
  Real with_loads(Real weight, Real x, std::span<const Real> loads) const;
  DrawnWater draw_water(const Overburden& overburden) const;
  /// Where soil has moved, unlimited above the water [Pa].
  Real carried_pressure(
      std::size_t node, const CarriedPlace& place, const Head& head, Real gravity, std::span<const Real> loads) const;

  const WaterCase water_;
  SharedMesh mesh_;
  std::vector<WaterKnot> knots_;
  std::array<Section, 2> sections_;  // with the bodies that the stage places, without those that it digs away; and the
                                     // other way round, empty where no body comes or goes
  std::vector<Field> fields_;        // by number of the situation, at t = 0
  std::vector<Stretch> stretches_;
  std::vector<Real> first_loads_;  // pressures at t = 0 [Pa]
  std::optional<DrawnWater> drawn_;
  std::shared_ptr<const SeepageSection> section_;
  Real gravity_;  // in full, downwards [m/s^2]
};

/// Way of the water of a model that has water, at a time of its stage [s]; that of t = 0.
WaterWay water_way(const Model& model, Real time);
WaterWay first_way(const Model& model);

/// Water of a model that has water: of soil that has not moved, at a time of its stage [s]; of a state.
PorePressure water_at(const Model& model, Real time);
PorePressure water_at(const Model& model, const StepState& state);

/// p_w at the material points of a block as the forces see it [Pa], in place of a field of its own.
Real pore_pressure_at(const Model& model, const PorePressure& pore, const PointBlock<2>& block, Index lane);

}  // namespace terp
