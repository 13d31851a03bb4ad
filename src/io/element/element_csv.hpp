// The path of an element test as a table, and its result (docs/element.md).
#pragma once

#include "run/element/element.hpp"

#include <string>

namespace terp {

struct PathFileOptions {
  std::array<Real, 4> stress{};  ///< at the start [Pa]
  bool undrained = false;
  int increments = 0;      ///< of each row; 0: as many as make 1000 of all rows
  Real duration = 1000.0;  ///< of all rows, where the table has no column `time` [s]
};

/// A row is a target of the path: a strain or a stress of each component; what it leaves out keeps its strain. Throws
/// CsvError.
ElementPath read_path_csv(const std::string& path, const PathFileOptions& options);
ElementPath read_path_csv_text(const std::string& path, const std::string& text, const PathFileOptions& options);

/// A header, then a line for each increment; numbers are the shortest that read back to the same bits.
std::string element_csv(const ElementResult& result);

}  // namespace terp
