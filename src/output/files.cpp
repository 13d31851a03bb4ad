#include "output/files.hpp"

#include "base/errors.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terp {
namespace {

/// 0, or the errno of the write that failed.
int write_all(int descriptor, std::string_view text)
{
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno != EINTR) return errno;
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

}  // namespace

void throw_file_error(std::string_view doing, const std::string& path, int error_number)
{
  throw FileError(fmt::format("cannot {} {}: {}", doing, path, std::generic_category().message(error_number)));
}

std::string folder_of(const std::string& path)
{
  const auto parent = std::filesystem::path(path).parent_path().string();
  return parent.empty() ? "." : parent;
}

std::string temporary_name(const std::string& path) { return path + ".tmp"; }

void make_folder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw_file_error("make the folder", folder, error.value());
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
  if (::access(path.c_str(), R_OK) != 0) throw_file_error("read", path, errno);
}

std::string read_file(const std::string& path)
{
  check_is_file(path);
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw_file_error("read", path, errno ? errno : EIO);
  return text;
}

TemporaryFile::~TemporaryFile()
{
  if (!name_.empty()) ::unlink(name_.c_str());
}

void TemporaryFile::move_into_place()
{
  sync_to_disk(name_);
  if (::rename(name_.c_str(), path_.c_str()) != 0) throw_file_error("write", path_, errno);
  name_.clear();
  sync_to_disk(folder_of(path_));
}

void write_file_atomically(const std::string& path, std::string_view text)
{
  TemporaryFile file(path);
  const int descriptor = ::open(file.name().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw_file_error("write", path, errno);
  int error = write_all(descriptor, text);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error != 0) throw_file_error("write", path, error);
  file.move_into_place();
}

void sync_to_disk(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw_file_error("open", path, errno);
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error != 0 && error != EINVAL) throw_file_error("write", path, error);  // EINVAL: not a thing to sync
}

void reserve_space(const std::string& path, std::int64_t n_bytes)
{
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) throw_file_error("write", path, errno);
  struct stat before = {};
  int error = ::fstat(descriptor, &before) == 0 ? 0 : errno;
  if (error == 0) error = ::posix_fallocate(descriptor, before.st_size, n_bytes);
  const bool restored = error == 0 || ::ftruncate(descriptor, before.st_size) == 0;
  ::close(descriptor);
  if (error != 0) throw_file_error(restored ? "write" : "restore", path, error);
}

AppendFile::AppendFile(const std::string& path) : path_(path)
{
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw_file_error("write", path, errno);
}

AppendFile::~AppendFile()
{
  if (descriptor_ >= 0) ::close(descriptor_);
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1))
{
}

void AppendFile::append(std::string_view text)
{
  struct stat before = {};
  const bool has_size = ::fstat(descriptor_, &before) == 0 && S_ISREG(before.st_mode);
  const int error = write_all(descriptor_, text);
  if (error == 0) return;
  if (has_size && ::ftruncate(descriptor_, before.st_size) != 0) throw_file_error("restore", path_, errno);
  throw_file_error("write", path_, error);
}

}  // namespace terp
