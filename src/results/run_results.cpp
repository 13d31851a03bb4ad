#include "results/run_results.hpp"

#include "base/errors.hpp"
#include "output/files.hpp"
#include "output/run_folder.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// The last n parts of a path, joined by "/".
std::string tail_of(const fs::path& path, int n)
{
  fs::path tail;
  fs::path rest = path;
  for (int k = 0; k < n && rest.has_filename(); ++k, rest = rest.parent_path())
    tail = tail.empty() ? rest.filename() : rest.filename() / tail;
  return tail.empty() ? path.string() : tail.string();
}

fs::path absolute_path(const std::string& folder)
{
  fs::path path = fs::absolute(folder.empty() ? "." : folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

void require(const std::string& folder, std::string_view file, std::string_view why)
{
  if (fs::exists(path_in(folder, file))) return;
  throw FileError(fmt::format("{}: this is no run folder that can be shown: it has no {}\n  {}", folder, file, why));
}

/// Of a run that reached its end the ledger does too.
void require_whole_ledger(const RunResults& run)
{
  const auto* step = run.ledger.find("step");
  const auto n_steps = run.summary.values.n_steps;
  const auto last = step == nullptr || step->empty() ? std::int64_t{0} : static_cast<std::int64_t>(step->back());
  if (!run.summary.finished || last >= n_steps) return;
  throw FileError(
      fmt::format("{}: ends at step {}, the run at step {}\n  The table was damaged or cut off: copy the folder again, "
                  "or solve the case again.",
          path_in(run.folder, ledger_file), last, n_steps));
}

}  // namespace

RunResults read_run(const std::string& folder)
{
  if (!fs::is_directory(folder.empty() ? "." : folder)) throw FileError(fmt::format("{}: no such run folder", folder));
  require(folder, case_file, "Give the folder that `terp run` wrote, e.g. runs/model_2.");
  require(folder, summary_file, "It is written when a run starts: solve the case first.");
  require(
      folder, results_file, "It is written with the first frame: the run has not begun to move yet, or failed before.");
  RunResults run{.folder = folder,
      .name = distinct_names({folder})[0],
      .case_toml = read_file(path_in(folder, case_file)),
      .summary = read_summary(path_in(folder, summary_file)),
      .ledger = {},
      .history = {}};
  if (fs::exists(path_in(folder, ledger_file))) {
    run.ledger = read_number_table(path_in(folder, ledger_file));
    require_whole_ledger(run);
  }
  if (fs::exists(path_in(folder, history_file))) run.history = read_history(path_in(folder, history_file));
  return run;
}

bool summary_is_behind(const RunResults& run)
{
  const auto* step = run.ledger.find("step");
  if (!run.summary.finished && run.summary.values.n_steps == 0) return true;  // as it was written at the start
  return step != nullptr && !step->empty() && step->back() > static_cast<Real>(run.summary.values.n_steps);
}

std::vector<std::string> distinct_names(const std::vector<std::string>& folders)
{
  std::vector<fs::path> paths;
  for (const auto& folder : folders) paths.push_back(absolute_path(folder));
  std::vector<std::string> names;
  for (int n = 1; n < 32; ++n) {
    names.clear();
    for (const auto& path : paths) names.push_back(tail_of(path, n));
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) break;
  }
  return names;
}

}  // namespace terp
