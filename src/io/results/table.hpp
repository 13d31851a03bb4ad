// ledger.csv and history.csv, read: columns of numbers by name (docs/formats.md).
// Not for: writing them (io/files/table_csv).
#pragma once

#include "math/quantity.hpp"
#include "math/types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Columns of numbers, all of one length. What is no number is NaN.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<Real>> columns;  ///< shape [n_columns][n_rows]

  std::size_t n_rows() const { return columns.empty() ? 0 : columns[0].size(); }
  /// The column of that name; nullptr if there is none.
  const std::vector<Real>* find(std::string_view name) const;
};

struct PointTable {
  std::string point;
  Table table;
};

/// Rows of a file like ledger.csv; a last line that is being written is left out. Throws FileError.
Table read_number_table(const std::string& path);

/// The rows of history.csv by point, or of loads.csv by `load`, in the order of the file.
std::vector<PointTable> read_history(const std::string& path, std::string_view name_column = "point");

/// Of a column of a table of a run; one that is not known is called by its name. For axes and legends.
QuantityInfo describe_column(std::string_view name);

}  // namespace terp
