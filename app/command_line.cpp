#include "command_line.hpp"

#include "base/closest.hpp"
#include "command_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace terp {
namespace {

void declare_solvers(CLI::App& app, CommandLine& line)
{
  CLI::App* run = add_command(app, "run", "Solve",
      "solve a case; results go to runs/NAME/\nNAME is that of the file, NAME.toml or NAME/case.toml "
      "(docs/formats.md).",
      "  terp run cases/column_collapse/model_2.toml\n"
      "  terp run cases/dike/dike.toml --set scheme=mpm_mixed -o runs/mixed --report\n");
  add_case(run, line.options);
  add_output(run, line.options.output, "folder of the results (default: runs/NAME)");
  run->add_option("--from", line.options.from,
         "begin with another run of the same mesh and bodies:\nRUN, a folder, with its newest checkpoint; RUN:STAGE,\n"
         "with the end of a stage; or a checkpoint file. time.end\ncounts from there. (To end a run that was stopped:\n"
         "terp resume)")
      ->option_text("RUN[:STAGE]");
  run->add_option("--at-strength", line.options.at_strength,
         "divide all strengths by this, as terp stability does:\nsets at_strength (docs/stability.md)")
      ->option_text("F");
  run->add_flag("--force", line.options.force, "replace the results of an earlier run");
  run->add_flag("--report", line.options.report, "write the page of the run at its end: DIR/report.html");
  add_language(run, line.options.language);

  CLI::App* resume = add_command(app, "resume", "Solve",
      "go on from the newest checkpoint of a run folder\nor from the checkpoint file that is named. The case in the "
      "folder and its files\nmust be what the run began with. These may change: title, time.end,\n"
      "output.fields.every, output.checkpoint. With a later time.end a run that was\nsolved goes on in the same time "
      "step.",
      "  terp resume runs/dike --report\n");
  resume->add_option("RUN", line.options.path, "run folder, or one of its checkpoints")->option_text(" ")->required();
  resume->add_flag("--report", line.options.report, "write the page of the run at its end: RUN/report.html");
  add_language(resume, line.options.language);

  add_set(run, line.options);
  for (CLI::App* command : {run, resume}) {
    add_threads(command, line.options.threads);
    add_quiet(command, line.options);
    command->add_flag("-v,--verbose", line.options.verbose, "time of each pass of the steps, at the end");
  }
}

void declare_stability(CLI::App& app, CommandLine& line)
{
  CLI::App* stability = add_command(app, "stability", "Solve",
      "factor of safety by strength reduction\nWrites stability.txt, stability.json and the mechanism at failure with "
      "a picture\n(docs/stability.md).",
      "  terp stability cases/dike/dike.toml --from 1 --to 3\n"
      "  terp stability cases/dike/dike.toml --cells 2,1\n");
  add_case(stability, line.options);
  const auto factors = number_between(least_factor, greatest_factor), shares = number_between(0.0, 0.99);
  BisectionOptions& search = line.stability.search;
  TrialRules& rules = line.stability.rules;
  stability->add_option("--from", search.from, "least factor to look at (0.01 to 100)")
      ->option_text("F")
      ->check(factors);
  stability->add_option("--to", search.to, "greatest factor to look at")->option_text("F")->check(factors);
  stability->add_option("--tolerance", search.tolerance, "width of the bracket at the end")
      ->option_text("T")
      ->check(number_between(least_tolerance, greatest_tolerance));
  stability->add_option("--damping", rules.damping, "local damping while the soil seeks rest\n(0 to 0.99; default 0.5)")
      ->option_text("A")
      ->check(shares);
  stability
      ->add_option("--rest", rules.rest,
          "stands when it hardly moves, as soil with this part of\nits weight out of balance would (default 2e-5)")
      ->option_text("R")
      ->check(number_between(1e-9, 0.1));
  stability->add_option("--failure", rules.failure, "fails beyond this displacement, in rho g H^2/E\n(default 4)")
      ->option_text("D")
      ->check(number_between(1e-3, 1e3));
  stability->add_option("--windows", rules.most_windows, "time that a trial has (default 200)")
      ->option_text("N")
      ->check(whole_number_between(3, 100000));
  stability
      ->add_option(
          "--stiffening", rules.stiffening, "displacements are kept so many times smaller\n(1 to 1e6; default 1000)")
      ->option_text("S")
      ->check(number_between(1.0, 1e6));
  stability
      ->add_option("--cells", line.stability_cells,
          "search on cells of these sizes [m], and extrapolate to\nthe limit of small cells (docs/stability.md)")
      ->option_text("A,B")
      ->delimiter(',')
      ->check(number_between(1e-6, 1e6));
  add_output(stability, line.options.output, "folder of the results (default: runs/NAME)");
  stability->add_flag("--json", line.options.json, "print stability.json");
  add_set(stability, line.options);
  add_threads(stability, line.options.threads);
  add_quiet(stability, line.options);
}

void declare_converge(CLI::App& app, ConvergeOptions& options)
{
  CLI::App* converge = add_command(app, "converge", "Solve",
      "on several cell sizes: does the mesh matter?\nSolves the case on each size and says of each quantity how it "
      "follows the\nsize, with its observed order and an estimate of the error\n(docs/convergence.md). Writes "
      "convergence.html and convergence.json. Runs that\nare there already are kept, and one that was interrupted goes "
      "on.",
      "  terp converge cases/column_collapse/model_1.toml --cells 0.5,0.25,0.125\n"
      "  terp converge cases/dike/dike.toml --cells 1,0.5,0.25 --estimate\n");
  add_case(converge, options.run);
  converge->add_option("--cells", options.cells, "sizes of the cells [m]; three or more, each about half\nof the next")
      ->option_text("A,B,C")
      ->required()
      ->delimiter(',')
      ->check(number_between(1e-6, 1e6));
  converge
      ->add_option("--variant", options.variants,
          "solve all sizes once more with this change; `;`\nbetween several; may be given several times")
      ->option_text("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  converge
      ->add_option("--turn", options.turns,
          "solve all sizes once more with cells in these\ndirections against x [degrees]; the sides of the mesh\nstay")
      ->option_text("A,B")
      ->delimiter(',')
      ->check(number_between(-89.9, 89.9));
  converge
      ->add_option(
          "--points", options.points, "solve all sizes once more with so many points per cell\nin each direction")
      ->option_text("N,M")
      ->delimiter(',')
      ->check(whole_number_between(1, 16));
  converge->add_option("--tolerance", options.tolerance, "share from which on a change counts (default 0.02)")
      ->option_text("T")
      ->check(number_between(1e-6, 1.0));
  converge->add_flag("--estimate", options.estimate, "say what it would cost, and end");
  add_output(converge, options.run.output, "folder of the runs (default: runs/NAME_convergence)");
  converge->add_flag("--force", options.run.force, "solve all sizes anew");
  converge->add_flag("--report", options.run.report, "write the report page of all runs as well");
  converge->add_flag("--json", options.run.json, "print convergence.json");
  add_set(converge, options.run);
  add_threads(converge, options.run.threads);
  converge->add_flag("-q,--quiet", options.run.quiet, "no progress, no table; warnings stay");
}

void declare_study(CLI::App& app, StudyCommand& command)
{
  CLI::App* study = add_command(app, "study", "Solve",
      "how probable a slide and a flood are\nSolves many realisations of a case with random numbers and fields, or a "
      "table of\nits keys (docs/probability.md). What is solved is kept: after a kill the same\ncommand goes "
      "on.\n\nACTION\n"
      "  check   what would run, how long, on what\n"
      "  sample  what would be drawn: histograms of the input\n"
      "  run     solve, or go on; results go to runs/NAME/. Under mpirun or srun all\n"
      "          processes solve one study, each on -j threads (default there: 1)\n"
      "  status  what the realisations that are solved say\n"
      "  report  the same, with the page report.html and the table results.csv",
      "  terp study check cases/dike_study/dike_study.toml\n  terp study run cases/dike_study/dike_study.toml -j 2\n"
      "  terp study run dike_study.toml --part 3/100\n  terp study report runs/dike_study\n");
  study->add_option("ACTION", command.action, "check, sample, run, status or report")
      ->option_text(" ")
      ->required()
      ->check(CLI::IsMember({"check", "sample", "run", "status", "report"}));
  study->add_option("STUDY", command.path, "study file (.toml), or the folder of a study")
      ->option_text(" ")
      ->required();
  add_output(study, command.output, "folder of the study (default: runs/NAME)");
  study
      ->add_option(
          "--part", command.part, "of run: every N-th realisation, from the K-th; for\narrays of batch systems")
      ->option_text("K/N");
  study
      ->add_option("--keep", command.keep,
          "of run: solve these realisations once more, with all\nthe files of a run, in DIR/kept; counted from 0")
      ->option_text("A,B")
      ->delimiter(',');
  study->add_option("--samples", command.samples, "of sample: how many (default 1000)")
      ->option_text("N")
      ->check(whole_number_between(1, 1000000));
  study->add_flag("--force", command.force, "of run: remove what is solved, and begin anew");
  study
      ->add_option("-j,--threads", command.threads,
          "realisations at a time (default: what this job may\nuse); results "
          "have the same bits on any number")
      ->option_text("N")
      ->check(whole_number_between(1, 1024));
  study->add_flag("-q,--quiet", command.quiet, "no progress, no result; warnings stay");
}

void declare_watch(CLI::App& app, WatchCommand& options)
{
  CLI::App* watch = add_command(app, "watch", "Solve", "how far a run is that another terp solves\nEnds with that run.",
      "  terp watch runs/dike --every 10\n");
  watch->add_option("RUN", options.run, "run folder")->option_text(" ")->required();
  watch->add_option("--every", options.every, "seconds between two looks (default 2)")
      ->option_text("S")
      ->check(number_between(0.1, 3600.0));
  watch->add_flag("--once", options.once, "look once");
}

void declare_viewers(CLI::App& app, CommandLine& line)
{
  CLI::App* report = add_command(app, "report", "Look",
      "write report.html, one page with runs side by side\nIt opens without a network (docs/report_page.md).",
      "  terp report runs/gp runs/mixed -o both.html\n");
  report->add_option("RUN", line.report.runs, "run folders")->option_text(" ")->required();
  add_output(report, line.report.output, "the file (default: report.html)", "FILE");
  add_language(report, line.report.language);

  CLI::App* compare = add_command(app, "compare", "Look",
      "table of what differs between runs\nThe first run against each of the others, in numbers and in words, with the "
      "keys\nin which the cases differ.",
      "  terp compare runs/gp runs/mixed\n");
  compare->add_option("RUN", line.report.runs, "two or more run folders")->option_text(" ")->required();
  compare->add_flag("--json", line.report.json, "the same for a program");

  CLI::App* exported = add_command(app, "export", "Look",
      "frames of a run as CSV\nWrites a table per frame into RUN/csv, and a list of them (docs/formats.md).\nParaView, "
      "VTK and h5py read the frames as they are (docs/python.md).",
      "  terp export runs/dike --frames 0,10:20,last\n  terp export runs/dike --dxf after.dxf --profile after.csv\n");
  exported->add_option("RUN", line.exported.run, "run folder")->option_text(" ")->required();
  exported->add_option("--format", line.exported.format, "csv")->option_text("F")->group("");
  exported->add_option("--field", line.exported.fields, "only this field; may be given several times")
      ->option_text("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  exported
      ->add_option(
          "--frames", line.exported.frames, "numbers, ranges with both ends, `last`:\n0,5,10:20,last (default: all)")
      ->option_text("LIST");
  add_output(exported, line.exported.folder, "folder (default: RUN/csv)");
  exported->add_option("--dxf", line.exported.dxf, "instead: the section at the end (docs/dxf.md)")
      ->option_text("FILE");
  exported->add_option("--profile", line.exported.profile, "instead: the ground before and after, as a table")
      ->option_text("FILE");
}

void declare_verify(CLI::App& app, VerifyOptions& options)
{
  CLI::App* verify = add_command(app, "verify", "Understand",
      "solve problems with a known answer\nPrints what came out (docs/verification_cases.md); without a name all of "
      "them.",
      "  terp verify infinite_slope\n  terp verify --short --markdown ledger.md\n");
  verify->add_option("CASE", options.names, "names of cases")->option_text(" ");
  verify->add_flag("--list", options.list, "names and titles");
  CLI::Option* only_short =
      verify->add_flag("--short", options.only_short, "only those that take seconds")->option_text(" ");
  CLI::Option* only_long = verify->add_flag("--long", options.only_long, "only those that take minutes");
  only_long->option_text(" ")->excludes(only_short);
  verify->add_option("--markdown", options.markdown, "write the ledger as a page")->option_text("FILE");
  verify
      ->add_option("--overview", options.overview,
          "write one line per case, and what does not agree;\nan old page keeps the cases that are not solved")
      ->option_text("FILE")
      ->excludes(only_short)
      ->excludes(only_long);
  verify->add_option("--cases", options.cases, "folder of the cases")->option_text("DIR");
  add_threads(verify, options.threads);
}

void declare_guides(CLI::App& app, CommandLine& line)
{
  CLI::App* check = add_command(app, "check", "Understand",
      "read and validate a case, print what would run\nMesh, bodies, side conditions, steps, time and memory. Solves "
      "nothing.",
      "  terp check cases/dike/dike.toml --picture section.svg\n");
  add_case(check, line.options);
  check->add_option("--picture", line.options.picture, "draw the section: mesh, bodies, sides, points (SVG)")
      ->option_text("FILE");
  check
      ->add_option("--profile", line.options.profiles,
          "strength, stiffness and vertical stress with depth,\n"
          "at each x in m; default: a few, where a strength varies")
      ->delimiter(',')
      ->option_text("X,X");
  CLI::App* explain = add_command(app, "explain", "Understand", "a key, material or scheme: meaning, unit, range",
      "  terp explain mesh.cell\n  terp explain tresca_softening\n");
  explain->add_option("TOPIC", line.topic, "key or section of the case file, or a name of terp list")
      ->option_text(" ")
      ->required();
  add_command(app, "list", "Understand", "materials, schemes and outputs in this build", "  terp list\n");
  add_command(app, "schema", "Understand",
      "a JSON Schema of the case file, for editors\nThey complete keys with it, and check them (docs/conventions.md).",
      "  terp schema > terp.schema.json\n");
  CLI::App* bench = add_command(app, "bench", "Understand",
      "how fast the step is here, pass by pass\nWithout a case: the paper's column.", "  terp bench --threads 2\n");
  add_case(bench, line.options, false);
  bench->add_option("--steps", line.options.steps, "steps in each of five trials")
      ->option_text("N")
      ->check(whole_number_between(1, 1000000));
  bench->add_option("--warm", line.options.warm_steps, "steps before them")
      ->option_text("N")
      ->check(whole_number_between(0, 1000000));
  bench->add_flag("--json", line.options.json, "numbers for a program");
  for (CLI::App* command : {check, bench}) {
    add_set(command, line.options);
    add_threads(command, line.options.threads);
  }
  add_quiet(check, line.options, "say what is wrong, and nothing else");
}

const CLI::App& command_of(const CLI::App& app)
{
  const auto given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

std::vector<std::string> options_of(const CLI::App& command)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options([](const CLI::Option* o) { return o->nonpositional(); }))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string describe_unknown(const CLI::App& command, const std::string& word)
{
  if (!word.starts_with('-'))
    return fmt::format("`terp {}` does not take a further argument, got `{}`", command.get_name(), word);
  const auto names = options_of(command);
  const std::string nearest = closest(word, names);
  return fmt::format("`terp {}` has no option `{}`\n{}  Options: {}", command.get_name(), word,
      nearest.empty() ? "" : fmt::format("  Did you mean `{}`?\n", nearest), fmt::join(names, ", "));
}

}  // namespace

void declare(CLI::App& app, CommandLine& line)
{
  app.description("terp: explicit material point method for soil (MPM-Mixed and MPM-GP)");
  app.name("terp");
  app.formatter(help_page());
  app.set_help_flag();
  app.set_help_all_flag();
  app.require_subcommand(1);
  app.footer(std::string("Options of a command: terp COMMAND --help. Version: terp --version\n\nExamples:\n"
                         "  terp check cases/column_collapse/model_2.toml\n"
                         "  terp run cases/column_collapse/model_2.toml --set scheme=mpm_mixed\n\n") +
             exit_statuses);
  declare_solvers(app, line);
  declare_stability(app, line);
  declare_converge(app, line.converge);
  declare_study(app, line.study);
  declare_watch(app, line.watch);
  declare_viewers(app, line);
  declare_guides(app, line);
  declare_verify(app, line.verify);
  declare_import(app, line.imported);
  declare_assess(app, line.assess);
}

std::string help_on(const CLI::App& app, const std::string& command)
{
  for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; }))
    if (known->get_name() == command) return known->help("terp");
  return app.help();
}

std::string describe(const CLI::App& app, const CLI::ParseError& error)
{
  const CLI::App& command = command_of(app);
  std::string text = error.what();
  if (const auto remaining = app.remaining(true); dynamic_cast<const CLI::ExtrasError*>(&error) && !remaining.empty())
    text = describe_unknown(command, remaining.front());
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && &command != &app)
    text = fmt::format("`terp {}` needs {}", command.get_name(), text.substr(0, text.find(" is required")));
  return fmt::format("error: {}\nUsage: terp COMMAND [options]; see terp{} --help\n", text,
      &command == &app ? "" : " " + command.get_name());
}

}  // namespace terp
