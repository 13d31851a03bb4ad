// One quantity of one run: it observes the run, and gives a number at its end. A further kind of quantity: a word of
// QuantityKind, a class in measure.cpp, one line in make_plain_measure.
#pragma once

#include "run/loop/observer.hpp"
#include "run/report/summary.hpp"
#include "verify/scope.hpp"

#include <memory>

namespace terp {

struct Measured {
  Real value;      ///< the number, or the norm of its error over scale
  Real reference;  ///< NaN for a norm, and where only a bound is given
};

class Measure : public Observer {
 public:
  Measure(const Quantity& quantity, const Scope& scope) : quantity_(quantity), scope_(scope) {}
  /// At the end of the run. Throws CaseError for a formula that cannot be evaluated.
  virtual Measured finish(const Summary& summary) = 0;

 protected:
  const Quantity& quantity_;
  const Scope& scope_;
};

/// Errors, now or during the run, are thrown at its end. Not for quantities that compare runs (judge.hpp). Quantity and
/// scope must outlive the measure.
std::unique_ptr<Measure> make_measure(const Quantity& quantity, const Scope& scope);

}  // namespace terp
