// Tables of water levels over time, as a measuring station or a forecast gives them: CSV whose first column is a time.
// Not for: what the levels do (model/water/level_series, model/seepage/seepage_in_time).
#pragma once

#include "model/seepage/seepage_in_time.hpp"

#include <string>
#include <string_view>

namespace terp {

struct LevelTable {
  LevelWave wave;  ///< columns without a name have none; of dates the first is time 0
  int gaps = 0;    ///< rows without a level, which are left out: between its neighbours it is linear anyway
};

/// Cells are apart by commas or semicolons; with semicolons a number may have a comma. Times are numbers in `unit` [s]
/// or dates: 2026-01-05 12:30, 05-01-2026 12:30. Throws FileError with FILE:LINE.
LevelTable read_level_table(const std::string& path, Real unit);

/// The same of a text.
LevelTable read_level_table_text(const std::string& path, std::string_view text, Real unit);

}  // namespace terp
