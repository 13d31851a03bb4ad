// What laws with a limit of tension share: its parameter, the opening of soil that has come apart, and strain and work
// of a return in principal stresses. Not for: the surface itself (mohr_coulomb_return.hpp).
#pragma once

#include "soil/laws/material.hpp"
#include "soil/laws/principal.hpp"
#include "soil/laws/wrapped_law.hpp"

#include <array>
#include <limits>

namespace terp {

inline constexpr ParameterInfo tension_cutoff_info{.name = tension_cutoff,
    .unit = "Pa",
    .range = not_negative,
    .typical = 5e3,
    .meaning = "largest principal stress, tension positive; 0: soil that cracks; without it there is no limit",
    .fallback = std::numeric_limits<Real>::infinity(),
    .reduction = Reduction::divide,
    .may_vary = true};

inline constexpr StateInfo opening_info{
    "opening", "-", Averaging::cell, "volume strain by which the soil has come apart", Role::opening};

/// The state of a law, with an opening where it tears.
template <bool tears, std::size_t n>
constexpr auto with_opening(const std::array<StateInfo, n>& state)
{
  if constexpr (tears)
    return joined(state, std::array{opening_info});
  else
    return state;
}

/// sqrt(1/2 dev:dev) of a tensor with these principal values.
template <class R>
R shear_norm(R a, R b, R c)
{
  const R ab = a - b, bc = b - c, ca = c - a;
  return sqrt((ab * ab + bc * bc + ca * ca) * R(1.0 / 6.0));
}

/// The part of a return in Eq. (6).
template <class R, class P>
R strain_of_return(const Sorted<R>& trial, const Sorted<R>& s, P shear)
{
  return shear_norm(trial.major - s.major, trial.middle - s.middle, trial.minor - s.minor) * R(0.5 / shear);
}

/// sigma : d_eps_p of a return [J/m^3]; never negative, but for round-off.
template <class R, class P>
R work_of_return(const Sorted<R>& trial, const Sorted<R>& s, P bulk, P shear)
{
  const R p = (s.major + s.middle + s.minor) * R(1.0 / 3.0);
  const R a = trial.major - s.major, b = trial.middle - s.middle, c = trial.minor - s.minor;
  const R by_shear = (s.major - p) * a + (s.middle - p) * b + (s.minor - p) * c;
  return max(R(0.0), by_shear * R(0.5 / shear) + p * (a + b + c) * R(1.0 / (3.0 * bulk)));
}

/// Exact where all three are equal.
template <class R, int Dim>
R mean_of_direct(const SymTensor<R, Dim>& sigma)
{
  return sigma[0] + ((sigma[1] - sigma[0]) + (sigma[2] - sigma[0])) * R(1.0 / 3.0);
}

/// The opening of soil whose principal stresses all meet the limit, which they are given to the bit; 0 elsewhere.
/// slack: round-off of a stress that was returned and rebuilt [Pa].
template <class R, class P>
R come_apart(const Sorted<R>& trial, R tension, R slack, P bulk, Sorted<R>& s)
{
  const auto apart = s.minor >= tension - slack;
  s = select(apart, Sorted<R>{tension, tension, tension}, s);
  const R beyond = (trial.major + trial.middle + trial.minor) * R(1.0 / 3.0) - tension;
  return select(apart, max(R(0.0), beyond * R(1.0 / bulk)), R(0.0));
}

/// Soil that has come apart carries no more tension than before, none as soon as it closes, and no pressure before it
/// has closed. sigma: with the elastic stress of the step. before: mean stress at its start. Returns the plastic work
/// per volume.
template <class R, int Dim, class P>
R close_opening(SymTensor<R, Dim>& sigma, R& opening, R before, R volumetric, R tension, P bulk)
{
  const R held = select(volumetric < R(0.0), R(0.0), min(max(before, R(0.0)), tension));
  const R closed = before + R(bulk) * (opening + volumetric);  // mean stress if the opening were closed by stress
  const auto was_open = opening > R(0.0);
  const auto stays_open = was_open & (closed > held);
  for (int k = 0; k < 3; ++k)
    sigma[k] = select(stays_open, held, select(was_open, sigma[k] + R(bulk) * opening, sigma[k]));
  for (int k = 3; k < n_sym<Dim>; ++k) sigma[k] = select(stays_open, R(0.0), sigma[k]);
  opening = select(stays_open, opening + volumetric + (before - held) * R(1.0 / bulk), R(0.0));
  return select(stays_open, held * volumetric, R(0.0));
}

}  // namespace terp
