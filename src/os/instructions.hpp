// Which instruction set the kernels of this process use. The kernels are compiled once per set; the choice is made when
// the program starts, by what the processor offers (decision 0028).
// Not for: what the kernels offer. A layer with kernels has tables of its own, one copy per set (kernel_table.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace terp {

/// A set of instructions that this program was compiled for.
struct InstructionSet {
  std::string_view name;  ///< "avx512", "avx2", "sse2"; "native" or "plain" in a build with a single set
  bool offered = false;   ///< by this processor and its operating system
};

/// TERP_INSTRUCTIONS asks for what cannot be had.
class InstructionsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Every set in this build, the best first.
std::span<const InstructionSet> instruction_sets();

/// Number in `sets` of the set called `word`, or of the first that is offered if `word` is empty. Throws
/// InstructionsError.
std::size_t choose_instructions(std::span<const InstructionSet> sets, std::string_view word);

/// Number in instruction_sets() of the set of this process: the one that the environment variable TERP_INSTRUCTIONS
/// names, or the best. The choice is made at the first call and stays. Throws InstructionsError.
std::size_t chosen_set();

/// Name of the set of this process.
std::string_view instructions();

/// "Intel(R) Xeon(R) ..., 4 processors" as the system has it, for the record of a run; empty if it does not say.
std::string processor_name();

}  // namespace terp
