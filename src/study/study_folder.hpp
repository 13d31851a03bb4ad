// The folder of a study: runs/NAME/ with its store, a copy of study and case, and what they said. It can be read where
// the originals are gone.
#pragma once

#include "study/store.hpp"

#include <string>

namespace terp {

inline constexpr const char* study_copy = "study.toml";
inline constexpr const char* study_results = "results.csv";
inline constexpr const char* study_numbers = "results.json";
inline constexpr const char* study_report = "report.html";
inline constexpr const char* fragility_table = "fragility.csv";
inline constexpr const char* fragility_of_slides = "fragility_slide.json";
inline constexpr const char* fragility_of_floods = "fragility_flood.json";

/// runs/NAME.
std::string default_study_folder(const StudySettings& settings);

/// A study from its file, or from a folder that holds its copy. Throws CaseError, FileError.
Study open_study(const std::string& path);

/// The folder of what `open_study` took: itself, or by default.
std::string folder_of_study(const std::string& path, const std::string& output, const Study& study);

/// Makes the folder with the copies, where they are not there yet. Part 1 alone writes them.
void prepare_study_folder(const Study& study, const std::string& folder, const StudyPart& part);

/// Removes the store and what was said of it.
void clear_study(const std::string& folder);

/// Writes results.csv, results.json, what a fragility curve adds, and the page. written: when, for the page.
void write_results(const Study& study, const std::string& folder, const Realisations& rows, const std::string& written);

}  // namespace terp
