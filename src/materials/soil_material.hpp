// A law with its parameters under the user's name, and what its points are asked for by role: their plastic strain and
// their strength, whatever the law calls them. Not for: the law itself (material.hpp).
#pragma once

#include "materials/material.hpp"
#include "points/point_blocks.hpp"

namespace terp {

struct SoilMaterial {
  std::string name;  ///< the user's: "clay"
  const MaterialType* type = nullptr;
  std::unique_ptr<Material> law;
  Real density = 0.0;  ///< rho at t = 0 [kg/m^3]
  int n_state() const { return static_cast<int>(type->state.size()); }
};

/// Row of the points that holds the state variable with a role; -1: the law has none.
inline int row_of(const SoilMaterial& material, Role role)
{
  const int k = find_role(material.type->state, role);
  return k < 0 ? -1 : PointRows<2>::state + k;
}

/// True if the law has a derived field that is the strength.
inline bool has_strength(const SoilMaterial& material)
{
  return find_role(material.type->derived, Role::strength) >= 0;
}

/// True if the strength is a function of the plastic strain alone: it need not be remembered beside it.
inline bool strain_gives_strength(const SoilMaterial& material)
{
  return material.n_state() == 1 && find_role(material.type->state, Role::plastic_strain) == 0;
}

/// Strength of a point of a law that has_strength() [Pa].
inline Real strength_of(const SoilMaterial& material, const PointBlock<2>& block, Index lane)
{
  std::array<Real, max_state> values{};
  for (int k = 0; k < material.n_state(); ++k) values[k] = block.row(PointRows<2>::state + k)[lane];
  return material.law->derived(find_role(material.type->derived, Role::strength), values.data());
}

/// The strength that the same point would have at another plastic strain, its other state variables as at the start
/// [Pa].
inline Real strength_at(const SoilMaterial& material, const PointBlock<2>&, Index, Real plastic_strain)
{
  std::array<Real, max_state> values{};
  if (const int k = find_role(material.type->state, Role::plastic_strain); k >= 0) values[k] = plastic_strain;
  return material.law->derived(find_role(material.type->derived, Role::strength), values.data());
}

}  // namespace terp
