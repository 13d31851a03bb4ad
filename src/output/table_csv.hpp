// history.csv and ledger.csv: tables with a header line and the time in the first column (docs/formats.md).
#pragma once

#include "output/checksum.hpp"
#include "output/files.hpp"
#include "simulation/observer.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

inline constexpr std::string_view history_header = "time,point,id,x,y,eps_deviatoric,eps_eq_p,su,pressure";
inline constexpr std::string_view ledger_header =
    "time,step,kinetic,kinetic_nodal,elastic,plastic,gravity_work,damping_work,boundary_work,left_energy,numerical,"
    "mass,momentum_x,momentum_y,"
    "clamped,left,front_x,crest_x,crest_y,front_left_x,crest_left_x,crest_left_y,moved_volume,v_max,v_999";
inline constexpr std::string_view left_header = "time,id,x,y,v_x,v_y,mass";
inline constexpr std::string_view footings_header =
    "time,footing,displacement_x,displacement_y,reaction_x,reaction_y,work";

/// Lines with their line ends. Numbers are the shortest that read back to the same bits; not a number is "nan".
std::string csv_lines(const std::vector<HistoryRow>& rows);
std::string csv_line(const LedgerRow& row);
std::string csv_lines(const std::vector<LeftPoint>& points);
std::string csv_lines(const std::vector<FootingRow>& rows);

/// A table up to some row.
struct TablePart {
  std::int64_t n_rows = 0;  ///< without the header
  std::string checksum;     ///< over every byte, header included; empty without a file
};

/// Up to the last whole row with a time of at most `time` [s]. Throws FileError if the columns are not those of
/// `header`.
TablePart read_part_until(const std::string& path, std::string_view header, Real time);

/// Drops the rows later than `time` [s], and a last line that was cut short. Without a file, nothing is done.
/// Throws FileError if the columns are not those of `header`.
void drop_rows_after(const std::string& path, std::string_view header, Real time);

/// A table that grows.
class TableFile {
 public:
  /// A new one gets its header.
  TableFile(const std::string& path, std::string_view header);

  /// Whole lines with their line ends.
  void append(std::string_view lines);
  std::string checksum() const { return checksum_.digits(); }  ///< as in TablePart, of all rows

 private:
  AppendFile file_;
  Fnv1a checksum_;
};

}  // namespace terp
