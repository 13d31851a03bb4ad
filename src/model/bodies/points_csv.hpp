// Material points from a table: a CSV file with the columns x, y, volume, material.
// Not for: which cell holds a point, or whether its material exists (setup_points).
#pragma once

#include "model/bodies/csv_rows.hpp"

#include <string>
#include <vector>

namespace terp {

/// One row of the table.
struct CsvPoint {
  Vec<2> x;              ///< [m]
  Real volume;           ///< Omega_p, greater than 0 [m^2]
  std::string material;  ///< name, not empty
  Index line;            ///< in the file, from 1
};

/// In file order. The first line names the four columns, in any order; cells are apart by commas, spaces around them do
/// not count, a name may stand in double quotes; empty lines and lines from # on are passed over. Numbers are finite.
/// Throws CsvError; FileError if the file cannot be read.
std::vector<CsvPoint> read_points_csv(const std::string& path);

/// The same from the text of a file; path: for messages.
std::vector<CsvPoint> read_points_csv_text(const std::string& path, const std::string& text);

}  // namespace terp
