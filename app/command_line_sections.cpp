// The command line of import and assess.

#include "command_parts.hpp"

namespace terp {
namespace {

/// What both commands ask of a stage. which: its default scenario.
void add_stage_options(CLI::App* command, ImportCommand& options, const char* which)
{
  const auto number = whole_number_between(1, 100000);
  command->add_option("--scenario", options.scenario, which)->option_text("N")->check(number);
  command->add_option("--stage", options.stage, "of the scenario, from 1 (default: its last)")
      ->option_text("N")
      ->check(number);
  command->add_option("--strength", options.strength, "deterministic, design or mean (default: deterministic)")
      ->option_text("S")
      ->check(CLI::IsMember({"deterministic", "design", "mean"}));
  command->add_option("--cell", options.cell, "size of the cells [m] (default: a tenth of the dike)")
      ->option_text("H")
      ->check(number_between(1e-3, 1e3));
  command
      ->add_option("--between", options.between,
          "part of the section that is taken over, from x to x\n[m] (default: the dike and room for its slides)")
      ->option_text("X,X")
      ->delimiter(',')
      ->expected(2);
  command->add_option("--base", options.base, "level above which it is taken over [m]")
      ->option_text("Z")
      ->check(number_between(-1e5, 1e5));
  command
      ->add_option("--river", options.river,
          "level of the river [m]; heads in the ground follow in\nproportion (default: that of the file)")
      ->option_text("LEVEL")
      ->check(number_between(-1e4, 1e4));
  command
      ->add_option("--trigger", options.trigger,
          "a last stage that makes it fail: `strength` divides\nall strengths by the factor at which it slides, which\n"
          "is looked for (strength=F: by F); `water` brings the\nriver to the crest (water=LEVEL: to a level in m)")
      ->option_text("T");
  command->add_option("--soil-defaults", options.soil_defaults, "table of what the file does not say of soils")
      ->option_text("FILE");
}

}  // namespace

void declare_import(CLI::App& app, ImportCommand& command)
{
  CLI::App* import = add_command(app, "import", "Understand",
      "what a D-Stability file or a drawing (DXF) holds\nScenarios, stages, calculations with their stored "
      "results, soils, and what\nis left out; regions of a drawing. With -o a case folder\n(docs/dstability.md, "
      "docs/dxf.md).",
      "  terp import section.stix --slices slices.csv\n  terp import section.stix --scenario 1 --stage 2 -o "
      "section\n  terp import section.stix --trigger strength -o section\n  terp import section.dxf -o section\n");
  import->add_option("FILE", command.path, "D-Stability file (.stix) or drawing (.dxf)")->option_text(" ");
  CLI::Option* json = import->add_flag("--json", command.json, "the list for a program")->option_text(" ");
  import
      ->add_option("--slices", command.slices,
          "write what Terp computes at the feet of all stored\nslices beside what is stored")
      ->option_text("FILE")
      ->excludes(json);
  add_output(import, command.output, "write a case folder: case.toml, its tables, report.md");
  import->add_flag("--force", command.force, "replace the case that is in the folder");
  add_stage_options(import, command, "of the list, from 1");
  import->add_flag("--held", command.is_held,
      "strengths are doubled until the soil is at rest: for a\nsection that cannot stand (docs/dstability.md)");
  import->add_option("--unit", command.unit, "of a drawing: m, dm, cm, mm, ft, in\n(default: that of its header)")
      ->option_text("U");
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
  assess->add_option("FILE", command.files, "D-Stability files, case files, folders with a case.toml")
      ->option_text(" ")
      ->required();
  add_output(assess, command.output, "folder of the reach; each section has one in it");
  assess->get_option("--output")->required();
  assess->add_flag("--estimate", command.estimate, "import and check, say what would run and how long,\nand end");
  assess->add_flag("--stability", command.stability, "find the factor of safety of each, too");
  add_stage_options(assess, command.import, "of each file, from 1 (default: its last)");
  assess
      ->add_option("-j,--sections", command.sections,
          "solve so many at once, each in a process of its own\n(default: as many as there are processors)")
      ->option_text("N")
      ->check(whole_number_between(1, 1024));
  assess->add_option("--threads", command.threads, "CPU threads of each (default: processors over sections)")
      ->option_text("N")
      ->check(whole_number_between(1, 1024));
  add_language(assess, command.language);
  assess->add_flag("--force", command.force, "import and solve all anew");
}

}  // namespace terp
