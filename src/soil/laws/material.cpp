#include "soil/laws/material_list.hpp"

#include "os/instructions.hpp"

#include <cmath>
#include <numbers>

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

Real reduced(Reduction reduction, Real value, Real factor)
{
  constexpr Real degree = std::numbers::pi / 180.0;
  switch (reduction) {
    case Reduction::none:
    case Reduction::zero: return value;
    case Reduction::divide: return value / factor;
    case Reduction::divide_tangent: return std::atan(std::tan(value * degree) / factor) / degree;
  }
  return value;
}

std::vector<Real> MaterialType::complete(std::span<const Real> given) const
{
  std::vector<Real> values(given.begin(), given.end());
  values.resize(parameters.size(), std::numeric_limits<Real>::quiet_NaN());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isnan(values[k]) && parameters[k].fallback) values[k] = *parameters[k].fallback;
    for (std::size_t from = 0; from < k && std::isnan(values[k]); ++from)
      if (parameters[from].name == parameters[k].fallback_of) values[k] = values[from];
  }
  return values;
}

const MaterialType* find_material(std::string_view name, const SofteningOptions& softening, bool tears)
{
  const MaterialType* type = find_material(name);
  if (tears && type != nullptr && type->torn != nullptr) type = type->torn;
  if (type == nullptr || type->nonlocal == nullptr) return type;
  return softening.is_nonlocal() ? type->nonlocal : softening.is_scaled() ? type->scaled : type;
}

}  // namespace terp
