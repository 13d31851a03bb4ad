// The folder of a study: runs/NAME/ with its store, a copy of study and case, and what they said. It can be read where
// the originals are gone.
#pragma once

#include "io/files/run_folder.hpp"
#include "batch/store.hpp"

#include <string>

namespace terp {

inline constexpr const char* study_copy = "study.toml";
inline constexpr const char* study_results = "results.csv";
inline constexpr const char* study_numbers = "results.json";
inline constexpr const char* study_report = "report.html";
inline constexpr const char* fragility_table = "fragility.csv";
inline constexpr const char* height_curve_table = "flood_after_slide.csv";
inline constexpr const char* failure_path_table = "failure_path.csv";
inline constexpr const char* fragility_of_dikes = "fragility_continu_inzicht.csv";
inline constexpr const char* fragility_of_slides = "fragility_slide.json";
inline constexpr const char* fragility_of_floods = "fragility_flood.json";
inline constexpr const char* kept_runs = "kept";          ///< folder of the run folders of --keep
inline constexpr const char* kept_mark = "of_study.txt";  ///< in each that is whole: digits_of_study()

std::string default_study_folder(const StudySettings& settings);

/// A study from its file, or from a folder that holds its copy. Throws CaseError, FileError.
Study open_study(const std::string& path);

/// The folder of what `open_study` took: itself, or by default.
std::string folder_of_study(const std::string& path, const std::string& output, const Study& study);

/// Refuses, with FileError, to write results where the study or its case lies that the user wrote, and where other
/// things lie under the names of results. Makes nothing.
void check_study_folder(const Study& study, const std::string& folder);

/// A study folder in which this process may write: it holds a lock of that name. Files come from a folder of the lock
/// under their own names, so that no two processes write to one file.
class StudyPlace {
 public:
  /// Makes the folder. Throws FileError where another process holds the lock.
  StudyPlace(std::string folder, const std::string& lock);
  const std::string& folder() const { return folder_; }
  /// Replaces a file, whole or not at all; one that has this content is left.
  void write(const std::string& name, const std::string& content) const;
  /// Removes the store, what was said of it and runs of --keep, but for the copies of study and case.
  /// Throws FileError, and removes nothing, while another process writes a part.
  void clear() const;

 private:
  std::string folder_, own_;
  FolderLock lock_;
};

/// For those who write results: a report and the end of a run wait for each other, so that who reads the store later
/// also writes later. Throws FileError after half a minute.
StudyPlace place_of_results(const std::string& folder);

/// Writes the copies of study and case, and of the files that they name; where the study was read from the copy there,
/// they are.
void write_copies(const Study& study, const StudyPlace& place);

/// Writes results.csv, results.json, what a fragility curve adds, and the page. written: when, for the page.
void write_results(const Study& study, const StudyPlace& place, const Realisations& rows, const std::string& written);

}  // namespace terp
