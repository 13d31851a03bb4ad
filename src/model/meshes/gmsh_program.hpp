// gmsh as a program: Debian's, run as a separate process in a folder of its own, without the user's options.
// Not for: what it is asked to do. generate.hpp makes meshes, gmsh_file.hpp has files of other formats converted.
#pragma once

#include "os/process.hpp"

#include <functional>
#include <string>
#include <vector>

namespace terp {

/// A new empty folder for work in progress. It is removed with its contents at the end of the scope, and if this
/// process is killed, by the next process that makes one.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int claim_ = -1;  ///< on the folder, as long as this process works in it
};

/// gmsh with a home in `folder`. seconds: that it may take. waiting: called now and then with the seconds that have
/// passed. Throws MeshError if it was interrupted.
ProcessResult run_gmsh(std::vector<std::string> arguments, const std::string& folder, double seconds,
    const std::function<void(double)>& waiting = {});

/// As "apt-get install gmsh".
inline std::string how_to_install_gmsh() { return how_to_install("gmsh", "https://gmsh.info"); }

/// "4.8.4"; empty if gmsh is not installed.
std::string gmsh_version(const std::string& folder);

}  // namespace terp
