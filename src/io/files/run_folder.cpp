// What Terp may remove is decided by names alone: is_written_by_terp must know each file that a run writes, or --force
// leaves it, and must fit no file of a user. Files that the case names are read before anything is removed, as they may
// be those of the run replaced.

#include "io/files/run_folder.hpp"

#include "math/errors.hpp"
#include "math/number_from.hpp"
#include "run/measure/followers.hpp"
#include "io/files/files.hpp"
#include "io/files/frame_files.hpp"
#include "os/folder_claim.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// NAME of "stage_NN_NAME.h5"; empty if the name is not of this form.
std::string stage_in_name(std::string_view name)
{
  constexpr std::string_view prefix = "stage_", ending = ".h5";
  if (!name.starts_with(prefix) || !name.ends_with(ending) || name.size() <= prefix.size() + ending.size() + 3)
    return "";
  const std::string_view middle = name.substr(prefix.size(), name.size() - prefix.size() - ending.size());
  const std::size_t end = middle.find('_');
  if (end == std::string_view::npos || end < 2 || !std::ranges::all_of(middle.substr(0, end), is_digit)) return "";
  return std::string(middle.substr(end + 1));
}

bool is_empty_folder(const std::string& folder)
{
  std::error_code error;
  const bool empty = fs::is_empty(folder, error);
  if (error) throw_file_error("open", folder, error);
  return empty;
}

constexpr std::string_view temporary = ".tmp";

std::string_view without_temporary(std::string_view name)
{
  return name.ends_with(temporary) ? name.substr(0, name.size() - temporary.size()) : name;
}

bool is_frame(std::string_view file_name)
{
  const std::string_view name = without_temporary(file_name);
  return number_of_frame(point_frames, name) >= 0 || number_of_frame(mesh_frames, name) >= 0;
}

template <class Meant>
void remove_files(const std::string& folder, Meant&& is_meant)
{
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const bool is_file = entry.is_symlink() || entry.is_regular_file();
    if (!is_file || !is_meant(entry.path().filename().string())) continue;
    fs::remove(entry.path(), error);
    if (error) throw_file_error("remove", entry.path().string(), error);
  }
  if (error && error != std::errc::no_such_file_or_directory) throw_file_error("open", folder, error);
}

bool is_copy_of_input(std::string_view name)
{
  if (name == copy_of_import || std::ranges::find(mesh_copies, name) != std::end(mesh_copies)) return true;
  return number_in_name(name, "points_", ".csv") >= 0 || number_in_name(name, "values_", ".csv") >= 0 ||
         number_in_name(name, "library_", ".so") >= 0;
}

using Contents = std::vector<std::pair<std::string, std::string>>;

Contents read_contents(const std::vector<InputFile>& files)
{
  Contents contents;
  for (const InputFile& file : files) contents.emplace_back(file.copy, read_file(file.path));
  return contents;
}

void write_contents(const Contents& contents, const std::string& folder)
{
  for (const auto& [name, content] : contents) write_file_atomically(path_in(folder, name), content);
}

}  // namespace

std::string checkpoint_file(std::int64_t step) { return fmt::format("checkpoint_{:09}.h5", step); }

std::string failed_file(std::int64_t step) { return fmt::format("failed_{:09}.h5", step); }

std::string find_stage_file(const std::string& folder, const std::string& stage)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string(), name = stage_in_name(file);
    if (name == stage && !name.empty()) return entry.path().string();
    if (!name.empty()) names.push_back(name);
  }
  if (error) throw_file_error("open", folder, error);
  std::ranges::sort(names);
  throw FileError(fmt::format("{}: no stage `{}` of this run has ended\n  {}", folder, stage,
      names.empty() ? "It holds the end of no stage." : fmt::format("Stages that have: {}", fmt::join(names, ", "))));
}

std::int64_t number_in_name(std::string_view name, std::string_view prefix, std::string_view ending)
{
  if (!name.starts_with(prefix) || !name.ends_with(ending) || name.size() < prefix.size() + ending.size()) return -1;
  const std::string_view digits = name.substr(prefix.size(), name.size() - prefix.size() - ending.size());
  return std::ranges::all_of(digits, is_digit) ? number_from<std::int64_t>(digits).value_or(-1) : -1;
}

std::int64_t step_of_checkpoint(std::string_view file_name) { return number_in_name(file_name, "checkpoint_", ".h5"); }

std::int64_t newest_step(const std::string& folder)
{
  std::int64_t step = -1;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    step = std::max(step, step_of_checkpoint(entry.path().filename().string()));
  return step;
}

bool is_written_by_terp(std::string_view file_name)
{
  file_name = without_temporary(file_name);
  constexpr std::array names = {case_file, point_frames.index, mesh_frames.index, mesh_file, summary_file, report_file};
  const auto is_table = [&](const auto& table) { return table->file() == file_name; };
  return std::ranges::find(names, file_name) != names.end() || std::ranges::any_of(all_tables(), is_table) ||
         is_copy_of_input(file_name) || step_of_checkpoint(file_name) >= 0 || !stage_in_name(file_name).empty() ||
         number_in_name(file_name, "failed_", ".h5") >= 0;
}

std::string path_in(const std::string& folder, std::string_view file_name)
{
  return (fs::path(folder) / file_name).string();
}

void copy_inputs(const std::vector<InputFile>& files, const std::string& folder)
{
  write_contents(read_contents(files), folder);
}

FolderLock prepare_run_folder(const std::string& folder, bool force, const std::vector<InputFile>& inputs)
{
  const Contents contents = read_contents(inputs);  // first: they may be those of the run that is replaced
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_file_error("make the run folder", folder, error);
  FolderLock lock(folder);
  if (!is_empty_folder(folder)) {
    if (!force) {
      throw FileError(
          fmt::format("the run folder {0} is not empty\n"
                      "  Use --force to replace the run in it, -o DIR to write to another folder, or `terp resume {0}` "
                      "to continue it.",
              folder));
    }
    remove_run(folder);
  }
  write_contents(contents, folder);
  return lock;
}

void remove_run(const std::string& folder)
{
  remove_files(folder, is_written_by_terp);
  const std::string frames = path_in(folder, frames_folder);
  remove_files(frames, is_frame);
  std::error_code not_empty;
  fs::remove(frames, not_empty);  // if nothing else is in it
}

void remove_unfinished(const std::string& folder)
{
  const auto of = [](auto&& is_written) {
    return [=](const std::string& name) { return name.ends_with(temporary) && is_written(name); };
  };
  remove_files(folder, of(is_written_by_terp));
  remove_files(path_in(folder, frames_folder), of(is_frame));
}

FolderLock::FolderLock(const std::string& folder)
{
  const ClaimResult result = claim_folder(folder, descriptor_);
  if (result == ClaimResult::no_folder) throw_file_error("open the run folder", folder, errno);
  if (result == ClaimResult::held_by_another)
    throw FileError(fmt::format("another terp is writing to the run folder {}", folder));
}

bool is_being_written(const std::string& folder)
{
  const ClaimResult result = look_at_claim(folder);
  if (result == ClaimResult::no_folder) throw_file_error("open the run folder", folder, errno);
  return result == ClaimResult::held_by_another;
}

FolderLock::~FolderLock() { release_claim(descriptor_); }

FolderLock::FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace terp
