// Two levels: cheap, coarse realisations carry the estimate, and pairs, solved with the coarse and the fine case and
// the same random input, correct it (decision 0056). Fine is the case of the study as it is.
#pragma once

#include "batch/realise.hpp"
#include "batch/statistics.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace terp {

struct EventEstimate;

enum class StudyEvent { slide, flood, slide_and_flood };

/// Fine realisations of pairs that have the same to say on the coarse level.
struct PairGroup {
  std::int64_t n = 0, happened = 0, unknown = 0;  ///< unknown: whether the event happened with the fine case
  std::int64_t known() const { return n - unknown; }
};

/// One event on both levels. A coarse realisation without a result counts as one without the event: that is a level
/// like another, which the pairs correct. So `coarse` is always known.
struct TwoLevelCounts {
  std::int64_t n = 0, coarse = 0;     ///< coarse realisations, and those with the event
  PairGroup with = {}, without = {};  ///< pairs with and without the event on the coarse level

  std::int64_t lost() const { return with.known() - with.happened; }
  std::int64_t gained() const { return without.happened; }
  /// P = P(C) P(F|C) + (1 - P(C)) P(F|not C), C the coarse and F the fine event. The bounds are what two pairs of them
  /// have in common: those of the three shares, and those of the fine realisations alone; each may err by half. No
  /// estimate where no pair says what a coarse event, or none, is worth.
  EventEstimate estimate(Real confidence) const;
  /// Those of as many independent realisations as have the variance of the estimate; not proven. None where too little
  /// is there to tell, as of find_savings.
  std::optional<Bounds> rough_bounds(Real confidence) const;
  /// As if the coarse case were right.
  EventEstimate coarse_alone(Real confidence) const;
};

/// Sums over a table that grows by one realisation after another, in the order of their numbers.
class TwoLevels {
 public:
  void take(const Realisation& realisation, bool is_coarse);
  const TwoLevelCounts& of(StudyEvent event) const { return events_[static_cast<std::size_t>(event)]; }

 private:
  std::array<TwoLevelCounts, 3> events_ = {};
  std::array<bool, 3> last_coarse_ = {};  ///< of the last coarse realisation, whose pair comes next
};

/// What two levels are worth in time; all numbers follow from a sample, and say no more than it does.
struct LevelSavings {
  Real coarse_s = 0.0, fine_s = 0.0;     ///< processor time of one realisation
  Real same_variance = 0.0;              ///< time of Monte Carlo with the fine case alone, over that of the study
  std::optional<Real> same_bounds = {};  ///< the same for bounds as narrow; none where a fine event is not known
  Real best_share = 0.0;          ///< pairs for each coarse realisation with which the variance is least; at most 1
  Real best_same_variance = 0.0;  ///< what `same_variance` is then; at or below 1 two levels do not pay
};

/// None where no event, no other realisation, or no pair of one of the two is there to tell.
std::optional<LevelSavings> find_savings(const TwoLevelCounts& counts, Real coarse_s, Real fine_s, Real confidence);

/// Builds the coarse level; adds a problem where the case does not take it. Does nothing for other estimators.
void prepare_coarse(Study& study, std::vector<Problem>& problems);
/// Adds a problem where `coarse` changes nothing, or makes a case that cannot begin while the fine one can.
void check_levels_differ(const Study& study, std::vector<Problem>& problems);
/// Of the case with its mesh; of two levels of both. What the digits of the case are of.
std::string record_of_case(const Study& study);

}  // namespace terp
