// A run's folder: see run_folder.hpp.
#include "output/run_folder.hpp"

#include "base/errors.hpp"
#include "output/files.hpp"
#include "simulation/run_table.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// N of a name "<prefix>N.h5"; -1 if the name is not of this form.
std::int64_t step_in_name(std::string_view name, std::string_view prefix)
{
  constexpr std::string_view ending = ".h5";
  if (!name.starts_with(prefix) || !name.ends_with(ending)) return -1;
  const std::string_view digits = name.substr(prefix.size(), name.size() - prefix.size() - ending.size());
  const bool all_digits = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  std::int64_t step = -1;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), step);
  return all_digits && end.ec == std::errc() ? step : -1;
}

bool is_empty_folder(const std::string& folder)
{
  std::error_code error;
  const bool empty = fs::is_empty(folder, error);
  if (error) throw_file_error("open", folder, error.value());
  return empty;
}

constexpr std::string_view temporary = ".tmp";

/// Removes the files of Terp that `is_meant` names, and no others.
template <class Meant>
void remove_files(const std::string& folder, Meant&& is_meant)
{
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_file = entry.is_symlink() || entry.is_regular_file();
    if (!is_file || !is_written_by_terp(name) || !is_meant(name)) continue;
    fs::remove(entry.path(), error);
    if (error) throw_file_error("remove", entry.path().string(), error.value());
  }
  if (error) throw_file_error("open", folder, error.value());
}

}  // namespace

std::string checkpoint_file(std::int64_t step) { return fmt::format("checkpoint_{:09}.h5", step); }

std::string failed_file(std::int64_t step) { return fmt::format("failed_{:09}.h5", step); }

std::int64_t step_of_checkpoint(std::string_view file_name) { return step_in_name(file_name, "checkpoint_"); }

bool is_written_by_terp(std::string_view file_name)
{
  for (const std::string_view ending : {temporary, std::string_view(".journal")})
    if (file_name.ends_with(ending)) file_name.remove_suffix(ending.size());
  constexpr std::array names = {case_file, results_file, mesh_file, summary_file, report_file};
  const auto is_table = [&](const auto& table) { return table->file() == file_name; };
  return std::ranges::find(names, file_name) != names.end() || std::ranges::any_of(all_tables(), is_table) ||
         step_of_checkpoint(file_name) >= 0 || step_in_name(file_name, "failed_") >= 0;
}

std::string path_in(const std::string& folder, std::string_view file_name)
{
  return (fs::path(folder) / file_name).string();
}

FolderLock prepare_run_folder(const std::string& folder, bool force)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_file_error("make the run folder", folder, error.value());
  FolderLock lock(folder);
  if (is_empty_folder(folder)) return lock;
  if (!force) {
    throw FileError(
        fmt::format("the run folder {0} is not empty\n"
                    "  Use --force to replace the run in it, -o DIR to write to another folder, or `terp resume {0}` "
                    "to continue it.",
            folder));
  }
  remove_files(folder, [](const std::string&) { return true; });
  return lock;
}

void remove_unfinished(const std::string& folder)
{
  remove_files(folder, [](const std::string& name) { return name.ends_with(temporary); });
}

FolderLock::FolderLock(const std::string& folder)
{
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) throw_file_error("open the run folder", folder, errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;  // some network disks have no locks
  ::close(descriptor_);
  throw FileError(fmt::format("another terp is writing to the run folder {}", folder));
}

bool is_being_written(const std::string& folder)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw_file_error("open the run folder", folder, errno);
  const bool held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return held;
}

FolderLock::~FolderLock()
{
  if (descriptor_ >= 0) ::close(descriptor_);
}

FolderLock::FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace terp
