// terp import: what a D-Stability file holds, and how Terp's stresses and strengths stand to the stored slices.

#include "commands.hpp"
#include "dstability/listing.hpp"
#include "dstability/read_stix.hpp"
#include "input/case_file.hpp"
#include "input/printable.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace terp {
namespace {

/// Faults of the file in the words of the other commands.
[[noreturn]] void refuse(const InputError& error)
{
  std::string text;
  for (const Problem& problem : error.problems())
    text += fmt::format("error: {}: {}\n{}", problem.key, problem.what,
        problem.detail.empty() ? "" : fmt::format("  {}\n", problem.detail));
  throw CaseError(printable(text));
}

}  // namespace

int import_stix(const ImportCommand& command)
try {
  const StixProject project = read_stix(command.path);
  const StixVerdict verdict = [](std::size_t, std::size_t) { return std::string(); };
  fmt::print("{}", command.json ? listing_json(project, verdict) : printable(listing_of(project, verdict)));
  return solved;
} catch (const InputError& error) {
  refuse(error);
}

}  // namespace terp
