// Mohr-Coulomb soil: friction, cohesion and dilatancy of their own, a tension cut-off, and exponential softening of all
// three. Tension is positive, and sigma_1 >= sigma_2 >= sigma_3:
//
//   sigma_1 - sigma_3 + (sigma_1 + sigma_3) sin(phi) <= 2 c cos(phi)
//   sigma_1 <= min(tension_cutoff, c cot(phi))
//
// The return for a given strength is exact (mohr_coulomb_return.hpp). Softening makes the strength depend on the
// plastic strain of the step: one equation, solved between two bounds that hold a root whatever the stress.

#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/law.hpp"
#include "soil/laws/mohr_coulomb_return.hpp"
#include "soil/laws/softening_return.hpp"
#include "soil/laws/softening_shape.hpp"
#include "soil/laws/tension.hpp"

#include <fmt/format.h>

#include <numbers>

namespace terp {
namespace {

constexpr Real degree = std::numbers::pi / 180.0;
constexpr Range friction_range = between(0.0, 60.0);
constexpr Range dilatancy_range = between(-15.0, 60.0);
constexpr Range usual_friction = between(2.0, 60.0), usual_dilatancy = between(1.0, 60.0);  // less: radians, tangents
/// What is left of the stiffness of a return, over that without change of volume, where soil that contracts still has
/// one answer to a strain.
constexpr Real least_return_stiffness = 0.05;

constexpr ParameterInfo stress_info(std::string_view name, Real typical, std::string_view meaning)
{
  return {.name = name,
      .unit = "Pa",
      .range = not_negative,
      .typical = typical,
      .meaning = meaning,
      .reduction = Reduction::divide,
      .may_vary = true};
}

constexpr ParameterInfo angle_info(std::string_view name, Real typical, std::string_view meaning)
{
  return {.name = name,
      .unit = "deg",
      .range = friction_range,
      .typical = typical,
      .meaning = meaning,
      .reduction = Reduction::divide_tangent,
      .may_vary = true};
}

constexpr ParameterInfo dilatancy_info(std::string_view name, Real typical, std::string_view meaning)
{
  ParameterInfo info = angle_info(name, typical, meaning);
  info.range = dilatancy_range;
  info.usual = usual_dilatancy;
  return info;
}

constexpr ParameterInfo with_default(ParameterInfo info, Real value)
{
  info.fallback = value;
  return info;
}

/// What softening leaves of a strength: all of it, unless it is given.
constexpr ParameterInfo residual_of(std::string_view peak, ParameterInfo info)
{
  info.fallback_of = peak;
  info.acts_with = "eta";
  return info;
}

constexpr ParameterInfo with_usual(ParameterInfo info, Range usual)
{
  info.usual = usual;
  return info;
}

/// A quantity that softens by Eq. (5): residual + drop exp(-eta e).
template <class P>
struct Softening {
  P residual, drop;
  template <class R>
  R at(R decay) const
  {
    return R(residual) + R(drop) * decay;
  }
};

template <class P>
struct MohrCoulomb {
  static constexpr std::string_view equations =
      "sigma_1 - sigma_3 + (sigma_1 + sigma_3) sin(phi) <= 2 c cos(phi)     tension positive, sorted in three "
      "dimensions\n"
      "sigma_1 <= min(tension_cutoff, c cot(phi))\n"
      "flow       (1 + sin(psi), 0, -(1 - sin(psi))) on the first, (1, 0, 0) on the second; both on edges and at the "
      "apex\n"
      "softening  c, phi, psi = residual + (peak - residual) exp(-eta eps_eq_p)             as Eq. (5)\n"
      "eps_eq_p = sum sqrt(1/2 de_p : de_p), de_p the deviator of the plastic strain         Eq. (6)\n"
      "opening  = volume strain beyond the apex, where all three stresses meet their limit; closes before pressure "
      "returns\n"
      "psi < 0: the soil contracts; psi_residual = 0 and eta make that end at a critical state (docs/strength.md)\n"
      "phi = psi = 0 is Tresca's law with c = S_u. With [water] drained soil has the pore pressure of its place; give\n"
      "c', phi', stiffness of drained soil and the density of the soil with its water. For total stress in undrained\n"
      "soil: phi = 0, c = S_u and saturated density (docs/methods.md).\n";
  static constexpr std::array parameters{
      shear_modulus_info,
      poisson_ratio_info,
      with_usual(stress_info("cohesion", 8e3, "cohesion c, at its peak"), between(10.0, 1e7)),
      with_usual(angle_info("friction_angle", 30.0, "friction angle phi, at its peak"), usual_friction),
      with_default(dilatancy_info("dilatancy_angle", 8.0,
                       "dilatancy angle psi before softening; negative: the soil contracts; at most friction_angle"),
          0.0),
      tension_cutoff_info,
      residual_of("cohesion", stress_info("cohesion_residual", 2e3, "cohesion that softening leaves")),
      with_usual(residual_of("friction_angle",
                     angle_info("friction_angle_residual", 25.0, "friction angle that softening leaves")),
          usual_dilatancy),
      residual_of(
          "dilatancy_angle", dilatancy_info("dilatancy_angle_residual", 0.0, "dilatancy angle that softening leaves")),
      eta_info,
  };
  static constexpr std::array state{
      StateInfo{
          "eps_eq_p", "-", Averaging::cell, "accumulated equivalent plastic strain, Eq. (6)", Role::plastic_strain},
      opening_info,
  };
  static constexpr std::array derived{
      DerivedInfo{"cohesion", "Pa", "current cohesion"},
      DerivedInfo{"friction_angle", "deg", "current friction angle"},
      DerivedInfo{"dilatancy_angle", "deg", "current dilatancy angle"},
  };

  explicit MohrCoulomb(std::span<const P> v)
      : shear(v[0]),
        bulk(bulk_from_poisson(v[0], v[1])),
        tension_cutoff(v[5]),
        eta(v[9]),
        cohesion{v[6], v[2] - v[6]},
        phi{v[7] * degree, (v[3] - v[7]) * degree},
        psi{v[8] * degree, (v[4] - v[8]) * degree},
        softening(eta * max(cohesion.drop, max(phi.drop, abs(psi.drop))))
  {
  }

  /// With strengths that stay as they are.
  MohrCoulomb(P shear_, P bulk_, P cutoff, std::array<P, 3> strengths)
      : shear(shear_),
        bulk(bulk_),
        tension_cutoff(cutoff),
        eta(0.0),
        cohesion{strengths[0], P(0.0)},
        phi{strengths[1], P(0.0)},
        psi{strengths[2], P(0.0)},
        softening(0.0)
  {
  }

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, 2>& state, const SymTensor<R, Dim>& d_eps, Real) const
  {
    const auto strength = strength_at(state[0]);
    const R before = mean_of_direct(sigma);
    add_elastic_stress(sigma, d_eps, bulk, shear);
    const R work = any_of(state[1] > R(0.0))
                       ? close_opening(sigma, state[1], before, trace(d_eps), strength.tension, bulk)
                       : R(0.0);
    auto principal = principal_values(sigma);
    const Sorted<R> trial = sort_principal_values(principal);
    const auto yields = is_outside(trial, strength);
    if (!any_of(yields)) return work;

    R d_e(0.0);
    Sorted<R> returned = softens() ? return_softening_soil(trial, state[0], d_e) : return_to(trial, strength, d_e);
    state[0] = select(yields, state[0] + d_e, state[0]);
    const auto now = softens() ? strength_at(state[0]) : strength;
    state[1] = select(yields, come_apart(trial, now.tension, slack(trial, now), bulk, returned), state[1]);
    assign_by_rank(returned, principal);
    const SymTensor<R, Dim> on_surface = from_principal_values(principal);
    for (int k = 0; k < n_sym<Dim>; ++k) sigma[k] = select(yields, on_surface[k], sigma[k]);
    return select(yields, work_of_return(trial, returned, bulk, shear), work);
  }

  bool softens() const { return any_of(softening > P(0.0)); }

  /// What is left of each drop [-].
  template <class R>
  R decay_at(R eps_eq_p) const
  {
    return softens() ? exponential(R(-eta) * eps_eq_p) : R(1.0);
  }

  template <class R>
  MohrCoulombStrength<R> strength_at(R eps_eq_p) const
  {
    const R decay = decay_at(eps_eq_p);
    const R sin_phi = sine(phi.at(decay)), cos_phi = sqrt(R(1.0) - sin_phi * sin_phi), c = cohesion.at(decay);
    const R apex = c * cos_phi / max(sin_phi, R(tiny));
    return {sin_phi, cos_phi, sine(psi.at(decay)), c, min(R(tension_cutoff), apex)};
  }

  /// A point yields when it exceeds a limit by more than the round-off of a stress that was returned and rebuilt.
  template <class R>
  auto is_outside(const Sorted<R>& s, const MohrCoulombStrength<R>& at) const
  {
    const R limit = slack(s, at);
    return (mohr_coulomb_excess(s.major, s.minor, at) > limit) | (s.major - at.tension > limit);
  }
  /// Of a stress that was returned and rebuilt: it repeats to 3e-14 of its size at worst (granular column).
  template <class R>
  static R slack(const Sorted<R>& s, const MohrCoulombStrength<R>& at)
  {
    return R(1e-12) * (abs(s.major) + abs(s.minor) + at.cohesion);
  }

  /// Return to a surface that stays where it is. d_e: out, the step's part of Eq. (6).
  template <class R>
  Sorted<R> return_to(const Sorted<R>& trial, const MohrCoulombStrength<R>& strength, R& d_e) const
  {
    const Sorted<R> returned = MohrCoulombReturn<R, P>(strength, bulk, shear)(trial);
    d_e = strain_of_return(trial, returned, shear);
    return returned;
  }

  /// The strength follows the strain of the step. The bound is twice the shear strain of the trial stress: no return
  /// moves the deviator further.
  template <class R>
  Sorted<R> return_softening_soil(const Sorted<R>& trial, R eps_eq_p, R& d) const
  {
    const R settled = R(round_off) * ((abs(trial.major) + abs(trial.minor)) * R(1.0 / shear) + R(1.0 / eta));
    const R high = shear_norm(trial.major, trial.middle, trial.minor) * R(1.0 / shear);
    return return_softening([&](R at, R& d_e) { return return_to(trial, strength_at(eps_eq_p + at), d_e); },
        R(softening) > R(0.0), high, settled, d);
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return shear; }
  Real derived_value(int k, const std::array<Real, 2>& state) const
  {
    const Real decay = decay_at(state[0]);
    return k == 0 ? cohesion.at(decay) : (k == 1 ? phi : psi).at(decay) / degree;
  }
  P softened_strain() const
  {
    return select(softening > P(0.0), P(3.0) / eta, P(std::numeric_limits<Real>::infinity()));  // exp(-3) = 5 %
  }
  template <class R>
  MohrCoulomb<R> softened_at(R k) const
  {
    const R decay = decay_at(k);
    return {R(shear), R(bulk), R(tension_cutoff), {cohesion.at(decay), phi.at(decay), psi.at(decay)}};
  }

  std::vector<ParameterProblem> check() const;
  void check_dilatancy(std::vector<ParameterProblem>& problems) const;
  std::vector<ParameterProblem> check_within_point() const;

  static constexpr Real tiny = 1e-30;  // keeps 0/0 from soil without friction and from brackets that have closed
  static constexpr Real round_off =
      1e-15;              // of the plastic strain, as a part of the elastic strain of the trial stress and of 1/eta
  P shear;                // G [Pa]
  P bulk;                 // K [Pa]
  P tension_cutoff;       // [Pa]
  P eta;                  // [-]
  Softening<P> cohesion;  // [Pa]
  Softening<P> phi, psi;  // [rad]
  P softening;            // above 0 where any of the three softens
};

template <class P>
std::vector<ParameterProblem> MohrCoulomb<P>::check() const
{
  std::vector<ParameterProblem> problems;
  const auto refuse = [&](const char* parameter, std::string what, std::string detail) {
    problems.push_back({parameter, std::move(what), std::move(detail)});
  };
  const auto peak = [](const Softening<P>& s) { return s.residual + s.drop; };
  const auto degrees = [](Real angle) { return fmt::format("{:.6g} deg", angle / degree); };
  if (cohesion.drop < 0.0)
    refuse("cohesion_residual", "the residual cohesion exceeds the peak",
        fmt::format("cohesion_residual = {} Pa, at most cohesion = {} Pa.", cohesion.residual, peak(cohesion)));
  if (phi.drop < 0.0)
    refuse("friction_angle_residual", "the residual friction angle exceeds the peak",
        fmt::format(
            "friction_angle_residual = {}, at most friction_angle = {}.", degrees(phi.residual), degrees(peak(phi))));
  check_dilatancy(problems);
  if (peak(psi) > peak(phi) || psi.residual > phi.residual) {
    const bool at_peak = peak(psi) > peak(phi);
    const std::string ending = at_peak ? "" : "_residual";
    refuse(at_peak ? "dilatancy_angle" : "dilatancy_angle_residual", "the dilatancy angle exceeds the friction angle",
        fmt::format("dilatancy_angle{0} = {1}, at most friction_angle{0} = {2}: soil that dilates more gains energy by "
                    "shearing.",
            ending, degrees(at_peak ? peak(psi) : psi.residual), degrees(at_peak ? peak(phi) : phi.residual)));
  }
  if (!(peak(cohesion) > 0.0) && !(peak(phi) > 0.0))
    refuse("cohesion", "the soil has no strength",
        "cohesion and friction_angle are both 0. Give one of them, or choose model = \"newtonian_fluid\".");
  return problems;
}

/// Softening takes the dilatancy towards 0, from either side. Soil that contracts loses pressure as it flows, and with
/// it strength: the stiffness of the return to a plane, and to both edges, must stay positive
/// (mohr_coulomb_return.hpp).
template <class P>
void MohrCoulomb<P>::check_dilatancy(std::vector<ParameterProblem>& problems) const
{
  const Real first = psi.residual + psi.drop, last = psi.residual;
  const auto degrees = [](Real angle) { return fmt::format("{:.6g} deg", angle / degree); };
  if (first * last < 0.0 || std::abs(last) > std::abs(first))
    problems.push_back({"dilatancy_angle_residual", "the residual dilatancy angle exceeds the peak",
        fmt::format("dilatancy_angle_residual = {}, allowed are those from 0 to dilatancy_angle = {}.", degrees(last),
            degrees(first))});
  const Real s = std::sin(first), sin_phi = std::sin(phi.residual + std::max(phi.drop, P(0.0)));
  if (!(s < 0.0)) return;
  const Real lame = bulk - 2.0 / 3.0 * shear, own = 4.0 * shear + 4.0 * sin_phi * s * (lame + shear),
             extension = 2.0 * shear * (1.0 - s) * (1.0 - sin_phi) + 4.0 * lame * s * sin_phi,
             compression = 2.0 * shear * (1.0 + s) * (1.0 + sin_phi) + 4.0 * lame * s * sin_phi;
  const Real least = std::min({own, (own + extension) / 2.0, (own + compression) / 2.0}) / (4.0 * shear);
  if (least < least_return_stiffness)
    problems.push_back({"dilatancy_angle", "the soil contracts too much for its stiffness",
        fmt::format("With dilatancy_angle = {} a small strain would take all strength at once. Use an angle nearer to "
                    "0, or a smaller\npoisson_ratio: that of drained soil, 0.2 to 0.35.",
            degrees(first))});
}

template <class P>
std::vector<ParameterProblem> MohrCoulomb<P>::check_within_point() const
{
  std::vector<ParameterProblem> problems;
  const Real steepness = eta * cohesion.drop * std::cos(phi.residual), limit = 1.5 * shear;
  if (steepness > limit)
    problems.push_back({"eta", "softening is too steep",
        fmt::format("eta (cohesion - cohesion_residual) cos(phi) = {:.3g} Pa, at most 1.5 G = {:.3g} Pa\n"
                    "(beyond sqrt(3) G the return mapping has no unique answer). Use eta <= {:.3g}, or a stiffer soil.",
            steepness, limit, limit / (cohesion.drop * std::cos(phi.residual)))});
  return problems;
}

}  // namespace

TERP_MATERIAL_DEFINITION(
    mohr_coulomb, MohrCoulomb, "Mohr-Coulomb with dilatancy, tension cut-off and exponential softening")

}  // namespace terp
