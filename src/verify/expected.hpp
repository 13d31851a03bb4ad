// What a verification case expects: the contents of expected.toml, checked. Format: docs/verification_cases.md. Not
// for: evaluating its formulas (scope.hpp).
#pragma once

#include "io/case/document.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace terp {

/// A formula as written in the file; empty text: not given.
struct Formula {
  std::string text = {};
  Place place = {};
  bool given() const { return !text.empty(); }
};

enum class QuantityKind { field, point, ledger, summary, formula, order, footing, extrapolated, mesh_error };

/// How many numbers become one. The errors are those of value - reference over scale.
enum class Reduce { rms_error, max_error, mean, sum, max, min, at, last, period, frequency, arrival };

struct Quantity {
  std::string name = {}, unit = {}, source = {};
  std::string shown = {};       ///< the reference as the table shows it; empty: its number or formula
  std::string red = {};         ///< why it is known not to agree, and what would correct it; empty: it must agree
  std::string regression = {};  ///< why no value from outside Terp holds it: such a row never passes; empty: one does
  QuantityKind kind = QuantityKind::field;
  Reduce reduce = Reduce::rms_error;
  Formula value = {}, reference = {};
  Formula where = {}, scale = {};         ///< field: points that count; unit of errors
  Formula time = {}, from = {}, to = {};  ///< field, at: when; series: the window that counts [s]
  Formula threshold = {};                 ///< arrival: |value| to be reached
  std::array<Formula, 2> at = {};         ///< point: initial position [m]
  Formula tolerance = {}, relative = {}, at_least = {}, at_most = {};
  std::string as = {};  ///< name of its value in later quantities of kind formula; without a bound it has no row
  std::string of = {},
              over = {};  ///< order, extrapolated, mesh_error: name of another quantity; the constant that is refined
  bool differences = false;  ///< order: of the differences of successive values, where the limit is not the reference
  Formula order = {};        ///< extrapolated: of two runs, whose order is not observed
  std::vector<std::string> runs = {};      ///< names of the runs in which it is measured; empty: all
  std::vector<std::string> red_runs = {};  ///< those to which `red` applies; empty: all
  Place place = {};
};

/// A constant: a formula, or a key of the case as it runs.
struct Constant {
  std::string name = {}, key = {};
  Formula formula = {};
};

struct Variant {
  std::string name = {};  ///< "h = 0.25 m"; empty if there is one only
  std::string case_file = {};
  std::vector<std::string> schemes = {};  ///< empty: that of the case
  std::vector<std::string> set = {};      ///< KEY=VALUE
  std::vector<Constant> constants = {};   ///< in addition to those of the file
  std::vector<Real> stability = {};       ///< a factor of safety instead of a run: from, to, tolerance; empty: a run
  double least_depth = 0.0;               ///< of soil that a factor of safety looks at [m]
  bool is_long = false;
  std::vector<std::string> long_schemes = {};  ///< those of `schemes` whose run is long where the others' is not
  double seconds = 1.0;                        ///< approximate, on one core; for the remaining time
  Place place = {};
};

struct Expected {
  std::string path = {}, text = {};
  std::string title = {};
  std::vector<Constant> constants = {};
  std::vector<Variant> variants = {};
  std::vector<Quantity> quantities = {};
};

/// Throws CaseError.
Expected read_expected(const std::string& path);

/// Throws CaseError: the file, line and column of the place, what is wrong there.
[[noreturn]] void refuse(const Expected& expected, Place place, const std::string& what, const std::string& detail);

/// A quantity that only others use.
inline bool is_auxiliary(const Quantity& q)
{
  return !(q.tolerance.given() || q.relative.given() || q.at_least.given() || q.at_most.given());
}

/// True if a list of runs contains this one; an empty list contains all.
inline bool names_run(const std::vector<std::string>& runs, const std::string& run)
{
  return runs.empty() || std::ranges::find(runs, run) != runs.end();
}

/// It needs the limit to which the runs of a scheme tend.
inline bool needs_limit(const Quantity& q)
{
  return q.kind == QuantityKind::extrapolated || q.kind == QuantityKind::mesh_error;
}

/// It compares the runs of a scheme; a single run does not measure it.
inline bool compares_runs(const Quantity& q) { return q.kind == QuantityKind::order || needs_limit(q); }

/// The fewest runs of a scheme that determine it: two for an order of errors, three for one of differences or a limit.
inline std::ptrdiff_t least_runs(const Quantity& q)
{
  return q.order.text.empty() && (q.differences || needs_limit(q)) ? 3 : 2;
}

/// Errors of a norm are themselves the number that is judged.
inline bool is_error(Reduce reduce) { return reduce == Reduce::rms_error || reduce == Reduce::max_error; }

}  // namespace terp
