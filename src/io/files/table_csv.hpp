// The tables of a run: CSV with a header line and the time in the first column (docs/formats.md).
#pragma once

#include "math/checksum.hpp"
#include "io/files/files.hpp"
#include "run/report/run_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// "time,step,kinetic": the names of the columns.
std::string header_of(const RunTable& table);

/// Lines with their line ends. Numbers are the shortest that read back to the same bits; not a number is "nan".
std::string csv_lines(const std::vector<TableRow>& rows);

struct TablePart {
  std::int64_t n_rows = 0;  ///< without the header
  std::string checksum;     ///< over every byte, header included; empty without a file
};

/// What a checkpoint says of a table of its run, one line each: "ledger.csv = 85944171f73967e8".
std::string table_line(std::string_view file, const std::string& checksum);

/// Up to the last whole row with a time of at most `time` [s]. Throws FileError if the columns are not those of
/// `header`.
TablePart read_part_until(const std::string& path, std::string_view header, Real time);

/// Drops the rows later than `time` [s], and a last line that was cut short. Without a file, nothing is done.
/// Throws FileError if the columns are not those of `header`.
void drop_rows_after(const std::string& path, std::string_view header, Real time);

class TableFile {
 public:
  /// A new one gets its header.
  TableFile(const std::string& path, std::string_view header);

  /// Whole lines with their line ends.
  void append(std::string_view lines);
  std::string checksum() const { return checksum_.digits(); }  ///< as in TablePart, of all rows
  std::int64_t n_bytes() const { return n_bytes_; }

 private:
  AppendFile file_;
  Fnv1a checksum_;
  std::int64_t n_bytes_;
};

}  // namespace terp
