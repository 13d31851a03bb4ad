// What the forms of a law that softens have in common: the tables of the law but for its state, and its moduli.
// Not for: what a form adds to the state (nonlocal.hpp, scaled_softening.hpp).
#pragma once

#include "soil/laws/material.hpp"

#include <algorithm>
#include <array>

namespace terp {

template <class T, std::size_t n, std::size_t m>
constexpr std::array<T, n + m> joined(const std::array<T, n>& a, const std::array<T, m>& b)
{
  std::array<T, n + m> all{};
  std::ranges::copy(b, std::ranges::copy(a, all.begin()).out);
  return all;
}

// A law is a type of its own file, and so is what is made of it; GCC warns of that in a header.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"

/// P: number type of the parameters.
template <template <class> class Law, class P>
struct WrappedLaw {
  using Base = Law<P>;
  static constexpr std::string_view equations = Base::equations;
  static constexpr auto parameters = Base::parameters;
  static constexpr auto derived = Base::derived;
  static constexpr std::size_t n_own = Base::state.size();
  static constexpr std::size_t strain_row = find_role(Base::state, Role::plastic_strain);
  static constexpr bool depends_on_rate = requires { Base::depends_on_rate; };
  static constexpr bool ignores_pressure = [] {
    if constexpr (requires { Base::total_stress; }) return Base::total_stress;
    return false;
  }();
  static_assert(strain_row < n_own, "a law that softens has a state variable of Role::plastic_strain");

  explicit WrappedLaw(std::span<const P> values) : law(values) {}

  P bulk_modulus() const { return law.bulk_modulus(); }
  P shear_modulus() const { return law.shear_modulus(); }
  P softened_strain() const { return law.softened_strain(); }
  std::vector<ParameterProblem> check() const { return law.check(); }

  /// The state of the law itself, which comes first.
  template <class R, std::size_t n>
  static std::array<R, n_own> own_state(const std::array<R, n>& at)
  {
    std::array<R, n_own> own;
    std::copy_n(at.begin(), n_own, own.begin());
    return own;
  }

  Base law;
};

#pragma GCC diagnostic pop

}  // namespace terp
