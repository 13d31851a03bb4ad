// What the realisations say: probabilities with their bounds, what remains, which inputs matter.
#pragma once

#include "study/statistics.hpp"
#include "study/store.hpp"

#include <string>
#include <vector>

namespace terp {

/// An event in a sample. What failed may have been either: it counts as not happened in the lower bound, as happened in
/// the upper one.
struct EventEstimate {
  std::int64_t happened = 0, solved = 0, failed = 0;
  Bounds bounds = {};

  std::optional<Real> probability() const;  ///< of what was solved; none of nothing
  std::optional<Real> cov() const;          ///< of that estimate; none where nothing happened
};
/// happened out of solved; failed: of which nothing is known.
EventEstimate estimate_event(std::int64_t happened, std::int64_t solved, std::int64_t failed, Real confidence);

/// Sums over a table that grows by one realisation after another.
struct EventCounts {
  std::int64_t solved = 0, failed = 0, slid = 0, flooded = 0, flooded_after_slide = 0, judged = 0;

  void take(const Realisation& realisation);
  EventEstimate slide(Real confidence) const;
  EventEstimate flood(Real confidence) const;
  EventEstimate flood_after_slide(Real confidence) const;
};

/// How an input goes with the outcomes: rank correlations.
struct Sensitivity {
  std::string input;
  std::optional<Real> with_slide, with_height;
};

/// One kind of failed realisation.
struct FaultCount {
  std::string what;
  Index first = 0;
  int n = 0;
};

struct StudyEstimates {
  Index n_made = 0;    ///< realisations of the table: 0 ... n_made - 1
  Index n_beyond = 0;  ///< solved, but after a gap, or after the rule has stopped: not in the table
  bool judges_flood = false;
  EventEstimate slide, flood, flood_after_slide;
  std::vector<Sensitivity> sensitivities;
  std::vector<FaultCount> faults;
  double mean_wall_s = 0.0;
  bool rule_met = false;  ///< the stop rule
};

/// The realisations that count: the first ones without a gap, up to the one at which the rule stops. So neither the
/// order in which they were solved nor how long each took has a say in P.
Index count_in_table(const Study& study, const Realisations& rows, bool& rule_met);

StudyEstimates estimate(const Study& study, const Realisations& rows);

/// P of an event after each realisation, as far as they are in the table: at most `most` of them.
struct RunningEstimate {
  Index n;
  EventEstimate event;
};
std::vector<RunningEstimate> running_estimates(
    const Study& study, const Realisations& rows, bool of_flood, std::size_t most = 200);

}  // namespace terp
