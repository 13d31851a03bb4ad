// The table of one copy of the kernels. cmake/kernels.cmake compiles this file once per instruction set and names the
// set. No copy may have anything that runs before main: on another machine it would be an illegal instruction.

#include "os/kernel_table.hpp"

#include "os/machine.hpp"
#include "mpm/step/kernels.hpp"

#define TERP_TEXT_(a) #a
#define TERP_TEXT(a) TERP_TEXT_(a)

namespace terp {
namespace {

constexpr Kernels table{TERP_TEXT(TERP_KERNEL_COPY), &step_compiled, &find_forces_compiled, &strain_compiled,
    &score_compiled, &add_up_compiled, &measure_triad, &measure_multiply_add};

}  // namespace
}  // namespace terp

TERP_KERNEL_TABLE(simulation, Kernels, table)
