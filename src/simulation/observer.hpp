// What a run shows to the outside. simulation/ calls an Observer; output/ and app/ implement it.
#pragma once

#include "base/types.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

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

/// One row of history.csv.
struct HistoryRow {
  Real time;          ///< [s]
  std::string point;  ///< the user's name, "A"
  std::int64_t id;
  Real x, y;                      ///< [m]
  Real eps_deviatoric, eps_eq_p;  ///< [-]
  Real su;                        ///< [Pa]; NaN where the material has none
  Real pressure;                  ///< tr(sigma)/3, tension positive [Pa]
};

/// One row of left_the_mesh.csv: a point that crossed an open side.
struct LeftPoint {
  Real time;  ///< [s]
  std::int64_t id;
  Vec<2> x;            ///< where [m]
  Vec<2> v;            ///< how fast [m/s]
  Real mass;           ///< [kg per m]
  Real elastic = 0.0;  ///< elastic energy that it took along [J per m]; not in the table
  Real volume = 0.0;   ///< [m^2]; not in the table
};

/// One row of ledger.csv. Energies in J per metre of thickness; work is positive when it adds energy to the soil.
struct LedgerRow {
  Real time = 0.0;
  std::int64_t step = 0;
  Real kinetic = 0.0;        ///< of the material points
  Real kinetic_nodal = 0.0;  ///< of the nodes at the start of the last step: the part of it that the mesh sees
  Real elastic = 0.0;        ///< stored
  Real plastic = 0.0;        ///< dissipated so far
  Real gravity_work = 0.0, damping_work = 0.0, boundary_work = 0.0;  ///< so far
  Real left_energy = 0.0;  ///< kinetic + elastic of the points that left through open sides so far
  Real numerical = 0.0;    ///< gained by the balance: kinetic + elastic + plastic + left_energy - works - their start
  Real mass = 0.0;         ///< [kg per m]
  Real momentum_x = 0.0, momentum_y = 0.0;           ///< [kg m/s per m]
  std::int64_t clamped = 0;                          ///< points put back at a wall so far
  std::int64_t left = 0;                             ///< points that left through open sides so far
  Real front_x = 0.0, crest_x = 0.0, crest_y = 0.0;  ///< of the slope to the right [m]; NaN if not defined
  Real front_left_x = 0.0, crest_left_x = 0.0, crest_left_y = 0.0;  ///< of the slope to the left
  Real moved_volume = 0.0;                                          ///< volume away from its first place [m^2]
  Real v_max = 0.0, v_999 = 0.0;                                    ///< largest speed, and its 99.9 % quantile [m/s]
};

/// One row of footings.csv.
struct FootingRow {
  Real time;                            ///< [s]
  std::string footing;                  ///< the user's name
  Real displacement_x, displacement_y;  ///< since t = 0 [m]
  Real reaction_x, reaction_y;          ///< force of the soil on the footing, mean since the row before [N per m]
  Real work;                            ///< done on the soil so far [J per m]; part of the ledger's boundary_work
};

/// A named array of a checkpoint, or rows of it.
struct NamedArray {
  std::string name;
  std::vector<std::int64_t> shape;  ///< of the whole
  std::variant<std::vector<Real>, std::vector<std::int64_t>> values;
  std::int64_t first =
      0;  ///< row of the whole that the first values are; arrays come from their first row to their last
};

/// Everything a checkpoint holds, or a part of a large one.
struct StateImage {
  Real time = 0.0;
  std::int64_t step = 0;
  std::vector<NamedArray> arrays;
  int part = 0;      ///< parts come in order
  bool last = true;  ///< no further part follows
  std::string case_record =
      {};                   ///< what the run began with, in the words of its writer; of a whole image that was read
  std::string tables = {};  ///< what its tables held by then, the same
};

/// How far a run is.
struct Progress {
  Real time, end_time;  ///< [s]
  std::int64_t step, n_steps, n_points;
  double wall_s;             ///< spent solving in this process
  double point_steps_per_s;  ///< over this process
  double eta_s;              ///< to the end
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
  virtual void history(const std::vector<HistoryRow>&) {}
  virtual void ledger(const LedgerRow&) {}
  virtual void left(const std::vector<LeftPoint>&) {}
  virtual void footings(const std::vector<FootingRow>&) {}
  virtual void checkpoint(const std::shared_ptr<const StateImage>&) {}
  virtual void progress(const Progress&) {}
  /// Keeps the state of a run that stopped itself; returns where it was saved, or nothing.
  virtual std::string save_failed(const StateImage&) { return {}; }
};

}  // namespace terp
