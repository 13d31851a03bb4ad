// The list of sets comes from cmake/kernels.cmake, the best first, and the choice is the first that the processor
// offers. What is asked for by name is had or refused, never replaced: another set may give other bits. The test asks
// for levels of x86-64, which the compiler has as its target. So it covers all instructions that the kernels may use.

#include "os/instructions.hpp"

#include <cstdlib>
#include <string>

namespace terp {
namespace {

/// Whether processor and operating system offer what CMakeLists.txt lets the compiler use for a set.
bool is_offered(std::string_view set)
{
#if defined(__x86_64__) && \
    !defined(__clang__)  // clang 14 does not know these names; with it there is one copy (TERP_FUZZ)
  __builtin_cpu_init();
  if (set == "avx512") return __builtin_cpu_supports("x86-64-v4");
  if (set == "avx2") return __builtin_cpu_supports("x86-64-v3");
#endif
  return !set.empty();  // the least of the architecture, or a build for its own machine
}

constexpr const char* advice = "\n  Without the variable Terp takes the best set that the processor offers.";

std::string names_of(std::span<const InstructionSet> sets)
{
  std::string names;
  for (const InstructionSet& set : sets) names += (names.empty() ? "" : ", ") + std::string(set.name);
  return names;
}

}  // namespace

std::span<const InstructionSet> instruction_sets()
{
  static const InstructionSet sets[] = {
#define TERP_KERNEL_SET(set) {#set, is_offered(#set)},  // TERP_KERNEL_SETS: one per copy of the kernels, the best first
      TERP_KERNEL_SETS
#undef TERP_KERNEL_SET
  };
  return sets;
}

std::size_t choose_instructions(std::span<const InstructionSet> sets, std::string_view word)
{
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (word.empty() ? !sets[k].offered : sets[k].name != word) continue;
    if (sets[k].offered) return k;
    throw InstructionsError("TERP_INSTRUCTIONS=" + std::string(word) + ": this processor does not offer it" + advice);
  }
  if (!word.empty())
    throw InstructionsError("TERP_INSTRUCTIONS=" + std::string(word) +
                            ": there is no such set in this build. It has: " + names_of(sets) + advice);
  throw InstructionsError("this processor offers none of the instruction sets of this build: " + names_of(sets) + ".");
}

std::size_t chosen_set()
{
  static const std::size_t chosen = [] {
    const char* word = std::getenv("TERP_INSTRUCTIONS");
    return choose_instructions(instruction_sets(), word == nullptr ? "" : word);
  }();
  return chosen;
}

std::string_view instructions() { return instruction_sets()[chosen_set()].name; }

}  // namespace terp
