#include "materials/material_list.hpp"

#include "parallel/instructions.hpp"

#define TERP_KERNEL_SET(set) extern "C" const terp::MaterialList* terp_materials_##set();
TERP_KERNEL_SETS
#undef TERP_KERNEL_SET

namespace terp {

MaterialList materials_of_set(std::size_t set)
{
  const MaterialList* const copies[] = {
#define TERP_KERNEL_SET(set) terp_materials_##set(),
      TERP_KERNEL_SETS
#undef TERP_KERNEL_SET
  };
  return *copies[set];
}

std::span<const MaterialType* const> all_materials() { return materials_of_set(chosen_set()); }

const MaterialType* find_material(std::string_view name)
{
  for (const MaterialType* type : all_materials())
    if (type->name == name) return type;
  return nullptr;
}

}  // namespace terp
