// The numbers that remain of a run: what summary.json holds.
#pragma once

#include "run/report/run_findings.hpp"
#include "math/quantity.hpp"
#include "run/measure/crest.hpp"
#include "run/measure/slip_surface.hpp"
#include "run/report/flood_summary.hpp"
#include "model/case/method_form.hpp"
#include "mpm/step/stage.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace terp {

/// What a footing met in a run.
struct FootingSummary {
  std::string name;
  Vec<2> displacement{0.0, 0.0};  ///< at the end [m]
  Vec<2> reaction{0.0, 0.0};      ///< force of the soil on it, mean over the last interval of the ledger [N per m]
  Real largest = 0.0;             ///< largest reaction against its motion, of such means [N per m]
  Real work = 0.0;                ///< done on the soil [J per m]
};

/// A stage that has ended, or the one that runs; of a run that ended at rest and has no stages: the run, without a
/// name.
struct StageSummary {
  static constexpr Real none = std::numeric_limits<Real>::quiet_NaN();

  std::string name;
  StageRecord record{.end = none, .fastest = none};  ///< without an end: it runs
};

/// "the answer is known: ...", of a stage that the verdict ended; empty: it did not.
std::string why_known(const StageRecord& record);

/// Name of the stage in which a time lies, its end included; empty: it lies in none of them.
std::string stage_at(const std::vector<StageSummary>& stages, std::optional<Real> time);

/// A slide, and where the soil sheared when it sheared fastest, and when the slide was first seen.
struct SlideSummary {
  Slide slide;
  SlipSurface slip;
  SlipSurface onset = {};
  std::string stage = {};  ///< name of that in which it began; empty: of none
};

/// The water that a strength belongs to: names of situations, "start" for that of t = 0.
struct StrengthWater {
  std::string material, parameter;   ///< "peat", "su_peak"
  std::string stress;                ///< of sigma'_v
  std::optional<std::string> daily;  ///< of sigma'_v,daily, from which sigma'_p follows; none: it does not
};

/// A side of the mesh that soil came to during the run.
struct ReachedSide {
  std::string side;
  Real time = 0.0;    ///< of the ledger row at which soil first lay in a cell at it, or had risen [s]
  bool rose = false;  ///< soil lay at it from the start, and rose there
};

/// Wall time spent in a pass of the step.
struct PassTime {
  std::string name;
  double seconds = 0.0;
};

struct Summary {
  std::string scheme;
  std::optional<MethodOptions> method;  ///< that ran; none: not known, as of a run of an older Terp
  Real at_strength = 1.0;               ///< factor by which all strengths were divided, in the last stage so far [-]
  std::int64_t n_points = 0, n_cells = 0, n_steps = 0;
  Real dt = 0.0;                  ///< [s]
  double wall_s = 0.0;            ///< spent solving, over all processes that worked on the run
  double search_s = 0.0;          ///< of it, in the search for equilibrium
  std::int64_t search_steps = 0;  ///< iterations and steps of the same
  double point_steps_per_s = 0.0;
  int threads = 1;
  std::string instructions;      ///< instruction set of the kernels
  std::string processor;         ///< as the system calls it
  std::vector<PassTime> passes;  ///< of the last process
  std::optional<Facing> facing;  ///< of the slope that front, crest and run-out are of; none: the section has no slope
  bool free_toe = true;          ///< of that slope
  Real front_x = std::numeric_limits<Real>::quiet_NaN();  ///< at the end [m]; NaN: none
  std::optional<Real> crest_x;          ///< at the end [m]; none if nothing of the first surface stands
  std::optional<Real> crest_y;          ///< height of the surface there [m]
  std::optional<Real> residual_height;  ///< of the highest ground between river and land, at the end [m]; none without
  Real run_out = std::numeric_limits<Real>::quiet_NaN();  ///< of the front since t = 0 [m]; without a free toe: beyond
                                                          ///< the toe of the slope
  Real moved_distance = 0.0;                              ///< displacement from which on soil counts as moved [m]
  Real moved_volume = 0.0;                                ///< at the end [m^2]
  Real moved_fraction = 0.0;                              ///< of all volume [-]
  std::optional<Real> intact_fraction;      ///< of the volume that moved, with an eps_eq_p below `intact_strain` [-]
  std::vector<SlideSummary> slides;         ///< of all stages, in order of time, definition in docs/formats.md
  std::optional<Real> first_slide_time;     ///< of all stages [s]
  std::optional<Real> second_failure_time;  ///< [s], definition in docs/formats.md
  std::optional<Real> max_eps_eq_p;         ///< at the end [-]; none: all soil is of libraries that do not say which
                                            ///< of their variables it is
  std::optional<Real> softened_strain;      ///< plastic strain from which soil counts as softened: the smallest of the
                                            ///< laws in use, Material::softened_strain() [-]; none: nothing softens
  std::vector<std::pair<Real, Real>>
      softened_fraction;                  ///< (time [s], share of the volume that lost half of its drop [-])
  std::int64_t points_eps_eq_p_fell = 0;  ///< points whose eps_eq_p ever fell between two ledger rows
  std::int64_t points_su_rose = 0;        ///< points whose S_u ever rose between two ledger rows
  Real unexplained_energy = 0.0;          ///< the most so far over what came from outside [-]
  Real energy_balance_error = 0.0;  ///< |numerical| at the end over the energy exchanged: works, plastic, start [-]
  std::int64_t clamped_points = 0;
  std::vector<ReachedSide>
      reached_sides;             ///< in order of time; without open sides and those where soil lay at the start
  std::int64_t points_left = 0;  ///< through open sides
  std::vector<FootingSummary> footings;
  std::optional<FloodSummary> flood;  ///< none without a water level
  std::vector<StageSummary> stages;
  std::vector<StrengthWater> strength_water;         ///< of strengths that follow from the effective stress
  std::map<std::string, Real, std::less<>> numbers;  ///< of followers, under the names that they declare; NaN: none
  std::vector<RunFinding> findings;                  ///< what the numbers say against themselves
  Real v_999 = 0.0;  ///< largest 99.9 % quantile of the speed over all ledger rows [m/s]
};

/// A key of summary.json that is a single value: what it is, and the member of Summary that has it.
struct SummaryQuantity {
  QuantityInfo info;
  std::variant<Real Summary::*, std::optional<Real> Summary::*, std::int64_t Summary::*, int Summary::*,
      bool Summary::*, std::string Summary::*>
      member;

  /// As a number; none for a text, or where it is not defined.
  std::optional<Real> number(const Summary& summary) const;
};

/// In the order of summary.json. A new one is a member and an entry in summary.cpp; numbers of followers are not here.
std::span<const SummaryQuantity> summary_quantities();
/// nullptr: there is none of that name.
const SummaryQuantity* find_summary_quantity(std::string_view name);

}  // namespace terp
