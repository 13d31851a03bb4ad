// A folder is believed only as far as it agrees with itself. The ledger must reach the step of the summary, and the
// history have a row at each interval. Case and tables must be as the summary has them.

#include "io/results/run_results.hpp"

#include "math/checksum.hpp"
#include "math/errors.hpp"
#include "io/case/units.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/table_csv.hpp"
#include "model/case/case.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace terp {
namespace {

namespace fs = std::filesystem;

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

void require_frames(const std::string& folder)
{
  if (fs::exists(path_in(folder, "results.vtkhdf")))
    throw FileError(fmt::format(
        "{}: an earlier terp wrote this run, with all frames in one file, results.vtkhdf (VTKHDF 2.0); this is terp "
        "{}, which reads one file per frame (VTKHDF 1.0)\n  Read it with that terp, or solve the case again.",
        folder, TERP_VERSION));
  if (list_frames(folder, point_frames).empty())
    require(folder, frames_folder, "It is made with the first frame: the run has not begun to move, or failed before.");
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

/// Interval of the rows of history.csv, as the case has it [s]; 0 if it cannot be read.
Real history_interval(const std::string& case_toml)
try {
  const Node root = parse_toml(case_toml);
  const Node* every = find_node(root, "output.history.every");
  if (every == nullptr) return OutputCase{}.history_every;
  return number_of(*every, "s").value_or(0.0);
} catch (const SyntaxError&) {
  return 0.0;
}

/// Each point has a row every interval, in order of time, and of a run that reached its end up to there.
void require_whole_history(const RunResults& run)
{
  const std::string path = path_in(run.folder, history_file);
  const auto refuse = [&](const std::string& point, const std::string& fault) {
    throw FileError(
        fmt::format("{}: point {}: {}\n  The table was damaged or edited: copy the folder again, or solve "
                    "the case again.",
            path, point, fault));
  };
  const Real dt = run.summary.values.dt, most = history_interval(run.case_toml) + 1.01 * dt;
  const auto* ledger_time = run.ledger.find("time");
  for (const PointTable& point : run.history) {
    const auto* time = point.table.find("time");
    if (time == nullptr || time->empty()) refuse(point.point, "it has no times");
    for (std::size_t k = 1; k < time->size(); ++k) {
      const Real before = (*time)[k - 1], now = (*time)[k];
      if (!(now > before)) refuse(point.point, fmt::format("the row of t = {} s follows that of {} s", now, before));
      if (dt > 0.0 && most > 1.01 * dt && now - before > most)
        refuse(point.point, fmt::format("rows between t = {} s and {} s are missing", before, now));
    }
    if (run.summary.finished && ledger_time != nullptr && !ledger_time->empty() && time->back() < ledger_time->back())
      refuse(point.point, fmt::format("it ends at t = {} s, the run at {} s", time->back(), ledger_time->back()));
  }
}

[[noreturn]] void refuse_altered(const std::string& path, std::string_view fault)
{
  throw FileError(fmt::format("{}: {}\n  Put a copy of it back, or solve the case again.", path, fault));
}

/// Case and tables are those that the run wrote, as its summary has them. Rows that came later are not known to it.
void require_unaltered(const RunResults& run)
{
  if (run.summary.case_toml && *run.summary.case_toml != run.case_toml)
    refuse_altered(path_in(run.folder, case_file), "this is not the case that was solved: it was altered");
  for (const WrittenTable& table : run.summary.tables) {
    const std::string path = path_in(run.folder, table.file);
    if (!fs::exists(path)) refuse_altered(path, "it is missing, and the run wrote it");
    const std::string text = read_file(path);
    const auto n = static_cast<std::size_t>(table.n_bytes);
    if (text.size() < n || (run.summary.finished && text.size() > n) || digits_of(text.substr(0, n)) != table.checksum)
      refuse_altered(path, "this is not what the run wrote: it was altered, doubled or cut off");
  }
}

}  // namespace

RunResults read_run(const std::string& folder)
{
  if (!fs::is_directory(folder.empty() ? "." : folder)) throw FileError(fmt::format("{}: no such run folder", folder));
  require(folder, case_file, "Give the folder that `terp run` wrote, e.g. runs/model_2.");
  require(folder, summary_file, "It is written when a run starts: solve the case first.");
  require_frames(folder);
  RunResults run{.folder = folder,
      .name = distinct_names({folder})[0],
      .case_toml = read_file(path_in(folder, case_file)),
      .summary = read_summary(path_in(folder, summary_file))};
  require_unaltered(run);
  if (fs::exists(path_in(folder, ledger_file))) {
    run.ledger = read_number_table(path_in(folder, ledger_file));
    require_whole_ledger(run);
  }
  if (fs::exists(path_in(folder, history_file))) {
    run.history = read_history(path_in(folder, history_file));
    require_whole_history(run);
  }
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
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) break;
  }
  return names;
}

}  // namespace terp
