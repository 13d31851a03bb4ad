// The copies of the list of laws, one per instruction set. Not for: users of laws (all_materials in material.hpp).
#pragma once

#include "soil/laws/material.hpp"

namespace terp {

/// Laws in the order of materials.def.
using MaterialList = std::span<const MaterialType* const>;

/// Every law in this build, compiled for set number `set` of instruction_sets() (os/instructions.hpp).
MaterialList materials_of_set(std::size_t set);

}  // namespace terp
