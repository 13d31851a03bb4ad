// The estimators of a study: what each is called, which keys of [estimator] it takes, what else it can do. A new one is
// a word of `Estimator`, its entry in the table of estimator_kinds.cpp, and its rule here if it has keys of its own.
#pragma once

#include "math/errors.hpp"
#include "math/types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

enum class Estimator {
  monte_carlo,
  latin_hypercube,
  sobol,
  two_stage,
  multilevel,
  form,
  importance_sampling,
  subset,
  sweep
};

/// A key of [estimator] that must be given, and what for, with an example.
struct NeededKey {
  std::string_view name, why;
};

struct EstimatorInfo {
  Estimator kind;
  std::string_view name, title;
  bool takes_cov = false;                       ///< a study may end by the coefficient of variation
  bool adaptive = false;                        ///< the next realisations follow from the last ones
  bool counts_alike = false;                    ///< P is the share of realisations with an event
  std::string_view remark = {};                 ///< on its bounds; empty: they are proven
  std::vector<std::string_view> keys = {};      ///< of [estimator], beside `kind`
  std::vector<NeededKey> needs = {};            ///< those of `keys` without a default
  std::string_view no_curve = {};               ///< why it takes no [fragility]; empty: it does
  std::string_view inputs_go_with = "a slide";  ///< what inputs are correlated with
};
/// In the order of the enum.
const std::vector<EstimatorInfo>& all_estimators();
inline const EstimatorInfo& info_of(Estimator kind) { return all_estimators()[static_cast<std::size_t>(kind)]; }

/// Of methods that choose their realisations.
struct AdaptiveRule {
  bool of_flood = false;  ///< else P of a slide
  Index block = 16;       ///< realisations that are asked for at a time
};

/// Which realisations of a two-stage study are run in full.
struct TwoStageRule {
  Real factor = 0.0;  ///< those that do not stand with strengths reduced by it
  Real audit = 0.1;   ///< and this share of the others
};

/// Samples of a study with two levels: all are solved with the coarse case, the first `pairs` with the case too.
struct MultilevelRule {
  std::vector<std::string> coarse;  ///< KEY=VALUE, changes of the case that make it cheap
  Index pairs = 0;
};

enum class SweepForm { grid, table };

struct StudySettings;
struct StudyKey;

/// Keys of [estimator]; what is read goes to `settings`, which must outlive them. `coarse` is read as `set` is.
std::vector<StudyKey> keys_of_estimators(StudySettings& settings);

/// Adds a problem for each part of the file that does not go with the kind of its estimator.
void check_estimator(const StudySettings& settings, std::vector<Problem>& problems);

/// What the estimator does with the realisations, a line for `terp study check`; empty where its title says it.
std::string plan_of_estimator(const StudySettings& settings);

}  // namespace terp
