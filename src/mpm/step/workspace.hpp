// Scratch that every step writes anew, and the clock of the passes.
#pragma once

#include "mpm/kernels/nodal_pressure.hpp"
#include "os/threads.hpp"
#include "os/memory.hpp"
#include "mpm/schemes/block_slip.hpp"
#include "mpm/kernels/cell_balance.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/outer_forces.hpp"
#include "mpm/step/passes.hpp"
#include "mpm/kernels/held_shares.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace terp {

struct NodeSpread;
struct PatchValues;

/// A node of the background mesh during a step.
struct NodeValues {
  Real mass = 0.0;      ///< m_i [kg per m]
  Vec<2> v{0.0, 0.0};   ///< velocity: at the start of the step, v* after pass 2, remapped after pass 4 [m/s]
  Vec<2> dv{0.0, 0.0};  ///< a_i dt [m/s]
  Vec<2> internal{0.0, 0.0}, damping{0.0, 0.0},
      boundary{0.0, 0.0};  ///< forces of the step, kept for the ledger [N per m]
};

/// Of the search for equilibrium, which adds and follows forces of its own (equilibrium.hpp).
struct SearchForces {
  std::vector<Vec<2>> held;             ///< what held each node at rest in the first step [N per m], shape [n_nodes]
  std::vector<Vec<2>> last;             ///< out of balance at the last step [N per m], shape [n_nodes]
  Real share = 0.0;                     ///< of the held forces that has been let go; 0: of the first step
  Real viscous = 0.0;                   ///< damping in proportion to the nodal mass [1/s]
  Real stiffness = 0.0, inertia = 0.0;  ///< v K v and v M v in the last step [N m/s^2 per m]
};

/// Sums over the nodes of one chunk.
struct NodeSums {
  Real gravity = 0.0, damping = 0.0, boundary = 0.0, clamps = 0.0, internal = 0.0;  ///< work of the step [J per m]
  OuterWork outer{};                            ///< the same of forces from outside [J per m]
  Real unbalanced = 0.0, weight = 0.0;          ///< sum of |m a| but for damping, of |m g| [N per m]
  Real fastest = 0.0;                           ///< largest squared speed of a node that counts for rest [m^2/s^2]
  Real kinetic = 0.0;                           ///< of the nodes at the start of the step [J per m]
  Real stiffness = 0.0, inertia = 0.0;          ///< of SearchForces
  std::array<Vec<2>, most_footings> footing{};  ///< impulse of each footing on its nodes [N s per m]
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

/// Of nonlocal softening, at the corners of one cell: sums over the points that can soften.
struct CornerSoftening {
  PerCorner<Quad4> volume;          ///< [m^2]
  PerCorner<Quad4> increment;       ///< volume times increment [m^2]
  PerCorner<Quad4> length_squared;  ///< volume times l^2 [m^4]
};

/// Cells and nodes that softening can reach in a step.
struct SofteningReach {
  std::vector<std::uint8_t> has_cell, has_node;  ///< shape [n_cells], [pack_width * n_groups] of NodeDiffusion
  std::vector<Index> cells;                      ///< in the order in which they are found

  void enter(Index cell)
  {
    if (std::exchange(has_cell[cell], 1) == 0) cells.push_back(cell);
  }
  bool has_any_of_group(Index g) const
  {
    const auto* nodes = &has_node[pack_width * g];
    return std::any_of(nodes, nodes + pack_width, [](auto has) { return has != 0; });
  }
  void clear()
  {
    cells.clear();
    std::ranges::fill(has_cell, 0);
    std::ranges::fill(has_node, 0);
  }
};

inline constexpr int n_fit_terms = Quad4::n_corners * (Quad4::n_corners + 1) / 2;

/// Of the points of one cell, at its corners (point_noise.hpp).
struct CornerFit {
  PerCorner<Quad4> mass;                 ///< sum m_p N_i [kg per m]
  std::array<Real, n_fit_terms> matrix;  ///< sum m_p N_i N_j, the lower half by rows [kg per m]
  CornerVectors<Quad4> momentum;         ///< sum m_p N_i v_p, then mass times the fitted velocity [kg/s]
};

/// Of a node, while the acceleration of the cells is found (balance_passes.hpp).
struct BalanceNode {
  Real mass = 0.0;                ///< 0: the node does not move [kg per m]
  Vec<2> v{0.0, 0.0};             ///< at the start of the step [m/s]
  Vec<2> force{0.0, 0.0};         ///< out of balance without that of the slope of the pressure [N per m]
  Vec<2> acceleration{0.0, 0.0};  ///< [m/s^2]
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
  ~Workspace();

  /// Fits the arrays to the occupied cells; asks for memory only when they grew.
  void fit(const StepModel& model, const StepState& state);
  /// The pressures on the nodes are of another stage, or of another time: the next step sets them.
  void forget_water() { water_moment.time = std::numeric_limits<Real>::quiet_NaN(); }
  Threads threads;
  std::vector<CornerSums<Quad4>> corners;  ///< shape [n_occupied]
  ZeroedArray<GaussValues<Quad4, Pack>>
      gauss;  ///< shape [n_materials * n_bodies * n_groups at least]; a scheme may use few of them or none
  ZeroedArray<GaussRow<Quad4>>
      gauss_rows;              ///< shape [n_materials * n_bodies * n_groups at least, n_gauss_rows]; used like `gauss`
  Index n_gauss_rows = 0;      ///< the most that any law adds to the points
  std::vector<Real> pressure;  ///< p_e [Pa], shape [n_blocks]; of schemes that keep no other Gauss values
  std::vector<Real> excess;    ///< u_e [Pa], shape [n_blocks]; empty: no soil has excess pressure
  ZeroedArray<VolumeGradient<Quad4>> volume_gradients;  ///< shape [n_groups]; empty: volume_change = centre
  std::vector<CellBalance> balance;       ///< shape [n_occupied]; empty: no block has a slope of its pressure
  std::vector<BalanceNode> balance_node;  ///< shape [n_nodes]; of the same
  std::vector<PerGauss<Quad4>>
      ratios;                    ///< shape [n_blocks]; empty: strain_shares = plain (mpm/schemes/share_ratio.hpp)
  std::vector<BlockSlip> slips;  ///< shape [n_blocks]; empty: soils do not slip in the cells that they share
  std::unique_ptr<PatchValues> patches;            ///< of shares that overlap
  WaterMoment water_moment;                        ///< that `pore` is of, with
  std::vector<Real> water_loads;                   ///< the pressures of the loads [Pa]
  PorePressure pore;                               ///< on the nodes; empty without water
  std::vector<CornerSoftening> softening_corners;  ///< shape [n_occupied]; of nonlocal softening
  std::unique_ptr<NodeSpread> softening;           ///< of nonlocal softening
  std::vector<std::uint8_t> cell_softens;          ///< whether a point of a cell softened, shape [n_occupied]
  SofteningReach softening_reach;
  std::vector<CornerFit> fits;      ///< shape [n_occupied]; of velocities that relax
  std::vector<Vec<2>> fitted;       ///< U_i of the same [m/s], shape [n_nodes]
  ZeroedArray<NodeValues> node;     ///< shape [n_nodes]; only those of active nodes are written
  std::vector<Index> active_nodes;  ///< nodes of occupied cells, ascending
  std::vector<std::uint64_t> node_bits;
  std::vector<NodeSums> node_sums;  ///< by chunk
  std::vector<CellSums> cell_sums;  ///< by chunk
  std::vector<std::vector<PointPlace>>
      points_leaving;                      ///< points that left their cell, by thread; in the order of its chunks
  std::vector<Real> point_leaving;         ///< values of the point being moved
  std::array<double, n_passes> seconds{};  ///< spent in each pass
  std::vector<PlacedFooting> footings;     ///< in this step
  std::array<Vec<2>, most_footings> footing_impulse{};  ///< of each on its nodes, in the last step [N s per m]
  std::array<OuterForces, n_outer_kinds> outer;         ///< forces from outside
  HeldShares held;                                      ///< of the weight of bodies that come or go, in this step
  std::vector<Real> load_pressure;                      ///< of each load in this step [Pa]
  bool settling = false;           ///< in the search for equilibrium, which knows neither footings nor loads for a time
  SearchForces search = {};        ///< of the same
  Vec<2> gravity{0.0, 0.0};        ///< in this step [m/s^2]
  bool watches_rest = false;       ///< `fastest_node` is wanted
  StepWatcher* watcher = nullptr;  ///< not owned; nullptr: none
  Real fastest_node = std::numeric_limits<Real>::quiet_NaN();  ///< largest speed of a node that counts for rest [m/s]
  Real damping_local = 0.0;     ///< alpha in force: the model's, or that of the search for equilibrium
  bool finite = true;           ///< no nodal value was NaN or infinite in the last step
  Real unbalanced_ratio = 0.0;  ///< sum |m a|, but for damping, over sum |m g| in the last step
  Real kinetic_nodal = 0.0;     ///< 1/2 sum m_i |v_i|^2 at the start of the last step [J per m]

  /// From the next step on the soil settles, its first forces out of balance held.
  void begin_search()
  {
    const std::vector<Vec<2>> none(node.size(), Vec<2>{0.0, 0.0});
    settling = true;
    search = {.held = none, .last = none};
  }
};

}  // namespace terp
