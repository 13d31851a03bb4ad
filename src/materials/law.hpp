// Turns one law, a small struct with a pointwise update, into a MaterialType: the loop over packs, the factory and
// the checks that every law shares. A law's file includes this; nobody else does.
#pragma once

#include "base/tensor.hpp"
#include "materials/material.hpp"
#include "parallel/pack.hpp"

namespace terp {

/// A law in the form that the rest of Terp calls.
///
/// Law has: static constexpr std::string_view `equations`; static constexpr tables `parameters` (ParameterInfo[]),
/// `state` (StateInfo[]) and `derived` (DerivedInfo[]), as std::array; `explicit Law(std::span<const Real>)`;
/// bulk_modulus(), shear_modulus(), derived_value(k, state); template <class R, int Dim> R update(SymTensor<R, Dim>&
/// sigma, std::array<R, n>& state, const SymTensor<R, Dim>& d_eps, Real dt) const, which returns the plastic or viscous
/// work per volume [J/m^3]. A law whose stress depends on the rate has viscosity() too.
template <class Law>
class MaterialOf final : public Material {
 public:
  explicit MaterialOf(std::span<const Real> values) : law_(values) {}

  void update(const StressArrays<2>& arrays) const override
  {
    for (Index p = 0; p < arrays.n; p += pack_width) update_pack(arrays, p);
  }
  Real bulk_modulus() const override { return law_.bulk_modulus(); }
  Real shear_modulus() const override { return law_.shear_modulus(); }
  Real viscosity() const override
  {
    if constexpr (requires { law_.viscosity(); }) return law_.viscosity();
    return 0.0;
  }
  Real derived(int k, const Real* state) const override { return law_.derived_value(k, state); }
  const Law& law() const { return law_; }

 private:
  void update_pack(const StressArrays<2>& arrays, Index p) const
  {
    SymTensor<Pack, 2> sigma, d_eps;
    std::array<Pack, Law::state.size()> state;
    for (int k = 0; k < n_sym<2>; ++k) sigma[k] = Pack::load(arrays.sigma[k] + p);
    for (int k = 0; k < n_sym<2>; ++k) d_eps[k] = Pack::load(arrays.d_eps[k] + p);
    for (std::size_t k = 0; k < state.size(); ++k) state[k] = Pack::load(arrays.state[k] + p);
    const Pack work = law_.update(sigma, state, d_eps, arrays.dt);
    for (int k = 0; k < n_sym<2>; ++k) sigma[k].store(arrays.sigma[k] + p);
    for (std::size_t k = 0; k < state.size(); ++k) state[k].store(arrays.state[k] + p);
    work.store(arrays.plastic_work + p);
  }

  Law law_;
};

template <class Law>
std::vector<ParameterProblem> check_law(std::span<const Real> values)
{
  return Law(values).check();
}

template <class Law>
std::unique_ptr<Material> make_law(std::span<const Real> values)
{
  return std::make_unique<MaterialOf<Law>>(values);
}

}  // namespace terp

/// Defines `material_NAME`, which materials.def lists.
#define TERP_MATERIAL_DEFINITION(name, Law, summary) \
  extern const MaterialType material_##name;         \
  const MaterialType material_##name{                \
      #name, summary, Law::equations, Law::parameters, Law::state, Law::derived, &check_law<Law>, &make_law<Law>};
