// The folder of a run that Python drives: the same files as `terp run` writes.
#pragma once

#include "io/case/case_file.hpp"
#include "io/files/mesh_file.hpp"
#include "io/files/run_writer.hpp"
#include "io/files/summary_keeper.hpp"
#include "run/loop/simulation.hpp"

#include <memory>
#include <string>
#include <vector>

namespace terp {

class RunFiles {
 public:
  /// Begins the folder. Throws FileError where it holds something, unless `force`: then the run there is removed.
  RunFiles(const CaseFile& file, const Simulation& run, const std::string& folder, bool force);

  /// To be connected to the run.
  std::vector<Observer*> observers() { return {writer_.get(), &mesh_, &keeper_}; }
  /// Writes the summary, and returns when all is on the disk.
  void finish(bool has_ended);

 private:
  const Simulation& run_;
  std::unique_ptr<RunWriter> writer_;
  MeshWriter mesh_;
  SummaryKeeper keeper_;
};

}  // namespace terp
