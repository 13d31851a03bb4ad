// Mohr-Coulomb soil: friction, cohesion and dilatancy of their own, a tension cut-off, and exponential softening of all
// three. Tension is positive, and sigma_1 >= sigma_2 >= sigma_3:
//
//   sigma_1 - sigma_3 + (sigma_1 + sigma_3) sin(phi) <= 2 c cos(phi)
//   sigma_1 <= min(tension_cutoff, c cot(phi))
//
// The return for a given strength is exact (mohr_coulomb_return.hpp). Softening makes the strength depend on the
// plastic strain of the step: one equation, solved between two bounds that hold a root whatever the stress.

#include "materials/elastic_constants.hpp"
#include "materials/law.hpp"
#include "materials/mohr_coulomb_return.hpp"
#include "materials/softening_shape.hpp"

#include <fmt/format.h>

#include <numbers>

namespace terp {
namespace {

constexpr Real degree = std::numbers::pi / 180.0;
constexpr Range friction_range = between(0.0, 60.0);
constexpr Range usual_friction = between(2.0, 60.0), usual_dilatancy = between(1.0, 60.0);  // less: radians, tangents

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
      "phi = psi = 0 is Tresca's law with c = S_u. With [water] drained soil has the pore pressure of its place; give\n"
      "c', phi', stiffness of drained soil and the density of the soil with its water. For total stress in undrained\n"
      "soil: phi = 0, c = S_u and saturated density (docs/methods.md).\n";
  static constexpr std::array parameters{
      shear_modulus_info,
      poisson_ratio_info,
      with_usual(stress_info("cohesion", 8e3, "cohesion c, at its peak"), between(10.0, 1e7)),
      with_usual(angle_info("friction_angle", 30.0, "friction angle phi, at its peak"), usual_friction),
      with_usual(
          with_default(
              angle_info("dilatancy_angle", 8.0, "dilatancy angle psi, at its peak; at most friction_angle"), 0.0),
          usual_dilatancy),
      with_default(stress_info("tension_cutoff", 5e3,
                       "largest principal stress; never above the apex c cot(phi), which is the limit without it"),
          std::numeric_limits<Real>::infinity()),
      residual_of("cohesion", stress_info("cohesion_residual", 2e3, "cohesion that softening leaves")),
      with_usual(residual_of("friction_angle",
                     angle_info("friction_angle_residual", 25.0, "friction angle that softening leaves")),
          usual_dilatancy),
      with_usual(residual_of("dilatancy_angle",
                     angle_info("dilatancy_angle_residual", 0.0, "dilatancy angle that softening leaves")),
          usual_dilatancy),
      eta_info,
  };
  static constexpr std::array state{
      StateInfo{
          "eps_eq_p", "-", Averaging::cell, "accumulated equivalent plastic strain, Eq. (6)", Role::plastic_strain},
      StateInfo{"opening", "-", Averaging::cell, "volume strain by which the soil has come apart"},
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
        softening(eta * max(cohesion.drop, max(phi.drop, psi.drop)))
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
    const R work =
        any_of(state[1] > R(0.0)) ? close_opening(sigma, state[1], before, trace(d_eps), strength.tension) : R(0.0);
    auto principal = principal_values(sigma);
    const Sorted<R> trial = sort_principal_values(principal);
    const auto yields = is_outside(trial, strength);
    if (!any_of(yields)) return work;

    R d_e(0.0);
    Sorted<R> returned = softens() ? return_softening(trial, state[0], strength, d_e) : return_to(trial, strength, d_e);
    state[0] = select(yields, state[0] + d_e, state[0]);
    state[1] = select(yields, come_apart(trial, softens() ? strength_at(state[0]) : strength, returned), state[1]);
    assign_by_rank(returned, principal);
    const SymTensor<R, Dim> on_surface = from_principal_values(principal);
    for (int k = 0; k < n_sym<Dim>; ++k) sigma[k] = select(yields, on_surface[k], sigma[k]);
    return select(yields, plastic_work(trial, returned), work);
  }

  /// The opening of soil whose principal stresses all meet their limit, which they are given to the bit; 0 elsewhere.
  template <class R>
  R come_apart(const Sorted<R>& trial, const MohrCoulombStrength<R>& at, Sorted<R>& s) const
  {
    const auto apart = s.minor >= at.tension - slack(trial, at);
    s = {select(apart, at.tension, s.major), select(apart, at.tension, s.middle), select(apart, at.tension, s.minor)};
    const R beyond = (trial.major + trial.middle + trial.minor) * R(1.0 / 3.0) - at.tension;
    return select(apart, max(R(0.0), beyond * R(1.0 / bulk)), R(0.0));
  }

  /// Exact where all three are equal.
  template <class R, int Dim>
  static R mean_of_direct(const SymTensor<R, Dim>& sigma)
  {
    return sigma[0] + ((sigma[1] - sigma[0]) + (sigma[2] - sigma[0])) * R(1.0 / 3.0);
  }

  /// Soil that has come apart carries no more tension than before, none as soon as it closes, and no pressure before it
  /// has closed. sigma: with the elastic stress of the step. before: mean stress at its start. Returns the plastic work
  /// per volume.
  template <class R, int Dim>
  R close_opening(SymTensor<R, Dim>& sigma, R& opening, R before, R volumetric, R tension) const
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
    const R a = trial.major - returned.major, b = trial.middle - returned.middle, c = trial.minor - returned.minor;
    d_e = shear_norm(a, b, c) * R(0.5 / shear);
    return returned;
  }

  /// sqrt(1/2 dev:dev) of a tensor with these principal values.
  template <class R>
  static R shear_norm(R a, R b, R c)
  {
    const R ab = a - b, bc = b - c, ca = c - a;
    return sqrt((ab * ab + bc * bc + ca * ca) * R(1.0 / 6.0));
  }

  /// Solves d = d_e(strength at eps_eq_p + d) by regula falsi (Illinois) between 0, where the left side is below, and
  /// the shear strain of the trial stress, twice, where it is above: no return moves the deviator further. Any answer
  /// is on the surface of the strength that belongs to it. Lanes that have settled keep their answer, so that it does
  /// not depend on the other lanes.
  template <class R>
  Sorted<R> return_softening(const Sorted<R>& trial, R eps_eq_p, const MohrCoulombStrength<R>& strength, R& d) const
  {
    const R settled = R(round_off) * ((abs(trial.major) + abs(trial.minor)) * R(1.0 / shear) + R(1.0 / eta));
    R low(0.0), high = shear_norm(trial.major, trial.middle, trial.minor) * R(1.0 / shear), at_high;
    Sorted<R> best = return_to(trial, strength, at_high);
    R at_low = at_high;  // d_e less d; above 0 at `low`, below at `high`
    return_to(trial, strength_at(eps_eq_p + high), at_high);
    at_high = at_high - high;
    const auto softens_here = R(softening) > R(0.0);
    d = select(softens_here, R(0.0), at_low);
    auto open = softens_here & (at_low > settled);
    auto was_below = R(0.0) > R(0.0), was_above = was_below;
    for (int k = 0; k < most_trials && any_of(open); ++k) {
      const R next = low + (high - low) * (at_low / (at_low - min(at_high, R(-tiny))));
      R d_e;
      const Sorted<R> returned = return_to(trial, strength_at(eps_eq_p + next), d_e);
      best = {select(open, returned.major, best.major), select(open, returned.middle, best.middle),
          select(open, returned.minor, best.minor)};
      d = select(open, next, d);
      const R rest = d_e - next;
      const auto below = rest > R(0.0);  // the root lies above
      const auto above = rest <= R(0.0);
      at_high = select(below, select(was_below, at_high * R(0.5), at_high), rest);
      at_low = select(below, rest, select(was_above, at_low * R(0.5), at_low));
      was_below = below, was_above = above;
      low = select(below, next, low);
      high = select(below, high, next);
      open = open & (abs(rest) > settled);
    }
    return best;
  }

  /// sigma : d_eps_p [J/m^3]; never negative, but for round-off.
  template <class R>
  R plastic_work(const Sorted<R>& trial, const Sorted<R>& s) const
  {
    const R p = (s.major + s.middle + s.minor) * R(1.0 / 3.0);
    const R a = trial.major - s.major, b = trial.middle - s.middle, c = trial.minor - s.minor;
    const R by_shear = (s.major - p) * a + (s.middle - p) * b + (s.minor - p) * c;
    return max(R(0.0), by_shear * R(0.5 / shear) + p * (a + b + c) * R(1.0 / (3.0 * bulk)));
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
  std::vector<ParameterProblem> check_within_point() const;

  static constexpr Real tiny = 1e-30;  // keeps 0/0 from soil without friction and from brackets that have closed
  static constexpr Real round_off =
      1e-15;  // of the plastic strain, as a part of the elastic strain of the trial stress and of 1/eta
  static constexpr int most_trials = 60;
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
  if (psi.drop < 0.0)
    refuse("dilatancy_angle_residual", "the residual dilatancy angle exceeds the peak",
        fmt::format(
            "dilatancy_angle_residual = {}, at most dilatancy_angle = {}.", degrees(psi.residual), degrees(peak(psi))));
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
