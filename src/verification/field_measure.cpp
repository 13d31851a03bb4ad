// A field at one time: the points that count, reduced to one number.

#include "verification/frame_table.hpp"
#include "verification/measure.hpp"
#include "verification/series.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

class FieldMeasure : public Measure {
 public:
  FieldMeasure(const Quantity& quantity, const Scope& scope)
      : quantity_(quantity), scope_(scope), time_(scope.evaluate_or(quantity.time, scope.constants.at("end")))
  {
  }

  /// Keeps the frame nearest to the time.
  void frame(const std::shared_ptr<const Frame>& frame) override
  {
    if (nearest_ == nullptr || std::abs(frame->time - time_) < std::abs(nearest_->time - time_)) nearest_ = frame;
  }

  Measured finish(const Summary& summary) override
  {
    if (!(std::abs(nearest_->time - time_) <= 0.51 * std::max(summary.dt, 1e-9 * time_)))
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

  const Quantity& quantity_;
  const Scope& scope_;
  Real time_;
  std::shared_ptr<const Frame> nearest_;
  std::vector<Real> values_, references_;
};

}  // namespace

std::unique_ptr<Measure> make_field_measure(const Quantity& quantity, const Scope& scope)
{
  return std::make_unique<FieldMeasure>(quantity, scope);
}

}  // namespace terp
