// A field keeps the one frame that it needs and evaluates its formulas at the end. A series evaluates its formula at
// each frame or row and keeps only numbers. So the names and their order must not change during a run. A point whose
// condition is NaN counts with the value NaN instead of being left out. One faulty quantity does not end the run for
// the others.

#include "verify/measure.hpp"

#include "math/nan.hpp"
#include "io/case/case_file.hpp"
#include "verify/frame_table.hpp"
#include "verify/series.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace terp {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// From numbers of summary.json and the last softened share, or from those measured before it in the same run.
class NumberMeasure : public Measure {
 public:
  using Measure::Measure;
  Measured finish(const Summary& summary) override
  {
    if (quantity_.kind == QuantityKind::summary) add_numbers(summary);
    return {scope_.compile(quantity_.value, names_)(values_), scope_.evaluate_or(quantity_.reference, nan)};
  }

 private:
  void add_numbers(const Summary& s)
  {
    for (const SummaryQuantity& quantity : summary_quantities())
      if (!quantity.info.is_text) add(quantity.info.name, quantity.number(s).value_or(nan));
    for (const auto& [name, value] : s.numbers) add(name, value);
    add("softened_fraction", s.softened_fraction.empty() ? nan : s.softened_fraction.back().second);
  }
  void add(std::string_view name, Real value)
  {
    names_.emplace_back(name);
    values_.push_back(value);
  }

  std::vector<std::string> names_;
  std::vector<Real> values_;
};

class FieldMeasure : public Measure {
 public:
  using Measure::Measure;

  void frame(const std::shared_ptr<const Frame>& frame) override
  {
    const bool is_last = !quantity_.time.given();  // so far: a run may end at rest before its latest end
    if (is_last || nearest_ == nullptr || std::abs(frame->time - time_) < std::abs(nearest_->time - time_))
      nearest_ = frame;
  }

  Measured finish(const Summary& summary) override
  {
    if (quantity_.time.given() && !(std::abs(nearest_->time - time_) <= 0.51 * std::max(summary.dt, 1e-9 * time_)))
      refuse(scope_.file, quantity_.time.given() ? quantity_.time.place : quantity_.place,
          fmt::format("there is no frame at {:g} s", time_),
          fmt::format(
              "The nearest is at {:g} s. Let output.fields.every of the case divide the time.", nearest_->time));
    read_points();
    if (values_.empty()) refuse(scope_.file, quantity_.where.place, "no point is `where` this says", "");
    const Real scale = scope_.scale(quantity_.scale);
    const Real value = reduce_values(values_, references_, quantity_.reduce, scale);
    if (is_error(quantity_.reduce)) return {value, nan};
    return {value, quantity_.reference.given() ? reduce_values(references_, {}, quantity_.reduce, scale) : nan};
  }

 private:
  void read_points()
  {
    const auto names = names_of(*nearest_);
    const Formula all{"1", {}}, none{"0", {}};
    const Expression value = scope_.compile(quantity_.value, names);
    const Expression where = scope_.compile(quantity_.where.given() ? quantity_.where : all, names);
    const Expression reference = scope_.compile(quantity_.reference.given() ? quantity_.reference : none, names);
    std::vector<Real> row;
    for (std::size_t k = 0; k < nearest_->x.size() / 2; ++k) {
      read_row(*nearest_, k, row);
      const Real counts = where(row);
      if (counts == 0.0) continue;
      values_.push_back(std::isnan(counts) ? nan : value(row));  // unknown whether this point counts
      references_.push_back(reference(row));
    }
  }

  Real time_ = scope_.evaluate_or(quantity_.time, scope_.constants.at("end"));
  std::shared_ptr<const Frame> nearest_;
  std::vector<Real> values_, references_;
};

/// Collects a curve from rows of named numbers; a derived class says which.
class SeriesMeasure : public Measure {
 public:
  using Measure::Measure;

  Measured finish(const Summary&) override
  {
    const Series s = rows_of_interest();
    const Real value = reduced(s);
    return {value, is_error(quantity_.reduce) || !quantity_.reference.given() ? nan : reference_of(s)};
  }

 protected:
  void start_at(Vec<2> x) { start_ = x; }
  void add(Real time, const std::vector<std::string>& names, const std::vector<Real>& row)
  {
    if (!value_) value_ = scope_.compile(quantity_.value, names);
    if (!reference_ && is_error(quantity_.reduce)) reference_ = scope_.compile(quantity_.reference, names);
    series_.time.push_back(time);
    series_.value.push_back((*value_)(row));
    if (reference_) series_.reference.push_back((*reference_)(row));
  }

 private:
  Real time() const { return scope_.evaluate_or(quantity_.time, scope_.constants.at("end")); }

  /// The reference for the number of these rows: for a mean, sum, max or min the same of the reference at their times.
  Real reference_of(const Series& s) const
  {
    const bool of_a_time = quantity_.reduce != Reduce::period && quantity_.reduce != Reduce::frequency &&
                           quantity_.reduce != Reduce::arrival;
    const Expression reference = scope_.compile(quantity_.reference,
        of_a_time ? std::vector<std::string>{"x0", "y0", "t"} : std::vector<std::string>{"x0", "y0"});
    const auto at = [&](Real t) {
      return reference(
          of_a_time ? std::vector<Real>{start_[0], start_[1], t} : std::vector<Real>{start_[0], start_[1]});
    };
    if (quantity_.reduce == Reduce::at) return at(time());
    if (!of_a_time || quantity_.reduce == Reduce::last) return at(s.time.back());
    std::vector<Real> values;
    for (const Real t : s.time) values.push_back(at(t));
    return reduce_values(values, {}, quantity_.reduce, 1.0);
  }

  /// The rows from `from` to `to`. Throws CaseError where there is nothing to reduce, which would look like a missing
  /// arrival.
  Series rows_of_interest() const
  {
    if (series_.time.empty())
      refuse(scope_.file, quantity_.place,
          quantity_.kind == QuantityKind::footing ? "there is no footing in this case" : "the run has no rows",
          "A quantity of kind `footing` needs a [[footing]] in the case.");
    const Real from = scope_.evaluate_or(quantity_.from, 0.0), to = scope_.evaluate_or(quantity_.to, infinity);
    const Series s = cut(series_, from * (1.0 - 1e-9), to * (1.0 + 1e-9));
    const std::string rows = fmt::format(
        "There are {} rows, from {:g} to {:g} s.", series_.time.size(), series_.time.front(), series_.time.back());
    if (s.time.empty())
      refuse(scope_.file, (quantity_.from.given() ? quantity_.from : quantity_.to).place,
          fmt::format("there is no row from {:g} to {:g} s", from, to), rows);
    if (quantity_.reduce == Reduce::at && !covers(s, time()))
      refuse(scope_.file, quantity_.time.given() ? quantity_.time.place : quantity_.place,
          fmt::format("there is no row at {:g} s", time()), rows);
    return s;
  }

  Real reduced(const Series& s) const
  {
    switch (quantity_.reduce) {
      case Reduce::at: return value_at(s, time());
      case Reduce::period: return period_of(s);
      case Reduce::frequency: return 1.0 / period_of(s);
      case Reduce::arrival: return arrival_of(s, scope_.evaluate(quantity_.threshold));
      default: return reduce_values(s.value, s.reference, quantity_.reduce, scope_.scale(quantity_.scale));
    }
  }

  std::optional<Expression> value_, reference_;
  Series series_;
  Vec<2> start_{nan, nan};
};

class PointMeasure : public SeriesMeasure {
 public:
  using SeriesMeasure::SeriesMeasure;
  void frame(const std::shared_ptr<const Frame>& frame) override
  {
    if (!point_) {
      point_ = nearest(*frame);
      start_at({frame->x[2 * *point_], frame->x[2 * *point_ + 1]});
    }
    read_row(*frame, *point_, row_);
    add(frame->time, names_of(*frame), row_);
  }

 private:
  std::size_t nearest(const Frame& frame) const
  {
    const Vec<2> place{scope_.evaluate(quantity_.at[0]), scope_.evaluate(quantity_.at[1])};
    std::size_t best = 0;
    Real smallest = infinity;
    for (std::size_t k = 0; k < frame.x.size() / 2; ++k) {
      const Real distance = std::hypot(frame.x[2 * k] - place[0], frame.x[2 * k + 1] - place[1]);
      if (distance < smallest) smallest = distance, best = k;
    }
    if (const Real spacing = nearest_other(frame, best); smallest > most_spacings * spacing)
      refuse(scope_.file, quantity_.at[0].place,
          fmt::format("there is no soil at x = {:g} m, y = {:g} m", place[0], place[1]),
          fmt::format("The nearest material point is {:.3g} m away; its own neighbour {:.3g} m. Choose a place in a "
                      "body at t = 0.",
              smallest, spacing));
    return best;
  }

  /// Distance to the next point [m]; infinite where there is none.
  static Real nearest_other(const Frame& frame, std::size_t point)
  {
    Real smallest = infinity;
    for (std::size_t k = 0; k < frame.x.size() / 2; ++k)
      if (k != point)
        smallest = std::min(
            smallest, std::hypot(frame.x[2 * k] - frame.x[2 * point], frame.x[2 * k + 1] - frame.x[2 * point + 1]));
    return smallest;
  }

  static constexpr Real most_spacings = 2.0;  // inside of soil 0.71 of a square lattice, more where cells are stretched
  std::optional<std::size_t> point_;
  std::vector<Real> row_;
};

/// Rows of a table of the run; of those with several rows per time the first.
class TableMeasure : public SeriesMeasure {
 public:
  TableMeasure(const Quantity& quantity, const Scope& scope, std::string_view table)
      : SeriesMeasure(quantity, scope), table_(table)
  {
  }
  void rows(const std::vector<TableRow>& rows) override
  {
    const TableRow& row = rows.front();
    if (row.table->name != table_) return;
    if (names_.empty())
      for (const QuantityInfo& column : row.table->columns)
        if (!column.is_text) names_.emplace_back(column.name == "time" ? "t" : column.name);
    add(row["time"], names_, row.values);
  }

 private:
  std::string_view table_;
  std::vector<std::string> names_;
};

std::unique_ptr<Measure> make_plain_measure(const Quantity& quantity, const Scope& scope)
{
  switch (quantity.kind) {
    case QuantityKind::field: return std::make_unique<FieldMeasure>(quantity, scope);
    case QuantityKind::point: return std::make_unique<PointMeasure>(quantity, scope);
    case QuantityKind::ledger: return std::make_unique<TableMeasure>(quantity, scope, "ledger");
    case QuantityKind::footing: return std::make_unique<TableMeasure>(quantity, scope, "footings");
    case QuantityKind::summary:
    case QuantityKind::formula: return std::make_unique<NumberMeasure>(quantity, scope);
    default: return nullptr;  // compares runs: judge.hpp
  }
}

/// Keeps an error of another measure during the run, and throws it at the end.
class GuardedMeasure : public Measure {
 public:
  GuardedMeasure(const Quantity& quantity, const Scope& scope) : Measure(quantity, scope)
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

std::unique_ptr<Measure> make_measure(const Quantity& quantity, const Scope& scope)
{
  return std::make_unique<GuardedMeasure>(quantity, scope);
}

}  // namespace terp
