// Each section is solved by a process of its own: a fault of ours or the end of memory ends that process and no other.

#include "cli/assess.hpp"
#include "import/drawing/section_export.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "os/threads.hpp"
#include "cli/progress.hpp"
#include "page/document.hpp"
#include "page/page.hpp"
#include "os/children.hpp"
#include "os/files.hpp"
#include "os/stop.hpp"
#include "os/terminal.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <new>
#include <optional>
#include <set>

namespace terp {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* page_file = "index.html";
constexpr const char *csv_file = "reach.csv", *vrtool_file = "Stabiliteit_default.csv";
constexpr const char* json_file = "reach.json";
constexpr const char* log_file = "log.txt";

/// Of a file or of the folder of a case: letters, digits, . - _.
std::string name_for(const std::string& file)
{
  const fs::path path = fs::path(file).lexically_normal();
  const fs::path folder = path.has_filename() ? path : path.parent_path();
  std::error_code none;
  const std::string text = path.filename() == case_file   ? path.parent_path().filename().string()
                           : fs::is_directory(path, none) ? folder.filename().string()
                                                          : path.stem().string();
  std::string name;
  for (const unsigned char c : text)
    name += std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_' ? static_cast<char>(c) : '_';
  return name.find_first_not_of("._") == std::string::npos ? "section" : name;
}

std::vector<PlannedSection> plan_of(const AssessCommand& command)
{
  std::vector<PlannedSection> plan;
  std::set<std::string> names{page_file, csv_file, json_file};  // of the reach itself
  std::map<std::string, std::string> paths;
  for (const std::string& file : command.files) {
    const std::string path = fs::absolute(file).lexically_normal().string();
    if (const auto [known, is_new] = paths.emplace(path, file); !is_new)
      throw CaseError(printable(fmt::format("error: {} is given twice\n  Name each section once.\n", file)));
    const std::string first = name_for(file);
    std::string name = first;
    for (int k = 2; !names.insert(name).second; ++k) name = fmt::format("{}_{}", first, k);
    const std::string folder = path_in(command.output, name);
    plan.push_back({.file = file, .name = name, .folder = folder, .record = read_record(folder)});
  }
  if (fs::exists(path_in(command.output, case_file)))
    throw FileError(
        fmt::format("{}: this is the folder of one case; sections get folders of their own\n  Choose another: -o DIR",
            command.output));
  return plan;
}

/// What the process of a section prints goes to its log. Its exit status.
int solve_here(const PlannedSection& section, const AssessCommand& command, SectionProgress& progress)
{
  listen_for_stop();
  try {
    make_folder(section.folder);
    print_to_file(path_in(section.folder, log_file));
    return assess_section(section, command, progress) ? solved : failed;
  } catch (const std::exception& error) {
    say(stderr, "error: {}\n", error.what());
  }
  return failed;
}

class Reach {
 public:
  Reach(std::vector<PlannedSection>& plan, const AssessCommand& command)
      : plan_(plan), command_(command), children_(plan.size() * sizeof(SectionProgress))
  {
    told_ = static_cast<SectionProgress*>(children_.shared());
    for (std::size_t k = 0; k < plan.size(); ++k) new (told_ + k) SectionProgress;
    for (std::size_t k = 0; k < plan.size(); ++k)
      if (is_done(plan[k], command))
        ++n_done_, show(stdout, fmt::format("[{}/{}] {}  kept, solved before\n", n_done_, plan.size(), plan[k].name));
      else
        waiting_.push_back(k);
    if (waiting_.empty()) return;
    for (const char* file : {page_file, csv_file, json_file}) remove_table(path_in(command.output, file));
  }

  /// False: stopped before the last one was done.
  bool solve()
  {
    while ((!waiting_.empty() && !stop_requested) || !running_.empty()) {
      while (!stop_requested && !waiting_.empty() && std::ssize(running_) < command_.sections) begin_next();
      wait_for_one();
      if (stop_requested && !told_to_stop_ && !running_.empty()) children_.ask_to_stop(), told_to_stop_ = true;
    }
    line_.clear();
    return !stop_requested;
  }

 private:
  /// Of an earlier command: it would say what no longer holds. It is written at the end.
  static void remove_table(const std::string& path)
  {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw_file_error("remove", path, error);
  }

  void begin_next()
  {
    const std::size_t k = waiting_.front();
    waiting_.erase(waiting_.begin());
    children_.begin(k, plan_[k].name, [&, k] { return solve_here(plan_[k], command_, told_[k]); });
    running_[k] = Clock::now();
  }

  void wait_for_one()
  {
    const std::optional<ChildEnd> end = children_.next_end();
    if (!end) {
      show_line();
      wait_seconds(0.1);
      return;
    }
    const auto start = running_.at(end->number);
    running_.erase(end->number);
    note_end(*end, std::chrono::duration<double>(Clock::now() - start).count());
  }

  void note_end(const ChildEnd& end, double seconds)
  {
    const std::size_t k = end.number;
    PlannedSection& section = plan_[k];
    section.record = read_record(section.folder);
    if (stop_requested) return;
    if (!end.killed_by.empty())
      note_fault(section, k, fmt::format("was ended by {}", end.killed_by));
    else if (end.status != 0 && section.record.fault.empty())
      note_fault(section, k, fmt::format("ended with status {}", end.status));
    const std::string& fault = section.record.fault;
    ++n_done_;
    if (fault.empty())
      seconds_done_ += seconds, ++n_solved_here_;  // what is refused at once says nothing of the others
    line_.clear();
    const std::string done = command_.estimate ? "checked" : "solved";
    show(stdout, printable(fmt::format("[{}/{}] {}  {}{}\n", n_done_, plan_.size(), section.name,
                     fault.empty() ? fmt::format("{} in {}", done, readable_duration(seconds))
                                   : "no result: " + fault.substr(0, fault.find('\n')),
                     waiting_.empty() && running_.empty() ? "" : "; ETA " + readable_duration(time_left()))));
  }

  /// The process of a section could not say itself what befell it.
  void note_fault(PlannedSection& section, std::size_t k, const std::string& what)
  {
    section.record.name = section.name, section.record.file = printable(section.file);
    section.record.is_refused = false;
    section.record.fault = fmt::format("its process {} during: {}\n  {} has what it printed.", what,
        section_steps[told_[k].step.load()], path_in(section.folder, log_file));
    try {
      write_file_atomically(path_in(section.folder, record_file), record_text(section.record));
    } catch (const FileError& error) {  // of a folder that cannot be made
      section.record.fault += fmt::format("\n  {}", error.what());
    }
  }

  /// As long as the sections so far have taken on average; of runs under way what they say themselves [s].
  double time_left()
  {
    const double mean = n_solved_here_ > 0 ? seconds_done_ / n_solved_here_ : -1.0;
    double all = 0.0, longest = 0.0;
    for (const auto& [k, start] : running_) {
      const double spent = std::chrono::duration<double>(Clock::now() - start).count();
      const double told = told_[k].left_s;
      const double left = told >= 0.0 ? told : std::max(mean - spent, 0.0);
      all += left, longest = std::max(longest, left);
    }
    if (mean < 0.0 && (!waiting_.empty() || longest == 0.0)) return 1e9;  // not known
    all += mean * static_cast<double>(waiting_.size());
    return std::max(longest, all / std::max(1, command_.sections));
  }

  void show_line()
  {
    if (!line_.renews()) return;
    std::string line = fmt::format("{} of {} done", n_done_, plan_.size());
    for (const auto& [k, start] : running_) {
      const SectionProgress& told = told_[k];
      line += fmt::format("; {}: {}", plan_[k].name, section_steps[told.step.load()]);
      if (told.left_s >= 0.0) line += ", " + readable_duration(told.left_s);
    }
    line_.show(line + "; ETA " + readable_duration(time_left()));
  }

  std::vector<PlannedSection>& plan_;
  const AssessCommand& command_;
  Children children_;
  SectionProgress* told_ = nullptr;  ///< one entry per section, in the memory that the processes share
  std::vector<std::size_t> waiting_;
  std::map<std::size_t, Clock::time_point> running_;  ///< sections and their start
  std::size_t n_done_ = 0;
  int n_solved_here_ = 0;
  double seconds_done_ = 0.0;
  LiveLine line_;
  bool told_to_stop_ = false;
};

int print_estimate(const std::vector<PlannedSection>& plan, const AssessCommand& command)
{
  double seconds = 0.0;
  int n_refused = 0;
  for (const PlannedSection& section : plan) {
    const SectionRecord record = read_record(section.folder);
    if (!record.fault.empty() || record.n_points == 0) {
      say("  {:<30} {}: {}\n", section.name, state_of({.record = record}),
          printable(record.fault.substr(0, record.fault.find('\n'))));
      ++n_refused;
      continue;
    }
    seconds += record.expected_s;
    say("  {:<30} {}, cells of {:.3g} m, {} points, at most {}\n", section.name, printable(record.title), record.cell,
        record.n_points, readable_duration(record.expected_s));
    if (!record.ignored.empty()) say("    {}\n", record.ignored);
  }
  say("all runs: at most {} with {} at once, without searches for factors of safety\ncases in {}; nothing was run\n",
      readable_duration(seconds / command.sections), command.sections, command.output);
  return n_refused == 0 ? solved : stopped_itself;
}

/// --estimate runs nothing, so it must not take the place of what was solved.
void refuse_to_replace(const std::vector<PlannedSection>& plan, const AssessCommand& command)
{
  for (const PlannedSection& section : plan)
    if (would_replace_result(section, command))
      throw CaseError(printable(fmt::format(
          "error: {} has a result of another file, other options or another build of terp\n  --estimate leaves it as "
          "it is. Choose another folder: -o FOLDER. --force replaces the case; the same command without --estimate "
          "solves it anew.\n",
          section.folder)));
}

int write_reach(const std::vector<PlannedSection>& plan, const AssessCommand& command)
{
  std::vector<ReachSection> sections;
  int n_faults = 0;
  for (const PlannedSection& section : plan) {
    const bool is_known = section.record.fault.empty();  // a folder that cannot be written does not say the fault
    sections.push_back(is_known ? read_section(section.folder, profile_of) : ReachSection{.record = section.record});
    ReachSection& s = sections.back();
    s.record.name = section.name, s.record.file = printable(section.file);
    n_faults += s.is_solved ? 0 : 1;
  }
  const std::string now = now_in_utc();
  const PageDocument page(reach_json(sections, now, true));
  write_file_atomically(
      path_in(command.output, page_file), make_page(page_template(), page.payload("reach", now, command.language)));
  write_file_atomically(path_in(command.output, csv_file), reach_csv(sections));
  write_file_atomically(path_in(command.output, json_file), reach_json(sections, now));
  if (const std::string table = vrtool_csv(sections); !table.empty())
    write_file_atomically(path_in(command.output, vrtool_file), table);
  for (const ReachSection& s : sections) say("  {:<30} {}\n", s.record.name, printable(sentence_on(s)));
  say("{} of {} sections have a result; page in {}, tables in {} and {}\n", plan.size() - n_faults, plan.size(),
      path_in(command.output, page_file), csv_file, json_file);
  return n_faults == 0 ? solved : stopped_itself;
}

}  // namespace

int assess_reach(AssessCommand command)
{
  const int processors = available_processors();
  if (command.sections == 0) command.sections = processors;
  command.sections = std::min(command.sections, static_cast<int>(command.files.size()));
  if (command.threads == 0) command.threads = std::max(1, processors / command.sections);
  std::vector<PlannedSection> plan = plan_of(command);
  if (const std::optional<OwnTask> own = own_task(); own && own->number < plan.size())
    return solve_here(plan[own->number], command, static_cast<SectionProgress*>(own->shared)[own->number]);
  make_folder(command.output);
  const FolderLock lock(command.output);
  listen_for_stop();
  if (command.estimate) refuse_to_replace(plan, command);
  if (!Reach(plan, command).solve()) {
    say(stderr, "stopped; what is solved is kept in {}. Go on with the same command\n", command.output);
    return failed;
  }
  return command.estimate ? print_estimate(plan, command) : write_reach(plan, command);
}

}  // namespace terp
