// The pore pressure on the nodes of the background mesh, of each water situation of a case, and between them in time.
// The mesh stays where it is, so that the field is renewed only when the water changes. docs/methods.md, "Water".
#pragma once

#include "forces/pore_pressure.hpp"
#include "simulation/model.hpp"
#include "water/water_pressure.hpp"

namespace terp {

/// Where the water had to be cut to the weight above it.
struct CappedWater {
  Index n = 0;                ///< nodes of cells with soil
  Real most = 0.0;            ///< largest part that was cut off [Pa]
  Vec<2> where{0.0, 0.0};     ///< there [m]
  std::size_t situation = 0;  ///< in which
};

class NodalWater {
 public:
  /// Of a model whose mesh, materials and gravity are set.
  explicit NodalWater(const Model& model);

  /// Sets the pressures of a time [s]; does nothing if they are the same as before.
  void renew(Real time, PorePressure& pore) const;

  /// Of the way from one situation to another: share 0 is the first, 1 the second.
  void set(std::size_t from, std::size_t to, Real share, PorePressure& pore) const;

  /// Over all situations, at the given nodes.
  CappedWater find_capped(std::span<const Index> nodes) const;

  /// True if there is no water at any of the nodes, in no situation.
  bool is_dry(std::span<const Index> nodes) const;

 private:
  /// Unlimited pressures of a situation [Pa], shape [n_nodes].
  struct Field {
    std::vector<Real> at_node, at_ground;  // at_ground: at the surface of the soil above the node
  };

  Field field_of(const WaterSituation& situation, Real time) const;
  bool changes_between(Real a, Real b) const;
  void set(const Field& from, const Field& to, Real share, PorePressure& pore) const;

  const WaterCase water_;
  SharedMesh mesh_;
  std::vector<WaterKnot> knots_;
  std::vector<Real> ground_;      // elevation above or below each node [m]; -infinity: no soil
  std::vector<Real> soil_above_;  // weight per area [Pa]; infinite at nodes above the ground: no cap
  std::vector<Field> fields_;     // by number of the situation
};

/// Water of a model that has water, at a time of its stage [s].
PorePressure water_at(const Model& model, Real time);

/// p_w at the material points of a block as the forces see it [Pa], in place of a field of its own.
Real pore_pressure_at(const Model& model, const PorePressure& pore, const PointBlock<2>& block, Index lane);

}  // namespace terp
