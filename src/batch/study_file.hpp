// What a study file says: which numbers of a case are random, how many realisations, what counts as a slide. Keys:
// study_keys.cpp, docs/probability.md.
// Not for: whether the case takes what is drawn (study.hpp).
#pragma once

#include "io/case/document.hpp"
#include "io/case/values.hpp"
#include "batch/distribution.hpp"
#include "batch/estimator_kinds.hpp"
#include "batch/follow.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace terp {

/// A key of the case that is drawn, one number for all of the soil.
struct RandomNumber {
  std::string key = {};   ///< of the case: "material.peat.su_peak.shansep.pop"; or the name that formulas have
  bool is_name = false;   ///< keys of [follow] have formulas of it
  std::string unit = {};  ///< of the values
  std::string path = {};  ///< in the study file: "random[0]"
  Distribution distribution = {};
};

/// A parameter that varies from place to place. What is kept as TOML goes to the case as it is.
struct RandomFieldKey {
  std::string key = {}, path = {};
  std::string distribution = "lognormal", correlation = "markov";
  Real cov = 0.0;
  Vec<2> scale{0.0, 0.0};                         ///< of fluctuation, along x and y [m]
  std::string mean = {}, known = {};              ///< TOML; empty: that of the case; none
  std::optional<std::array<Vec<2>, 2>> box = {};  ///< none: about the bodies of the material
};

/// Of the standard normal scores of two random numbers, or of two fields.
struct StudyCorrelation {
  std::string a = {}, b = {}, path = {};
  Real value = 0.0;
};

/// The load of a fragility curve: P is found at each of its levels, with the same random numbers.
struct FragilityLoad {
  std::string name = "load", unit = {};           ///< of the axis
  std::vector<Real> levels = {};                  ///< ascending
  KeyValues set = {};                             ///< keys of the case; texts in them are formulas of h
  std::optional<Distribution> distribution = {};  ///< of the load, over which the curve is integrated

  std::string label() const { return unit.empty() ? name : name + " [" + unit + "]"; }
  /// KEY=VALUE at a level, as of --set. Throws ExpressionError.
  std::vector<std::string> changes_at(Real level) const;
};

/// A key of the case with the values that it takes in turn.
struct SweepKey {
  std::string key = {}, path = {};
  std::vector<Node> values = {};

  /// All values are numbers without units: they are inputs as they are.
  bool is_of_numbers() const;
};

/// When a study ends: at the first of these.
struct StopRule {
  Index number = 0;  ///< of realisations
  Real cov = 0.0;    ///< of the estimate of P; 0: none
  Real time = 0.0;   ///< of one call of the program [s]; 0: none

  /// Events that `cov` asks for: 1/cov^2, at least 10. The study ends with the last of them, so that the bounds of
  /// Clopper and Pearson hold (docs/probability.md). 0: none.
  std::int64_t events() const;
};

/// What counts as a slide (I).
struct EventRule {
  Real volume = 1.0;        ///< that moved, at least [m^2]
  Real displacement = 0.5;  ///< from where on soil counts as moved [m]
};

struct StudySettings {
  Document source;     ///< of the study file
  std::string name;    ///< of the study file without .toml; of NAME/study.toml NAME
  std::string folder;  ///< that holds it
  std::string title, case_path;
  std::string note;  ///< said wherever a P of the study is said
  Index seed = 1;
  Real confidence = 0.95;
  std::vector<std::string> set;  ///< KEY=VALUE, changes of the case in all realisations
  std::vector<RandomNumber> numbers;
  KeyValues follow;  ///< formulas of numbers that have a name
  KeyValues held;    ///< of realisations that slide as drawn, which are solved once more with them
  std::vector<RandomFieldKey> fields;
  std::vector<StudyCorrelation> correlations;
  Estimator estimator = Estimator::monte_carlo;
  SweepForm form = SweepForm::grid;
  TwoStageRule two_stage;
  MultilevelRule multilevel;
  AdaptiveRule adaptive;
  std::vector<SweepKey> sweep;
  std::optional<FragilityLoad> fragility;
  StopRule stop;
  EventRule event;
  std::vector<Problem> warnings;

  std::vector<std::string> names() const;                                 ///< of numbers that keys follow
  std::vector<Real> named_values(const std::vector<Real>& values) const;  ///< of them, out of those of all numbers
  /// KEY=VALUE of numbers that are drawn, all of them, and of the keys that follow. Throws ExpressionError.
  std::vector<std::string> changes_at(const std::vector<Real>& values) const;
  std::vector<std::string> held_changes_at(const std::vector<Real>& values) const;
  /// All numbers at the value that they do not exceed with this probability.
  std::vector<Real> quantiles(Real p) const;
};

/// Reads a study file. Throws CaseError with what is wrong where, at most ten faults.
StudySettings read_study(const std::string& path);
/// The same for a text in memory; path: what messages call it.
StudySettings read_study_text(const std::string& text, const std::string& path);

/// Throws CaseError if there are problems.
void refuse_if_any(const std::vector<Problem>& problems, const StudySettings& settings);

/// What decides the results of realisations: the file without its comments, title and stop rule, and with the digits
/// of the files that it names. Throws FileError where one cannot be read.
std::string identity_text(const StudySettings& settings);

}  // namespace terp
