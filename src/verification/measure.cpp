#include "verification/measure.hpp"

#include "input/case_file.hpp"

#include <limits>

namespace terp {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

/// The numbers of a summary by name: those of summary.json, and the last softened share.
struct NamedNumbers {
  std::vector<std::string> names;
  std::vector<Real> values;

  explicit NamedNumbers(const Summary& s)
  {
    for (const SummaryQuantity& quantity : summary_quantities())
      if (!quantity.info.is_text) add(quantity.info.name, quantity.number(s).value_or(nan));
    for (const auto& [name, value] : s.numbers) add(name, value);
    add("softened_fraction", s.softened_fraction.empty() ? nan : s.softened_fraction.back().second);
  }
  void add(std::string_view name, Real value)
  {
    names.emplace_back(name);
    values.push_back(value);
  }
};

/// A number of summary.json.
class SummaryMeasure : public Measure {
 public:
  SummaryMeasure(const Quantity& quantity, const Scope& scope) : quantity_(quantity), scope_(scope) {}
  Measured finish(const Summary& summary) override
  {
    const NamedNumbers numbers(summary);
    return {
        scope_.compile(quantity_.value, numbers.names)(numbers.values), scope_.evaluate_or(quantity_.reference, nan)};
  }

 private:
  const Quantity& quantity_;
  const Scope& scope_;
};

/// From numbers measured before it in the same run.
class FormulaMeasure : public Measure {
 public:
  FormulaMeasure(const Quantity& quantity, const Scope& scope) : quantity_(quantity), scope_(scope) {}
  Measured finish(const Summary&) override
  {
    return {scope_.evaluate(quantity_.value), scope_.evaluate_or(quantity_.reference, nan)};
  }

 private:
  const Quantity& quantity_;
  const Scope& scope_;
};

std::unique_ptr<Measure> make_plain_measure(const Quantity& quantity, const Scope& scope)
{
  switch (quantity.kind) {
    case QuantityKind::field: return make_field_measure(quantity, scope);
    case QuantityKind::point: return make_point_measure(quantity, scope);
    case QuantityKind::ledger: return make_ledger_measure(quantity, scope);
    case QuantityKind::summary: return make_summary_measure(quantity, scope);
    case QuantityKind::formula: return std::make_unique<FormulaMeasure>(quantity, scope);
    case QuantityKind::footing: return make_footing_measure(quantity, scope);
    case QuantityKind::order:
    case QuantityKind::extrapolated:
    case QuantityKind::mesh_error: break;
  }
  return nullptr;
}

/// Keeps an error of another measure during the run, and throws it at the end.
class GuardedMeasure : public Measure {
 public:
  GuardedMeasure(const Quantity& quantity, const Scope& scope)
  {
    guard([&] { inner_ = make_plain_measure(quantity, scope); });
  }
  void frame(const std::shared_ptr<const Frame>& frame) override
  {
    guard([&] { inner_->frame(frame); });
  }
  void rows(const std::vector<TableRow>& rows) override
  {
    guard([&] { inner_->rows(rows); });
  }
  Measured finish(const Summary& summary) override
  {
    if (!fault_.empty()) throw CaseError(fault_);
    return inner_->finish(summary);
  }

 private:
  template <class F>
  void guard(F&& f)
  {
    if (!fault_.empty()) return;
    try {
      f();
    } catch (const CaseError& error) {
      fault_ = error.what();
    }
  }

  std::unique_ptr<Measure> inner_;
  std::string fault_;
};

}  // namespace

std::unique_ptr<Measure> make_summary_measure(const Quantity& quantity, const Scope& scope)
{
  return std::make_unique<SummaryMeasure>(quantity, scope);
}

std::unique_ptr<Measure> make_measure(const Quantity& quantity, const Scope& scope)
{
  return std::make_unique<GuardedMeasure>(quantity, scope);
}

}  // namespace terp
