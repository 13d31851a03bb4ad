// Weakly compressible viscous fluid: pressure from the change of volume, shear stress from the rate of shear.
//
//   sigma = p I + 2 mu dev(d_eps) / dt,   dp = K tr(d_eps),   p <= tension_cutoff      tension positive
//
// A fluid that would be pulled beyond the limit tears: the volume strain by which it has opened is kept, and pressure
// returns only when it has closed again. So spray that falls back has the volume it had.

#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/law.hpp"

namespace terp {
namespace {

template <class P>
struct NewtonianFluid {
  static constexpr std::string_view equations =
      "sigma   = p I + 2 mu dev(d_eps)/dt                     no shear stress at rest, nor where the fluid has torn\n"
      "p       = min(p + K (opening + tr(d_eps)), tension_cutoff)\n"
      "opening = what this takes away from K tr(d_eps), over K: closes before pressure returns\n"
      "c = sqrt(K/rho). For a flow that water would do, K = rho (10 v)^2 or more with v the largest speed keeps "
      "changes of\n"
      "density near 1 % and the time step a hundredth of water's. The time step also heeds the viscosity "
      "(docs/methods.md).\n"
      "At rest the stress must be hydrostatic: initial.stress = \"k0\" with k0 = 1, its default, or \"equilibrium\".\n";
  static constexpr std::array parameters{
      ParameterInfo{.name = "bulk_modulus",
          .unit = "Pa",
          .range = positive,
          .typical = 2e6,
          .meaning = "bulk modulus K = rho c^2, c the speed of sound",
          .usual = between(1e2, 1e10),
          .strain_exponent = 1.0},
      ParameterInfo{.name = "viscosity",
          .unit = "Pa s",
          .range = not_negative,
          .typical = 300.0,
          .meaning = "dynamic viscosity mu; that of water is 0.001",
          .fallback = 0.0,
          .usual = between(1e-6, 1e6),
          .strain_exponent = 0.5},
      ParameterInfo{.name = "tension_cutoff",
          .unit = "Pa",
          .range = not_negative,
          .typical = 5e3,
          .meaning = "largest tension before the fluid tears; inf: it never does",
          .fallback = 0.0},
  };
  static constexpr std::array state{
      StateInfo{"opening", "-", Averaging::cell, "volume strain by which the fluid has torn open"},
  };
  static constexpr std::array<DerivedInfo, 0> derived{};
  static constexpr bool total_stress = true;
  static constexpr bool depends_on_rate = true;
  static constexpr std::string_view not_judged =
      "a fluid has no strength: it flows under any shear stress, however small, and no factor makes it stand";

  explicit NewtonianFluid(std::span<const P> v) : bulk(v[0]), mu(v[1]), tension_cutoff(v[2]) {}

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, 1>& state, const SymTensor<R, Dim>& d_eps, Real dt) const
  {
    constexpr Real third = 1.0 / 3.0;
    const R before =
        sigma[0] + ((sigma[1] - sigma[0]) + (sigma[2] - sigma[0])) * R(third);  // exact where all three are equal
    const R volumetric = trace(d_eps), strain = state[0] + volumetric, mean = volumetric * R(third);
    const R whole = before + R(bulk) * strain;
    const auto torn = whole > R(tension_cutoff);
    const R pressure = select(torn, R(tension_cutoff), whole);
    state[0] = select(torn, strain + (before - pressure) * R(1.0 / bulk), R(0.0));

    const R twice_mu_per_dt = select(torn, R(0.0), R(2.0 * mu / dt));
    SymTensor<R, Dim> shear_strain = d_eps;
    add_isotropic(shear_strain, -mean);
    for (int k = 0; k < n_sym<Dim>; ++k) sigma[k] = twice_mu_per_dt * shear_strain[k];
    const R dissipated = double_dot(sigma, shear_strain);
    add_isotropic(sigma, pressure);
    return dissipated;
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return P(0.0); }
  P viscosity() const { return mu; }

  P bulk;            // K [Pa]
  P mu;              // [Pa s]
  P tension_cutoff;  // [Pa]
};

}  // namespace

TERP_MATERIAL_DEFINITION(newtonian_fluid, NewtonianFluid, "weakly compressible viscous fluid that tears under tension")

}  // namespace terp
