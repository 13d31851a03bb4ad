// The runs of the plan are solved one after the other, each on all threads of the command. One that stops itself has no
// result, and the others go on. Results are read back from the folders at the end, so that kept runs and new ones are
// judged alike. After an interruption the same command makes a new plan from what the folders hold.

#include "cli/converge_plan.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "cli/progress.hpp"
#include "page/convergence_page.hpp"
#include "page/page.hpp"
#include "os/stop.hpp"
#include "cli/what_decides.hpp"
#include "os/say.hpp"

#include <chrono>
#include <fmt/format.h>
#include <new>

namespace terp {
namespace {

constexpr const char* convergence_json = "convergence.json";
constexpr const char* convergence_page = "convergence.html";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// How much longer runs take than was expected of them, from those that are done.
class Pace {
 public:
  double later(const Plan& plan, std::size_t now) const
  {
    double seconds = 0.0;
    for (std::size_t k = now + 1; k < plan.runs.size(); ++k) seconds += plan.runs[k].seconds;
    return expected_ > least_seconds ? seconds * spent_ / expected_ : seconds;
  }
  void done(double expected, double spent) { expected_ += expected, spent_ += spent; }

 private:
  static constexpr double least_seconds = 2.0;  // shorter runs say nothing of longer ones
  double expected_ = 0.0, spent_ = 0.0;
};

/// Solves a run or goes on with it. Returns why there is no result; empty: solved.
std::string solve(const PlannedRun& run, const ConvergeOptions& options, PartOfSet part)
{
  std::string fault;
  part.fault = &fault;
  RunOptions o = options.run;
  o.report = o.json = o.verbose = false;
  o.part = &part;
  try {
    if (run.start == RunStart::goes_on) {
      o.path = run.folder;
      o.changes.clear();
      resume_run(o);
    } else {
      o.output = run.folder;
      o.changes = run.changes;
      o.force = run.start == RunStart::again;
      run_case(o);
    }
  } catch (const std::bad_alloc&) {
    fault = "not enough memory";
  }
  return fault;
}

std::string word(const PlannedRun& run, double seconds)
{
  if (run.start == RunStart::kept) return "kept, solved before";
  return fmt::format("solved in {}", readable_duration(seconds));
}

bool solve_all(Plan& plan, const ConvergeOptions& options)
{
  using Clock = std::chrono::steady_clock;
  Pace pace;
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    const PlannedRun& run = plan.runs[k];
    const std::string label = fmt::format("[{}/{}] {}  ", k + 1, plan.runs.size(), run.label);
    const auto start = Clock::now();
    std::string fault;
    if (run.start != RunStart::kept) fault = solve(run, options, {.label = label, .later_s = pace.later(plan, k)});
    if (stop_requested) return false;
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (run.start != RunStart::kept) pace.done(run.seconds, seconds);
    if (!fault.empty()) say(stderr, "warning: {}no result; the others go on\n  {}\n", label, fault);
    if (fault.empty() && !options.run.quiet) say("{}{}\n", label, word(run, seconds));
    plan.sequences[run.sequence].runs[run.number].fault = first_line(fault);
  }
  return true;
}

void read_results(Plan& plan)
{
  for (StudySequence& sequence : plan.sequences)
    for (StudyRun& run : sequence.runs)
      if (run.fault.empty()) run.results = read_run(path_in(plan.folder, run.folder));
}

int count_faults(const Plan& plan)
{
  int n = 0;
  for (const StudySequence& sequence : plan.sequences)
    for (const StudyRun& run : sequence.runs) n += run.fault.empty() ? 0 : 1;
  return n;
}

void write_report(const Plan& plan)
{
  ReportCommand report{.runs = {}, .output = path_in(plan.folder, report_file)};
  for (const StudySequence& sequence : plan.sequences)
    for (const StudyRun& run : sequence.runs)
      if (run.fault.empty()) report.runs.push_back(path_in(plan.folder, run.folder));
  if (!report.runs.empty()) report_runs(report);
}

}  // namespace

int converge_case(const ConvergeOptions& options)
{
  Plan plan = plan_study(options);
  const RunOptions& run = options.run;
  const bool speaks = !run.quiet && !run.json;
  if (speaks || options.estimate) say("{}", plan_text(plan, threads_of(run)));
  if (options.estimate) return say("nothing was run\n"), solved;
  make_folder(plan.folder);
  listen_for_stop();
  ConvergeOptions silent = options;
  silent.run.quiet = !speaks;
  if (!solve_all(plan, silent)) {
    say(stderr, "stopped; what is solved is kept in {}. Go on with the same command\n", plan.folder);
    return failed;
  }
  if (options.what_decides) {
    const Decision decision = decide(plan);
    write_file_atomically(path_in(plan.folder, depends_file), decision.json);
    if (run.json) say("{}", decision.json);
    if (speaks) say("{}numbers in {}\n", decision.text, path_in(plan.folder, depends_file));
    if (run.report) write_report(plan);
    return plan.sequences.front().runs.front().fault.empty() ? solved : stopped_itself;  // else that is an outcome
  }
  read_results(plan);
  MeshStudy study = study_mesh(plan.sequences, options.tolerance);
  study.case_name = plan.case_name, study.title = plan.title;
  const std::string now = now_in_utc();
  write_file_atomically(path_in(plan.folder, convergence_json), study_json(study, now));
  write_file_atomically(
      path_in(plan.folder, convergence_page), make_page(page_template(), convergence_payload(study, now)));
  if (run.json) say("{}", study_json(study, now));
  if (speaks) say("{}", study_text(study));
  if (run.report) write_report(plan);
  if (speaks) say("page in {}, numbers in {}\n", path_in(plan.folder, convergence_page), convergence_json);
  return count_faults(plan) == 0 ? solved : stopped_itself;
}

}  // namespace terp
