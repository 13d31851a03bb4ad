// Where a harness puts the file that its reader reads.
#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>

namespace terp::test {

/// A file in memory where there is such a place.
inline std::string scratch_file()
{
  const std::string folder =
      std::filesystem::exists("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path().string();
  return folder + "/terp_fuzz_" + std::to_string(getpid()) + ".h5";
}

}  // namespace terp::test
