// One quantity of one run: it observes the run, and gives a number at its end. A further kind of quantity: a word of
// QuantityKind, a class here, one line in make_measure.
#pragma once

#include "simulation/observer.hpp"
#include "simulation/summary.hpp"
#include "verification/scope.hpp"

#include <memory>

namespace terp {

struct Measured {
  Real value;      ///< the number, or the norm of its error over scale
  Real reference;  ///< NaN for a norm, and where only a bound is given
};

class Measure : public Observer {
 public:
  /// At the end of the run. Throws CaseError for a formula that cannot be evaluated.
  virtual Measured finish(const Summary& summary) = 0;
};

/// Errors, now or during the run, are thrown at its end. Not for quantities that compare runs (judge.hpp). Quantity and
/// scope must outlive the measure.
std::unique_ptr<Measure> make_measure(const Quantity& quantity, const Scope& scope);

std::unique_ptr<Measure> make_field_measure(const Quantity& quantity, const Scope& scope);
std::unique_ptr<Measure> make_point_measure(const Quantity& quantity, const Scope& scope);
std::unique_ptr<Measure> make_ledger_measure(const Quantity& quantity, const Scope& scope);
std::unique_ptr<Measure> make_footing_measure(const Quantity& quantity, const Scope& scope);
std::unique_ptr<Measure> make_summary_measure(const Quantity& quantity, const Scope& scope);

}  // namespace terp
