#include "study/study_folder.hpp"

#include "output/run_folder.hpp"
#include "study/fragility_text.hpp"
#include "study/study_json.hpp"
#include "study/study_page.hpp"
#include "study/study_text.hpp"

#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// The study file with the case beside it, without comments.
std::string copied_study(const StudySettings& settings)
{
  Node root = settings.source.root;
  find_item(root, "case")->text = case_file;
  return "# The copy of " + settings.source.path + "\n\n" + write_toml(root);
}

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

void prepare_study_folder(const Study& study, const std::string& folder, const StudyPart& part)
{
  make_folder(folder);
  if (part.number != 1 || fs::exists(path_in(folder, study_copy))) return;
  copy_inputs(study.base.inputs, folder);
  write_file_atomically(path_in(folder, case_file), study.base.text);
  write_file_atomically(path_in(folder, study_copy), copied_study(study.settings));
}

void clear_study(const std::string& folder)
{
  std::error_code none;
  if (!fs::is_directory(folder, none)) return;
  const std::initializer_list<std::string_view> own = {study_copy, case_file, study_results, study_numbers,
      study_report, fragility_table, fragility_of_slides, fragility_of_floods};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".rows") || std::ranges::find(own, name) != own.end()) files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file);
}

void write_results(const Study& study, const std::string& folder, const Realisations& rows, const std::string& written)
{
  write_file_atomically(path_in(folder, study_results), study_csv(study, rows));
  write_file_atomically(path_in(folder, study_numbers), study_json(study, rows));
  if (study.settings.fragility) {
    const FragilityCurve curve = estimate_fragility(study, rows);
    write_file_atomically(path_in(folder, fragility_table), fragility_csv(study, curve));
    write_file_atomically(path_in(folder, fragility_of_slides), dstability_curve(study, curve, false));
    if (curve.judges_flood)
      write_file_atomically(path_in(folder, fragility_of_floods), dstability_curve(study, curve, true));
  }
  write_file_atomically(path_in(folder, study_report), page_of_study(study, rows, written));
}

}  // namespace terp
