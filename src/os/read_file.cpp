#include "os/read_file.hpp"

#include "math/errors.hpp"
#include "os/files.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

namespace terp {

void throw_file_error(std::string_view doing, const std::string& path, int error_number)
{
  throw FileError(fmt::format("cannot {} {}: {}", doing, path, words_of_errno(error_number)));
}

void throw_file_error(std::string_view doing, const std::string& path, const std::error_code& error)
{
  throw_file_error(doing, path, error.default_error_condition().value());  // on Windows it may be a number of its own
}

void check_is_file(const std::string& path)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw FileError(fmt::format("cannot read {}: a {} is in the place of the file\n  Put the file back there.", path,
      std::filesystem::is_directory(status) ? "folder" : "pipe or device"));
}

void check_readable(const std::string& path)
{
  if (const int error = may_read(path); error != 0) throw_file_error("read", path, error);
}

std::string read_file(const std::string& path)
{
  check_is_file(path);
  errno = 0;
  try {
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (in) return text;
  } catch (const std::ios_base::failure&) {  // of a disk, after the file was opened
  }
  throw_file_error("read", path, errno ? errno : EIO);
}

}  // namespace terp
