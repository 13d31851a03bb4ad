// Nothing is solved here: the stored slices are compared with what the section of the file gives at their feet. The
// list needs that comparison too, since it says of each stored result whether it still fits the section. A file that
// --slices would replace is looked at first, before the work of the comparison.

#include "import/dstability/listing.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/slices.hpp"
#include "cli/import_options.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "os/say.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace terp {
namespace {

/// A table may replace an earlier one, nothing else: not the file that it was made of.
void refuse_other_tables(const std::string& path)
{
  std::ifstream file(path);
  std::string first;
  if (file && std::getline(file, first) && !first.starts_with("result,x,z,"))
    refuse_import(fmt::format("{} is there already, and it is no table of slices", path),
        "Choose another name: --slices slices.csv");
}

/// What the list says of a stored result: whether it fits the section of the file.
std::string verdict_of(const std::vector<ResultSlices>& results, std::size_t scenario, std::size_t calculation)
{
  const auto found = std::ranges::find_if(
      results, [&](const ResultSlices& r) { return r.scenario == scenario && r.calculation == calculation; });
  if (found == results.end()) return "no slices";
  if (!found->trouble.empty()) return "not computed";
  return words_of(found->state);
}

/// One line per result: how far the computed values are from the stored ones.
void print_deviations(const std::vector<ResultSlices>& results)
{
  say("largest difference from the stored slices\n{:<56} {:>6} {:>7} {:>7} {:>7} {:>9}\n{:<56} {:>6} {:>7} {:>7} "
      "{:>7} {:>9}\n",
      "", "", "sigma_v", "u", "sigma_y", "s_u", "result", "slices", "kPa", "kPa", "kPa", "%");
  for (const ResultSlices& result : results) {
    const SliceDeviation most = largest_deviation(result);
    say("{:<56} {:>6} {:>7.4f} {:>7.4f} {:>7.4f} {:>9.4f}{}{}\n", printable(result.name), result.rows.size(),
        most.total_stress / 1e3, most.pore_pressure / 1e3, most.yield_stress / 1e3, 100.0 * most.su,
        most.missing == 0 ? "" : fmt::format("\n  {} stored numbers have no computed one", most.missing),
        result.why.empty() ? "" : fmt::format("\n  {}: {}", words_of(result.state), result.why));
    if (!result.trouble.empty()) say(stderr, "warning: {}\n", printable(result.name + ": " + result.trouble));
  }
}

}  // namespace

int import_stix(const ImportCommand& command)
try {
  if (!command.slices.empty()) refuse_other_tables(command.slices);
  const StixProject project = read_stix(command.path);
  const std::vector<ResultSlices> results = compare_slices(project);
  if (!command.slices.empty()) {
    write_file_atomically(command.slices, slices_csv(results));
    print_deviations(results);
    say("{} results in {}\n", results.size(), command.slices);
    return solved;
  }
  const StixVerdict verdict = [&](std::size_t s, std::size_t k) { return verdict_of(results, s, k); };
  say("{}", command.json ? listing_json(project, verdict) : printable(listing_of(project, verdict)));
  return solved;
} catch (const InputError& error) {
  refuse_import(command.path, error);
}

}  // namespace terp
