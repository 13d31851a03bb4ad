// Modified Cam-Clay (Roscoe and Burland 1968) in effective stress: clay and peat whose strength and stiffness follow
// from their stress and from the largest stress that they have carried.
//
//   J^2 = sin^2(phi) p' (p_c - p')      yield surface; J^2 = 1/2 s:s, p' pressure positive
//   dp' = K de_v,e,  K = p'/kappa*      kappa* = kappa/(1 + e0), lambda* alike
//   dp_c = p_c de_v,p/(lambda* - kappa*)
//
// Flow is associated. M = sqrt(3) sin(phi): at the critical state of plane strain, where no strain along z makes
// sigma_zz the mean, phi is then the friction angle of Mohr's circle (decision 0053).
//
// Implicit return. One equation in the plastic volume strain e of the step, on an interval whose ends have different
// signs whatever the stress; unique where the soil hardens. p' and p_c of an e are exact, not rates.

#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/law.hpp"
#include "math/functions.hpp"

#include <fmt/format.h>

#include <numbers>

namespace terp {
namespace {

/// A starting stress may lie outside the yield surface by this part of p_c: sums and digits of the case file.
constexpr Real start_slack = 1e-3;

constexpr ParameterInfo compression_info(std::string_view name, Real typical, Range usual, std::string_view meaning)
{
  return {.name = name,
      .unit = "-",
      .range = positive,
      .typical = typical,
      .meaning = meaning,
      .usual = usual,
      .strain_exponent = -1.0,
      .may_vary = true};
}

constexpr ParameterInfo drained_poisson_ratio()
{
  ParameterInfo info = poisson_ratio_info;
  info.typical = 0.2;
  info.meaning = "Poisson's ratio of the drained soil";
  return info;
}

/// dp'/dz = p' between two mean stresses, constant below and above: z is 1 + ln(p'/least) between them, linear beyond.
/// One function over all stresses, tension too.
template <class P>
struct LogPressure {
  P least, most;  ///< [Pa]
  P span;         ///< ln(most/least)

  LogPressure(P least_, P most_) : least(least_), most(most_), span(logarithm(most_ / least_)) {}

  template <class R>
  R within(R p) const
  {
    return min(max(p, R(least)), R(most));
  }
  template <class R>
  R z_of(R p) const
  {
    const R between = R(1.0) + logarithm(within(p) / R(least));
    return select(p < R(least), p / R(least), select(p > R(most), R(span) + p / R(most), between));
  }
  template <class R>
  R p_of(R z) const
  {
    const R linear = z - R(span), between = R(least) * exponential(z - R(1.0));
    return select(z < R(1.0), R(least) * z, select(linear > R(1.0), R(most) * linear, between));
  }
  /// Integral of p' dz from no stress on.
  template <class R>
  R energy(R p) const
  {
    const R half_least(0.5 * least), beyond = max(p, R(most));
    const R above = within(p) - half_least + (beyond * beyond - R(most) * R(most)) * R(0.5 / most);
    return select(p < R(least), p * p * R(0.5 / least), above);
  }
};

template <class P>
struct ModifiedCamClay {
  static constexpr std::string_view equations =
      "J^2 = sin^2(phi) p' (p_c - p')      yield surface in effective stress; J^2 = 1/2 s:s, p' = -tr(sigma')/3\n"
      "flow associated; critical state J = sin(phi) p' at p' = p_c/2, which is Mohr-Coulomb's in plane strain\n"
      "d_p'  = p'/kappa* d_eps_v_e,  kappa* = kappa/(1 + void_ratio);  G by poisson_ratio\n"
      "d_p_c = p_c/(lambda* - kappa*) d_eps_v_p;  ln(v) falls by lambda* for each ln(p') along a normal compression\n"
      "p_c at the start = yield_stress ((3 - 2 sin(phi))/3 + 1/(3 - 2 sin(phi))), of the stress yield_stress with\n"
      "                   K0 = 1 - sin(phi) beside it; yield_stress = { ocr = 1.3 } or { pop = 15e3 } by the "
      "overburden\n"
      "Below smallest_mean_stress the stiffness is that at it; p_c does not fall below it. No tension: p' >= 0.\n"
      "Drained, or with drainage = \"undrained_effective\". docs/cam_clay.md.\n";
  static constexpr std::array parameters{
      ParameterInfo{.name = "friction_angle",
          .unit = "deg",
          .range = {0.0, 60.0, true, false},
          .typical = 25.0,
          .meaning = "friction angle of the critical state in plane strain; sin(phi) = M/sqrt(3)",
          .usual = between(10.0, 45.0),
          .may_vary = true},
      compression_info("lambda", 0.2, between(0.01, 3.0),
          "slope of the normal compression line, fall of the void ratio for each ln(p')"),
      compression_info("kappa", 0.04, between(0.001, 0.5), "the same of unloading; at most 0.9 lambda"),
      ParameterInfo{.name = "void_ratio",
          .unit = "-",
          .range = not_negative,
          .typical = 1.1,
          .meaning = "void ratio e0 at the start; 0 where lambda and kappa are those of natural strain",
          .usual = between(0.0, 15.0),
          .may_vary = true},
      drained_poisson_ratio(),
      ParameterInfo{.name = "yield_stress",
          .unit = "Pa",
          .range = positive,
          .typical = 60e3,
          .meaning = "vertical yield stress sigma'_p at the start, from which p_c follows",
          .usual = between(1e3, 1e7),
          .may_vary = true},
      ParameterInfo{.name = "largest_mean_stress",
          .unit = "Pa",
          .range = positive,
          .typical = 400e3,
          .meaning = "largest p' that the soil will meet: the time step holds for it, and K grows no further beyond",
          .usual = between(1e4, 1e7)},
      ParameterInfo{.name = "smallest_mean_stress",
          .unit = "Pa",
          .range = positive,
          .typical = 2e3,
          .meaning = "p' below which K falls no further; least p_c",
          .fallback = 1e3,
          .usual = between(100.0, 1e5)},
  };
  static constexpr std::array state{
      StateInfo{"eps_eq_p", "-", Averaging::cell, "accumulated equivalent plastic strain, sum sqrt(1/2 de_p : de_p)",
          Role::plastic_strain},
      StateInfo{"hardening", "-", Averaging::cell, "ln of p_c over p_c at the start", Role::carried_pressure},
  };
  static constexpr std::array derived{
      DerivedInfo{"p_c", "Pa", "preconsolidation pressure, p' where the yield surface ends", Role::carried_pressure},
  };
  static constexpr std::string_view not_judged =
      "its strength follows from the stress path, and reducing its friction would change its yield stress, too";

  explicit ModifiedCamClay(std::span<const P> v)
      : sin_phi(sine(v[0] * (std::numbers::pi / 180.0))),
        kappa(v[2] / (1.0 + v[3])),
        plastic((v[1] - v[2]) / (1.0 + v[3])),
        shear_over_bulk(1.5 * (1.0 - 2.0 * v[4]) / (1.0 + v[4])),
        start_p_c(v[5] * ((3.0 - 2.0 * sin_phi) * (1.0 / 3.0) + 1.0 / (3.0 - 2.0 * sin_phi))),
        pressure(v[7], v[6]),
        least_hardening(logarithm(v[7] / start_p_c))
  {
  }

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, 2>& at, const SymTensor<R, Dim>& d_eps, Real) const
  {
    const R compression = -trace(d_eps), p = -mean(sigma);
    const R z = pressure.z_of(p) + compression / R(kappa);
    const R p_trial = pressure.p_of(z);
    // The mean of both ends: a strain and its reverse lead back to the same stress.
    const R G = (pressure.within(p) + pressure.within(p_trial)) * R(0.5 * shear_over_bulk / kappa);
    const R shared = compression * R(1.0 / 3.0), d_p = select(abs(compression) > R(0.0), p_trial - p, R(0.0));
    SymTensor<R, Dim> s = sigma;  // the trial stress without the change of pressure, then its deviator
    for (int k = 0; k < n_sym<Dim>; ++k) {
      s[k] = sigma[k] + R(2.0) * G * (k < 3 ? d_eps[k] + shared : d_eps[k]);
      sigma[k] = k < 3 ? s[k] - d_p : s[k];
    }
    add_isotropic(s, -mean(s));
    const R J = sqrt(double_dot(s, s) * R(0.5));
    const auto yields = is_outside(p_trial, J, p_c_at(at[1]));
    if (!any_of(yields)) return R(0.0);

    const Returned<R> to = return_to_surface(Trial<R>{z, p_trial, J, G, at[1]}, yields);
    const R J_1 = min(J, R(sin_phi) * sqrt(max(R(0.0), to.p * (to.p_c - to.p))));
    const R share = J_1 / max(J, R(tiny)), d_e = (J - J_1) / (R(2.0) * G);
    for (int k = 0; k < n_sym<Dim>; ++k)
      sigma[k] = select(yields, k < 3 ? s[k] * share - to.p : s[k] * share, sigma[k]);
    at[0] = select(yields, at[0] + d_e, at[0]);
    at[1] = select(yields, to.hardening, at[1]);
    return select(yields, max(R(0.0), to.p * to.e + R(2.0) * J_1 * d_e), R(0.0));
  }

  template <class R, int Dim>
  static R mean(const SymTensor<R, Dim>& a)
  {
    return trace(a) * R(1.0 / 3.0);
  }

  template <class R>
  R p_c_at(R hardening) const
  {
    return R(start_p_c) * exponential(hardening);
  }

  /// Beyond the round-off of a stress that was returned and put together again. p' is a mean of numbers as large as J.
  template <class R>
  auto is_outside(R p, R J, R p_c) const
  {
    const R square(sin_phi * sin_phi), slack = R(1e-12) * (J * J + square * p_c * (abs(p) + J));
    return J * J - square * p * (p_c - p) > slack;
  }

  /// The elastic stress of the step. hardening: at its start.
  template <class R>
  struct Trial {
    R z, p, J, G, hardening;
  };
  template <class R>
  struct Returned {
    R e;  ///< plastic volume strain of the step, compression positive
    R p, p_c, hardening;
  };
  /// f and its slope in e; D: of the other sign beyond the critical state, where no flow leads.
  template <class R>
  struct Excess {
    R f, slope, D;
  };

  template <class R>
  Returned<R> at_plastic_strain(const Trial<R>& trial, R e) const
  {
    const R hardening = max(trial.hardening + e / R(plastic), R(least_hardening));
    return {e, pressure.p_of(trial.z - e / R(kappa)), p_c_at(hardening), hardening};
  }

  /// With D = 2 p' - p_c the flow is e = gamma D, s = s_trial/(1 + c gamma), c = 2 G/sin^2(phi). On the surface
  ///   f = J_trial^2 D^2 - sin^2(phi) p' (p_c - p') (D + c e)^2 = 0
  /// which has neither a root nor a division to go wrong at the apex, on the axis, or near the critical state.
  template <class R>
  Excess<R> excess(const Trial<R>& trial, const Returned<R>& r) const
  {
    const R square(sin_phi * sin_phi), c = R(2.0) * trial.G / square;
    const R p_slope = -pressure.within(r.p) / R(kappa);
    const R p_c_slope = select(r.hardening > R(least_hardening), r.p_c / R(plastic), R(0.0));
    const R D = R(2.0) * r.p - r.p_c, D_slope = R(2.0) * p_slope - p_c_slope;
    const R A = square * r.p * (r.p_c - r.p), A_slope = square * (r.p * p_c_slope - p_slope * D);
    const R B = D + c * r.e, JJ = trial.J * trial.J;
    return {JJ * D * D - A * B * B, R(2.0) * JJ * D * D_slope - (A_slope * B + R(2.0) * A * (D_slope + c)) * B, D};
  }

  /// e has the sign of D of the trial stress, and |e| is below what takes p' elastically to p_c/2 of the start: p_c
  /// moves towards p' meanwhile. f is positive at 0; at the critical state between, negative. Newton's steps between
  /// bounds, halving where they would not close in. Lanes that have settled keep their answer, so that it does not
  /// depend on the other lanes.
  template <class R, class M>
  Returned<R> return_to_surface(const Trial<R>& trial, M yields) const
  {
    const R critical = p_c_at(trial.hardening) * R(0.5), way = R(kappa) * (trial.z - pressure.z_of(critical));
    const R sign = select(way < R(0.0), R(-1.0), R(1.0)), settled(settled_part * kappa);
    R low(0.0), high = abs(way), last = high, u(0.0);
    Returned<R> best = at_plastic_strain(trial, u);
    M open = yields;
    for (int k = 0; k < most_trials && any_of(open); ++k) {
      const Excess<R> at = excess(trial, best);
      const auto before = (at.f > R(0.0)) & (at.D * sign > R(0.0));
      low = select(before, u, low);
      high = select(before, high, u);
      const R newton = u - at.f / (at.slope * sign);
      const auto closes_in = (newton > low) & (newton < high) & (abs(newton - u) <= R(0.5) * last);
      const R next = select(closes_in, newton, (low + high) * R(0.5));
      last = abs(next - u);
      u = select(open, next, u);
      best = keep_open(open, at_plastic_strain(trial, u * sign), best);
      open = open & (last > settled);
    }
    return best;
  }

  template <class R, class M>
  static Returned<R> keep_open(M open, const Returned<R>& now, const Returned<R>& before)
  {
    return {select(open, now.e, before.e), select(open, now.p, before.p), select(open, now.p_c, before.p_c),
        select(open, now.hardening, before.hardening)};
  }

  /// Of the stiffest state.
  P bulk_modulus() const { return pressure.most / kappa; }
  P shear_modulus() const { return bulk_modulus() * shear_over_bulk; }
  Moduli moduli_at(const SymTensor<Real, 2>& sigma) const
  {
    const Real bulk = pressure.within(-mean(sigma)) / kappa;
    return {bulk, bulk * shear_over_bulk};
  }
  Real stored_energy(const SymTensor<Real, 2>& sigma) const
  {
    const Real p = -mean(sigma);
    SymTensor<Real, 2> s = sigma;
    add_isotropic(s, p);
    return kappa * pressure.energy(p) + 0.25 * double_dot(s, s) / moduli_at(sigma).shear;
  }
  Real derived_value(int, const std::array<Real, 2>& at) const { return p_c_at(at[1]); }

  /// The yield surface goes at least through the stress.
  void start(const SymTensor<Real, 2>& sigma, std::array<Real, 2>& at) const
  {
    if (const Real needed = p_c_of(sigma); std::isfinite(needed) && needed > p_c_at(at[1]))
      at[1] = std::log(needed / start_p_c);
  }

  static Real J_squared(SymTensor<Real, 2> sigma)
  {
    add_isotropic(sigma, -mean(sigma));
    return 0.5 * double_dot(sigma, sigma);
  }

  /// Of the yield surface through a stress [Pa]; infinite without pressure.
  Real p_c_of(const SymTensor<Real, 2>& sigma) const
  {
    const Real p = -mean(sigma), JJ = J_squared(sigma);
    if (!(JJ > 0.0)) return std::max(p, 0.0);
    return p > 0.0 ? p + JJ / (sin_phi * sin_phi * p) : std::numeric_limits<Real>::infinity();
  }

  std::vector<ParameterProblem> check() const;
  std::vector<ParameterProblem> check_start(const SymTensor<Real, 2>& sigma, const std::array<Real, 2>& at) const;

  static constexpr Real tiny = 1e-30;          // keeps 0/0 from stresses without shear
  static constexpr Real settled_part = 4e-15;  // of kappa*: p' to its round-off
  static constexpr int most_trials = 100;
  P sin_phi;
  P kappa;                  // kappa* [-]
  P plastic;                // lambda* - kappa* [-]
  P shear_over_bulk;        // G/K
  P start_p_c;              // [Pa]
  LogPressure<P> pressure;  // p' of elastic volume strain over kappa*
  P least_hardening;
};

template <class P>
std::vector<ParameterProblem> ModifiedCamClay<P>::check() const
{
  std::vector<ParameterProblem> problems;
  if (!(kappa <= 0.9 * (plastic + kappa) * (1.0 + 1e-12)))
    problems.push_back({"kappa", "kappa is too large beside lambda",
        fmt::format("kappa/lambda = {:.4g}, at most 0.9: unloading must be stiffer than normal compression.",
            kappa / (plastic + kappa))});
  if (!(pressure.least < pressure.most))
    problems.push_back({"smallest_mean_stress", "the smallest mean stress is not below the largest",
        fmt::format(
            "smallest_mean_stress = {:.6g} Pa, largest_mean_stress = {:.6g} Pa.", pressure.least, pressure.most)});
  if (start_p_c < pressure.least)
    problems.push_back({"yield_stress", "the yield stress is below what the law can hold",
        fmt::format("It gives p_c = {:.4g} Pa; the least is smallest_mean_stress = {:.4g} Pa. Give a larger "
                    "yield_stress, or a smaller\nsmallest_mean_stress.",
            start_p_c, pressure.least)});
  return problems;
}

template <class P>
std::vector<ParameterProblem> ModifiedCamClay<P>::check_start(
    const SymTensor<Real, 2>& sigma, const std::array<Real, 2>& at) const
{
  std::vector<ParameterProblem> problems;
  const Real p = -mean(sigma), J = std::sqrt(J_squared(sigma));
  const Real p_c = p_c_at(at[1]), needed = p_c_of(sigma), scale = needed / p_c;
  if (p > pressure.most)
    problems.push_back({"largest_mean_stress", "the soil starts with more than its largest mean stress",
        fmt::format(
            "p' = {:.4g} Pa, largest_mean_stress = {:.4g} Pa. Give the largest that will occur.", p, pressure.most)});
  else if (!(p > 0.0) && std::max(-p, J) > start_slack * p_c)
    problems.push_back({"model", "the soil starts without pressure",
        fmt::format(
            "p' = {:.4g} Pa, J = {:.4g} Pa, and this law carries no tension. Look at k0 and at the water there, "
            "or give the\nbody another law.",
            p, J)});
  else if (p > 0.0 && scale > 1.0 + start_slack)
    problems.push_back({"yield_stress", "the starting stress lies outside the yield surface",
        fmt::format("p' = {:.4g} Pa, J = {:.4g} Pa need p_c = {:.4g} Pa; {} {:.4g} Pa. Give {:.3g} times "
                    "the yield_stress\nor more, by ocr or pop, or a k0 nearer to 1 - sin(phi) = {:.3g}.",
            p, J, needed, at[1] == 0.0 ? "yield_stress gives" : "the soil was loaded to", p_c, scale, 1.0 - sin_phi)});
  return problems;
}

}  // namespace

TERP_MATERIAL_DEFINITION(
    modified_cam_clay, ModifiedCamClay, "Modified Cam-Clay: strength and stiffness that follow from effective stress")

}  // namespace terp
