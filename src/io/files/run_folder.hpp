// A run's folder, runs/<case>/: making it, guarding earlier results, the names of the files in it.
// Not for: what stands in the files.
#pragma once

#include "model/case/input_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

struct CaseText {
  std::string name;  ///< of the case file without .toml
  std::string toml;  ///< the exact text, with what --set changed
};

inline constexpr std::string_view case_file = "case.toml";
inline constexpr std::string_view mesh_file = "mesh.vtkhdf";
inline constexpr std::string_view history_file = "history.csv";
inline constexpr std::string_view ledger_file = "ledger.csv";
inline constexpr std::string_view summary_file = "summary.json";
inline constexpr std::string_view report_file = "report.html";
std::string checkpoint_file(std::int64_t step);  ///< "checkpoint_000000123.h5"
std::string failed_file(std::int64_t step);      ///< "failed_000000123.h5"

/// The file of the end of a stage of that name, "stage_02_flood.h5", in a run folder. Throws FileError with the stages
/// that there are.
std::string find_stage_file(const std::string& folder, const std::string& stage);

/// N of a name "<prefix>N<ending>"; -1 if the name is not of this form.
std::int64_t number_in_name(std::string_view name, std::string_view prefix, std::string_view ending);

/// The step in a checkpoint's name; -1 for any other file.
std::int64_t step_of_checkpoint(std::string_view file_name);

/// The step of the newest checkpoint in a folder; -1: there is none.
std::int64_t newest_step(const std::string& folder);

/// True for the names of files that Terp writes into a run folder itself, temporary ones included.
bool is_written_by_terp(std::string_view file_name);

std::string path_in(const std::string& folder, std::string_view file_name);

/// Copies the files that a case names into a run folder, each as a whole.
void copy_inputs(const std::vector<InputFile>& files, const std::string& folder);

/// Removes what a run that was killed left under temporary names.
void remove_unfinished(const std::string& folder);

/// Removes the files of a run, and no others. FileError if one cannot be removed.
void remove_run(const std::string& folder);

/// Keeps a second Terp out of a run folder for as long as it lives. The system lets go of it if the process dies.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  int descriptor_ = -1;
};

/// True while some Terp holds the lock of the folder: a run goes on.
bool is_being_written(const std::string& folder);

/// Makes the folder ready for a new run, locks it, and copies the files that the case names into it. A folder that
/// holds anything is refused with FileError, unless `force`: then the files of the earlier run are removed, and no
/// others.
FolderLock prepare_run_folder(const std::string& folder, bool force, const std::vector<InputFile>& inputs = {});

}  // namespace terp
