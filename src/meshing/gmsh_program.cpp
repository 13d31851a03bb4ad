#include "meshing/gmsh_program.hpp"

#include "base/errors.hpp"
#include "mesh/mesh_error.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr const char* folder_name = "terp-mesh-";
constexpr auto time_to_lock = std::chrono::minutes(1);  // far longer than from making a folder to locking it

/// The folder, open and locked; -1 if it cannot be opened or another process has the lock. The kernel releases the lock
/// when its process ends, however that ends. Programs that we start do not inherit it.
int open_locked(const std::string& path)
{
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (folder < 0 || flock(folder, LOCK_EX | LOCK_NB) == 0) return folder;
  close(folder);
  return -1;
}

/// Folders of processes that were killed. What cannot be looked at or removed is left.
void remove_stale_folders()
{
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), ignored)) {
    if (!entry.path().filename().string().starts_with(folder_name)) continue;
    if (fs::file_time_type::clock::now() - entry.last_write_time(ignored) < time_to_lock) continue;
    const int lock = open_locked(entry.path().string());
    if (lock < 0) continue;
    fs::remove_all(entry.path(), ignored);
    close(lock);
  }
}

std::string new_folder()
{
  std::string pattern = (fs::temp_directory_path() / folder_name).string() + "XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) throw FileError("cannot make a folder for temporary files: " + pattern);
  return pattern;
}

}  // namespace

WorkFolder::WorkFolder() : path_((remove_stale_folders(), new_folder())), lock_(open_locked(path_)) {}

WorkFolder::~WorkFolder()
{
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

ProcessResult run_gmsh(std::vector<std::string> arguments, const std::string& folder, double seconds,
    const std::function<void(double)>& waiting)
{
  arguments.insert(arguments.begin(), "gmsh");
  // A home of its own: the user's gmsh options must not change the mesh.
  const ProcessResult result =
      run_process(arguments, seconds, {"GMSH_HOME=" + folder, "LC_ALL=C", "OMP_NUM_THREADS=1"}, waiting);
  if (result.interrupted || result.signal == SIGINT) throw MeshError("gmsh was interrupted");
  return result;
}

std::string gmsh_version(const std::string& folder)
{
  const ProcessResult result = run_gmsh({"--version"}, folder, 60.0);
  if (!result.found) return "";
  if (!result.succeeded()) throw MeshError("`gmsh --version` fails: " + result.output);
  return result.output.substr(0, result.output.find_last_not_of(" \n") + 1);
}

}  // namespace terp
