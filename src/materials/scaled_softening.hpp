// A law that softens, in soil whose bands are one cell wide: the strength follows the plastic strain times h/t_ref, so
// that a slip surface takes the energy of a band of width t_ref, whatever the cell (crack band, decision 0046).
//
//   k += (h/t_ref) d_eps_p,   h = sqrt(V_e) of the cell in which the point lies in this step
//
// Within a step this is the law with its shape factors times h/t_ref, at the strain k t_ref/h: the return stays
// implicit and exact. A point that comes to another cell keeps k, so its strength never rises.
// Not for: h/t_ref of a point (the schemes give it), nor strain that spreads (nonlocal.hpp).
#pragma once

#include "base/tensor.hpp"
#include "materials/material.hpp"
#include "materials/nonlocal.hpp"
#include "parallel/pack.hpp"

#include <array>

namespace terp {

// As in nonlocal.hpp: a law is a type of its own file.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"

/// The law with one state variable more. P: number type of the parameters.
template <template <class> class Law, class P>
struct ScaledLaw {
  using Base = Law<P>;
  static constexpr std::string_view equations = Base::equations;
  static constexpr auto parameters = Base::parameters;
  static constexpr auto derived = Base::derived;
  static constexpr auto state = joined(Base::state,
      std::array{StateInfo{"eps_softening", "-", Averaging::cell,
          "strain that the strength follows, eps_eq_p scaled by cell over reference width", Role::softening}});
  static constexpr std::size_t n_own = Base::state.size(), driver_row = n_own;
  static constexpr std::size_t strain_row = find_role(Base::state, Role::plastic_strain);
  static constexpr bool depends_on_rate = requires { Base::depends_on_rate; };
  static_assert(strain_row < n_own, "a law that softens has a state variable of Role::plastic_strain");
  template <class R>
  using State = std::array<R, n_own + 1>;

  explicit ScaledLaw(std::span<const P> given) : law(given) { std::ranges::copy(given, values.begin()); }

  /// scale: h/t_ref.
  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, State<R>& at, const SymTensor<R, Dim>& d_eps, Real dt, R scale) const
  {
    std::array<R, n_own> own = own_state(at);
    own[strain_row] = at[driver_row] / scale;
    const R before = own[strain_row], work = steepened(scale).update(sigma, own, d_eps, dt);
    const R d_e = own[strain_row] - before;
    own[strain_row] = at[strain_row] + d_e;
    std::ranges::copy(own, at.begin());
    at[driver_row] = at[driver_row] + scale * d_e;
    return work;
  }

  P bulk_modulus() const { return law.bulk_modulus(); }
  P shear_modulus() const { return law.shear_modulus(); }
  P softened_strain() const { return law.softened_strain(); }
  Real derived_value(int number, const State<Real>& at) const
  {
    std::array<Real, n_own> own = own_state(at);
    own[strain_row] = at[driver_row];
    return law.derived_value(number, own);
  }
  std::vector<ParameterProblem> check() const { return law.check(); }

  template <class R>
  static std::array<R, n_own> own_state(const State<R>& at)
  {
    std::array<R, n_own> own;
    std::copy_n(at.begin(), n_own, own.begin());
    return own;
  }

  /// The law with its shape factors times a scale.
  template <class R>
  Law<R> steepened(R scale) const
  {
    std::array<R, parameters.size()> steep;
    for (std::size_t k = 0; k < steep.size(); ++k)
      steep[k] = is_shape_factor(parameters[k]) ? R(values[k]) * scale : R(values[k]);
    return Law<R>(steep);
  }

  Base law;
  std::array<P, parameters.size()> values;
};

#pragma GCC diagnostic pop

/// As the template that a law is.
template <template <class> class Law>
struct ScaledForm {
  template <class P>
  using Type = ScaledLaw<Law, P>;
};

}  // namespace terp
