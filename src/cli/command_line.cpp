// A line has exactly one command, so several commands may fill the same options without a conflict. Ranges are tested
// here, by validators; what depends on the case is left to the command. The first line of a description also stands in
// the list of all commands, so it must do by itself. Line breaks in the texts are set by hand for a terminal.

#include "cli/command_line.hpp"

#include "math/closest.hpp"
#include "cli/command_parts.hpp"
#include "run/element/element_tests.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  add_option(run, "--from RUN[:STAGE]", line.options.from,
      "begin with another run of the same mesh and bodies:\nRUN, a folder, with its newest checkpoint; "
      "RUN:STAGE,\nwith the end of a stage; or a checkpoint file. time.end\ncounts from there. (To end a run that was "
      "stopped:\nterp resume)");
  add_option(run, "--at-strength F", line.options.at_strength,
      "divide all strengths by this, as terp stability does:\nsets at_strength (docs/stability.md)");
  run->add_flag("--force", line.options.force, "replace the results of an earlier run");
  run->add_flag("--report", line.options.report, "write the page of the run at its end: DIR/report.html");
  add_language(run, line.options.language);
  run->add_flag("--exact-fields", line.options.exact_fields,
      "write the fields of the frames with 64 bits per number\n(default: 32); not kept by terp resume");

  CLI::App* resume = add_command(app, "resume", "Solve",
      "go on from the newest checkpoint of a run folder\nor from the checkpoint file that is named. The case in the "
      "folder and its files\nmust be what the run began with. These may change: title, time.end,\n"
      "output.fields.every, output.checkpoint. With a later time.end a run that was\nsolved goes on in the same time "
      "step.",
      "  terp resume runs/dike --report\n");
  add_option(resume, "RUN", line.options.path, "run folder, or one of its checkpoints")->required();
  resume->add_flag("--report", line.options.report, "write the page of the run at its end: RUN/report.html");
  add_language(resume, line.options.language);

  add_set(run, line.options.changes);
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
  BisectionOptions& search = line.stability.search;
  TrialRules& rules = line.stability.rules;
  line.stability.cracks = true;
  add_number(
      stability, "--from F", search.from, least_factor, greatest_factor, "least factor to look at (0.01 to 100)");
  add_number(stability, "--to F", search.to, least_factor, greatest_factor, "greatest factor to look at");
  add_number(stability, "--tolerance T", search.tolerance, least_tolerance, greatest_tolerance,
      "width of the bracket at the end");
  add_number(stability, "--damping A", rules.damping, 0.0, 0.99,
      "local damping while the soil seeks rest\n(0 to 0.99; default 0.5)");
  add_number(stability, "--rest R", rules.rest, 1e-9, 0.1,
      "stands when it hardly moves, as soil with this part of\nits weight out of balance would (default 2e-5)");
  add_number(stability, "--failure D", rules.failure, 1e-3, 1e3,
      "fails beyond this displacement, in rho g H^2/E\n(default 4)");
  add_number(stability, "--windows N", rules.most_windows, 3, 100000, "time that a trial has (default 200)");
  add_number(stability, "--stiffening S", rules.stiffening, 1.0, 1e6,
      "displacements are kept so many times smaller\n(1 to 1e6; default 1000)");
  add_number(stability, "--least-depth D", rules.least_depth, 0.0, 1e4,
      "leave out soil less deep below the ground than this [m]");
  stability->add_flag_callback(
      "--with-tension", [&line] { line.stability.cracks = false; },
      "soil without a tension_cutoff carries tension\n(default: it cracks; docs/stability.md)");
  CLI::Option* associated = stability->add_flag_callback(
      "--associated", [&line] { line.stability.flow = FlowRule::associated; },
      "dilatancy is that of the friction angle in all soil, as\nlimit equilibrium has it");
  stability
      ->add_flag_callback(
          "--davis", [&line] { line.stability.flow = FlowRule::davis; },
          "the reduced pair of Davis for cohesion and friction,\nwith associated flow (docs/strength.md)")
      ->excludes(associated);
  add_number(stability, "--cells A,B", line.stability_cells, 1e-6, 1e6,
      "search on cells of these sizes [m], and extrapolate to\nthe limit of small cells (docs/stability.md)")
      ->delimiter(',');
  add_output(stability, line.options.output, "folder of the results (default: runs/NAME)");
  stability->add_flag("--force", line.options.force, "replace the results of an earlier search");
  stability->add_flag("--json", line.options.json, "print stability.json");
  add_set(stability, line.options.changes);
  add_threads(stability, line.options.threads);
  add_quiet(stability, line.options);
}

void declare_seepage(CLI::App& app, SeepageCommand& command)
{
  CLI::App* seepage = add_command(app, "seepage", "Solve",
      "the water of a case with water.model = \"seepage\", without a run\nFlows, uplift, phreatic line, heads, a "
      "picture "
      "with flow lines\n(docs/seepage.md).",
      "  terp seepage dike.toml\n"
      "  terp seepage dike.toml --levels wave.csv --step 0.5 --at 24\n");
  add_case(seepage, command.run);
  add_option(seepage, "--levels FILE", command.levels,
      "follow levels over hours: CSV with the columns hours,\nriver, and names of ponds and heads");
  add_number(seepage, "--step H", command.step, 1e-4, 1e5, "longest step in time [h] (default 1)");
  add_number(seepage, "--at H,H", command.at, 0.0, 1e7, "hours at which the water is written for a run")
      ->delimiter(',');
  add_number(seepage, "--along X,Y,X,Y", command.along, -1e7, 1e7, "heads along a line [m] as along.csv")
      ->delimiter(',');
  add_output(seepage, command.run.output, "folder of the results (default: runs/NAME_seepage)");
  add_set(seepage, command.run.changes);
  add_quiet(seepage, command.run, "print no numbers; warnings stay");
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
  add_number(converge, "--cells A,B,C", options.cells, 1e-6, 1e6,
      "sizes of the cells [m]; three or more, each about half\nof the next")
      ->required()
      ->delimiter(',');
  converge->add_flag("--what-decides", options.what_decides,
      "change k0, S, POP, S_u, sensitivity and phi one at a\ntime, on the largest of the cells, and say which of\nthem "
      "give another outcome; writes depends.json");
  add_option(converge, "--variant KEY=VALUE", options.variants,
      "solve all sizes once more with this change; `;`\nbetween several; may be given several times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_number(converge, "--turn A,B", options.turns, -89.9, 89.9,
      "solve all sizes once more with cells in these\ndirections against x [degrees]; the sides of the mesh\nstay")
      ->delimiter(',');
  add_number(converge, "--points N,M", options.points, 1, 16,
      "solve all sizes once more with so many points per cell\nin each direction")
      ->delimiter(',');
  add_number(
      converge, "--tolerance T", options.tolerance, 1e-6, 1.0, "share from which on a change counts (default 0.02)");
  converge->add_flag("--estimate", options.estimate, "say what it would cost, and end");
  add_output(converge, options.run.output, "folder of the runs (default: runs/NAME_convergence)");
  converge->add_flag("--force", options.run.force, "solve all sizes anew");
  converge->add_flag("--report", options.run.report, "write the report page of all runs as well");
  converge->add_flag("--json", options.run.json, "print convergence.json");
  add_set(converge, options.run.changes);
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
      "  run     solve, or go on; results go to runs/NAME/. Under mpirun, srun or an\n"
      "          array of Slurm each process makes its part, on -j threads (default\n"
      "          of mpirun and srun: 1), and the last one writes the results\n"
      "  status  what the realisations that are solved say\n"
      "  report  the same, with the page report.html and the table results.csv",
      "  terp study check cases/dike_study/dike_study.toml\n  terp study run cases/dike_study/dike_study.toml -j 2\n"
      "  terp study run dike_study.toml --part 3/100\n  terp study report runs/dike_study\n");
  add_option(study, "ACTION", command.action, "check, sample, run, status or report")
      ->required()
      ->check(CLI::IsMember({"check", "sample", "run", "status", "report"}));
  add_option(study, "STUDY", command.path, "study file (.toml), or the folder of a study")->required();
  add_output(study, command.output, "folder of the study (default: runs/NAME)");
  add_option(study, "--part K/N", command.part,
      "of run: every N-th realisation, from the K-th; for\nother batch systems than those above");
  add_option(study, "--keep A,B", command.keep,
      "of run: solve these realisations once more, with all\nthe files of a run, in DIR/kept; counted from 0")
      ->delimiter(',');
  add_number(study, "--samples N", command.samples, 1, 1000000, "of sample: how many (default 1000)");
  study->add_flag("--force", command.force, "of run: remove what is solved, and begin anew");
  add_number(study, "-j,--threads N", command.threads, 1, 1024,
      "realisations at a time (default: what this job may\nuse); results have the same bits on any number");
  study->add_flag("-q,--quiet", command.quiet, "no progress, no result; warnings stay");
}

void declare_element(CLI::App& app, ElementCommand& command)
{
  std::vector<std::string> names;
  std::string meanings;
  for (const ElementTestInfo& info : element_tests()) {
    names.emplace_back(info.name);
    meanings += fmt::format("\n  {:<10} {}", info.name, info.meaning);
  }
  CLI::App* element = add_command(app, "element", "Solve",
      "a soil by itself on the path of a laboratory test\nOedometer, triaxial, biaxial and shear tests, or any path of "
      "strains and stresses\n(docs/element.md). Writes a table of each material, and a page of all.\n\nTEST" +
          meanings,
      "  terp element cases/dike/dike.toml --test triaxial --undrained --strain 0.1\n"
      "  terp element soil.toml --test oedometer --load \"400 kPa,50 kPa,800 kPa\"\n"
      "  terp element soil.toml --path path.csv --pressure \"50 kPa\"\n");
  add_option(element, "CASE.toml", command.case_path, "a case file, or one with materials alone")->required();
  CLI::Option* path = add_option(element, "--path FILE", command.path, "instead of a test: the path as a table (CSV)");
  add_option(element, "--test TEST", command.test, "see above (default: triaxial)")
      ->check(CLI::IsMember(names))
      ->excludes(path);
  add_option(element, "--material NAME", command.materials, "only this; may be given several times (default: all)")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_option(element, "--pressure P", command.pressure,
      "vertical effective stress at the start, in Pa or with\nits unit (default: the stress of the body, or 100 kPa)");
  add_number(
      element, "--k0 K", command.k0, 0.0, 100.0, "stress across over it (default 1); of a body times\nwhat it has");
  add_number(element, "--at X,Y", command.place, -1e6, 1e6,
      "place in the section: parameters and stress that vary\nare those there")
      ->delimiter(',')
      ->expected(2);
  element->add_flag("--undrained", command.undrained, "pore water cannot leave");
  CLI::Option* strain = add_number(element, "--strain A,B", command.strain, -10.0, 10.0,
      "strain of the test at its turning points: compression,\nor shear angle")
                            ->delimiter(',');
  add_option(element, "--load A,B", command.load, "instead: stress of the test at them, in Pa or with units")
      ->delimiter(',')
      ->excludes(strain);
  add_number(element, "--increments N", command.increments, 1, 1000000,
      "to each turning point, or row of the path (default\n1000; of a path 1000 in all)");
  add_number(element, "--duration S", command.duration, 1e-9, 1e12,
      "of the test [s], for laws that know a rate (default 1000)");
  add_number(element, "--void-ratio E", command.void_ratio, 0.0, 100.0, "at the start, for its column and picture");
  add_set(element, command.changes);
  add_output(element, command.output, "folder of the results (default: runs/NAME_element)");
  element->add_flag("-q,--quiet", command.quiet, "no table; warnings stay");
}

void declare_watch(CLI::App& app, WatchCommand& options)
{
  CLI::App* watch = add_command(app, "watch", "Solve", "how far a run is that another terp solves\nEnds with that run.",
      "  terp watch runs/dike --every 10\n");
  add_option(watch, "RUN", options.run, "run folder")->required();
  add_number(watch, "--every S", options.every, 0.1, 3600.0, "seconds between two looks (default 2)");
  watch->add_flag("--once", options.once, "look once");
}

void declare_viewers(CLI::App& app, CommandLine& line)
{
  CLI::App* report = add_command(app, "report", "Look",
      "write report.html, one page with runs side by side\nIt opens without a network (docs/report_page.md).",
      "  terp report runs/gp runs/mixed -o both.html\n");
  add_option(report, "RUN", line.report.runs, "run folders")->required();
  add_output(report, line.report.output, "the file (default: report.html)", "FILE");
  add_language(report, line.report.language);

  CLI::App* compare = add_command(app, "compare", "Look",
      "table of what differs between runs\nThe first run against each of the others, in numbers and in words, with the "
      "keys\nin which the cases differ.",
      "  terp compare runs/gp runs/mixed\n");
  add_option(compare, "RUN", line.report.runs, "two or more run folders")->required();
  compare->add_flag("--json", line.report.json, "the same for a program");

  CLI::App* exported = add_command(app, "export", "Look",
      "frames of a run as CSV\nWrites a table per frame into RUN/csv, and a list of them (docs/formats.md).\nParaView, "
      "VTK and h5py read the frames as they are (docs/python.md).",
      "  terp export runs/dike --frames 0,10:20,last\n  terp export runs/dike --dxf after.dxf --profile after.csv\n");
  add_option(exported, "RUN", line.exported.run, "run folder")->required();
  add_option(exported, "--field NAME", line.exported.fields, "only this field; may be given several times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_option(exported, "--frames LIST", line.exported.frames,
      "numbers, ranges with both ends, `last`:\n0,5,10:20,last (default: all)");
  add_output(exported, line.exported.folder, "folder (default: RUN/csv)");
  add_option(exported, "--dxf FILE", line.exported.dxf, "instead: the section at the end (docs/dxf.md)");
  add_option(exported, "--profile FILE", line.exported.profile, "instead: the ground before and after, as a table");
  add_option(exported, "--stix FILE", line.exported.stix,
      "instead: the D-Stability file of --template with the\nsection at the end as one more stage\n"
      "(docs/dstability.md)");
  add_option(exported, "--template FILE", line.exported.of_stix.path, "of --stix: what the case was imported from");
  add_number(exported, "--scenario N", line.exported.of_stix.scenario, 1, 100000, "of that file, from 1");
  add_number(exported, "--stage N", line.exported.of_stix.stage, 1, 100000,
      "that the new one follows, from 1 (default: the last)");
  add_number(exported, "--tolerance T", line.exported.tolerance, 1e-3, 1e3,
      "within which outlines are straightened [m] (default:\nsome half a cell)");
}

void declare_guides(CLI::App& app, CommandLine& line)
{
  CLI::App* check = add_command(app, "check", "Understand",
      "read and validate a case, print what would run\nMesh, bodies, side conditions, steps, time and memory. Solves "
      "nothing.",
      "  terp check cases/dike/dike.toml --picture section.svg\n");
  add_case(check, line.options);
  add_option(check, "--picture FILE", line.options.picture, "draw the section: mesh, bodies, sides, points (SVG)");
  add_option(check, "--profile X,X", line.options.profiles,
      "strength, stiffness and vertical stress with depth,\nat each x in m; default: a few, where a strength varies")
      ->delimiter(',');
  check->add_flag("--json", line.options.json, "the same for a program");
  CLI::App* explain = add_command(app, "explain", "Understand", "a key, material or scheme: meaning, unit, range",
      "  terp explain mesh.cell\n  terp explain tresca_softening\n");
  add_option(explain, "TOPIC", line.topic, "key or section of the case file, or a name of terp list")->required();
  add_command(app, "list", "Understand", "materials, schemes and outputs in this build", "  terp list\n");
  add_command(app, "schema", "Understand",
      "a JSON Schema of the case file, for editors\nThey complete keys with it, and check them (docs/conventions.md).",
      "  terp schema > terp.schema.json\n");
  CLI::App* bench = add_command(app, "bench", "Understand",
      "how fast the step is here, pass by pass\nWithout a case: the paper's column.", "  terp bench --threads 2\n");
  add_case(bench, line.options, false);
  add_number(bench, "--steps N", line.options.steps, 1, 1000000, "steps in each of five trials");
  add_number(bench, "--warm N", line.options.warm_steps, 0, 1000000, "steps before them");
  bench->add_flag("--json", line.options.json, "numbers for a program");
  bench->add_flag("--score", line.options.score, "what a step of the case does, and nothing else");
  for (CLI::App* command : {check, bench}) {
    add_set(command, line.options.changes);
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
  declare_seepage(app, line.seepage);
  declare_converge(app, line.converge);
  declare_study(app, line.study);
  declare_element(app, line.element);
  declare_watch(app, line.watch);
  declare_viewers(app, line);
  declare_guides(app, line);
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
