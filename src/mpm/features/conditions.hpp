// Boundary conditions of the nodes on the sides of the mesh: rollers, fixed nodes, prescribed velocity, contact planes.
#pragma once

#include "mpm/features/side_kind.hpp"
#include "mpm/mesh/mesh.hpp"

#include <string>
#include <vector>

namespace terp {

/// A node may lie on two sides (a corner) and so have two conditions; contacts act first. Parts of a straight base with
/// equal conditions are one side at the node between them, with the adhesion of both and their friction weighted by
/// length. A bilateral and a separating part stay two, also weighted.
struct NodeCondition {
  int n = 0;
  std::array<NodeSide, 2> sides;
  bool corner = false;  ///< two sides with different normals, neither of them fixed: together they leave one velocity
  Vec<2> corner_velocity{0.0, 0.0};  ///< this velocity [m/s]
};

/// The side of a mesh with this name. Throws InputError with the existing names.
const NamedSide& find_side(const Mesh<2>& mesh, const std::string& name);

/// A step, as sides see it.
struct SideStep {
  Real dt;                 ///< its length [s]
  Real at_strength = 1.0;  ///< adhesion and friction are divided by this [-]
};

class Boundary {
 public:
  Boundary() = default;
  /// Throws InputError for a side that the mesh does not have, whatever its kind: it may be misspelt.
  Boundary(const Mesh<2>& mesh, const std::vector<SideCondition>& sides);

  /// The part of a node's velocity, shape [2], that its sides leave free: nothing across a side that acts, or on which
  /// a `push` presses.
  Vec<2> free_velocity(Index node, Vec<2> v, Vec<2> push) const;
  /// The part of a node's force [N per m] that its sides do not carry: the same, and along a contact plane only what
  /// exceeds its adhesion, and its friction under that force (reading R13). at_strength: they are divided by it.
  Vec<2> free_force(Index node, Vec<2> force, Real at_strength) const;
  /// Corrects the trial velocity v* of a node (step 2 of docs/methods.md). mass [kg per m].
  void constrain(Index node, Real mass, SideStep step, Vec<2>& v) const;
  /// Applies the conditions to the remapped velocity (step 4). mass [kg per m]; v_1, reaction: the velocity of
  /// step 2 [m/s], and the force of the sides on the node there [N per m]. A separating contact that pushed then stays
  /// closed for the step. A contact acts along itself with the strength that it did not use then, so that a side that
  /// fixes a node does no work (decision 0037); not so with `across_alone`.
  void clamp(
      Index node, Real mass, SideStep step, Vec<2> v_1, Vec<2> reaction, Vec<2>& v, bool across_alone = false) const;
  /// The node's condition, or nullptr.
  const NodeCondition* at(Index node) const
  {
    return condition_of_node_[node] < 0 ? nullptr : &conditions_[condition_of_node_[node]];
  }

 private:
  template <class TakeAlong>
  Vec<2> free_part(Index node, Vec<2> value, Vec<2> push, TakeAlong take_along) const;

  std::vector<Index> condition_of_node_;  // shape [n_nodes], -1: free
  std::vector<NodeCondition> conditions_;
};

}  // namespace terp
