// The copy of a study begins with a mark. By it Terp knows that a folder is its own, and never writes over a study or a
// case of the user. A file is written in the folder of the lock and then moved, so that two processes never write to
// one.

#include "batch/study_folder.hpp"

#include "io/case/printable.hpp"
#include "batch/failure_path.hpp"
#include "batch/fragility_text.hpp"
#include "batch/height_curve.hpp"
#include "batch/study_inputs.hpp"
#include "batch/study_page.hpp"
#include "batch/study_text.hpp"
#include "os/files.hpp"
#include "page/page.hpp"
#include "os/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// First words of a copy: the mark by which a folder is one of Terp's.
constexpr std::string_view mark = "# The copy of ";

/// The study file with the case and other files beside it, without comments. files: to be copied.
std::string copied_study(const Study& study, std::vector<InputFile>& files)
{
  Node root = study.settings.source.root;
  for (InputFile& file : name_copies_of_files(root, study.base.values.folder)) files.push_back(std::move(file));
  find_item(root, "case")->text = case_file;
  return fmt::format("{}{}\n\n{}", mark, study.settings.source.path, write_toml(root));
}

bool is_copy(std::string_view text) { return text.starts_with(mark); }

bool lies_in(const std::string& file, const std::string& folder)
{
  std::error_code none;
  return fs::equivalent(folder_of(file), folder, none);
}

bool is_read_from_copy(const Study& study, const std::string& folder)
{
  const Document& source = study.settings.source;
  return fs::path(source.path).filename() == study_copy && lies_in(source.path, folder) && is_copy(source.text);
}

/// Where the lock of that name lies in a study folder.
std::string lock_folder_of(const std::string& folder, const std::string& lock)
{
  return path_in(folder, fmt::format("locks/{}", lock));
}

constexpr std::array<std::string_view, 9> result_files = {study_results, study_numbers, study_report, fragility_table,
    height_curve_table, failure_path_table, fragility_of_dikes, fragility_of_slides, fragility_of_floods};

}  // namespace

std::string default_study_folder(const StudySettings& settings) { return "runs/" + settings.name; }

Study open_study(const std::string& path)
{
  std::error_code none;
  return prepare_study(read_study(fs::is_directory(path, none) ? path_in(path, study_copy) : path));
}

std::string folder_of_study(const std::string& path, const std::string& output, const Study& study)
{
  std::error_code none;
  if (!output.empty()) return output;
  return fs::is_directory(path, none) ? path : default_study_folder(study.settings);
}

void check_study_folder(const Study& study, const std::string& folder)
{
  const auto refuse = [&](const std::string& what) {
    throw FileError(fmt::format(
        "{}: the folder holds {}\n  Give the results a folder of their own: -o DIR", printable(folder), what));
  };
  std::error_code none;
  if (!fs::is_directory(folder, none) || is_read_from_copy(study, folder)) return;
  if (lies_in(study.settings.source.path, folder)) refuse("the study file, in whose place a copy would be written");
  if (lies_in(study.case_path, folder)) refuse("the case, in whose place a copy could be written");
  const std::string copy = path_in(folder, study_copy);
  if (fs::exists(copy, none)) {
    if (!is_copy(read_file(copy))) refuse(fmt::format("a {} that Terp did not write", study_copy));
    return;
  }
  for (const std::string_view name : result_files)
    if (fs::exists(path_in(folder, name), none)) refuse(fmt::format("a {} of something else", name));
  if (fs::exists(path_in(folder, case_file), none)) refuse(fmt::format("a {} of something else", case_file));
}

StudyPlace::StudyPlace(std::string folder, const std::string& lock)
    : folder_(std::move(folder)), own_(lock_folder_of(folder_, lock)), lock_((make_folder(own_), own_))
{
}

void StudyPlace::write(const std::string& name, const std::string& content) const
{
  const std::string path = path_in(folder_, name), own = path_in(own_, name);
  std::error_code none;
  if (fs::exists(path, none) && read_file(path) == content) return;
  write_file_atomically(own, content);
  if (const int error = replace_file(own, path); error != 0) throw_file_error("write", path, error);
}

void StudyPlace::clear() const
{
  std::vector<FolderLock> parts;
  for (const auto& entry : fs::directory_iterator(path_in(folder_, "locks"))) {
    const std::string other = entry.path().string();
    if (!entry.is_directory() || entry.path() == fs::path(own_)) continue;  // Windows knows two signs between folders
    if (is_being_written(other))
      throw FileError(
          fmt::format("{}: another terp writes {} of this study; nothing was removed\n  Wait for it, or stop it first.",
              printable(folder_), entry.path().filename().string()));
    parts.emplace_back(other);
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (is_part_of_store(name) || std::ranges::find(result_files, name) != result_files.end())
      files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file);
  fs::remove_all(path_in(folder_, kept_runs));
}

StudyPlace place_of_results(const std::string& folder)
{
  constexpr int few_tries = 3, most_tries = 300;
  constexpr double between = 0.1;  // [s]
  for (int n = 1;; ++n) try {
      return StudyPlace(folder, "report");
    } catch (const FileError&) {
      const bool is_held = is_being_written(lock_folder_of(folder, "report"));
      if (n == most_tries || (n > few_tries && !is_held)) throw;  // it cannot be written for another reason
      wait_seconds(between);
    }
}

void write_copies(const Study& study, const StudyPlace& place)
{
  if (is_read_from_copy(study, place.folder())) return;
  std::vector<InputFile> files = study.base.inputs;
  place.write(study_copy, copied_study(study, files));
  place.write(std::string(case_file), study.base.text);
  for (const InputFile& file : files) place.write(file.copy, read_file(file.path));
}

void write_results(const Study& study, const StudyPlace& place, const Realisations& rows, const std::string& written)
{
  place.write(study_results, study_csv(study, rows));
  place.write(study_numbers, study_json(study, rows));
  if (study.settings.fragility) {
    const FragilityCurve curve = estimate_fragility(study, rows);
    place.write(fragility_table, fragility_csv(study, curve));
    const bool is_water = is_water_level(*study.settings.fragility);
    if (is_water) place.write(fragility_of_dikes, continu_inzicht_csv(curve, curve.judges_flood));
    if (is_water) place.write(fragility_of_slides, dstability_curve(study, curve, false));
    if (is_water && curve.judges_flood) place.write(fragility_of_floods, dstability_curve(study, curve, true));
  }
  if (has_failure_path(study)) place.write(failure_path_table, failure_path_csv(study, rows));
  if (const auto curve = flood_after_slide_over_level(study, rows); !curve.empty())
    place.write(height_curve_table, height_curve_csv(curve));
  place.write(study_report, make_page(page_template(), study_payload(study, rows, written)));
}

}  // namespace terp
