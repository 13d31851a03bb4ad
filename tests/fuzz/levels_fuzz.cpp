// Tables of levels: any bytes give levels over growing times, or a FileError.
#include "io/files/level_table.hpp"
#include "math/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  try {
    terp::read_level_table_text("levels.csv", {reinterpret_cast<const char*>(data), size}, 3600.0);
  } catch (const terp::FileError&) {
  }
  return 0;
}
