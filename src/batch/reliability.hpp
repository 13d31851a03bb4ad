// Probability of an event by methods that choose the next realisations from the last ones: FORM, importance sampling,
// subset simulation. OpenTURNS has them; it is known to openturns.cpp alone, and a build may lack it.
#pragma once

#include "batch/study_file.hpp"

#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

namespace terp {

/// Values of a limit state at places in the space of independent standard normal scores, shape [n, numbers]: the event
/// happens where it is not above 0. The places of one call are what workers share.
using LimitState = std::function<std::vector<Real>(const std::vector<std::vector<Real>>& scores)>;

struct ReliabilityRule {
  Estimator kind = Estimator::form;
  std::size_t n_numbers = 1;
  Index seed = 1;
  /// Of places: of FORM, after which its search ends with the step that it is in; of importance sampling also of the
  /// samples that follow the search; of subset simulation in each of its levels.
  Index number = 1000;
  Index block = 16;  ///< places of one call
  Real cov = 0.0;    ///< at which importance sampling ends, after `fewest_samples`; 0: at `number`
};

/// Fewer say nothing of their own spread.
inline constexpr Index fewest_samples = 100;
inline constexpr Index fewest_blocks = 10;  ///< of a level of subset simulation

/// The method ended without a result; what() says why, in a sentence.
struct MethodFault : std::runtime_error {
  using runtime_error::runtime_error;
};

struct ReliabilityResult {
  Real probability = 0.0;               ///< 0: no place hit the event, so that there is no estimate
  Real at_most = 1.0;                   ///< where no place hit it: P is roughly not above
  std::optional<Real> cov = {};         ///< of the estimate, as the method itself says; FORM has none
  std::vector<Real> design_point = {};  ///< of FORM and importance sampling, in scores
  std::vector<Real> importance = {};    ///< squares of the direction cosines of the design point; sum 1
  Index n_places = 0;                   ///< at which the limit state was found
  bool converged = true;                ///< FORM found a design point on the limit state
};

/// A library of openturns.cpp with another one was built for another program.
inline constexpr std::size_t reliability_layout = 1000 * sizeof(ReliabilityRule) + sizeof(ReliabilityResult);

/// The library of openturns.cpp lies beside the program, or where `cmake --install` puts it.
bool has_openturns();

/// Throws what `limit` throws, MethodFault, and CaseError where there is no OpenTURNS.
ReliabilityResult find_probability(const ReliabilityRule& rule, const LimitState& limit);

}  // namespace terp
