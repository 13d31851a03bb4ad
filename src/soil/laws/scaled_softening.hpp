// A law that softens, in soil whose bands are one cell wide: the strength follows the plastic strain times h/t_ref, so
// that a slip surface takes the energy of a band of width t_ref, whatever the cell (crack band, decision 0046).
//
//   k += (h/t_ref) d_eps_p,   h = sqrt(V_e) of the cell in which the point lies in this step
//
// Within a step this is the law with its shape factors times h/t_ref, at the strain k t_ref/h: the return stays
// implicit and exact. A point that comes to another cell keeps k, so its strength never rises.
// Not for: h/t_ref of a point (the schemes give it), nor strain that spreads (nonlocal.hpp).
#pragma once

#include "math/tensor.hpp"
#include "soil/laws/wrapped_law.hpp"
#include "math/pack.hpp"

#include <array>

namespace terp {

// As in wrapped_law.hpp: a law is a type of its own file.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"

/// The law with one state variable more. P: number type of the parameters.
template <template <class> class Law, class P>
struct ScaledLaw : WrappedLaw<Law, P> {
  using Wrapped = WrappedLaw<Law, P>;
  using Wrapped::law, Wrapped::n_own, Wrapped::own_state, Wrapped::parameters, Wrapped::strain_row,
      typename Wrapped::Base;
  static constexpr auto state = joined(Base::state,
      std::array{StateInfo{"eps_softening", "-", Averaging::cell,
          "strain that the strength follows, eps_eq_p scaled by cell over reference width", Role::softening}});
  static constexpr std::size_t driver_row = n_own;
  template <class R>
  using State = std::array<R, n_own + 1>;

  explicit ScaledLaw(std::span<const P> given) : Wrapped(given) { std::ranges::copy(given, values.begin()); }

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

  Real derived_value(int number, const State<Real>& at) const
  {
    std::array<Real, n_own> own = own_state(at);
    own[strain_row] = at[driver_row];
    return law.derived_value(number, own);
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
