// Soil of tresca_softening and its strength, for the tests of the law and of the rate.
#pragma once

#include "soil/laws/probe.hpp"

namespace terp::test {

struct Soil {
  Real G = 2e6, nu = 0.48, su_peak = 8e3, su_residual = 2e3, eta = 50.0;  // the paper's, model 2
  Real su_remoulded = std::nan(""), eta_remoulding = 0.0;                 // by default su_residual
  Real rate_mu = 0.0, rate_ref = INFINITY;
  Real dt = 1e-3;  // of a step [s]

  std::vector<Real> parameters() const
  {
    const std::vector<Real> given{G, nu, su_peak, su_residual, eta, su_remoulded, eta_remoulding, rate_mu, rate_ref};
    return find_material("tresca_softening")->complete(given);
  }
  Probe probe() const
  {
    Probe point(*find_material("tresca_softening"), parameters());
    point.dt = dt;
    return point;
  }
  /// Strength at slow rates.
  Real su(Real eps_eq_p) const
  {
    const Real last = std::isnan(su_remoulded) ? su_residual : su_remoulded;
    return last + (su_residual - last) * std::exp(-eta_remoulding * eps_eq_p) +
           (su_peak - su_residual) * std::exp(-eta * eps_eq_p);
  }
  Real su_after(Real e, Real d) const
  {
    return su(e + d) * (1.0 + (rate_mu > 0.0 ? rate_mu * std::log10(std::max(1.0, d / dt / rate_ref)) : 0.0));
  }
};

}  // namespace terp::test
