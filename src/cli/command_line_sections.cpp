// Both commands fill an ImportCommand, since `terp assess` imports each of its files as `terp import` does. So what
// they ask of a stage is declared once, and only the default scenario differs. Options of the wrong kind of file are
// refused later, when that kind is known (import_checks.cpp).

#include "cli/command_parts.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

/// What both commands ask of a stage. which: its default scenario.
void add_stage_options(CLI::App* command, ImportCommand& options, const char* which)
{
  add_number(command, "--scenario N", options.scenario, 1, 100000, which);
  add_number(command, "--stage N", options.stage, 1, 100000, "of the scenario, from 1 (default: its last)");
  add_option(command, "--strength S", options.strength, "deterministic, design or mean (default: deterministic)")
      ->check(CLI::IsMember({"deterministic", "design", "mean"}));
  add_number(command, "--cell H", options.cell, 1e-3, 1e3, "size of the cells [m] (default: a tenth of the dike)");
  add_option(command, "--between X,X", options.between,
      "part of the section that is taken over, from x to x\n[m] (default: the dike and room for its slides)")
      ->delimiter(',')
      ->expected(2);
  add_number(command, "--base Z", options.base, -1e5, 1e5, "level above which it is taken over [m]");
  add_number(command, "--river LEVEL", options.river, -1e4, 1e4,
      "level of the river [m]; heads in the ground follow in\nproportion (default: that of the file)");
  add_option(command, "--trigger T", options.trigger,
      "a last stage that makes it fail: `strength` divides\nall strengths by the factor at which it slides, which\nis "
      "looked for (strength=F: by F); `water` brings the\nriver to the crest (water=LEVEL: to a level in m)");
  command->add_flag("--no-film", options.no_film,
      "no film of the strength of the border at the top of\nan aquifer (docs/dstability.md)");
  add_number(command, "--face-cohesion C", options.face_cohesion, 0.0, 100.0,
      "of drained soil of the dike with less, in its outer\nmetre, so that it does not ravel [kPa]; 0: none\n(default: "
      "2)");
  add_option(command, "--soil-defaults FILE", options.soil_defaults, "table of what the file does not say of soils");
}

CLI::Validator is_depth()
{
  return CLI::Validator(
      [](std::string& text) -> std::string {
        double depth = 0.0;
        if (CLI::detail::lexical_cast(text, depth) && depth >= 0.1 && depth <= 1e3) return "";
        return fmt::format(
            "{} is no depth: it counts downwards from the lowest ground, 0.1 to 1000 m. --base takes a "
            "level",
            text);
      },
      "");
}

}  // namespace

void declare_import(CLI::App& app, ImportCommand& command)
{
  CLI::App* import = add_command(app, "import", "Understand",
      "what a D-Stability file, drawing or profile holds\nScenarios, stages, calculations with "
      "their stored results, "
      "soils, and what\nis left out; regions of a drawing. With -o a case folder\n(docs/dstability.md, docs/dxf.md).",
      "  terp import section.stix --slices slices.csv\n  terp import section.stix --scenario 1 --stage 2 -o "
      "section\n  terp import section.stix --trigger strength -o section\n  terp import section.stix --study -o "
      "section\n  terp import section.dxf -o section\n  "
      "terp import profile.csv --depth 8 -o section\n");
  add_option(import, "FILE", command.path, "D-Stability file (.stix), drawing (.dxf) or ground\nprofile (.csv)");
  CLI::Option* json = import->add_flag("--json", command.json, "the list for a program")->option_text(" ");
  add_option(import, "--slices FILE", command.slices,
      "write what Terp computes at the feet of all stored\nslices beside what is stored")
      ->excludes(json);
  add_output(import, command.output, "write a case folder: case.toml, its tables, report.md");
  import->add_flag("--force", command.force, "replace the case that is in the folder");
  add_stage_options(import, command, "of the list, from 1");
  import->add_flag("--held", command.is_held,
      "strengths are doubled while the river rises: for a\nsection that cannot stand (docs/dstability.md)");
  import->add_flag("--study", command.study,
      "a study file beside the case: how probable a slide\nand a flood are, by the file's distributions, else by\n"
      "kinds of soil (docs/dstability.md)");
  add_option(import, "--unit U", command.unit, "of a drawing: m, dm, cm, mm, ft, in\n(default: that of its header)");
  add_option(import, "--layers A,B", command.layers,
      "of a drawing: those alone; of a table of several\nprofiles: the one of that name");
  add_option(import, "--window X0,Y0,X1,Y1", command.window,
      "of a drawing of several sections: the one between\nthese corners [m]")
      ->delimiter(',')
      ->expected(4);
  add_option(
      import, "--depth D", command.depth, "of a profile: the base lies D m below the lowest\nground (default 10)")
      ->check(is_depth());
  add_option(import, "--soils FILE,NAME", command.soils,
      "of a profile: its soils by the level of their tops\n(soilprofiles.csv of DAM; NAME: of one of several)");
  import->add_flag("--soil-defaults-table", command.print_defaults, "print the table that holds without it");
}

void declare_assess(CLI::App& app, AssessCommand& command)
{
  CLI::App* assess = add_command(app, "assess", "Solve",
      "all sections of a reach: import, check, run, report\nOne page and one table of all (docs/assess.md): "
      "index.html, reach.csv,\nreach.json. Sections that are solved already are kept, and one that was\ninterrupted "
      "goes on. A file that cannot be read stops none of the others.",
      "  terp assess *.stix -o reach -j 2 --estimate\n  terp assess *.stix -o reach -j 2 --trigger strength --language "
      "nl\n");
  add_option(assess, "FILE", command.files, "D-Stability files, case files, folders with a case.toml")->required();
  add_output(assess, command.output, "folder of the reach; each section has one in it");
  assess->get_option("--output")->required();
  assess->add_flag("--estimate", command.estimate, "import and check, say what would run and how long,\nand end");
  assess->add_flag("--stability", command.stability, "find the factor of safety of each, too");
  add_stage_options(assess, command.import, "of each file, from 1 (default: its last)");
  add_number(assess, "-j,--sections N", command.sections, 1, 1024,
      "solve so many at once, each in a process of its own\n(default: as many as there are processors)");
  add_number(
      assess, "--threads N", command.threads, 1, 1024, "CPU threads of each (default: processors over sections)");
  add_language(assess, command.language);
  assess->add_flag("--force", command.force, "import and solve all anew");
}

}  // namespace terp
