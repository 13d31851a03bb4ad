// What is impossible is refused before a folder is made. Then the lock, and only under it anything is removed or
// written. A part writes its store alone; the one that finds all others done writes the results of the study.

#include "cli/study_run.hpp"

#include "math/number_from.hpp"
#include "io/case/printable.hpp"
#include "io/files/run_folder.hpp"
#include "os/threads.hpp"
#include "cli/progress.hpp"
#include "batch/adaptive.hpp"
#include "batch/store.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_text.hpp"
#include "cli/study_progress.hpp"
#include "os/stop.hpp"
#include "os/say.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

/// "3/100"; empty: that of this process.
StudyPart part_of(const std::string& text, const Launched& launched)
{
  if (text.empty()) return {launched.rank + 1, launched.size};
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = number_from<Index>(text.substr(0, slash)),
             n_all = number_from<Index>(text.substr(std::min(slash + 1, text.size())));
  if (!number || !n_all || *number < 1 || *n_all < *number)
    throw CaseError(printable(fmt::format(
        "error: --part {}: a part is K/N, K from 1 to N\n  As in --part 3/100, of the third of a hundred tasks.\n",
        text)));
  return {*number, *n_all};
}

void refuse_impossible(const Study& study, const std::string& folder, const StudyPart& part, bool force)
{
  if (part.n_all == 1) return;
  if (force)
    throw CaseError(printable(fmt::format(
        "error: --force in part {} of {}: a part does not begin anew, as it would remove what others solved\n"
        "  Remove the folder once, before the parts begin: rm -r {}\n",
        part.number, part.n_all, folder)));
  const EstimatorInfo& method = info_of(study.settings.estimator);
  if (method.adaptive)
    throw CaseError(
        fmt::format("error: part {} of {}: `{}` chooses its realisations one after another, so it has no parts\n  "
                    "Start one process, "
                    "without --part, mpirun, srun or an array, on the machine with the most processors.\n",
            part.number, part.n_all, method.name));
}

/// What is kept, if this program may go on with it.
Realisations take_store(const Study& study, const std::string& folder)
{
  StoredStudy stored = read_store(study, folder);
  say(stderr, "{}", check_that_bits_agree(study, folder, stored, stop_requested));
  return std::move(stored.rows);
}

StudyEnd solve(const Study& study, const std::string& folder, const StudyPart& part, const StudyCommand& command,
    Realisations& rows)
{
  StudyProgress progress(study, part, command.threads, command.quiet);
  const bool adaptive = info_of(study.settings.estimator).adaptive;
  const StudyEnd end = (adaptive ? run_adaptive : run_realisations)(study, folder,
      {.threads = command.threads,
          .part = part,
          .show = [&](const Realisation& newest, const Realisations& all) { progress.show(newest, all); }},
      stop_requested, rows);
  progress.finish();
  return end;
}

}  // namespace

int run_study(const Study& study, const std::string& folder, const StudyCommand& command, const Launched& launched)
{
  const StudyPart part = part_of(command.part, launched);
  refuse_impossible(study, folder, part, command.force);
  check_study_folder(study, folder);
  const StudyPlace place(folder, part.name());
  listen_for_stop();
  if (command.force) place.clear();
  Realisations rows = take_store(study, folder);
  write_copies(study, place);
  const StudyEnd end = solve(study, folder, part, command, rows);
  if (end == StudyEnd::stopped) {
    say(stderr, "stopped; what is solved is kept in {}. Go on with the same command\n", folder);
    return failed;
  }
  if (part.n_all > 1) {
    StoredStudy all = read_store(study, folder);
    rows = std::move(all.rows);
    if (!TableCounter(study, rows).rule_met()) {
      if (!command.quiet)
        say("part {} of {} {}; what all have so far: terp study report {}\n", part.number, part.n_all,
            end == StudyEnd::out_of_time ? "has had its stop.time, and the same command goes on" : "is done", folder);
      return solved;
    }
    say(stderr, "{}", why_bits_differ(all));
  }
  write_results(study, place_of_results(folder), rows, now_in_utc());
  if (!command.quiet) {
    say("{}", study_text(study, rows));
    say("page in {}, table in {}\n", path_in(folder, study_report), study_results);
  }
  if (rows.empty() || !std::ranges::all_of(rows, [](const auto& row) { return row.second.failed(); })) return solved;
  say(stderr, "error: all {} realisations failed, the first one: {}\n", rows.size(), rows.begin()->second.fault);
  return stopped_itself;
}

}  // namespace terp
