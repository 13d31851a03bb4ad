// What is measured of a finished run, as a table: `terp compare` and the report show it for runs side by side, `terp
// converge` follows it from cell size to cell size.
#pragma once

#include "io/results/run_results.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace terp {

/// How a measure of one mesh is set against that of another.
enum class MeasureKind {
  amount,  ///< a change counts as a share of the amount
  place,   ///< a coordinate: a change counts as a share of the distance since t = 0, of one cell at least
  time,    ///< of an event, in steps of the ledger
  count,   ///< whole numbers, equal or not
  word,    ///< number of one of `words`, equal or not
};

/// A measure of a run. A new one is one entry in measures.cpp.
struct RunMeasure {
  std::string name = {};  ///< key in convergence.json; empty: of the cost or the audit of a run, not of its result
  std::string label = {}, unit = {};
  int digits = 2;  ///< after the point, when printed
  MeasureKind kind = MeasureKind::amount;
  std::function<std::optional<Real>(const RunResults&)> value = {};  ///< none: not defined, or not recorded
  /// place: distance since t = 0 [unit].
  std::function<std::optional<Real>(const RunResults&)> distance = {};
  /// A difference that cannot be told from none, by the size of the cells [m]; none: zero.
  std::function<Real(const RunResults&, Real cell)> resolution = {};
  bool in_steps = false;                ///< takes whole multiples of the resolution, so that it has no order
  std::vector<std::string> words = {};  ///< of kind word
};

/// Name of the verdict on the water among the measures.
inline constexpr std::string_view flood_measure = "flood_verdict";

/// A frame or an end this near to a time counts as of that time [s].
inline constexpr Real same_time = 0.02;

/// All measures that these runs may have, in the order of the table.
std::vector<RunMeasure> measures_of(const std::vector<RunResults>& runs);

/// The first time at which eps_eq_p of a named point exceeds that of softened soil [s]; none if never, or if it is not
/// recorded.
std::optional<Real> softening_time(const RunResults& run, std::string_view point);

/// The named points whose S_u is larger in some row of their history than in the row before.
std::vector<std::string> points_that_regained_strength(const RunResults& run);

}  // namespace terp
