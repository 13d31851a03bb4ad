// Values at places from a table: a CSV file with the columns x, y, value. Between the places: bilinear where they form
// a grid, else the mean of the nearest ones, weighted by the inverse square of their distance. With one x, as of a
// boring, or one y the values hold along the whole other axis.
// Not for: what the values are.
#pragma once

#include "model/bodies/csv_rows.hpp"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace terp {

struct PlacedValue {
  Vec<2> x;  ///< [m]
  Real value;
};

/// Whether a positive value is eight times as large as each of some others, or an eighth.
bool lies_far_off(Real value, std::initializer_list<Real> others);

class ValueMap {
 public:
  static constexpr std::size_t n_nearest = 8;           ///< scattered places that a value is made of
  static constexpr std::size_t most_scattered = 20000;  ///< each value looks at all of them

  /// values: at least one, at places that differ. A grid: each x of the table with each y, two places or more.
  explicit ValueMap(std::vector<PlacedValue> values);

  bool is_grid() const { return !at_grid_.empty(); }
  std::size_t n_places() const { return values_.size(); }
  Real share_of_grid() const { return share_of_grid_; }  ///< of all places with an x and a y that occur
  /// A place of a grid whose value lies far off those of all places beside it.
  std::optional<PlacedValue> find_far_off() const;
  Vec<2> low() const { return low_; }    ///< of the box about the places, -inf where they hold for all [m]
  Vec<2> high() const { return high_; }  ///< [m]

  /// Beyond a grid: the value at the nearest place of its edge.
  Real at(Vec<2> x) const;

 private:
  Real on_grid(Vec<2> x) const;
  Real by_distance(Vec<2> x) const;

  std::vector<PlacedValue> values_;
  std::vector<Real> x_, y_, at_grid_;  // lines of the grid [m]; values, shape [n_y, n_x]
  Vec<2> low_{}, high_{};
  Real share_of_grid_ = 0.0;
};

/// Throws CsvError: faults of the file, two lines of one place, more than most_scattered of them; FileError if it
/// cannot be read.
ValueMap read_values_csv(const std::string& path);

/// The same from the text of a file; path: for messages.
ValueMap read_values_csv_text(const std::string& path, const std::string& text);

}  // namespace terp
