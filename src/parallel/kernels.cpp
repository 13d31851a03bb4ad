#include "parallel/kernels.hpp"

#include <cstdlib>
#include <string>

// TERP_KERNEL_SETS, from CMakeLists.txt: TERP_KERNEL_SET(name) for each copy of the kernels, the best first.
#define TERP_KERNEL_SET(set) extern "C" const terp::Kernels* terp_kernels_##set();
TERP_KERNEL_SETS
#undef TERP_KERNEL_SET

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
#define TERP_KERNEL_SET(set) {#set, is_offered(#set), terp_kernels_##set()},
      TERP_KERNEL_SETS
#undef TERP_KERNEL_SET
  };
  return sets;
}

const InstructionSet& choose_instructions(std::span<const InstructionSet> sets, std::string_view word)
{
  const InstructionSet* best = nullptr;
  for (const InstructionSet& set : sets) {
    if (set.offered && best == nullptr) best = &set;
    if (set.name != word) continue;
    if (set.offered) return set;
    throw InstructionsError("TERP_INSTRUCTIONS=" + std::string(word) + ": this processor does not offer it" + advice);
  }
  if (!word.empty())
    throw InstructionsError("TERP_INSTRUCTIONS=" + std::string(word) +
                            ": there is no such set in this build. It has: " + names_of(sets) + advice);
  if (best == nullptr)
    throw InstructionsError(
        "this processor offers none of the instruction sets of this build: " + names_of(sets) + ".");
  return *best;
}

const Kernels& kernels()
{
  static const Kernels& chosen = []() -> const Kernels& {
    const char* word = std::getenv("TERP_INSTRUCTIONS");
    return *choose_instructions(instruction_sets(), word == nullptr ? "" : word).kernels;
  }();
  return chosen;
}

}  // namespace terp
