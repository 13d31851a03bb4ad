// A law with its parameters under the user's name, where its points keep its numbers, and what they are asked for by
// role: their plastic strain and their strength, whatever the law calls them. Not for: the law itself (material.hpp).
#pragma once

#include "soil/laws/material.hpp"
#include "mpm/points/point_blocks.hpp"

#include <algorithm>

namespace terp {

struct SoilMaterial {
  std::string name;  ///< the user's: "clay"
  const MaterialType* type = nullptr;
  std::shared_ptr<const Material> law;
  Real density = 0.0;     ///< rho at t = 0 [kg/m^3]
  std::vector<int> rows;  ///< of the points: state variables, then parameters that vary, each in the order of the table
  SofteningOptions softening = {};
  bool stores_effective = false;           ///< effective stress where there is water, else total stress
  std::vector<Real> softening_scale = {};  ///< h/t_ref by cell, shape [n_cells]; empty: 1
  bool is_ground = true;                   ///< what a slope or dike is made of: neither water nor a load
  int increment_row = -1;         ///< of the points: what they softened in this step; -1: by themselves, or not at all
  int excess_row = -1;            ///< of the points: excess pore pressure; -1: no soil of the case has any
  Real flip = 1.0;                ///< share of FLIP in the velocity of its points
  bool ignores_pressure = false;  ///< its strength does not follow the mean stress: by its law, or without friction
  Real water_stiffness = 0.0;     ///< K_w/n of undrained soil that stores effective stress; 0: of all other soil [Pa]

  /// Water enters and leaves as its volume changes.
  bool is_drained() const { return stores_effective && water_stiffness == 0.0; }
  int n_state() const { return static_cast<int>(type->state.size()); }
  int n_rows() const { return static_cast<int>(rows.size()); }
  bool varies() const { return n_rows() > n_state(); }
  /// Rows of numbers of which row r begins at data + r * stride, as the law takes them.
  LawRows view(Real* data, std::ptrdiff_t stride) const
  {
    return {{data, stride, rows.data()}, {data, stride, rows.data() + n_state()}};
  }
  /// Of one point.
  LawRows view(const PointBlock<2>& block, Index lane) const { return view(block.data + lane, block.capacity); }
};

/// The row of a parameter that varies.
RowInfo row_of_parameter(const ParameterInfo& parameter);

/// The row of the excess pore pressure.
RowInfo row_of_excess_pressure();

/// Adds the rows of a law to the table and enters them in the material, whose number is `number`.
void add_rows(Index number, SoilMaterial& material, RowTable& table);
/// The same with the row of the excess pore pressure.
void add_excess_row(Index number, SoilMaterial& material, RowTable& table);

/// Stress of a point [Pa].
inline SymTensor<Real, 2> stress_at(const PointBlock<2>& block, Index lane)
{
  SymTensor<Real, 2> sigma;
  for (int k = 0; k < n_sym<2>; ++k) sigma[k] = block.row(Rows::sigma + k)[lane];
  return sigma;
}

/// Row of the points that holds the state variable with a role; -1: the law has none, or no body is of the material.
inline int row_of(const SoilMaterial& material, Role role)
{
  const int k = find_role(material.type->state, role);
  return k < 0 || material.rows.empty() ? -1 : material.rows[static_cast<std::size_t>(k)];
}

/// Role of the state variable that the strength follows.
inline Role driver_of_strength(const SoilMaterial& material)
{
  return find_role(material.type->state, Role::softening) >= 0 ? Role::softening : Role::plastic_strain;
}

/// False: the law is elastic.
inline bool can_yield(const SoilMaterial& material)
{
  return material.type->by_library || !material.type->state.empty() || material.type->depends_on_rate;
}

/// True if the law has a strength, as a derived field or as a state variable.
inline bool has_strength(const SoilMaterial& material)
{
  return find_role(material.type->derived, Role::strength) >= 0 || find_role(material.type->state, Role::strength) >= 0;
}

/// True if the strength is a function of the plastic strain alone: it need not be remembered beside it.
inline bool strain_gives_strength(const SoilMaterial& material)
{
  const auto& state = material.type->state;
  return find_role(state, Role::plastic_strain) == 0 &&
         std::ranges::all_of(state.subspan(1), [](const StateInfo& s) { return s.role == Role::opening; });
}

/// Strength of a point of a law that has_strength() [Pa].
inline Real strength_of(const SoilMaterial& material, const PointBlock<2>& block, Index lane)
{
  const int row = row_of(material, Role::strength);
  if (row >= 0) return block.row(row)[lane];
  return material.law->derived(find_role(material.type->derived, Role::strength), material.view(block, lane));
}

/// The strength that the same point would have at another value of what it follows, its other state variables as at the
/// start [Pa].
Real strength_at(const SoilMaterial& material, const PointBlock<2>& block, Index lane, Real strain);

}  // namespace terp
