// The order of a safe replacement: the content reaches the disk, the name moves, then the folder reaches the disk. With
// the name first, a power cut would leave an empty file under it. A write that fails half way is taken back to the size
// before it, so that tables hold whole rows. If even that fails, the error says "restore": only then may the file be
// torn.

#include "io/files/files.hpp"

#include "os/files.hpp"

#include <cerrno>
#include <filesystem>

namespace terp {

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
  if (error) throw_file_error("make the folder", folder, error);
}

TemporaryFile::~TemporaryFile()
{
  std::error_code ignored;
  if (!name_.empty()) std::filesystem::remove(name_, ignored);
}

void TemporaryFile::move_into_place()
{
  sync_to_disk(name_);
  if (const int error = replace_file(name_, path_); error != 0) throw_file_error("write", path_, error);
  name_.clear();
  sync_to_disk(folder_of(path_));
}

void write_file_atomically(const std::string& path, std::string_view text)
{
  TemporaryFile file(path);
  const int descriptor = open_to_write(file.name(), OpenAs::new_file);
  if (descriptor < 0) throw_file_error("write", path, errno);
  int error = write_all(descriptor, text);
  if (const int at_close = close_file(descriptor); error == 0) error = at_close;
  if (error != 0) throw_file_error("write", path, error);
  file.move_into_place();
}

void sync_to_disk(const std::string& path)
{
  if (const int error = wait_for_disk(path); error != 0) throw_file_error("write", path, error);
}

void reserve_space(const std::string& path, std::int64_t n_bytes)
{
  const int descriptor = open_to_write(path, OpenAs::there_already);
  if (descriptor < 0) throw_file_error("write", path, errno);
  const std::int64_t before = size_of(descriptor);
  const int error = reserve(descriptor, n_bytes);
  const bool restored = error == 0 || before < 0 || resize(descriptor, before) == 0;
  close_file(descriptor);
  if (error != 0) throw_file_error(restored ? "write" : "restore", path, error);
}

AppendFile::AppendFile(const std::string& path) : path_(path), descriptor_(open_to_write(path, OpenAs::end_of_file))
{
  if (descriptor_ < 0) throw_file_error("write", path, errno);
}

AppendFile::~AppendFile()
{
  if (descriptor_ >= 0) close_file(descriptor_);
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1))
{
}

void AppendFile::append(std::string_view text)
{
  const std::int64_t before = size_of(descriptor_);
  const int error = write_all(descriptor_, text);
  if (error == 0) return;
  if (const int problem = before < 0 ? 0 : resize(descriptor_, before); problem != 0)
    throw_file_error("restore", path_, problem);
  throw_file_error("write", path_, error);
}

}  // namespace terp
