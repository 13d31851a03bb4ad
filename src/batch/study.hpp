// A study that is ready to run: its file, its case, the mesh that realisations share, and what each of them changes.
// Not for: solving them (realise.hpp).
#pragma once

#include "io/case/case_file.hpp"
#include "model/soils/gaussian_field.hpp"
#include "model/parts/model.hpp"
#include "batch/correlation.hpp"
#include "batch/study_file.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace terp {

/// The cheap case of a study with two levels.
struct CoarseLevel {
  CaseFile base = {};  ///< with `set` and `coarse`, as it is without any draw
  SharedMesh mesh = {};
};

struct Study {
  StudySettings settings;
  std::string case_path = {}, case_text = {};
  CaseFile base = {};                               ///< the case with `set`, as it is without any draw
  SharedMesh mesh = {};                             ///< of the base
  bool shares_mesh = true;                          ///< no draw changes it
  std::optional<CoarseLevel> coarse = {};           ///< of kind = "multilevel"
  Index n_realisations = 0;                         ///< at most; of all levels of a load, coarse and fine
  SquareMatrix of_numbers = {}, of_fields = {};     ///< Cholesky factors of the correlations
  std::vector<std::vector<Real>> points = {};       ///< of a sampler that fills the space: by number, then by sample
  std::vector<std::array<Vec<2>, 2>> boxes = {};    ///< of the fields
  std::string case_digits = {}, study_digits = {};  ///< of what decides the results

  /// Levels of a fragility curve, else 1. A sample at one of them is a turn: turn t is sample t / n_levels() at level
  /// t % n_levels(). The samples are the same at all levels, and each count of turns from 0 has all levels equally
  /// often.
  Index n_levels() const;
  Index sample_of(Index realisation) const { return turn_of(realisation) / n_levels(); }
  std::size_t level_of(Index realisation) const { return static_cast<std::size_t>(turn_of(realisation) % n_levels()); }
  Index n_samples() const { return turn_of(n_realisations) / n_levels(); }
  /// Turns are realisations, but of two levels: there the first ones, of the pairs, are two each, the coarse one
  /// first, and all that follow are coarse. So a larger number goes on with the same study.
  Index turn_of(Index realisation) const { return realisation - std::min(realisation + 1, 2 * n_pairs()) / 2; }
  /// The coarse one, of two levels.
  Index first_of_turn(Index turn) const { return turn + std::min(turn, n_pairs()); }
  Index n_pairs() const { return coarse ? settings.multilevel.pairs * n_levels() : 0; }  ///< at all levels of a load
  bool is_coarse(Index realisation) const { return coarse && (realisation >= 2 * n_pairs() || realisation % 2 == 0); }
  /// For which part of a study it is: both of a pair are for one.
  Index share_of(Index realisation) const { return coarse ? turn_of(realisation) : realisation; }
  const SharedMesh& mesh_of(Index realisation) const { return is_coarse(realisation) ? coarse->mesh : mesh; }

  /// What realisations are told apart by: the level of the load, numbers that are drawn, means of fields over their
  /// trend, keys of a sweep.
  std::vector<std::string> input_names() const;
};

/// Of what decides the results: of the program, the case with its mesh, and what is drawn.
inline std::string digits_of_study(const Study& study)
{
  return std::string(TERP_VERSION) + ' ' + study.case_digits + ' ' + study.study_digits;
}

/// Reads the case, checks that it takes what is drawn, and builds the mesh. Throws CaseError, FileError.
Study prepare_study(StudySettings settings);

struct Draw {
  std::vector<std::string> changes;    ///< KEY=VALUE, as of --set, `set` included
  std::vector<std::string> held = {};  ///< what [held] changes beside them
  std::vector<Real> inputs = {};  ///< as input_names(); of a sweep that is not of numbers alone, the place in `values`
};

/// Its changes, without the means of fields among the inputs: makes no field.
Draw draw_changes(const Study& study, Index realisation);

/// realisation: from 0. The same on any machine, in any order.
Draw draw_realisation(const Study& study, Index realisation);

/// The realisation at a place in the space of independent standard normal scores, one of each number.
Draw draw_at(const Study& study, const std::vector<Real>& scores);

/// What a realisation that is kept was drawn with.
Draw draw_again(const Study& study, Index realisation, const std::vector<Real>& inputs);

/// The case of a draw. Throws CaseError where it refuses what was drawn.
CaseFile case_of(const Study& study, const Draw& draw);

/// Changes of a realisation that slides as drawn, with those of [held].
std::vector<std::string> held_changes(const Draw& draw);

/// A field of a sample over its trend, with the values of soundings.
class FieldOverTrend {
 public:
  FieldOverTrend(const Study& study, std::size_t field, Index sample);
  Real at(Vec<2> x) const { return value_over_mean(marginal_, cov_, field_.at(x)); }

 private:
  explicit FieldOverTrend(const struct RandomField& random);
  FieldMarginal marginal_;
  Real cov_;
  GaussianField field_;
};

/// An input as text: numbers to 6 digits, words of a sweep as they are.
std::string input_text(const Study& study, std::size_t number, Real value);

/// What is doubtful: fields that the cells average, as warnings of the study file.
std::vector<Problem> find_doubts(const Study& study);

}  // namespace terp
