// It knows the run only by its files. Whether a terp still writes is asked before the ledger is read: so the last
// reading is that of a complete ledger. Ages are differences between times of files in the folder, so the clock of this
// machine does not matter. The speed is that since the last reading in which time moved, at first since the folder was
// begun.

#include "cli/commands.hpp"
#include "io/case/case_file.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "cli/progress.hpp"
#include "io/results/table.hpp"
#include "os/terminal.hpp"
#include "os/say.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// What the last row of the ledger says.
struct Reading {
  double age = 0.0;  ///< wall time since the run's folder was begun, when the row was written [s]
  Real time = std::nan(""), kinetic = std::nan(""), front = std::nan(""), crest = std::nan("");
};

Real last_of(const Table& table, std::string_view name)
{
  const auto* column = table.find(name);
  return column == nullptr || column->empty() ? std::nan("") : column->back();
}

Reading read_progress(const std::string& folder)
{
  const std::string path = path_in(folder, ledger_file);
  if (!fs::exists(path)) return {};
  const Table table = read_number_table(path);
  const auto age = fs::last_write_time(path) - fs::last_write_time(path_in(folder, case_file));
  const auto either = [&](std::string_view right, std::string_view left) {
    const Real x = last_of(table, right);
    return std::isnan(x) ? last_of(table, left) : x;
  };
  return {std::chrono::duration<double>(age).count(), last_of(table, "time"), last_of(table, "kinetic"),
      either("front_x", "front_left_x"), either("crest_x", "crest_left_x")};
}

/// Wall time to the end, at the speed between two readings [s]; NaN if nothing moved.
double time_left(const Reading& before, const Reading& now, Real end)
{
  const double speed = (now.time - before.time) / (now.age - before.age);
  return speed > 0.0 ? (end - now.time) / speed : std::nan("");
}

std::string describe(const Reading& now, Real end, double left)
{
  if (std::isnan(now.time)) return "no row of the ledger yet";
  std::string text = fmt::format("t = {:.3f} of {:g} s ({:.0f} %)  kinetic energy {:.3g} kJ/m", now.time, end,
      100.0 * now.time / end, now.kinetic / 1e3);
  if (!std::isnan(now.front)) text += fmt::format("  front x = {:.2f} m", now.front);
  if (!std::isnan(now.crest)) text += fmt::format("  crest x = {:.2f} m", now.crest);
  return left >= 0.0 ? text + "  ETA " + readable_duration(left) : text;
}

}  // namespace

int watch_run(const WatchCommand& command)
{
  const std::string& folder = command.run;
  if (!fs::is_directory(folder))
    throw FileError(
        fmt::format("{}: no such run folder\n  Give the folder that `terp run` writes to, e.g. runs/model_2; it is "
                    "there once the run has begun.",
            folder));
  if (!fs::exists(path_in(folder, case_file)))
    throw FileError(fmt::format("{}: this is no run folder, it holds no {}", folder, case_file));
  const Real end = read_case(path_in(folder, case_file)).values.time.end;
  LiveLine line;
  Reading before{.age = 0.0, .time = 0.0};
  for (;;) {
    const bool running = is_being_written(folder);
    const Reading now = read_progress(folder);
    line.show(describe(now, end, running ? time_left(before, now, end) : std::nan("")));
    if (!running || command.once) {
      line.end();
      if (!running)
        say("no terp is writing to {}: the run {}\n", folder,
            now.time >= end * (1.0 - 1e-9) ? "is finished" : "has stopped; `terp resume` goes on");
      return solved;
    }
    if (now.time > before.time) before = now;
    wait_seconds(command.every);
  }
}

}  // namespace terp
