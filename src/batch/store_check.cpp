#include "batch/store.hpp"

#include "math/errors.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

constexpr const char* cure = "Give it a folder of its own, -o DIR, or begin anew: --force";

[[noreturn]] void refuse_instructions(const std::string& folder, const StoreHead& head, const StoreHead& own)
{
  throw FileError(
      fmt::format("{}: this store was solved with the instruction set {}, and this terp uses {}, which gives other "
                  "bits\n  Go on where {} is used (on this machine perhaps: TERP_INSTRUCTIONS={}).\n  {}",
          folder, head.instructions, own.instructions, head.instructions, head.instructions, cure));
}

std::string another_build(const StoreHead& head, const StoreHead& own)
{
  return fmt::format(
      "build {} of terp with {}; this is build {} with {}", head.build, head.instructions, own.build, own.instructions);
}

/// Solves it once more. Stopped on the way: nothing is known, and nothing was solved.
std::string try_realisation(const Study& study, const std::string& folder, const Realisation& kept,
    const std::string& who, const std::atomic<bool>& stop)
{
  const auto again = realise(study, kept.number, draw_again(study, kept.number, kept.inputs), stop);
  if (!again) return "";
  if (!again->same_as(kept))
    throw FileError(fmt::format("{}: realisation {} of this store has other results here\n  It was solved by {}.\n  {}",
        folder, kept.number, who, cure));
  return fmt::format(
      "note: part of this store was solved by {}. Realisation {} has the same bits here\n", who, kept.number);
}

}  // namespace

std::string check_that_bits_agree(
    const Study& study, const std::string& folder, const StoredStudy& stored, const std::atomic<bool>& stop)
{
  const StoreHead own = head_of(study);
  std::string notes;
  for (const SolvedUnder& solver : stored.solvers)
    if (same_bits(solver.head, own) == SameBits::no) refuse_instructions(folder, solver.head, own);
  for (const SolvedUnder& solver : stored.solvers)
    if (same_bits(solver.head, own) == SameBits::unknown && solver.first_solved)
      notes +=
          try_realisation(study, folder, stored.rows.at(*solver.first_solved), another_build(solver.head, own), stop);
  return notes;
}

std::string why_bits_differ(const StoredStudy& stored)
{
  for (const SolvedUnder& solver : stored.solvers)
    if (const StoreHead& first = stored.solvers.front().head; same_bits(first, solver.head) == SameBits::no)
      return fmt::format(
          "warning: parts of this study were solved with {} and with {}, which give other bits\n  The table is not "
          "that "
          "of one process. Begin anew with TERP_INSTRUCTIONS=sse2 on all machines.\n",
          first.instructions, solver.head.instructions);
  return "";
}

}  // namespace terp
