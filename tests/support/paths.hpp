// Where tests find the project's files and put their own.
#pragma once

#include "support/test.hpp"

namespace terp::test {

/// The program `terp` of this build.
std::string program();

/// Absolute path of a file of the project, e.g. source_path("cases/column_collapse/model_2.toml").
std::string source_path(const std::string& relative);

/// A new empty folder, removed with its contents at the end of the scope.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace terp::test
