// What the realisations say: probabilities with their bounds, what remains, which inputs matter.
#pragma once

#include "batch/multilevel.hpp"
#include "batch/reliability.hpp"
#include "batch/statistics.hpp"
#include "batch/store.hpp"

#include <string>
#include <vector>

namespace terp {

/// An event in a sample. solved: of which it is known; failed: of which it is not. These may have been either: they
/// count as not happened in the lower bound, as happened in the upper one.
struct EventEstimate {
  std::int64_t happened = 0, solved = 0, failed = 0;
  Bounds bounds = {};
  bool counts_alike = true;
  std::optional<Real> weighted = {};  ///< P of a sample whose realisations do not count alike; none: not known

  /// Share of what is known; none of nothing. Where some failed it is biased: these are no random sample.
  std::optional<Real> probability() const;
};
EventEstimate estimate_event(std::int64_t happened, std::int64_t solved, std::int64_t failed, Real confidence);

/// Sums over a table that grows by one realisation after another.
struct EventCounts {
  std::int64_t solved = 0, failed = 0, slid = 0, flooded = 0, flooded_after_slide = 0;
  std::int64_t judged = 0, slid_judged = 0;  ///< solved with a water level, so that F is known
  std::int64_t slid_as_drawn = 0;            ///< of `slid`; neither solved nor failed, as I is known and F is not

  std::int64_t n() const { return solved + failed + slid_as_drawn; }
  /// Realisations of which a member, a number of events, is not known.
  std::int64_t unknown(std::int64_t EventCounts::*event) const;

  void take(const Realisation& realisation);
};

EventCounts operator+(const EventCounts& a, const EventCounts& b);

/// The table of a study, in one or two stages or on two levels.
class Sample {
 public:
  explicit Sample(const StudySettings& settings) : settings_(&settings) {}

  void take(const Realisation& realisation, bool is_coarse = false);
  EventEstimate slide(Real confidence) const { return estimate(&EventCounts::slid, confidence); }
  EventEstimate flood(Real confidence) const { return estimate(&EventCounts::flooded, confidence); }
  EventEstimate flood_after_slide(Real confidence) const;
  /// With the confidence of the study.
  EventEstimate slide() const { return slide(settings_->confidence); }
  EventEstimate flood() const { return flood(settings_->confidence); }
  EventEstimate flood_after_slide() const { return flood_after_slide(settings_->confidence); }
  /// As if nothing above the factor of a two-stage study could happen.
  EventEstimate trusting(bool of_flood) const;

  const EventCounts& run_for_falling() const { return all_; }
  const EventCounts& audited() const { return audited_; }
  const EventCounts& coarse() const { return coarse_; }
  const TwoLevels& levels() const { return levels_; }
  EventCounts counts() const;  ///< of all that were run with the case itself, as if they counted alike
  std::int64_t n_skipped() const { return n_skipped_; }
  bool judges_flood() const { return judges_flood_; }
  /// Those that the rule of the study counts: F where floods are judged, else I.
  std::int64_t rule_events() const { return judges_flood_ ? all_.flooded : all_.slid; }

 private:
  EventEstimate estimate(std::int64_t EventCounts::*event, Real confidence) const;
  EventEstimate weigh(std::int64_t EventCounts::*event, Real confidence) const;
  std::optional<Real> weighted_worth() const;

  const StudySettings* settings_;
  EventCounts all_ = {};  ///< of two stages: those that fall at the factor
  EventCounts audited_ = {};
  EventCounts coarse_ = {};  ///< of two levels; `all_` are the fine ones
  TwoLevels levels_ = {};
  std::int64_t n_skipped_ = 0;
  bool judges_flood_ = false;  ///< any of them
};

/// How an input goes with the outcomes: rank correlations.
struct Sensitivity {
  std::string input;
  std::optional<Real> with_slide, with_height;  ///< with_slide: or as EstimatorInfo::inputs_go_with says
};

/// What a method that chooses its realisations says of those that are kept.
struct AdaptiveFound {
  std::optional<ReliabilityResult> result = {};  ///< none: it asks for a realisation that is missing, or has a fault
  std::string fault = {};                        ///< why it ended without a result; empty: none
};

struct FaultCount {
  std::string what;
  Index first = 0;
  int n = 0;
  bool slides = false;  ///< as drawn
};

struct StudyEstimates {
  explicit StudyEstimates(const StudySettings& settings) : sample(settings) {}

  Index n_made = 0;    ///< realisations of the table: 0 ... n_made - 1
  Index n_beyond = 0;  ///< solved, but after a gap, or after the rule has stopped: not in the table
  /// Of those, solved with the case itself and without the event while soil still moves at the end.
  Index n_moving_without_slide = 0, n_moving_without_flood = 0;
  Index n_near = 0;                   ///< that count as F, though the ground was below the water briefly or by little
  Index n_held = 0, n_held_slid = 0;  ///< that slide as drawn, and were held and released; of them, with I then
  bool judges_flood = false;
  EventCounts counts = {};  ///< of all that were run
  EventEstimate slide, flood, flood_after_slide;
  std::vector<Sensitivity> sensitivities;
  std::vector<FaultCount> faults;
  Sample sample;
  AdaptiveFound adaptive = {};  ///< of such a method
  double mean_wall_s = 0.0;
  double mean_processor_s = 0.0;
  double screening_s = 0.0, full_s = 0.0;  ///< means of the two stages, of processor time; 0: not known
  double coarse_s = 0.0, fine_s = 0.0;     ///< means of the two levels, of processor time; 0: not known
  bool rule_met = false;                   ///< the stop rule
};

/// Counts a table as it grows, each realisation once: the first ones without a gap, up to where the rule stops.
/// So neither the order in which they were solved nor how long each took has a say in P.
class TableCounter {
 public:
  explicit TableCounter(const Study& study, const Realisations& rows = {}) : study_(study), counts_(study.settings)
  {
    take(rows);
  }
  void take(const Realisations& rows);
  Index n() const { return n_; }
  bool rule_met() const { return rule_met_; }

 private:
  const Study& study_;
  Sample counts_;
  Index n_ = 0;
  bool rule_met_ = false;
};

StudyEstimates estimate(const Study& study, const Realisations& rows);

}  // namespace terp
