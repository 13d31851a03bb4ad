// In a page of a browser nobody can be heard while a function runs. So main() only begins a run; the page goes on with
// it part by part, and between them it hears whether the user wants to stop. A line that begins with the mark is for
// the page, in JSON: how far the run is.

#include "cli/program.hpp"
#include "cli/started_run.hpp"
#include "os/say.hpp"
#include "os/stop.hpp"

#include <nlohmann/json.hpp>

namespace {

using namespace terp;

constexpr char mark = '\x1e';
constexpr int goes_on = -1;  // instead of an exit status

class PageObserver : public Observer {
 public:
  void progress(const Progress& p) override
  {
    const nlohmann::json now = {{"time", p.time}, {"end_time", p.end_time}, {"step", p.step}, {"n_steps", p.n_steps},
        {"n_points", p.n_points}, {"searches", p.out_of_balance >= 0.0}, {"eta_s", p.eta_s}, {"at_most", p.at_most},
        {"stage", p.stage}};
    say("{}{}\n", mark, now.dump());
  }
};

struct RunOfPage {
  PageObserver observer;
  std::unique_ptr<StartedRun> run;
};

RunOfPage& of_page()
{
  static RunOfPage run;
  return run;
}

int begin_run(std::unique_ptr<StartedRun> run)
{
  run->simulation.observers.push_back(&of_page().observer);
  of_page().run = std::move(run);
  return goes_on;
}

/// The commands of a page; what runs many is left out, which makes it a third smaller.
int call_in_page(const CLI::App& app, const CommandLine& line)
{
  if (app.got_subcommand("run")) return begin_run(start_run(line.options));
  if (app.got_subcommand("resume")) return begin_run(start_resumed_run(line.options));
  if (app.got_subcommand("stability")) return find_stability(line.options, line.stability, line.stability_cells);
  if (app.got_subcommand("check")) return check_case(line.options);
  if (app.got_subcommand("report")) return report_runs(line.report);
  if (app.got_subcommand("export")) return export_run(line.exported);
  if (app.got_subcommand("import")) return import_file(line.imported);
  throw CaseError("error: a page of a browser has run, resume, stability, check, report, export and import alone\n");
}

}  // namespace

int main(int argc, char** argv) { return answer(argc, argv, call_in_page); }

extern "C" {

/// Makes steps up to `until` [s]; before the first step, what comes before it. Returns goes_on, or the exit status.
__attribute__((used)) int terp_go_on(double until)
{
  return status_of([&] { return of_page().run->go_on(until).value_or(goes_on); });
}

/// Of the run [s].
__attribute__((used)) double terp_time() { return of_page().run->simulation.state.time; }

/// The next part ends the run, with a checkpoint.
__attribute__((used)) void terp_stop() { stop_requested = true; }
}
