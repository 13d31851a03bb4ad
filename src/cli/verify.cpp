// The runs of all cases form one queue, the longest first, so that no thread begins a long one at the end. Each run has
// one thread. Cases are judged only after all are solved, in the order in which they were chosen. A case that cannot be
// read does not stop the others: it has one row with its fault. After an interruption nothing is judged.

#include "cli/commands.hpp"

#include "math/errors.hpp"
#include "io/case/case_file.hpp"
#include "io/files/files.hpp"
#include "os/threads.hpp"
#include "cli/progress.hpp"
#include "os/files.hpp"
#include "os/stop.hpp"
#include "os/terminal.hpp"
#include "verify/find_cases.hpp"
#include "verify/overview.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <numeric>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

struct VerificationCase {
  std::string name;
  Expected expected;
  std::string fault = {};  ///< why it cannot be read; then nothing of it is solved
};

/// The cases that were asked for. A list: runs point at what is in it, and it may not move.
std::vector<std::unique_ptr<VerificationCase>> read_cases(const VerifyOptions& options, const std::string& folder)
{
  std::vector<std::unique_ptr<VerificationCase>> cases;
  for (const std::string& name : choose_cases(folder, options.names)) {
    const std::string path = (std::filesystem::path(folder) / name / "expected.toml").string();
    cases.push_back(std::make_unique<VerificationCase>(VerificationCase{name, {}}));
    try {
      cases.back()->expected = read_expected(path);
      if (cases.back()->expected.quantities.empty())
        throw CaseError(fmt::format(
            "error: {}: there is no [[quantity]], so nothing would be judged\n  See docs/verification_cases.md.\n",
            path));
    } catch (const CaseError& error) {
      cases.back()->expected = {};
      cases.back()->fault = error.what();
    }
  }
  return cases;
}

/// What is done and how long the rest may take: a line that renews itself on a terminal, else one per run.
class VerifyProgress {
 public:
  VerifyProgress(std::size_t n_runs, double seconds) : n_runs_(n_runs), seconds_(seconds) {}

  void done(const std::string& name, double expected_seconds, double seconds)
  {
    const auto n = ++n_done_;
    const double part = done_seconds_.fetch_add(expected_seconds) + expected_seconds;
    const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
    const double left = part > 0.0 ? wall * std::max(0.0, seconds_ - part) / part : 0.0;
    const std::string line =
        fmt::format("[{}/{}] {}  {}  ETA {}", n, n_runs_, name, readable_duration(seconds), readable_duration(left));
    show(stderr, terminal_ ? "\r\033[K" + line + (n == n_runs_ ? "\r\033[K" : "") : line + '\n');
  }

 private:
  std::size_t n_runs_;
  double seconds_;
  bool terminal_ = is_terminal(stderr);
  Clock::time_point start_ = Clock::now();
  std::atomic<std::size_t> n_done_{0};
  std::atomic<double> done_seconds_{0.0};
};

std::vector<Solved> solve_all(const std::vector<Solve>& solves, int threads)
{
  std::vector<std::size_t> order(solves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return solves[a].variant->seconds > solves[b].variant->seconds; });
  double seconds = 0.0;
  for (const Solve& s : solves) seconds += s.variant->seconds;
  VerifyProgress progress(solves.size(), seconds);
  std::vector<Solved> solved(solves.size());
  std::atomic<std::size_t> next{0};  // chunks are handed out in parts; a queue keeps the longest first
  Threads(threads).for_each_chunk(static_cast<Index>(solves.size()), [&](Index, int) {
    const std::size_t k = order[next.fetch_add(1)];
    if (!stop_requested) solved[k] = solve_variant(solves[k], stop_requested);
    const std::string folder = std::filesystem::path(solves[k].file->path).parent_path().filename().string();
    const Variant& v = *solves[k].variant;
    progress.done(fmt::format("{}{}{}{}{}", folder, v.name.empty() ? "" : ", ", v.name,
                      solves[k].scheme.empty() ? "" : ", ", solves[k].scheme),
        v.seconds, solved[k].seconds);
  });
  return solved;
}

/// A case that cannot be read has one row.
std::vector<Row> judge_case(
    const VerificationCase& c, const std::vector<Solve>& solves, const std::vector<Solved>& solved)
{
  if (!c.fault.empty()) return {fault_row(c.name, "-", "expected.toml", c.fault)};
  std::vector<Solve> own_solves;
  std::vector<Solved> own_solved;
  for (std::size_t k = 0; k < solves.size(); ++k)
    if (solves[k].file == &c.expected) own_solves.push_back(solves[k]), own_solved.push_back(solved[k]);
  return judge(c.name, c.expected, own_solves, own_solved);
}

std::string head_of_page(const std::string& folder)
{
  const std::filesystem::path path = std::filesystem::path(folder) / "README.md";
  const std::string all = std::filesystem::exists(path) ? read_file(path.string()) : "";
  return all.starts_with("# ") ? all.substr(std::min(all.find('\n') + 2, all.size()))
                               : all;  // the page has its own title
}

/// The pages are written at the end, after up to half an hour of solving: what stands in their way is said before.
void check_page(const std::string& path)
{
  if (path.empty()) return;
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  const bool writable = std::filesystem::exists(path) ? may_write(path) == 0 && !std::filesystem::is_directory(path)
                                                      : may_write(parent.empty() ? "." : parent.string()) == 0;
  if (!writable) throw FileError(fmt::format("{}: the page cannot be written; nothing was solved", path));
}

void write_page(const std::string& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw FileError(fmt::format("{}: the page cannot be written", path));
  fmt::print("written: {}\n", path);
}

/// The short page. Cases that were not asked for keep what the page says of them.
std::string overview_with(const std::vector<CaseRows>& pages, const VerifyOptions& options, const std::string& head)
{
  Overview overview = overview_of(pages);
  if (!options.names.empty() && std::filesystem::exists(options.overview))
    overview.merge(read_overview(read_file(options.overview)));
  return overview_page(overview, head);
}

void list_cases(const std::vector<std::unique_ptr<VerificationCase>>& cases, const VerifyOptions& options)
{
  for (const auto& c : cases) {
    if (!c->fault.empty()) fmt::print("{:<28} cannot be read\n{}", c->name, c->fault);
    const auto n_short = list_solves(c->expected, true, false).size(),
               n_long = list_solves(c->expected, false, true).size();
    if ((options.only_short && n_short == 0) || (options.only_long && n_long == 0)) continue;
    fmt::print("{:<28} {:2} short and {:2} long runs  {}\n", c->name, n_short, n_long, c->expected.title);
  }
}

}  // namespace

int verify_cases(const VerifyOptions& options)
{
  const std::string folder = options.cases.empty() ? find_cases_folder() : options.cases;
  const auto cases = read_cases(options, folder);
  if (options.list) return list_cases(cases, options), solved;
  std::vector<Solve> solves;
  for (const auto& c : cases)
    for (const Solve& s : list_solves(c->expected, !options.only_long, !options.only_short)) solves.push_back(s);
  listen_for_stop();
  std::string faults;
  for (const auto& c : cases) faults += c->fault;
  if (solves.empty() && !faults.empty()) throw CaseError(faults);
  if (solves.empty())
    throw FileError(
        fmt::format("there is nothing to solve: these cases have no {} run", options.only_long ? "long" : "short"));
  for (const std::string& path : {options.markdown, options.overview}) check_page(path);
  const std::vector<Solved> solved = solve_all(solves, options.threads > 0 ? options.threads : available_processors());
  if (stop_requested) throw RunError("stopped before all cases were solved; nothing is said of the others");

  std::vector<CaseRows> pages;
  for (const auto& c : cases) {
    CaseRows page{c->name, c->expected.title, judge_case(*c, solves, solved)};
    if (page.rows.empty()) continue;
    fmt::print("{}\n", text_table(page));
    pages.push_back(std::move(page));
  }
  if (!options.markdown.empty()) write_page(options.markdown, markdown_page(pages, head_of_page(folder)));
  if (!options.overview.empty()) write_page(options.overview, overview_with(pages, options, head_of_page(folder)));
  const Counts counts = count(pages);
  fmt::print("{}\n", counts_text(counts));
  const bool all = options.names.empty() && !options.only_short && !options.only_long;
  const bool too_many = all && too_many_regressions(counts.regression, counts.rows());
  if (too_many) fmt::print("More than a tenth of the rows are regression: hold more of them against outside values.\n");
  return counts.fail == 0 && !too_many ? Status::solved : failed;
}

}  // namespace terp
