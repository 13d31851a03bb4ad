// The table of one copy of the kernels. CMakeLists.txt compiles this file once per instruction set and names the set.
// No copy may have anything that runs before main: on another machine it would be an illegal instruction.

#include "parallel/kernels.hpp"

#include "materials/material.hpp"
#include "parallel/machine.hpp"
#include "simulation/step.hpp"
#include "simulation/totals.hpp"

#define TERP_JOIN_(a, b) a##b
#define TERP_JOIN(a, b) TERP_JOIN_(a, b)
#define TERP_TEXT_(a) #a
#define TERP_TEXT(a) TERP_TEXT_(a)

namespace terp {

#define TERP_MATERIAL(name) extern const MaterialType material_##name;
#include "materials/materials.def"
#undef TERP_MATERIAL

namespace {

constexpr const MaterialType* materials[] = {
#define TERP_MATERIAL(name) &material_##name,
#include "materials/materials.def"
#undef TERP_MATERIAL
};

constexpr Kernels table{TERP_TEXT(TERP_KERNEL_COPY), materials, &find_compiled_step, &add_up_compiled, &measure_triad,
    &measure_multiply_add};

}  // namespace
}  // namespace terp

extern "C" const terp::Kernels* TERP_JOIN(terp_kernels_, TERP_KERNEL_COPY)();  // parallel/kernels.cpp calls it
extern "C" const terp::Kernels* TERP_JOIN(terp_kernels_, TERP_KERNEL_COPY)() { return &terp::table; }
