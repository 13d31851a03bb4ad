#include "materials/material.hpp"

#include "parallel/kernels.hpp"

namespace terp {

std::span<const MaterialType* const> all_materials() { return kernels().materials; }

const MaterialType* find_material(std::string_view name)
{
  for (const MaterialType* type : all_materials())
    if (type->name == name) return type;
  return nullptr;
}

}  // namespace terp
