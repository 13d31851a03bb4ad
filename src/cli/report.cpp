// These commands read the folders of runs and solve nothing. A run that is given twice is found by its folder, not by
// its spelling: links and other paths lead to the same run. Whether a page may take its place is tested before the runs
// are read. It is made as a whole in memory, and an earlier page stays until the new one is complete.

#include "cli/commands.hpp"
#include "cli/import_options.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/stix_export.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "cli/progress.hpp"
#include "page/page.hpp"
#include "io/results/compare.hpp"
#include "io/results/export.hpp"
#include "import/drawing/section_export.hpp"
#include "os/say.hpp"

#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <tuple>

namespace terp {

namespace {

/// A run beside itself has no difference, and the same name twice.
void refuse_twice(const std::vector<std::string>& folders)
{
  std::error_code unknown;
  for (std::size_t k = 0; k < folders.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (std::filesystem::equivalent(folders[k], folders[other], unknown))
        throw CaseError(printable(fmt::format("error: the run {} is given twice{}\n  Name each run once.\n",
            folders[other], folders[k] == folders[other] ? "" : ", also as " + folders[k])));
}

/// A page may replace an earlier page, nothing else.
void refuse_other_files(const std::string& path)
{
  std::ifstream file(path);
  std::string begin(9, '\0');
  if (!file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && file.gcount() == 0) return;
  for (char& c : begin) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (begin != "<!doctype")
    throw CaseError(printable(
        fmt::format("error: {} is there already, and it is no page\n  Choose another name: -o report.html\n", path)));
}

void write_stix(const ExportCommand& command)
{
  const ImportCommand& of = command.of_stix;
  if (of.path.empty())
    refuse_import("--stix needs the file that the case was imported from",
        "Its soils, and all that the run does not know, come from there: --template section.stix.");
  try {
    const FolderOptions place = folder_options(read_stix(of.path), of);
    const StixExport made = export_stix(read_run(command.run),
        {.original = of.path, .scenario = place.scenario, .stage = place.stage, .tolerance = command.tolerance});
    write_file_atomically(command.stix, made.bytes);
    for (const std::string& note : made.notes) say(stderr, "warning: {}\n", note);
    say("section at t = {:.4g} s, {} layers, in {}\n", made.time, made.n_layers, command.stix);
  } catch (const InputError& error) {
    refuse_import(of.path, error);
  }
}

}  // namespace

int report_runs(const ReportCommand& command)
{
  refuse_twice(command.runs);
  const std::string path = command.output.empty() ? "report.html" : command.output;
  refuse_other_files(path);
  ReportOptions options;
  options.language = command.language;
  options.written = now_in_utc();
  const Payload payload = make_payload(command.runs, options);
  write_file_atomically(path, make_page(page_template(), payload));
  for (const auto& note : payload.notes) say("{}\n", note);
  for (const auto& warning : payload.warnings) say(stderr, "warning: {}\n", warning);
  if (!has_page()) say(stderr, "warning: this terp was built without its report page; {} holds the data alone\n", path);
  say("{} in {} ({:.1f} MB)\n", has_page() ? "report" : "data of the report", path,
      static_cast<double>(std::filesystem::file_size(path)) / 1e6);
  return solved;
}

/// Options of the other kind of export would do nothing.
void refuse_idle_options(const ExportCommand& command)
{
  const bool is_section = !command.dxf.empty() || !command.profile.empty() || !command.stix.empty();
  const bool of_frames = !command.fields.empty() || !command.frames.empty() || !command.folder.empty();
  if (is_section && of_frames)
    throw CaseError(
        "error: --field, --frames and -o have no effect beside --dxf, --profile and --stix\n  These write the section "
        "at the end. Export the frames by a command of their own.\n");
  if (command.stix.empty() && command.tolerance > 0.0)
    throw CaseError(
        "error: --tolerance has no effect without --stix\n  It is that of the outlines in the D-Stability file.\n");
  const auto form_of = [](const std::string& path) { return path.substr(std::min(path.rfind('.'), path.size())); };
  for (const auto& [option, path, form] : {std::tuple{"--dxf", command.dxf, ".dxf"},
           std::tuple{"--profile", command.profile, ".csv"}, std::tuple{"--stix", command.stix, ".stix"}})
    for (const char* other : {".dxf", ".csv", ".stix"})
      if (form_of(path) == other && other != std::string_view(form))
        throw CaseError(fmt::format("error: {} writes a file *{}, not {}\n", option, form, printable(path)));
}

int export_run(const ExportCommand& command)
{
  refuse_idle_options(command);
  if (!command.stix.empty()) {
    write_stix(command);
    if (command.dxf.empty() && command.profile.empty()) return solved;
  }
  if (!command.dxf.empty() || !command.profile.empty()) {
    const SectionExport section = export_section(read_run(command.run));
    for (const auto& [path, text] :
        {std::pair{command.dxf, section.dxf}, std::pair{command.profile, section.profile_csv()}}) {
      if (path.empty()) continue;
      write_file_atomically(path, text);
      say("section at t = {:.4g} and {:.4g} s in {}\n", section.start, section.end, path);
    }
    return solved;
  }
  Frames frames = read_run(command.run).frames();
  const std::string folder = command.folder.empty() ? path_in(command.run, "csv") : command.folder;
  const auto paths = export_frames(frames, {command.fields, command.frames, folder});
  for (const auto& warning : frames.warnings()) say(stderr, "warning: {}\n", warning.en);
  const std::size_t n = paths.size() - 1;
  say("{} frame{} in {}, listed in {}\n", n, n == 1 ? "" : "s", folder, paths.back());
  return solved;
}

int compare_folders(const ReportCommand& command)
{
  if (command.runs.size() < 2)
    throw CaseError("error: terp compare takes two run folders or more\n  One run by itself: terp report RUN\n");
  refuse_twice(command.runs);
  std::vector<RunResults> runs;
  for (const auto& folder : command.runs) runs.push_back(read_run(folder));
  const Comparison comparison = compare_runs(runs, distinct_names(command.runs));
  say("{}", command.json ? comparison_json(comparison) + "\n" : comparison_table(comparison));
  return solved;
}

}  // namespace terp
