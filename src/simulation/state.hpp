// What changes during a run and must survive it: exactly what a checkpoint holds.
#pragma once

#include "events/crest.hpp"
#include "events/slip_surface.hpp"
#include "points/point_blocks.hpp"
#include "simulation/observer.hpp"

#include <map>
#include <vector>

namespace terp {

/// Work done so far [J per m]; positive when it adds energy to the soil.
struct WorkTotals {
  Real gravity = 0.0, damping = 0.0, boundary = 0.0;
  Real plastic = 0.0;    ///< dissipated
  Real internal = 0.0;   ///< of the internal forces on the nodes
  Real exchanged = 0.0;  ///< largest sum of the sizes of gravity, damping, boundary and plastic so far: what swings to
                         ///< and fro was exchanged, too
  Real last_step = 0.0;  ///< gravity, damping, boundary and internal, in the last step alone
};

/// What the history audit remembers of each point; by id. Judged at ledger rows.
struct HistoryAudit {
  std::vector<Real> last_eps_eq_p;  ///< at the last ledger row
  std::vector<Real> last_su;        ///< the same; empty where no material needs it: eps_eq_p alone tells S_u
  std::vector<bool> fell, rose;     ///< true where eps_eq_p ever fell, S_u ever rose
};

/// What a footing has met so far.
struct FootingMeter {
  Vec<2> impulse{0.0, 0.0};   ///< of the soil on it since `since` [N s per m]
  Real since = 0.0;           ///< time of the last row of footings.csv [s]
  Vec<2> reaction{0.0, 0.0};  ///< of that row: mean force of the soil on the footing since the row before [N per m]
  Real largest = 0.0;         ///< largest reaction of any row, against the motion [N per m]
  Real work = 0.0;            ///< done on the soil [J per m]
};

/// What is followed of a slope.
struct SlopeFailure {
  CrestHistory crest;
  std::vector<SlipSurface> slip;  ///< of each slide so far, when its strain grew fastest; one before there is any slide
};

struct State {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  PointBlocks<2> points;
  std::vector<Real> x_initial;  ///< by id, shape [n_points, 2] [m]
  WorkTotals work;
  std::int64_t equilibrium_steps = 0;  ///< made in the search for equilibrium, while the clock stands at 0
  Real start_energy = 0.0;             ///< kinetic + elastic at t = 0 [J per m]
  std::int64_t clamped = 0;            ///< points that ever had to be put back at a wall
  std::vector<bool> put_back;          ///< which, by id
  std::vector<LeftPoint> left;         ///< points that crossed an open side, in the order in which they did
  std::size_t left_reported = 0;       ///< how many of them have a row in left_the_mesh.csv
  HistoryAudit audit;
  std::map<std::string, std::int64_t, std::less<>> rows_reported;  ///< so far, by table
  std::int64_t frames_reported = 0;
  Section section;                   ///< at t = 0
  std::vector<SlopeFailure> slopes;  ///< of the section, in its order
  std::vector<Real> side_reached;  ///< when soil first lay in a cell at each side of the mesh, or rose there [s]; 0: at
                                   ///< the start, NaN: not yet
  std::vector<Real> side_top;      ///< top of the cells with soil at each steep side at the start [m]; NaN: none
  std::vector<FootingMeter> footings;                    ///< in the order of the case
  std::vector<std::pair<Real, Real>> softened_fraction;  ///< at the frame times
  Real largest_v_999 = 0.0;                              ///< [m/s]
  /// Points at t = 0; ids run from 0 to this.
  std::int64_t n_ids() const { return static_cast<std::int64_t>(x_initial.size() / 2); }
  double wall_s = 0.0;            ///< spent solving, over all processes
  std::string instructions = {};  ///< sets that the run was solved with, in their order; empty: that of this process
};

}  // namespace terp
