// What a run shows to the outside. simulation/ calls an Observer; output/ and src/cli/ implement it.
#pragma once

#include "mpm/step/state_arrays.hpp"
#include "run/report/run_table.hpp"

namespace terp {

/// One field of all material points, sorted by id, so that entry k is the same point in every frame.
struct PointField {
  std::string name;  ///< "velocity", "stress", "eps_eq_p", ...
  std::string unit;  ///< "m/s", "Pa", "-", ...
  int n_components = 1;
  std::vector<Real> values;  ///< shape [n_points, n_components], row-major
};

/// Material points at one time: all of them, or a part of a large frame.
struct Frame {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  std::vector<Real> x;             ///< positions [m], shape [n_points, 2]
  std::vector<PointField> fields;  ///< same names, order and sizes in every frame of a run
  std::int64_t first = 0;          ///< id of the first point
  std::int64_t n_all = 0;          ///< points of the whole frame; 0: these are all

  std::int64_t n_points() const { return static_cast<std::int64_t>(x.size() / 2); }
  std::int64_t n_whole() const { return n_all > 0 ? n_all : n_points(); }
  bool ends() const { return first + n_points() == n_whole(); }
};

/// Everything a checkpoint holds, or a part of a large one.
struct StateImage {
  Real time = 0.0;
  std::int64_t step = 0;
  std::vector<NamedArray> arrays;
  int part = 0;            ///< parts come in order
  bool last = true;        ///< no further part follows
  std::string stage = {};  ///< file of a stage that ended with it, "stage_01_daily.h5"; empty: none did
  std::string case_record =
      {};                   ///< what the run began with, in the words of its writer; of a whole image that was read
  std::string tables = {};  ///< what its tables held by then, the same
};

/// How far a run is.
struct Progress {
  Real time, end_time;  ///< [s]
  std::int64_t step, n_steps, n_points;
  double wall_s;               ///< spent solving in this process
  double point_steps_per_s;    ///< over this process
  double eta_s;                ///< to the end
  Real out_of_balance = -1.0;  ///< in the search for equilibrium: force over weight [-]; step and n_steps are its own
  Real limit = 0.0;            ///< at which it ends [-]
  bool at_most = false;        ///< the run may end at rest before
  std::string stage = {};      ///< name of the stage; empty: the run has none
};

/// Points beyond which frames and images are shown in parts, so that a run of millions of points need not hold a second
/// copy of them.
inline constexpr std::int64_t most_points_at_once = 250'000;
inline constexpr std::int64_t points_per_part = 1 << 14;

/// Called by the run, in the run's own thread. Times are those of the schedule (docs/formats.md). Frames and images are
/// large: an observer may keep them after the call, but of those that come in parts not many.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void frame(const std::shared_ptr<const Frame>&) {}
  /// Rows of one table, at least one.
  virtual void rows(const std::vector<TableRow>&) {}
  virtual void checkpoint(const std::shared_ptr<const StateImage>&) {}
  virtual void progress(const Progress&) {}
  /// Keeps the state of a run that stopped itself; returns where it was saved, or nothing.
  virtual std::string save_failed(const StateImage&) { return {}; }
};

}  // namespace terp
