// The tables that a run writes, one CSV file each: their columns, and their rows.
// Not for: when a row is due (reporter), nor how it is written (io/files/table_csv).
#pragma once

#include "math/quantity.hpp"
#include "math/types.hpp"

#include <memory>
#include <string>
#include <vector>

namespace terp {

struct RunTable {
  std::string_view name;              ///< "ledger": its file is ledger.csv
  std::string_view meaning;           ///< one line
  std::vector<QuantityInfo> columns;  ///< the first is the time [s]; at most one is a text
  bool from_start = false;            ///< its file is there before its first row
  bool between_ledger_rows = false;   ///< its rows have times of their own: also reported before a checkpoint

  std::string file() const { return std::string(name) + ".csv"; }
  /// Place of a column among the values of a row. The column must be there, and be no text.
  std::size_t place_of(std::string_view column) const;
  std::size_t n_values() const;
};

/// A row of a table. Its numbers are NaN until they are set.
struct TableRow {
  std::shared_ptr<const RunTable> table;
  std::vector<Real> values;  ///< of the columns that are numbers, in their order
  std::string text = {};     ///< of the column that is none

  TableRow() = default;
  explicit TableRow(std::shared_ptr<const RunTable> of, std::string its_text = {});
  Real& operator[](std::string_view column) { return values[table->place_of(column)]; }
  Real operator[](std::string_view column) const { return values[table->place_of(column)]; }
};

}  // namespace terp
