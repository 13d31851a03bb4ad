#include "materials/material.hpp"

namespace terp {

#define TERP_MATERIAL(name) extern const MaterialType material_##name;
#include "materials/materials.def"
#undef TERP_MATERIAL

std::span<const MaterialType* const> all_materials()
{
  static const MaterialType* const list[] = {
#define TERP_MATERIAL(name) &material_##name,
#include "materials/materials.def"
#undef TERP_MATERIAL
  };
  return list;
}

const MaterialType* find_material(std::string_view name)
{
  for (const MaterialType* type : all_materials())
    if (type->name == name) return type;
  return nullptr;
}

}  // namespace terp
