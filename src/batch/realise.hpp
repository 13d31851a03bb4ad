// One realisation: drawn, solved in memory on the caller's thread, and what of it is kept.
// Not for: runs with files, which `terp run` makes of the same changes.
#pragma once

#include "math/quantity.hpp"
#include "run/loop/simulation.hpp"
#include "batch/study.hpp"

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace terp {

/// A number that is kept of a realisation.
struct OutcomeInfo {
  QuantityInfo info;
  Real (*of_summary)(const Summary& summary);  ///< NaN: not defined. Null: it needs the points of the run
  Real (*of_run)(const Simulation& simulation, const Summary& summary, const EventRule& event) = nullptr;
};
/// In the order of the store and of the table. A new one is an entry in realise.cpp.
std::span<const OutcomeInfo> study_outcomes();
/// Number of the outcome of that name; it must be there.
std::size_t outcome_number(std::string_view name);

/// Names of outcomes of which one is not the other, to the bit; NaN is a value.
std::vector<std::string> differing_outcomes(const std::vector<Real>& kept, const std::vector<Real>& now);

/// What the first of two stages says of a realisation.
enum class Screening { none, falls, audited, skipped };  ///< the last two stand; a part of them is run all the same

struct Realisation {
  Index number = 0;
  std::vector<Real> inputs = {};  ///< as Study::input_names()
  std::string fault = {};         ///< why there is no result, on one line; empty: none
  Screening screening = Screening::none;
  bool is_held = false;  ///< it slides as drawn, and was solved once more with [held]
  bool slid = false;     ///< I; with a fault: the soil slides as it is drawn, and no more is known
  bool flooded = false;  ///< F; false where nothing is said of water
  bool judges_flood = false;
  std::vector<Real> outcomes = {};         ///< as study_outcomes(); empty where it is not solved
  double wall_s = 0.0, processor_s = 0.0;  ///< processor_s: of the one thread that solved it

  bool skipped() const { return screening == Screening::skipped; }
  bool solved() const { return fault.empty() && !skipped(); }
  /// It cannot stand in the section as it is drawn: an event I, of which F is not known.
  bool slides_as_drawn() const { return !fault.empty() && slid; }
  /// It was run, and neither I nor F is known.
  bool failed() const { return !fault.empty() && !slid; }
  /// Whether it floods is known: not of soil that still moves so fast that it may.
  bool knows_flood() const;
  /// But for the clock.
  bool same_as(const Realisation& other) const;
};

/// None: stopped before its end. Memory and disks that fail are thrown on; a case that is refused and a run that stops
/// itself are faults of the realisation.
std::optional<Realisation> realise(const Study& study, Index number, const Draw& draw, const std::atomic<bool>& stop);

/// What is kept of a run that was solved to its end.
void read_outcomes(const Simulation& simulation, const EventRule& event, Realisation& realisation);

}  // namespace terp
