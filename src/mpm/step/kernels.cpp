#include "mpm/step/kernels.hpp"

#include "os/instructions.hpp"

#define TERP_KERNEL_SET(set) extern "C" const terp::Kernels* terp_simulation_##set();
TERP_KERNEL_SETS
#undef TERP_KERNEL_SET

namespace terp {

const Kernels& kernels_of_set(std::size_t set)
{
  const Kernels* const copies[] = {
#define TERP_KERNEL_SET(set) terp_simulation_##set(),
      TERP_KERNEL_SETS
#undef TERP_KERNEL_SET
  };
  return *copies[set];
}

const Kernels& kernels() { return kernels_of_set(chosen_set()); }

}  // namespace terp
