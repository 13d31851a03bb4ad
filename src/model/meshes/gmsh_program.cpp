// A folder is claimed by a lock as long as its process lives, so a folder without a lock is left over. Between making
// and locking it has none either: only folders older than a minute are looked at.

#include "model/meshes/gmsh_program.hpp"

#include "math/errors.hpp"
#include "model/meshes/mesh_error.hpp"
#include "os/files.hpp"
#include "os/folder_claim.hpp"

#include <chrono>
#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr const char* folder_name = "terp-mesh-";
constexpr auto time_to_lock = std::chrono::minutes(1);  // far longer than from making a folder to locking it

/// Folders of processes that were killed. What cannot be looked at or removed is left.
void remove_stale_folders()
{
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), ignored)) {
    if (!entry.path().filename().string().starts_with(folder_name)) continue;
    if (fs::file_time_type::clock::now() - entry.last_write_time(ignored) < time_to_lock) continue;
    int claim = -1;
    if (entry.is_symlink(ignored) || claim_folder(entry.path().string(), claim) != ClaimResult::taken) continue;
    release_claim(claim);
    fs::remove_all(entry.path(), ignored);
  }
}

std::string new_folder()
{
  const std::string start = (fs::temp_directory_path() / folder_name).string();
  std::string folder = make_unique_folder(start);
  if (folder.empty()) throw FileError("cannot make a folder for temporary files: " + start + "XXXXXX");
  return folder;
}

}  // namespace

WorkFolder::WorkFolder() : path_((remove_stale_folders(), new_folder())) { claim_folder(path_, claim_); }

WorkFolder::~WorkFolder()
{
  std::error_code ignored;
  release_claim(claim_);
  fs::remove_all(path_, ignored);
}

ProcessResult run_gmsh(std::vector<std::string> arguments, const std::string& folder, double seconds,
    const std::function<void(double)>& waiting)
{
  arguments.insert(arguments.begin(), "gmsh");
  // A home of its own: the user's gmsh options must not change the mesh.
  const ProcessResult result =
      run_process(arguments, seconds, {"GMSH_HOME=" + folder, "LC_ALL=C", "OMP_NUM_THREADS=1"}, waiting);
  if (result.interrupted || result.ended_by_keyboard) throw MeshError("gmsh was interrupted");
  return result;
}

std::string gmsh_version(const std::string& folder)
{
  const ProcessResult result = run_gmsh({"--version"}, folder, 60.0);
  if (!result.found) return "";
  if (!result.succeeded()) throw MeshError("`gmsh --version` fails: " + result.output);
  return result.output.substr(0, result.output.find_last_not_of(" \r\n") + 1);
}

}  // namespace terp
