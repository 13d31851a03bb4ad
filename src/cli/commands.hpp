// The commands of the program, one function each. Each returns the exit status.
#pragma once

#include "run/loop/observer.hpp"
#include "run/loop/simulation.hpp"
#include "run/stability/factor_of_safety.hpp"

#include <functional>
#include <string>
#include <vector>

namespace terp {

/// Exit statuses, as the help promises.
enum Status { solved = 0, failed = 1, bad_input = 2, stopped_itself = 3 };

/// A run that is one of several, as of `terp converge`: it shows its progress with the others, and no summary.
struct PartOfSet {
  std::string label;             ///< "[2/3] cells of 0.5 m  "
  double later_s = 0.0;          ///< expected time of the runs after it [s]
  std::string* fault = nullptr;  ///< is given why the run stopped itself
  bool* slides = nullptr;        ///< is given whether that is since the soil slides in the section as it is drawn
  Observer* observer = nullptr;  ///< sees the run as well
};

struct RunOptions {
  std::string path;                  ///< case file, or run folder or checkpoint for resume
  std::string output;                ///< run folder; empty: runs/<case>
  std::string from;                  ///< of run: "RUN:STAGE", a run folder or a checkpoint to begin with; empty: none
  std::vector<std::string> changes;  ///< KEY=VALUE of --set
  std::string at_strength;           ///< of run: value of the key at_strength; empty: as the case has it
  int threads = 0;                   ///< 0: what this job may use
  bool force = false, quiet = false, verbose = false;
  long steps = 100, warm_steps = 50;  ///< of bench: in each of five trials, and before them
  bool json = false, score = false;   ///< of check and bench, of bench
  bool report = false;                ///< write the page of the run at its end
  bool exact_fields = false;          ///< of run: fields of the frames in double precision
  std::string language = "en";        ///< of that page
  std::string picture;                ///< of check: SVG file of the section; empty: none
  std::vector<double> profiles;       ///< of check: x of vertical lines [m]
  const PartOfSet* part = nullptr;    ///< of run and resume

  /// Is shown a run that was solved.
  std::function<void(const Simulation&)> at_end = {};
};

struct ConvergeOptions {
  RunOptions run;                     ///< the case; folder of the study; changes of all runs
  std::vector<double> cells;          ///< sizes [m]
  std::vector<std::string> variants;  ///< KEY=VALUE; several in one, with `;` between
  std::vector<double> turns;          ///< directions of the cells [deg]
  std::vector<int> points;            ///< points per cell in each direction
  double tolerance = 0.02;
  bool estimate = false;      ///< say what it would cost, and end
  bool what_decides = false;  ///< change inputs one at a time, and say which of them give another outcome
};

struct ReportCommand {
  std::vector<std::string> runs;  ///< folders
  std::string output;             ///< HTML file; empty: report.html
  bool json = false;              ///< of compare
  std::string language = "en";    ///< of the page: one of report_languages
};

struct ImportCommand {
  std::string path;    ///< of the .stix, .dxf or .csv file
  std::string slices;  ///< CSV file of computed and stored values; empty: none
  bool json = false;
  std::string output;                   ///< case folder; empty: none
  bool force = false;                   ///< replace a case that is there
  int scenario = 0, stage = 0;          ///< numbers from 1; 0: left out
  std::string strength;                 ///< deterministic, design, mean; empty: deterministic
  double cell = 0.0;                    ///< [m]; 0: from the section
  std::vector<double> between;          ///< x of the part of the section that is taken over [m]; empty: what matters
  std::optional<double> base;           ///< level above which it is taken over [m]; none: what matters
  std::string unit;                     ///< of a drawing or profile; empty: that of its header
  std::string layers;                   ///< of a drawing, apart by commas, or the name of a profile; empty: all
  std::vector<double> window;           ///< of a drawing: x, y of two corners [m]; empty: all of it
  double depth = 0.0;                   ///< of the base of a profile below its lowest ground [m]; 0: the usual one
  std::string soils;                    ///< of a profile: a table of soils by level, and after a comma a name in it
  std::string soil_defaults;            ///< CSV file; empty: the table of the program
  bool no_film = false;                 ///< no film at the top of aquifers
  std::optional<double> face_cohesion;  ///< of cohesionless faces [kPa]; none: the usual one
  bool is_held = false;                 ///< the section cannot stand: hold it while the river rises
  bool study = false;                   ///< a study file beside the case
  std::optional<double> river;          ///< level of the river [m]; none: that of the file
  std::string trigger;                  ///< "strength", "strength=1.2", "water", "water=12.5"; empty: none
  bool print_defaults = false;
};

struct ExportCommand {
  std::string run, frames, folder;
  std::string dxf, profile, stix;  ///< files of the section at the end; empty: none
  ImportCommand of_stix;           ///< the file that the new one is made of: path, scenario, stage
  double tolerance = 0.0;          ///< of the outlines in it [m]; 0: the usual one
  std::vector<std::string> fields;
};

struct StudyCommand {
  std::string action;     ///< check, run, status, report, sample
  std::string path;       ///< study file, or folder of a study
  std::string output;     ///< folder; empty: runs/NAME
  std::string part;       ///< of run: "K/N"; empty: all
  std::vector<int> keep;  ///< of run: realisations to solve once more, with all files
  int threads = 0;        ///< 0: what this job may use
  int samples = 1000;     ///< of sample
  bool force = false, quiet = false;
};

struct AssessCommand {
  std::vector<std::string> files;  ///< .stix, case.toml, or folders of one
  std::string output;              ///< folder of the reach
  ImportCommand import;            ///< options of `terp import`
  bool stability = false;          ///< find the factor of safety, too
  bool estimate = false;           ///< import and check, say what would run and how long, and end
  bool force = false;              ///< solve all anew
  int sections = 0;                ///< at once; 0: as many as there are processors
  int threads = 0;                 ///< of each; 0: processors over sections
  std::string language = "en";     ///< of the pages
};

struct SeepageCommand {
  RunOptions run;             ///< the case; folder of the results, empty: runs/NAME_seepage
  std::string levels;         ///< CSV file of levels over hours; empty: steady
  double step = 1.0;          ///< longest step in time [h]
  std::vector<double> at;     ///< moments that are written as water of a case [h]
  std::vector<double> along;  ///< x and y of both ends of a line [m]; empty: none
};

struct ElementCommand {
  std::string case_path;               ///< case file, or materials alone
  std::vector<std::string> changes;    ///< KEY=VALUE of --set
  std::vector<std::string> materials;  ///< names; empty: all
  std::string test = "triaxial";       ///< one of element_tests()
  std::string path;                    ///< instead: CSV file
  std::string pressure;                ///< vertical effective stress at the start; empty: that of the body, or 100 kPa
  double k0 = 1.0;                     ///< stress across over it [-]
  std::vector<double> place;           ///< x, y of the element in the section [m]; empty: none
  bool undrained = false;
  std::vector<double> strain;        ///< turning points [-]
  std::vector<std::string> load;     ///< turning points, stresses with units
  int increments = 0;                ///< of each part; 0: the usual number
  double duration = 1000.0;          ///< [s]
  std::optional<double> void_ratio;  ///< at the start
  std::string output;                ///< folder; empty: runs/NAME_element
  bool quiet = false;
};

struct WatchCommand {
  std::string run;
  double every = 2.0;  ///< [s]
  bool once = false;
};

/// Threads that a command asks the system for: those of --threads, or all that this job may use.
int threads_of(const RunOptions& options);

/// Warns where the system granted fewer.
void warn_of_missing_threads(const RunOptions& options, int granted);

int run_case(const RunOptions& options);
/// cells: sizes [m]; empty: those of the case.
int find_stability(const RunOptions& run, StabilityOptions options, const std::vector<double>& cells);
/// The search of `terp stability` on the cells of the case; results in run.output. Throws RunError if the soil cannot
/// be settled, or it was stopped before that.
StabilityResult search_stability(const RunOptions& run, StabilityOptions options = {});
int resume_run(const RunOptions& options);
int converge_case(const ConvergeOptions& options);
int study_case(const StudyCommand& command);
int check_case(const RunOptions& options);
int test_elements(const ElementCommand& command);
int bench_case(const RunOptions& options);
int report_runs(const ReportCommand& command);
int compare_folders(const ReportCommand& command);
int export_run(const ExportCommand& command);
int watch_run(const WatchCommand& command);
int import_file(const ImportCommand& command);
int assess_reach(AssessCommand command);
int import_stix(const ImportCommand& command);
int compute_seepage(const SeepageCommand& command);

}  // namespace terp
