// Rows of a CSV file with named columns: what all tables that a case names have in common.
// Not for: what the columns mean.
#pragma once

#include "math/errors.hpp"
#include "math/types.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// A table cannot be used. The text has every fault found with FILE:LINE, up to ten, and what to do.
class CsvError : public FileError {
 public:
  using FileError::FileError;
};

/// Collects faults with their lines.
class CsvFaults {
 public:
  /// what: the table, in words: "the table of points"; cure: the last line of the text.
  CsvFaults(std::string path, std::string what, std::string cure);
  void add(Index line, const std::string& what);
  /// Throws CsvError.
  void stop_if_any() const;

 private:
  std::string path_, what_, cure_, text_;
  std::int64_t n_ = 0;
};

/// A number, which may have a plus in front.
std::optional<Real> number_in_csv(std::string_view text);

/// A finite number in a cell; 0 with a fault noted if it is none.
Real finite_number_in_csv(std::string_view text, std::string_view column, Index line, CsvFaults& faults);

/// Calls row(cells, line) for each line below the first, which names the columns in any order; cells in the order of
/// `columns`. Cells are apart by commas, spaces around them do not count, a text may stand in double quotes; empty
/// lines and lines from # on are passed over. Throws CsvError, also for faults that `row` noted.
void read_csv_rows(const std::string& text, std::span<const std::string> columns, CsvFaults& faults,
    const std::function<void(std::span<const std::string>, Index)>& row);

}  // namespace terp
