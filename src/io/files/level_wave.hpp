// The table of levels over hours that `terp seepage` follows: CSV with a column `hours`, then a level for each name.
#pragma once

#include "model/seepage/seepage_in_time.hpp"

#include <string>

namespace terp {

/// Throws FileError with every fault found.
LevelWave read_level_wave(const std::string& path);

}  // namespace terp
