// The list of laws in one copy of the kernels: laws, and the steps that call them, are of one copy.

#include "soil/laws/material_list.hpp"
#include "os/kernel_table.hpp"

namespace terp {

#define TERP_MATERIAL(name) extern const MaterialType material_##name;
#include "soil/laws/materials.def"
#undef TERP_MATERIAL

namespace {

constexpr const MaterialType* laws[] = {
#define TERP_MATERIAL(name) &material_##name,
#include "soil/laws/materials.def"
#undef TERP_MATERIAL
};

constexpr MaterialList list{laws};

}  // namespace
}  // namespace terp

TERP_KERNEL_TABLE(materials, MaterialList, list)
