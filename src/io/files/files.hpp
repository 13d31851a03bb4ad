// Plain files on a disk that may be full, read-only or gone: whole or not at all, and errors that name the path.
// Not for: what stands in the files.
#pragma once

#include "os/read_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace terp {

/// With the folders above it, as needed. Throws FileError.
void make_folder(const std::string& folder);

/// Replaces the content of a file: readers see the old one or the new.
void write_file_atomically(const std::string& path, std::string_view text);

/// The name under which a file is written before it is moved to `path`.
std::string temporary_name(const std::string& path);

/// A file that is written under a temporary name and then moved to its own: it is there whole, or not at all, even
/// after a power cut. Without `move_into_place` the destructor removes what was written.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)), name_(temporary_name(path_)) {}
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept : path_(std::move(other.path_)), name_(std::exchange(other.name_, {}))
  {
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  const std::string& name() const { return name_; }

  /// The file must be closed. Returns when it is on the disk under its own name.
  void move_into_place();

 private:
  std::string path_, name_;
};

/// Waits until a file or folder is on the disk.
void sync_to_disk(const std::string& path);

/// Makes a file longer by n_bytes that are surely on the disk, so that writing them cannot fail for want of space.
/// Throws FileError and leaves the file as it was if there is no room.
void reserve_space(const std::string& path, std::int64_t n_bytes);

/// The folder that holds a file: "." for a bare name.
std::string folder_of(const std::string& path);

/// A file that only grows. Each append is whole or leaves the file as it was.
class AppendFile {
 public:
  explicit AppendFile(const std::string& path);
  ~AppendFile();
  AppendFile(AppendFile&& other) noexcept;
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;
  AppendFile& operator=(AppendFile&&) = delete;

  void append(std::string_view text);

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace terp
