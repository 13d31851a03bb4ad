// Scratch that every step writes anew, and the clock of the passes.
#pragma once

#include "mpm/features/slots.hpp"
#include "mpm/kernels/cell_sums.hpp"
#include "mpm/kernels/damping.hpp"
#include "mpm/points/point_blocks.hpp"
#include "mpm/step/outer_forces.hpp"
#include "mpm/step/score.hpp"
#include "os/memory.hpp"
#include "os/threads.hpp"

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;

/// A node of the background mesh during a step.
struct NodeValues {
  Real mass = 0.0;      ///< m_i [kg per m]
  Vec<2> v{0.0, 0.0};   ///< velocity: at the start of the step, v* after pass 2, remapped after pass 4 [m/s]
  Vec<2> dv{0.0, 0.0};  ///< a_i dt [m/s]
  Vec<2> internal{0.0, 0.0}, damping{0.0, 0.0},
      boundary{0.0, 0.0};  ///< forces of the step, kept for the ledger [N per m]
};

/// Sums over the nodes of one chunk.
struct NodeSums {
  Real gravity = 0.0, damping = 0.0, boundary = 0.0, clamps = 0.0, internal = 0.0;  ///< work of the step [J per m]
  OuterWork outer{};                    ///< the same of forces from outside [J per m]
  Real unbalanced = 0.0, weight = 0.0;  ///< sum of |m a| but for damping, of |m g| [N per m]
  Real fastest = 0.0;                   ///< largest squared speed of a node that counts for rest [m^2/s^2]
  Real kinetic = 0.0;                   ///< of the nodes at the start of the step [J per m]
  Real stiffness = 0.0, inertia = 0.0;  ///< of SearchScratch
  bool finite = true;
};

/// Sums over the cells of one chunk, and where the points are listed that left their cell.
struct CellSums {
  Real plastic = 0.0;             ///< work of the step [J per m]
  Real slip = 0.0;                ///< of soils along their border in the step [J per m]
  Real taken = 0.0, reset = 0.0;  ///< of StressSums [J per m]
  Real relaxation = 0.0;          ///< kinetic energy that velocities gain as they fade [J per m]
  int thread = 0;                 ///< whose list holds the points that left
  std::size_t first_leaving = 0, end_of_leaving = 0;
};

inline constexpr Index cells_per_chunk =
    2 * pack_width;  // 400 points at 5 x 5: about 10 us, long against claiming a chunk
inline constexpr Index nodes_per_chunk = 128;

/// Looks on in each step, when its forces and works are known, before points go to other cells.
class StepWatcher {
 public:
  virtual ~StepWatcher() = default;
  virtual void step(const StepModel& model, const Workspace& work) = 0;
};

struct Workspace {
  explicit Workspace(const StepModel& model, const StepState& state);

  /// Fits the arrays to the occupied cells; asks for memory only when they grew.
  void fit(const StepModel& model, const StepState& state);
  /// In the search for equilibrium, which knows neither footings nor loads for a time.
  bool settles() const { return static_cast<bool>(with.search); }
  Index chunk_of(const NodeSums& sums) const { return static_cast<Index>(&sums - node_sums.data()); }

  Threads threads;
  std::vector<CornerSums<Quad4>> corners;  ///< shape [n_occupied]
  ZeroedArray<GaussValues<Quad4, Pack>>
      gauss;  ///< shape [n_materials * n_bodies * n_groups at least]; a scheme may use few of them or none
  ZeroedArray<GaussRow<Quad4>>
      gauss_rows;              ///< shape [n_materials * n_bodies * n_groups at least, n_gauss_rows]; used like `gauss`
  Index n_gauss_rows = 0;      ///< the most that any law adds to the points
  std::vector<Real> pressure;  ///< p_e [Pa], shape [n_blocks]; of schemes that keep no other Gauss values
  ZeroedArray<NodeValues> node;     ///< shape [n_nodes]; only those of active nodes are written
  std::vector<Index> active_nodes;  ///< nodes of occupied cells, ascending
  std::vector<std::uint64_t> node_bits;
  std::vector<NodeSums> node_sums;  ///< by chunk
  std::vector<CellSums> cell_sums;  ///< by chunk
  std::vector<std::vector<PointPlace>>
      points_leaving;                            ///< points that left their cell, by thread; in the order of its chunks
  std::vector<Real> point_leaving;               ///< values of the point being moved
  std::array<OuterForces, n_outer_kinds> outer;  ///< forces from outside
  ScratchSlots with;                             ///< the features
  Scores scores;                                 ///< chosen by the first step
  std::vector<double> seconds;                   ///< spent in each pass (passes.hpp)
  StepWatcher* watcher = nullptr;                ///< not owned; nullptr: none
  Vec<2> gravity{0.0, 0.0};                      ///< in this step [m/s^2]
  Damping damping;                               ///< the same
  bool cells_changed = false;                    ///< in the last step cells filled or emptied
  bool finite = true;                            ///< no nodal value was NaN or infinite in the last step
  Real unbalanced_ratio = 0.0;                   ///< sum |m a|, but for damping, over sum |m g| in the last step
  Real kinetic_nodal = 0.0;                      ///< 1/2 sum m_i |v_i|^2 at the start of the last step [J per m]
};

}  // namespace terp
