// The kinds of boundary condition that a side of the mesh may have, each one entry of a table: how a case file writes
// it, what it does to the velocity of the nodes, what is reported, and how it is drawn. Reading, checks, help, warnings
// and pictures walk the table. Not for: how the sides of a node act together (conditions.hpp).
#pragma once

#include "math/types.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Reading R15. The table in side_kind.cpp has one entry for each.
enum class SideKind { free, open, roller, fixed, contact_bilateral, contact_separating, velocity };

/// Velocity at a place [m/s]; empty: the same everywhere.
using VelocityField = std::function<Vec<2>(Vec<2>)>;

/// The boundary condition of a side, as the case gives it.
struct SideCondition {
  std::string
      side;  ///< of the mesh: "left", "right", "bottom", "top", a name of mesh.edges, or a physical group of the file
  SideKind kind = SideKind::free;
  Real adhesion = 0.0;        ///< a [Pa]
  Real friction = 0.0;        ///< tangent of the contact friction angle [-]
  Vec<2> velocity{0.0, 0.0};  ///< across the side, and along it unless it slips [m/s]
  VelocityField velocity_at;  ///< instead of velocity
  bool slip = false;          ///< only the component of the velocity across the side is prescribed
};

/// True if the side moves, or may.
bool is_driven(const SideCondition& side);

/// What a side does to the velocity of its nodes across itself.
enum class Across {
  free,
  prescribed,  ///< it is zero, or the given one
  opens,       ///< as prescribed where the soil pushes on the side; it may leave
};

/// What a side does to the velocity of its nodes along itself.
enum class Along {
  free,
  prescribed,  ///< it is zero, or the given one; then it is prescribed across the side too
  resisted,    ///< up to a strength; the side does not move
};

struct NodeSide;

struct SideAction {
  Across across = Across::free;
  Along along = Along::free;
  Real (*strength)(const NodeSide&, Real push) = nullptr;  ///< of Along::resisted: force that the side can carry along
                                                           ///< itself under a push across it [N per m]
  bool operator==(const SideAction&) const = default;
};

/// A side's boundary condition at one node.
struct NodeSide {
  SideAction action;
  Vec<2> normal;        ///< outward, mean of the node's edges on this side weighted by length [-]
  Real half_length;     ///< L_i, half the lengths of the node's edges on this side [m]
  Real adhesion_force;  ///< a L_i [N per m]
  Real friction;        ///< [-]
  Vec<2> velocity;      ///< [m/s]
};

/// What `reached_sides` of summary.json says of a side.
enum class SideReport {
  none,              ///< soil is meant to come there
  arrival,           ///< that soil came to it
  arrival_and_rise,  ///< also that soil which lay at it has risen: the side is the end of the mesh and no wall
};

enum class SideMarks { none, ticks, circles };

struct SideKindInfo {
  SideKind kind;
  std::string_view key;      ///< that names the kind in the table of a side: "contact", "velocity"; "": its word alone
  std::string_view word;     ///< value of that key, or of the side itself; "": the key itself says it
  std::string_view meaning;  ///< of the word, for `terp explain`
  std::vector<std::string_view> takes = {};  ///< further keys of that table
  SideAction action = {};
  bool soil_leaves = false;  ///< points that reach the side leave the model
  SideReport report = SideReport::arrival;
  std::string_view label;                                  ///< in `terp check` and its picture
  std::string (*numbers)(const SideCondition&) = nullptr;  ///< that follow the label
  std::string_view legend;                                 ///< of the picture
  std::string_view colour;                                 ///< there
  SideMarks marks = SideMarks::none;                       ///< there, outside of the side
  /// The key and what speaks against its value, which is possible but doubtful; none: nothing does.
  struct Doubt {
    std::string_view key, what, detail;
  };
  std::optional<Doubt> (*doubt)(const SideCondition&) = nullptr;
};

/// In the order of SideKind.
std::span<const SideKindInfo> side_kinds();
const SideKindInfo& info_of(SideKind kind);
/// Those that a table names by this key, in that order; "": those that stand alone.
std::vector<const SideKindInfo*> kinds_named_by(std::string_view key);
/// Keys that name a kind, each once.
std::vector<std::string_view> keys_of_kinds();

/// What a condition does: "contact that never opens, adhesion 8 kPa".
std::string describe(const SideCondition& side);

}  // namespace terp
