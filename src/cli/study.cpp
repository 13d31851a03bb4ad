// Of several processes that a launcher started the first one warns and shows how far it is; they would say the same.
// The check times the case without draws, then sets up the first realisation: only there do all draws meet. A
// realisation that is kept must have the outcomes of the store to the bit. Where events end realisations, its run with
// files goes on beyond them; then it is solved once more as the study does.

#include "cli/commands.hpp"
#include "cli/cost.hpp"
#include "io/case/printable.hpp"
#include "io/case/render.hpp"
#include "io/files/run_folder.hpp"
#include "os/threads.hpp"
#include "cli/progress.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_page.hpp"
#include "page/page.hpp"
#include "batch/study_text.hpp"
#include "batch/study_warnings.hpp"
#include "cli/study_run.hpp"
#include "os/stop.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>

namespace terp {
namespace {

std::string quantile_line(const RandomNumber& number)
{
  const Distribution& d = number.distribution;
  return fmt::format("  random         {}: {}, 5 % {:.4g}, 50 % {:.4g}, 95 % {:.4g}\n", number.key,
      all_distributions()[static_cast<std::size_t>(d.kind)].name, d.quantile(0.05), d.quantile(0.5), d.quantile(0.95));
}

void print_input(const Study& study)
{
  const StudySettings& s = study.settings;
  for (const SweepKey& sweep : s.sweep) say("  sweep          {}: {} values\n", sweep.key, sweep.values.size());
  if (s.fragility)
    say("  load           {}: {} levels from {:g} to {:g}, the same samples at each\n", s.fragility->label(),
        s.fragility->levels.size(), s.fragility->levels.front(), s.fragility->levels.back());
  for (const RandomNumber& number : s.numbers) say("{}", quantile_line(number));
  for (std::size_t k = 0; k < s.fields.size(); ++k) {
    const RandomFieldKey& f = s.fields[k];
    const auto& box = study.boxes[k];
    say("  field          {}: {}, {}, cov {:g}, theta {:g} and {:g} m, from ({:g}, {:g}) to ({:g}, {:g}) m\n", f.key,
        f.distribution, f.correlation, f.cov, f.scale[0], f.scale[1], box[0][0], box[0][1], box[1][0], box[1][1]);
  }
  for (const StudyCorrelation& c : s.correlations) say("  correlation    {:g} between {} and {}\n", c.value, c.a, c.b);
}

/// All that is drawn at once, which the checks of single keys do not see. Of two levels both.
void check_first_draws(const Study& study)
{
  for (Index number = 0; number <= (study.coarse ? 1 : 0); ++number) {
    const std::string name = fmt::format("realisation {}{}", number,
        !study.coarse             ? ""
        : study.is_coarse(number) ? ", coarse"
                                  : ", fine");
    try {
      const CaseFile file = case_of(study, draw_realisation(study, number));
      const Simulation simulation(file.values, std::make_shared<const Mesh<2>>(build_mesh(file.values)), 1);
      say("  {}  can be solved: {} material points\n", name, simulation.state.points.n_points());
    } catch (const InputError& error) {
      say(stderr, "warning: the case refuses {}: {}\n", name, error.what());
    } catch (const CaseError& error) {
      say(stderr, "warning: the case refuses {}:\n{}", name, error.what());
    }
  }
}

struct RunCosts {
  double seconds = 0.0, bytes = 0.0;
};

/// Of a case without any draw; none, with a line that says why: it stops itself.
std::optional<RunCosts> costs_of(const CaseFile& base, const SharedMesh& mesh)
{
  try {
    Simulation simulation(base.values, mesh, 1);
    const double seconds = seconds_of_steps(simulation.model, time_a_step(simulation));
    return RunCosts{seconds, static_cast<double>(bytes_of(simulation.model, simulation.state))};
  } catch (const RunError& error) {
    say("  expected time  unknown: the case as it is stops itself: {}\n", error.what());
    return std::nullopt;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), base));
  }
}

void print_costs(const Study& study, int threads)
{
  const double limit = study.settings.stop.time;
  const auto fine = costs_of(study.base, study.mesh);
  const auto coarse = study.coarse ? costs_of(study.coarse->base, study.coarse->mesh) : std::optional(RunCosts{});
  if (!fine || !coarse) return;
  const Index n_fine = study.coarse ? study.n_pairs() : study.n_realisations;
  const double all = fine->seconds * n_fine + coarse->seconds * (study.n_realisations - n_fine);
  say("  memory         {:.0f} MB for each of {} threads\n", std::max(fine->bytes, coarse->bytes) / 1e6, threads);
  say("  expected time  at most {} each{}, at most {} in all\n", readable_duration(fine->seconds),
      study.coarse ? fmt::format(" fine, {} each coarse", readable_duration(coarse->seconds)) : "",
      readable_duration(all / threads));
  if (study.coarse && coarse->seconds >= fine->seconds)
    say(stderr, "warning: a coarse realisation takes as long as a fine one: two levels save nothing\n");
  if (limit > 0.0 && std::max(fine->seconds, coarse->seconds) > limit)
    say(stderr, "warning: one realisation may take longer than `stop.time`\n");
}

int check_study(const Study& study, int threads)
{
  const StudySettings& s = study.settings;
  say("{}\n  case           {}\n", printable(s.title.empty() ? s.name : s.title), printable(study.case_path));
  print_input(study);
  say("  realisations   {}{}, {}\n", s.stop.cov > 0.0 || info_of(s.estimator).adaptive ? "at most " : "",
      study.n_realisations, info_of(s.estimator).title);
  if (const std::string plan = plan_of_estimator(s); !plan.empty()) say("  of these       {}\n", plan);
  if (s.stop.cov > 0.0) say("  stops          at a coefficient of variation of P of {:g}\n", s.stop.cov);
  if (s.stop.time > 0.0) say("  stops          after {}\n", readable_duration(s.stop.time));
  say("  I              {}\n", slide_words(s));
  say("  mesh           {}\n", study.shares_mesh ? "one for all realisations" : "made anew for each realisation");
  print_costs(study, threads);
  check_first_draws(study);
  say("nothing was run\n");
  return solved;
}

bool has_store(const std::string& folder)
{
  std::error_code none;
  return std::ranges::any_of(std::filesystem::directory_iterator(folder, none),
      [](const auto& entry) { return is_part_of_store(entry.path().filename().string()); });
}

int report_study(const Study& study, const std::string& folder, bool writes)
{
  std::optional<StudyPlace> place;
  if (writes) check_study_folder(study, folder);
  if (writes && has_store(folder)) place.emplace(place_of_results(folder));
  const StoredStudy stored = read_store(study, folder);
  if (stored.n_files == 0)
    throw FileError(fmt::format("{}: there are no results of this study yet\n  Begin with: terp study run", folder));
  say("{}", study_text(study, stored.rows));
  say(stderr, "{}", why_bits_differ(stored));
  if (stored.n_broken > 0)
    say("  note: in the store {} lines were cut or altered; their realisations are made again\n", stored.n_broken);
  if (!writes) return solved;
  write_copies(study, *place);
  write_results(study, *place, stored.rows, now_in_utc());
  say("page in {}, table in {}\n", path_in(folder, study_report), study_results);
  return solved;
}

int sample_study(const Study& study, const std::string& folder, const StudyCommand& command)
{
  const Index n = std::min<Index>(study.n_samples(), command.samples);
  check_study_folder(study, folder);
  make_folder(folder);
  const std::string page = path_in(folder, "sample.html");
  write_file_atomically(page, make_page(page_template(), samples_payload(study, n, now_in_utc())));
  const auto names = study.input_names();
  for (Index k = 0; k < std::min<Index>(n, 10); ++k) {
    const Index number = study.first_of_turn(k * study.n_levels());
    const Draw draw = draw_realisation(study, number);
    say("realisation {}\n", number);
    for (std::size_t i = 0; i < names.size(); ++i)
      say("  {:>12}  {}\n", input_text(study, i, draw.inputs[i]), names[i]);
  }
  say("histograms of {} in {}\n", n, page);
  return solved;
}

/// Solves a realisation once more as a run with all its files, and compares it with the store.
int keep(const Study& study, const std::string& folder, Index number, const StudyCommand& command)
{
  if (number < 0 || number >= study.n_realisations)
    throw CaseError(fmt::format("error: --keep {}: there is no such realisation\n  They are numbered 0 to {}.\n",
        number, study.n_realisations - 1));
  RunOptions run;
  run.path = study.case_path;
  const Realisations rows = read_store(study, folder).rows;
  const auto there = rows.find(number);
  if (there == rows.end() && info_of(study.settings.estimator).adaptive)
    throw CaseError(fmt::format("error: --keep {}: the method has not come to this realisation\n", number));
  const Draw draw = draw_again(study, number, there != rows.end() ? there->second.inputs : std::vector<Real>{});
  Realisation again;
  again.is_held = there != rows.end() && there->second.solved() && there->second.outcomes[outcome_number("held")] > 0.0;
  run.changes = again.is_held ? held_changes(draw) : draw.changes;
  run.output = path_in(folder, fmt::format("{}/{}", kept_runs, number));
  run.threads = command.threads;
  run.force = run.report = true;
  run.quiet = command.quiet;
  run.at_end = [&](const Simulation& simulation) { read_outcomes(simulation, study.settings.event, again); };
  const std::string kept = path_in(run.output, kept_mark);
  std::filesystem::remove(kept);
  const int status = run_case(run);
  if (status != solved) return status;
  const bool is_known = there != rows.end() && there->second.solved();
  if (const auto names =
          is_known ? differing_outcomes(there->second.outcomes, again.outcomes) : std::vector<std::string>();
      !names.empty())
    throw FileError(
        fmt::format("realisation {} has other results than in the store: {}\n  It was solved by another program "
                    "or machine: AVX-512 and AVX2 give the same bits, SSE2 others.",
            number, fmt::join(names, ", ")));
  write_file_atomically(kept, digits_of_study(study) + '\n');
  if (is_known && !command.quiet) say("realisation {} has the results of the store, to the bit\n", number);
  return status;
}

void print_doubts(const Study& study, bool makes_cases)
{
  std::vector<Problem> doubts = find_doubts(study);
  WarningsOfCases of_cases;
  if (makes_cases) of_cases = find_warnings_of_cases(study, doubts);
  std::ranges::move(of_cases.drawn, std::back_inserter(doubts));
  say(stderr, "{}{}{}", render_warnings(study.base), render_warnings(of_cases.base, study.base),
      render_warnings(doubts, study.settings.source));
}

}  // namespace

int study_case(const StudyCommand& command)
{
  const bool takes_part = command.action == "run" && command.part.empty() && command.keep.empty();
  const Launched launched = takes_part ? find_launch([](const char* name) { return std::getenv(name); }) : Launched{};
  const Study study = open_study(command.path);
  const std::string folder = folder_of_study(command.path, command.output, study);
  if (!launched.is_silent) print_doubts(study, takes_part || command.action == "check");
  const int threads = command.threads > 0 ? command.threads : launched.shares_machine ? 1 : available_processors();
  if (command.action == "check") return check_study(study, threads);
  if (command.action == "sample") return sample_study(study, folder, command);
  if (command.action == "status") return report_study(study, folder, false);
  if (command.action == "report") return report_study(study, folder, true);
  int status = solved;
  for (const int number : command.keep) status = std::max(status, keep(study, folder, number, command));
  if (!command.keep.empty()) return status;
  StudyCommand own = command;
  own.threads = threads, own.quiet |= launched.is_silent;
  return run_study(study, folder, own, launched);
}

}  // namespace terp
