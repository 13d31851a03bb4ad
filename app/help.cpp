#include "help.hpp"

#include <utility>

namespace terp {
namespace {

constexpr const char* help_text = R"(terp: explicit material point method for soil (MPM-Mixed and MPM-GP)

Usage: terp COMMAND [options]

Solve
  run CASE.toml           solve a case; results go to runs/<case name>/
  resume RUN              continue from the newest checkpoint of a run folder,
                          or from the checkpoint file that is named
  stability CASE.toml     factor of safety by strength reduction (--from, --to,
                          --tolerance, --damping, --stiffening, --json;
                          docs/stability.md)
  watch RUN               how far a run is that another terp solves (--every S, --once)

Look
  report RUN...           write report.html: one page that shows the runs, side by side
  compare RUN RUN...      table of what differs between runs (--json)
  export RUN              frames as CSV into RUN/csv or -o DIR (--field NAME, may be given
                          several times; --frames 0,5,10:20,last)

Understand
  check CASE.toml         read and validate, print what would run, solve nothing
  explain TOPIC           a material, scheme or key: meaning, unit, range, equation
  list                    materials, schemes and outputs in this build
  bench [CASE.toml]       how fast the step is here, pass by pass; without a case:
                          the paper's column (--steps, --warm, --json)
  verify [CASE...]        solve problems with a known answer, print what came out
                          (--list, --short, --long, --html, --markdown, --overview FILE,
                          --cases DIR)

Options
  -o, --output DIR        where results go
  -j, --threads N         CPU threads (default: what this job may use)
      --set KEY=VALUE     change one key of the case; may be given several times
      --force             replace the results of an earlier run
      --report            write the page of the run at its end: RUN/report.html
  -q, --quiet    -v, --verbose    --version    -h, --help (COMMAND --help: of a command)

Try
  terp check cases/column_collapse/model_2.toml
  terp run   cases/column_collapse/model_2.toml --set scheme="mpm_mixed" -o runs/mixed

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)";

/// Name of a command and its page.
constexpr std::pair<std::string_view, std::string_view> pages[] = {
    {"run", R"(Usage: terp run CASE.toml [options]

Solves a case. Results go to runs/NAME/ for NAME.toml and for NAME/case.toml (docs/formats.md).

  -o, --output DIR        another folder
  -j, --threads N         CPU threads (default: what this job may use)
      --set KEY=VALUE     change one key of the case; may be given several times
      --force             replace the results of an earlier run
      --report            write the page of the run at its end: DIR/report.html
  -q, --quiet             no progress, no summary; warnings stay
  -v, --verbose           time per pass as well

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"resume", R"(Usage: terp resume RUN [options]

Goes on from the newest checkpoint of a run folder that can be read, or from the checkpoint file that is named.
The case in the folder and the files that it names must be what the run began with. What may change there (in comments
anything): title, time.end, output.fields.every, output.checkpoint. With a later time.end a run that was solved goes on
in the same time step.

  -j, --threads N         CPU threads; the results have the same bits on any number
      --report            write the page of the run at its end: RUN/report.html
  -q, --quiet    -v, --verbose

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"stability", R"(Usage: terp stability CASE.toml [options]

Factor of safety by strength reduction (docs/stability.md). Writes stability.txt and stability.json.

      --from F, --to F    factors between which to look (0.01 to 100)
      --tolerance T       width of the bracket at the end
      --damping A         local damping while the soil seeks rest (0 to 0.99; 0.5)
      --rest R            stands when it hardly moves, as soil with this part of its weight
                          out of balance would (2e-5)
      --failure D         fails beyond this displacement, in rho g H^2/E (4)
      --windows N         time that a trial has (200)
      --stiffening S      displacements are kept S times smaller than they were (1 to 1e6; 1000)
  -o, --output DIR        where the two files go
      --json              print stability.json
      --set KEY=VALUE     change one key of the case; may be given several times
  -j, --threads N    -q, --quiet    -v, --verbose

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"check", R"(Usage: terp check CASE.toml [options]

Reads and validates a case and says what would run: points, cells, steps, memory. Solves nothing.

      --set KEY=VALUE     change one key of the case; may be given several times
  -j, --threads N    -q, --quiet    -v, --verbose

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"bench", R"(Usage: terp bench [CASE.toml] [options]

How fast the step is on this machine, pass by pass; without a case the paper's column.

      --steps N           steps in each of five trials
      --warm N            steps before them
      --set KEY=VALUE     change one key of the case; may be given several times
      --json              numbers for a program
  -j, --threads N         CPU threads (default: what this job may use)

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"report", R"(Usage: terp report RUN [RUN...] [options]

Writes one HTML file that shows the runs side by side and opens without a network (docs/report_page.md).

  -o, --output FILE       the file (default: report.html)

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"compare", R"(Usage: terp compare RUN RUN [RUN...] [options]

Table of what differs between runs, and the differences in words: the first run against each of the others. Says in
which keys the cases differ.

      --json              the same for a program

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"export", R"(Usage: terp export RUN [options]

Frames of a run as CSV, and a list of them. ParaView, VTK and h5py read the frames as they are:
open RUN/results.vtkhdf.series, or see docs/python.md.

      --field NAME        only this field; may be given several times
      --frames LIST       numbers, ranges with both ends, `last`: 0,5,10:20,last (default: all)
  -o, --output DIR        folder (default: RUN/csv)

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"watch", R"(Usage: terp watch RUN [options]

How far a run is that another terp solves; ends with it.

      --every S           seconds between two looks (default 2)
      --once              look once

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"verify", R"(Usage: terp verify [CASE...] [options]

Solves problems with a known answer and prints what came out (docs/verification_cases.md); without a name all of them.

      --list              names and titles
      --short, --long     only those that take seconds, or minutes
      --html FILE, --markdown FILE
                          write the ledger as a page
      --overview FILE     write one line per case, and what does not agree
      --cases DIR         folder of the cases
  -j, --threads N         CPU threads (default: what this job may use)

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"explain", R"(Usage: terp explain TOPIC

Meaning, unit, range and default of a key or section of the case file, parameters and equations of a material or scheme.

  terp explain mesh.cell    terp explain tresca_softening    terp explain mpm_gp    terp explain body

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
    {"list", R"(Usage: terp list

Materials, schemes and outputs in this build. On each: terp explain NAME.

Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else
)"},
};

}  // namespace

std::string_view help() { return help_text; }

std::string_view help_on(std::string_view command)
{
  for (const auto& [name, page] : pages)
    if (name == command) return page;
  return help_text;
}

}  // namespace terp
