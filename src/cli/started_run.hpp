// A run of `terp run` or `terp resume` that goes on part by part, as a page of a browser must.
#pragma once

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "io/case/case_file.hpp"
#include "io/files/mesh_file.hpp"
#include "io/files/run_writer.hpp"
#include "io/files/summary_keeper.hpp"

#include <memory>
#include <optional>
#include <string>

namespace terp {

/// False of a run of a set, which says for itself what was done.
inline bool is_alone(const RunOptions& options) { return options.part == nullptr; }

class StartedRun {
 public:
  /// make: gives the simulation. Its files follow with write_to.
  template <class Make>
  StartedRun(RunOptions options, CaseFile file, std::string folder, Make&& make)
      : simulation(make()),
        options_(std::move(options)),
        file_(std::move(file)),
        folder_(std::move(folder)),
        progress_(options_.quiet, part().label, part().later_s)
  {
  }
  void write_to(std::unique_ptr<RunWriter> writer);

  /// Makes the steps up to the first one at or after `until` [s]; before the first step, no more than what comes before
  /// it. Returns the exit status of the program if the run has ended or was stopped, and leaves a summary then.
  std::optional<int> go_on(Real until);

  Simulation simulation;

 private:
  PartOfSet part() const { return options_.part != nullptr ? *options_.part : PartOfSet{}; }
  Summary write_summary(bool is_through);
  int end();
  int stop();
  int end_with(const RunError& error);

  RunOptions options_;
  CaseFile file_;
  std::string folder_;
  ProgressLine progress_;
  std::unique_ptr<RunWriter> writer_;
  std::optional<MeshWriter> mesh_;
  std::optional<SummaryKeeper> keeper_;
};

/// What run_case and resume_run begin with. Throw as they do.
std::unique_ptr<StartedRun> start_run(const RunOptions& options);
std::unique_ptr<StartedRun> start_resumed_run(const RunOptions& options);

}  // namespace terp
