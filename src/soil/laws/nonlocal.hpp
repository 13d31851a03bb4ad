// The nonlocal form of a law that softens: its strength follows a mean of the plastic strain over a distance l, not the
// strain of the point alone, so that a slip surface takes the same energy on any mesh (decision 0045).
//
//   z    = d_eps_p / eps_95 where k < 7/3 eps_95, else 0      increment of the step; eps_95 = softened_strain()
//   zbar = z spread over the distance l                       mpm/features/softening_passes.hpp
//   q   += eps_95 (m zbar + (1 - m) z)                        over-nonlocal strain, 1 <= m <= 2
//   k    = max(k, q); without halo max(k, min(q, eps_p))      drives the strength of the next step
//
// Not for: how far and over which points z is spread.
#pragma once

#include "math/tensor.hpp"
#include "soil/laws/wrapped_law.hpp"
#include "math/pack.hpp"

#include <algorithm>
#include <array>

namespace terp {

/// True for a law that can keep the strengths that it has at some plastic strain.
template <template <class> class Law>
concept Softens = requires(const Law<Real>& law)
{
  law.softened_at(Real{});
};

/// What softening leaves at 7/3 of the strain of 95 %, exp(-7) = 0.1 %, counts as nothing: there the soil ceases to
/// spread its strain. Without this the softened zone grows with slip without end (decision 0045).
inline constexpr Real softened_out = 7.0 / 3.0;

// As in wrapped_law.hpp: a law is a type of its own file.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"

/// The law with three state variables more. P: number type of the parameters.
template <template <class> class Law, class P>
struct NonlocalLaw : WrappedLaw<Law, P> {
  using Wrapped = WrappedLaw<Law, P>;
  using Wrapped::law, Wrapped::n_own, Wrapped::strain_row, Wrapped::Wrapped, typename Wrapped::Base;
  static constexpr auto state = joined(Base::state,
      std::array{StateInfo{"eps_nonlocal", "-", Averaging::cell,
                     "over-nonlocal plastic strain, m mean + (1 - m) eps_eq_p of soil that still softens"},
          StateInfo{"eps_softening", "-", Averaging::cell,
              "strain that the strength follows, largest over-nonlocal plastic strain so far", Role::softening},
          StateInfo{.name = "softening_increment",
              .unit = "-",
              .averaging = Averaging::cell,
              .meaning = "part of its softening that the soil did in this step; below 0 where it cannot soften",
              .scratch = true}});
  static constexpr std::size_t nonlocal_row = n_own, softening_row = n_own + 1, increment_row = n_own + 2;

  P whole = law.softened_strain();  ///< eps_95

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, n_own + 3>& at, const SymTensor<R, Dim>& d_eps, Real dt) const
  {
    const auto may_soften = R(whole) < R(std::numeric_limits<Real>::infinity());
    std::array<R, n_own> own = Wrapped::own_state(at);
    if constexpr (requires { law.stays_elastic(sigma, own, d_eps); }) {
      SymTensor<R, Dim> trial = sigma;
      std::array<R, n_own> driven = own;
      driven[strain_row] = at[softening_row];
      if (law.stays_elastic(trial, driven, d_eps)) {
        sigma = trial;
        at[increment_row] = select(may_soften, R(0.0), R(-1.0));
        return R(0.0);
      }
    }
    const R work = law.softened_at(at[softening_row]).update(sigma, own, d_eps, dt);
    const R part = (own[strain_row] - at[strain_row]) / R(whole);
    const auto softens_on = at[softening_row] < R(softened_out) * R(whole);
    at[increment_row] = select(may_soften, select(softens_on, part, R(0.0)), R(-1.0));
    std::copy_n(own.begin(), n_own, at.begin());
    return work;
  }

  /// spread: zbar of the step.
  template <class R>
  void soften(std::array<R, n_own + 3>& at, R spread, const SofteningOptions& options) const
  {
    const auto may_soften = R(whole) < R(std::numeric_limits<Real>::infinity());
    const R m(options.over_nonlocal);
    const R part = m * spread + (R(1.0) - m) * at[increment_row];
    at[nonlocal_row] =
        select(may_soften, at[nonlocal_row] + R(options.band_scale()) * (R(whole) * part), at[nonlocal_row]);
    const R now = options.halo ? at[nonlocal_row] : min(at[nonlocal_row], R(options.band_scale()) * at[strain_row]);
    at[softening_row] = max(at[softening_row], now);
  }

  Real derived_value(int number, const std::array<Real, n_own + 3>& at) const
  {
    return law.softened_at(at[softening_row]).derived_value(number, Wrapped::own_state(at));
  }
};

#pragma GCC diagnostic pop

/// As the template that a law is.
template <template <class> class Law>
struct NonlocalForm {
  template <class P>
  using Type = NonlocalLaw<Law, P>;
};

}  // namespace terp
