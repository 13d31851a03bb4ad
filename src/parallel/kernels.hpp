// The kernels: the code that is compiled once per instruction set, behind one table per set. Which set runs is chosen
// when the program starts, by what the processor offers (decision 0028).
// Not for: what the kernels compute. Their files know nothing of sets; CMakeLists.txt lists them.
#pragma once

#include "base/types.hpp"

#include <span>
#include <stdexcept>
#include <string_view>

namespace terp {

struct MaterialType;  // of rooms to the right: known here by name only
struct Model;
struct State;
struct Workspace;
class Threads;
struct Totals;
struct Columns;

/// One step of one scheme (simulation/step.hpp).
using StepFunction = void (*)(const Model&, State&, Workspace&);

/// What one copy of the kernels offers. Laws and steps of one copy go together.
struct Kernels {
  std::string_view instructions;                       ///< name of the set
  std::span<const MaterialType* const> materials;      ///< in the order of materials.def
  StepFunction (*find_step)(std::string_view scheme);  ///< nullptr if there is no such scheme
  Totals (*add_up)(
      const Model&, State&, Threads&, Real moved_distance, std::span<const Columns> shear);  ///< simulation/totals.hpp
  double (*measure_triad)(std::size_t bytes);                                                ///< machine.hpp
  double (*measure_multiply_add)();
};

/// A set of instructions that this program was compiled for.
struct InstructionSet {
  std::string_view name;  ///< "avx512", "avx2", "sse2"; "native" or "plain" in a build with a single set
  bool offered = false;   ///< by this processor and its operating system
  const Kernels* kernels = nullptr;
};

/// TERP_INSTRUCTIONS asks for what cannot be had.
class InstructionsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Every set in this build, the best first.
std::span<const InstructionSet> instruction_sets();

/// The set called `word`, or the first that is offered if `word` is empty. Throws InstructionsError.
const InstructionSet& choose_instructions(std::span<const InstructionSet> sets, std::string_view word);

/// The kernels of this process: those that the environment variable TERP_INSTRUCTIONS names, or the best. The choice is
/// made at the first call and stays. Throws InstructionsError.
const Kernels& kernels();

}  // namespace terp
