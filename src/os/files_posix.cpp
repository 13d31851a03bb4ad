// These are the calls of POSIX as they are, where they suffice; files_win32.cpp is the twin. A write that was
// interrupted or incomplete goes on. posix_fallocate() returns its error, the others leave it in errno. What cannot be
// synchronised at all (EINVAL) counts as being on the disk.

#include "os/files.hpp"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace terp {
namespace {

int flags_of(OpenAs how)
{
  switch (how) {
    case OpenAs::new_file: return O_CREAT | O_TRUNC;
    case OpenAs::end_of_file: return O_CREAT | O_APPEND;
    default: return 0;
  }
}

}  // namespace

int open_to_write(const std::string& path, OpenAs how)
{
  return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags_of(how), 0666);
}

int write_all(int descriptor, std::string_view text)
{
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno != EINTR) return errno;
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

std::int64_t size_of(int descriptor)
{
  struct stat now = {};
  return ::fstat(descriptor, &now) == 0 && S_ISREG(now.st_mode) ? now.st_size : -1;
}

int resize(int descriptor, std::int64_t n_bytes) { return ::ftruncate(descriptor, n_bytes) == 0 ? 0 : errno; }

int reserve(int descriptor, std::int64_t n_bytes)
{
  struct stat now = {};
  if (::fstat(descriptor, &now) != 0) return errno;
  return ::posix_fallocate(descriptor, now.st_size, n_bytes);
}

int close_file(int descriptor) { return ::close(descriptor) == 0 ? 0 : errno; }

int wait_for_disk(const std::string& path)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return error == EINVAL ? 0 : error;  // EINVAL: not a thing to sync
}

int replace_file(const std::string& from, const std::string& to)
{
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

void link_or_copy(const std::string& file, const std::string& name)
{
  std::filesystem::create_symlink(std::filesystem::absolute(file), name);
}

std::string words_of_errno(int error) { return std::generic_category().message(error); }

bool is_absolute(const std::string& path) { return path.starts_with('/'); }

int may_read(const std::string& path) { return ::access(path.c_str(), R_OK) == 0 ? 0 : errno; }

int may_write(const std::string& path) { return ::access(path.c_str(), W_OK) == 0 ? 0 : errno; }

std::string make_unique_folder(const std::string& start)
{
  std::string pattern = start + "XXXXXX";
  return mkdtemp(pattern.data()) == nullptr ? "" : pattern;
}

std::string cache_folder()
{
  const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
  if (cache != nullptr && is_absolute(cache))
    return cache;  // others are to be ignored: XDG Base Directory Specification
  return home != nullptr && *home != '\0' ? std::string(home) + "/.cache" : "";
}

bool print_to_file(const std::string& path)
{
  const int file = open_to_write(path, OpenAs::end_of_file);
  return file >= 0 && ::dup2(file, STDOUT_FILENO) >= 0 && ::dup2(file, STDERR_FILENO) >= 0;
}

std::string program_file() { return "/proc/self/exe"; }

long process_number() { return getpid(); }

}  // namespace terp
