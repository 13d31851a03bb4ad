// What is impossible is refused before a folder is made. Then the lock, and only under it anything is removed or
// written. Results are written by a study as a whole; a part writes its store alone.

#include "cli/study_run.hpp"

#include "io/case/printable.hpp"
#include "io/files/run_folder.hpp"
#include "os/threads.hpp"
#include "cli/progress.hpp"
#include "batch/adaptive.hpp"
#include "batch/ranks.hpp"
#include "batch/store.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_text.hpp"
#include "cli/study_progress.hpp"
#include "os/stop.hpp"
#include "os/terminal.hpp"

#include <charconv>
#include <fmt/format.h>
#include <utility>

namespace terp {
namespace {

/// "3/100"; empty: all.
StudyPart part_of(const std::string& text)
{
  StudyPart part;
  if (text.empty()) return part;
  const char *end = text.data() + text.size(), *slash = text.data() + std::min(text.find('/'), text.size());
  const auto first = std::from_chars(text.data(), slash, part.number);
  const auto second = slash == end ? first : std::from_chars(slash + 1, end, part.n_all);
  if (slash == end || first.ec != std::errc() || first.ptr != slash || second.ec != std::errc() || second.ptr != end ||
      part.number < 1 || part.n_all < part.number)
    throw CaseError(printable(fmt::format(
        "error: --part {}: a part is K/N, K from 1 to N\n  As in --part 3/100, of the third of a hundred tasks.\n",
        text)));
  return part;
}

void refuse_impossible(
    const Study& study, const std::string& folder, const StudyCommand& command, const StudyPart& part)
{
  if (command.force && part.n_all > 1)
    throw CaseError(printable(
        fmt::format("error: --force with --part {}: a part does not begin anew, as it would remove what others solved\n"
                    "  Remove the folder once, before the parts begin: rm -r {}\n",
            command.part, folder)));
  if (info_of(study.settings.estimator).adaptive && part.n_all > 1)
    throw CaseError(
        fmt::format("error: --part {}: `{}` chooses its realisations one after another\n  Its parts cannot "
                    "be made apart. Give -j alone, or start it with mpirun.\n",
            command.part, info_of(study.settings.estimator).name));
}

/// What is kept, if this program may go on with it.
Realisations take_store(const Study& study, const std::string& folder)
{
  StoredStudy stored = read_store(study, folder);
  fmt::print(stderr, "{}", check_that_bits_agree(study, folder, stored, stop_requested));
  return std::move(stored.rows);
}

StudyEnd solve(const Study& study, const StudyPlace& place, const StudyPart& part, const StudyCommand& command,
    const Launched& launched, Realisations& rows)
{
  std::optional<RankServer> ranks;
  const auto warn = [](const std::string& what) { fmt::print(stderr, "warning: {}\n", what); };
  if (!launched.is_alone()) ranks.emplace(study, place.lock_folder(), launched, warn);
  const int threads = command.threads > 0 ? command.threads : available_processors();
  const auto n_at_a_time = [&] { return ranks ? std::max(1, ranks->n_workers()) : threads; };
  StudyProgress progress(study, part, n_at_a_time, command.quiet);
  const bool adaptive = info_of(study.settings.estimator).adaptive;
  const StudyEnd end = (adaptive ? run_adaptive : run_realisations)(study, place.folder(),
      {.threads = threads,
          .part = part,
          .ranks = ranks ? &*ranks : nullptr,
          .show = [&](const Realisation& newest, const Realisations& all) { progress.show(newest, all); }},
      stop_requested, rows);
  progress.finish();
  if (ranks && ranks->n_ranks() < launched.size && !command.quiet)
    fmt::print("{} of {} ranks took part\n", ranks->n_ranks(), launched.size);
  return end;
}

/// In the process of a worker. Rank 0 says what is wrong with the study.
int work(const StudyCommand& command, const Launched& launched)
{
  listen_for_stop();
  const auto say = [&](const char* what) {
    fmt::print(stderr, "rank {}: {}\n", launched.rank, what);
    return failed;
  };
  try {
    const Study study = open_study(command.path);
    const std::string folder = folder_of_study(command.path, command.output, study);
    work_for_rank_0(study, lock_folder_of(folder, part_of(command.part).name()), launched, std::max(1, command.threads),
        stop_requested);
    return solved;
  } catch (const std::bad_alloc&) {
    return say("not enough memory; fewer ranks on a machine need less");
  } catch (const CaseError&) {
    return failed;
  } catch (const std::exception& error) {
    return say(error.what());
  }
}

/// A rank above 0 has no other task. It outlives a wish to stop, which its worker is told.
int wait_for_worker(Children& worker, const Launched& launched)
{
  listen_for_stop();
  for (bool told = false;;) {
    if (const auto end = worker.next_end()) {
      if (!end->killed_by.empty())
        fmt::print(stderr, "rank {}: its worker was ended by {}\n", launched.rank, end->killed_by);
      return solved;
    }
    if (stop_requested && !std::exchange(told, true)) worker.ask_to_stop();
    wait_seconds(0.1);
  }
}

}  // namespace

int run_study(const Study& study, const std::string& folder, const StudyCommand& command, const Launched& launched)
{
  const StudyPart part = part_of(command.part);
  refuse_impossible(study, folder, command, part);
  check_study_folder(study, folder);
  const StudyPlace place(folder, part.name());
  listen_for_stop();
  if (command.force) place.clear();
  Realisations rows = take_store(study, folder);
  write_copies(study, place);
  const StudyEnd end = solve(study, place, part, command, launched, rows);
  if (end == StudyEnd::stopped) {
    fmt::print(stderr, "stopped; what is solved is kept in {}. Go on with the same command\n", folder);
    return failed;
  }
  if (part.n_all > 1) {
    if (!command.quiet)
      fmt::print("part {} of {} {}; all of them: terp study report {}\n", part.number, part.n_all,
          end == StudyEnd::out_of_time ? "has had its stop.time, and the same command goes on" : "is done", folder);
    return solved;
  }
  write_results(study, place_of_results(folder), rows, now_in_utc());
  if (!command.quiet) {
    fmt::print("{}", study_text(study, rows));
    fmt::print("page in {}, table in {}\n", path_in(folder, study_report), study_results);
  }
  if (rows.empty() || !std::ranges::all_of(rows, [](const auto& row) { return row.second.failed(); })) return solved;
  fmt::print(stderr, "error: all {} realisations failed, the first one: {}\n", rows.size(), rows.begin()->second.fault);
  return stopped_itself;
}

std::optional<int> begin_worker(const StudyCommand& command, const Launched& launched, Children& worker)
{
  if (own_task()) return work(command, launched);
  worker.begin(0, fmt::format("the worker of rank {}", launched.rank));
  return launched.rank == 0 ? std::nullopt : std::optional(wait_for_worker(worker, launched));
}

}  // namespace terp
