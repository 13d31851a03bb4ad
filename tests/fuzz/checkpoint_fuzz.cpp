// Checkpoints: a file of any bytes gives an image, or a FileError that says why.
#include "math/errors.hpp"
#include "io/files/checkpoint.hpp"
#include "scratch_file.hpp"

#include <filesystem>
#include <fstream>

/// HDF5 1.10 loses what it had decoded of an object header that turns out to be damaged (H5O_protect): some hundred
/// bytes per file, refused all the same. A handle of ours that is not closed stays in the tables of HDF5 and is no leak
/// to the sanitizer.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5_serial\n"; }

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  static const std::string path = terp::test::scratch_file();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    terp::read_checkpoint(path);
  } catch (const terp::FileError&) {
  }
  std::filesystem::remove(path);
  return 0;
}
