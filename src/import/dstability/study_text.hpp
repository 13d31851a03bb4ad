// A study of an imported case: which numbers of its soils are random, from the file's distributions, else from
// coefficients of variation by kind of soil. docs/dstability.md, "A study of the section".
// Not for: what a study does with them (batch).
#pragma once

#include "import/dstability/soil_text.hpp"
#include "import/dstability/stage_text.hpp"

#include <memory>
#include <string>
#include <vector>

namespace terp {

/// A stage up to the analysed one has a distribution of a soil in use, or of a state.
bool has_distributions(const StixProject& project, std::size_t scenario, std::size_t stage);

/// That of the probabilistic calculation of the stage; without a deviation: none.
StixParameter model_factor_of(const StixScenario& scenario, std::size_t stage);

/// POP of the states that are drawn with one distribution, and what the yield stress owes to it.
class RandomPops {
 public:
  /// of_file: the distributions of the file; else all POP together, with none.
  RandomPops(const StixSection& section, std::size_t scenario, std::size_t stage, bool of_file);

  /// The distribution that a yield stress follows at these places, with its mean in the part of it that is POP; none:
  /// it follows none, or only a part of it does.
  std::optional<RandomPop> at(const std::vector<Vec<2>>& places) const;

 private:
  struct Without {
    std::unique_ptr<StixProject> project;  ///< the same with that POP at zero
    std::unique_ptr<StixSection> section;
    RandomPop pop;
  };
  const StixSection* section_;
  std::vector<Without> without_;
};

struct StudyPlan {
  std::string title = {};
  StagePlan stages = {};                  ///< of the case, with the sets of soil that is held
  std::vector<const SoilUse*> uses = {};  ///< materials of the case that are drawn
  const std::vector<SoilKind>* kinds = nullptr;
  StixParameter model_factor = {};          ///< by which strengths are divided; without a deviation none
  bool is_of_file = true;                   ///< the distributions
  bool has_films = false;                   ///< the case
  Real slide = 1.0;                         ///< smallest that counts [m^2]
  std::vector<std::string> held_sets = {};  ///< KEY = VALUE, of realisations that slide as drawn
};

struct StudyText {
  std::string file;                 ///< study.toml
  std::vector<std::string> report;  ///< what is drawn, and from where
  Sentence source;                  ///< whose the distributions are
};

/// Throws InputError where nothing is random.
StudyText study_text(const StudyPlan& plan);

}  // namespace terp
