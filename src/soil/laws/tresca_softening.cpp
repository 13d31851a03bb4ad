// Tresca soil whose undrained shear strength softens with plastic strain.
//
//   S_u = S_u,r + (S_u,p - S_u,r) exp(-eta e)     Eq. (5), sign by decision 0001
//   e   = sum sqrt(1/2 de_p : de_p)               Eq. (6), norm by decision 0002
//
// Beside the paper: a second fall from S_u,r to the remoulded strength, and a strength that the rate of shearing raises
// (rate_factor.hpp, decision 0044), and a limit of tension (tension.hpp). All are off by default.
//
// Exact implicit return in sorted 3-D principal space: to the main plane, or to one of the two edges where the middle
// stress equals the major (triaxial extension) or the minor one (triaxial compression). The pressure changes only where
// the limit of tension acts: there the return is that of Mohr-Coulomb soil without friction (mohr_coulomb_return.hpp).

#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/law.hpp"
#include "soil/laws/mohr_coulomb_return.hpp"
#include "soil/laws/rate_factor.hpp"
#include "soil/laws/softening_return.hpp"
#include "soil/laws/softening_shape.hpp"
#include "soil/laws/tension.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

/// A point counts as yielding when sigma_1 - sigma_3 exceeds 2 S_u by more than this part of it: the stress of a
/// returned point, rebuilt from its principal values, repeats to about 1e-13 in the worst cases met.
constexpr Real yield_round_off = 1e-11;

/// Newton steps of the returns. Measured for every softening that check() admits (residual over S_u, trial radii to 11
/// S_u, tests/soil/laws/tresca_softening_test.cpp): on the plane 4e-7 after four, 3e-14 after five, round-off after
/// six; on an edge, which starts from the plane's answer, 5e-9 after three and round-off after four.
constexpr int plane_steps = 5;
constexpr int edge_steps = 6;

/// A Newton step has settled when eta times it is below the first number, since the next one is of its square, or when
/// it changes S_u by less than the second, since the equations depend on the step in no other way that is not linear.
constexpr Real settled_change = 1e-8;
constexpr Real settled_strength = 1e-16;

/// The return is shown to be unique for rates up to 10^9 rate_ref: 1000 1/s for a laboratory's 1e-6 1/s.
constexpr Real most_decades = 9.0;

/// tears: with a limit of tension that acts.
template <class P, bool tears>
struct TrescaLaw {
  static constexpr std::string_view equations =
      "sigma_1 - sigma_3 <= 2 S_u, principal stresses sorted in three dimensions; the pressure never changes\n"
      "S_u      = su_residual + (su_peak - su_residual) exp(-eta eps_eq_p)   Eq. (5)\n"
      "eps_eq_p = sum sqrt(1/2 de_p : de_p)                                  Eq. (6)\n"
      "Exact implicit return to the plane or an edge of the yield surface. Off by default:\n"
      "a second fall of S_u, by (su_residual - su_remoulded) (1 - exp(-eta_remoulding eps_eq_p))\n"
      "a limit of tension: sigma_1 <= tension_cutoff, flow (1, 0, 0): the one return that changes the pressure\n"
      "a rate: S_u times 1 + rate_mu log10(max(rate, rate_ref)/rate_ref), rate = increment of eps_eq_p / dt\n"
      "Needs (1 + 9 rate_mu) (eta (su_peak - su_residual) + eta_remoulding (su_residual - su_remoulded)) <= 1.5 G.\n"
      "docs/softening_laws.md converts published laws.\n";
  static constexpr std::array parameters{
      with_ratio(
          shear_modulus_info, {.name = "stiffness_ratio",
                                  .of = "su_peak",
                                  .range = positive,
                                  .usual = between(20.0, 2000.0),
                                  .meaning = "G / S_u,p, instead of shear_modulus: G = stiffness_ratio su_peak"}),
      poisson_ratio_info,
      ParameterInfo{.name = "su_peak",
          .unit = "Pa",
          .range = positive,
          .typical = 8e3,
          .meaning = "peak undrained shear strength S_u,p",
          .usual = between(100.0, 1e7),
          .reduction = Reduction::divide,
          .may_vary = true},
      ParameterInfo{.name = "su_residual",
          .unit = "Pa",
          .range = positive,
          .typical = 2e3,
          .meaning = "residual undrained shear strength S_u,r",
          .fallback_of = "su_peak",
          .acts_with = "eta",
          .usual = between(10.0, 1e7),
          .reduction = Reduction::divide,
          .may_vary = true,
          .ratio = {.name = "sensitivity",
              .of = "su_peak",
              .divides = true,
              .range = Range{1.0},
              .usual = between(1.0, 20.0),
              .meaning = "S_u,p / S_u,r, instead of su_residual: su_residual = su_peak / sensitivity"}},
      eta_info,
      ParameterInfo{.name = "su_remoulded",
          .unit = "Pa",
          .range = positive,
          .typical = 400.0,
          .meaning = "remoulded undrained shear strength, to which the residual one falls",
          .fallback_of = "su_residual",
          .acts_with = "eta_remoulding",
          .usual = between(10.0, 1e7),
          .reduction = Reduction::divide,
          .may_vary = true},
      ParameterInfo{.name = "eta_remoulding",
          .unit = "-",
          .range = not_negative,
          .typical = 2.0,
          .meaning = "shape factor of the fall to su_remoulded; 95 % of it is done at a strain of 3/eta_remoulding",
          .fallback = 0.0,
          .acts_with = "su_remoulded",
          .strain_exponent = 1.0,
          .may_vary = true},
      ParameterInfo{.name = "rate_mu",
          .unit = "-",
          .range = between(0.0, 1.0),
          .typical = 0.1,
          .meaning = "gain of strength per tenfold rate of shearing; clay: 0.05 to 0.2",
          .fallback = 0.0,
          .usual = between(0.01, 0.5),
          .reduction = Reduction::zero},
      ParameterInfo{.name = "rate_ref",
          .unit = "1/s",
          .range = positive,
          .typical = 1e-6,
          .meaning = "rate of eps_eq_p, half the engineering shear strain rate, up to which the strength is S_0",
          .fallback = std::numeric_limits<Real>::infinity(),
          .acts_with = "rate_mu",
          .usual = between(1e-9, 1.0),
          .strain_exponent = -0.5},
      tension_cutoff_info,
  };
  static constexpr auto state = with_opening<tears>(std::array{StateInfo{
      "eps_eq_p", "-", Averaging::cell, "accumulated equivalent plastic strain, Eq. (6)", Role::plastic_strain}});
  using State = std::array<Real, state.size()>;
  static constexpr std::array derived{
      DerivedInfo{"su", "Pa", "current undrained shear strength, Eq. (5), at slow rates", Role::strength},
  };
  static constexpr bool total_stress = true;
  static constexpr bool depends_on_rate = true;

  explicit TrescaLaw(std::span<const P> v)
      : shear(v[0]),
        bulk(bulk_from_poisson(v[0], v[1])),
        su_peak(v[2]),
        su_residual(v[3]),
        eta(v[4]),
        su_remoulded(v[5]),
        eta_remoulding(v[6]),
        rate{v[7], v[8]},
        tension_cutoff(v[9]),
        steepest(select(su_residual > su_remoulded, max(eta, eta_remoulding), eta))
  {
  }
  /// With a strength that stays as it is.
  TrescaLaw(P shear_, P bulk_, P su, const RateFactor<P>& rate_, P cutoff)
      : shear(shear_),
        bulk(bulk_),
        su_peak(su),
        su_residual(su),
        eta(0.0),
        su_remoulded(su),
        eta_remoulding(0.0),
        rate(rate_),
        tension_cutoff(cutoff),
        steepest(0.0)
  {
  }

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, state.size()>& at, const SymTensor<R, Dim>& d_eps, Real dt) const
  {
    const R before = mean_of_direct(sigma);
    if (stays_elastic(sigma, at, d_eps)) return R(0.0);
    R work(0.0);
    if constexpr (tears)
      if (any_of(at[1] > R(0.0))) work = close_opening(sigma, at[1], before, trace(d_eps), R(tension_cutoff), bulk);
    auto principal = principal_values(sigma);
    const Sorted<R> trial = sort_principal_values(principal);
    Strength<R> strength = strength_at(at[0]);
    auto yields = trial.major - trial.minor > R(2.0) * strength.su * R(1.0 + yield_round_off);
    R d_e(0.0);  // the step's part of Eq. (6)
    Sorted<R> returned = trial;
    if (any_of(yields)) {
      returned = select(yields, return_to_yield_surface(trial, at[0], strength, dt, d_e), trial);
      work = select(yields, plastic_work(trial, returned), work);
    }
    if constexpr (tears) {
      const R slack = R(1e-12) * (abs(trial.major) + abs(trial.minor) + strength.su);
      const auto opens = returned.major - R(tension_cutoff) > slack;
      if (any_of(opens)) {
        R torn_d_e;
        returned = select(opens, tear(trial, at[0], dt, torn_d_e), returned);
        d_e = select(opens, torn_d_e, d_e);
        at[1] = select(opens, come_apart(trial, R(tension_cutoff), slack, bulk, returned), at[1]);
        work = select(opens, work_of_return(trial, returned, bulk, shear), work);
        yields = yields | opens;
      }
    }
    if (!any_of(yields)) return work;

    at[0] = select(yields, at[0] + d_e, at[0]);
    assign_by_rank(returned, principal);
    const SymTensor<R, Dim> on_surface = from_principal_values(principal);
    for (int k = 0; k < n_sym<Dim>; ++k) sigma[k] = select(yields, on_surface[k], sigma[k]);
    return work;
  }

  /// Strength at slow rates and how steeply it falls with eps_eq_p [Pa].
  template <class R>
  struct Strength {
    R su;
    R fall;  ///< -dS_u/de
  };

  template <class R>
  Strength<R> strength_at(R eps_eq_p) const
  {
    return strength_at(eps_eq_p, [](R x) { return exponential(x); });
  }
  /// left: exp(x) of x <= 0, or a bound of it.
  template <class R, class Left>
  Strength<R> strength_at(R eps_eq_p, Left&& left_at) const
  {
    if (!any_of(su_peak > su_remoulded)) return {R(su_remoulded), R(0.0)};
    const R left = R(su_peak - su_residual) * left_at(R(-eta) * eps_eq_p);
    const R fall = R(eta) * left;
    if (!any_of(su_residual > su_remoulded)) return {R(su_residual) + left, fall};
    const R second = R(su_residual - su_remoulded) * left_at(R(-eta_remoulding) * eps_eq_p);
    return {R(su_remoulded) + second + left, fall + R(eta_remoulding) * second};
  }

  /// Adds the elastic stress. True if it surely lies within the yield surface in all lanes, by a thousandth of S_u, far
  /// more than round-off: that spares the root, the quotient and the exponential of the answer, which is the same. With
  /// radius r in the plane sigma_1 - sigma_3 is the larger of 2 r and r + |mean - zz|, and exp(x) >= (1 + x/8)^8 for
  /// -8 <= x <= 0. at: state, of which the plastic strain is the one that drives the strength.
  template <class R>
  bool stays_elastic(SymTensor<R, 2>& sigma, const std::array<R, state.size()>& at, const SymTensor<R, 2>& d_eps) const
  {
    add_elastic_stress(sigma, d_eps, bulk, shear);
    const auto bound = [](R x) {
      const R root = max(fma(x, R(0.125), R(1.0)), R(0.0)), square = root * root, fourth = square * square;
      return fourth * fourth;
    };
    const R su = R(0.999) * strength_at(at[0], bound).su;
    const R half = (sigma[0] - sigma[1]) * R(0.5), mean = (sigma[0] + sigma[1]) * R(0.5);
    R least = max(min(su, R(2.0) * su - abs(mean - sigma[2])), R(0.0));
    if constexpr (tears) {
      const R limit = R(tension_cutoff) - R(1e-3) * su;
      least = select((sigma[2] < limit) & (at[1] <= R(0.0)), max(min(least, limit - mean), R(0.0)), R(0.0));
    }
    return !any_of(!(fma(half, half, sigma[3] * sigma[3]) < least * least));
  }

  /// The return where the limit of tension acts: to it, or to its corner with the yield surface.
  template <class R>
  Sorted<R> tear(const Sorted<R>& trial, R eps_eq_p, Real dt, R& d_e) const
  {
    const auto return_at = [&](R d, R& made) {
      const R su = strength_at(eps_eq_p + d).su * rate.factor(d, dt);
      const Sorted<R> s = MohrCoulombReturn<R, P>({R(0.0), R(1.0), R(0.0), su, R(tension_cutoff)}, bulk, shear)(trial);
      made = strain_of_return(trial, s, shear);
      return s;
    };
    const R high = shear_norm(trial.major, trial.middle, trial.minor) * R(1.0 / shear);  // twice what it can be
    const auto follows = (R(su_peak) > R(su_remoulded)) | (R(rate.per_tenfold) > R(0.0));
    const R settled = R(1e-15) * ((abs(trial.major) + abs(trial.minor)) * R(1.0 / shear) + R(1e-3));
    return return_softening(return_at, follows, high, settled, d_e);
  }

  /// strength: in at eps_eq_p. dt: length of the step [s]. d_e: in 0, out the step's part of Eq. (6).
  template <class R>
  Sorted<R> return_to_yield_surface(
      const Sorted<R>& trial, R eps_eq_p, const Strength<R>& strength, Real dt, R& d_e) const
  {
    solve_plane(trial, eps_eq_p, strength, d_e);
    if (rate.acts()) rate.solve([&](R d, R factor) { return excess_of_plane(trial, eps_eq_p, d, factor); }, dt, d_e);
    const R shift = R(2.0 * shear) * d_e;
    Sorted<R> result{trial.major - shift, trial.middle, trial.minor + shift};
    const auto past_major = result.major < trial.middle;
    const auto past_minor = trial.middle < result.minor;
    const auto on_edge = past_major | past_minor;
    if (!any_of(on_edge)) return result;

    // Direction of the edge: (2, 2, -4)/3 where major = middle, (4, -2, -2)/3 where middle = minor, both times S_u.
    const R upper(2.0 / 3.0), lower(-4.0 / 3.0);
    const Sorted<R> edge{
        select(past_major, upper, -lower), select(past_major, upper, -upper), select(past_major, lower, -upper)};
    R edge_d_e = d_e;
    const Sorted<R> at_edge = return_to_edge(trial, edge, eps_eq_p, dt, edge_d_e);
    d_e = select(on_edge, edge_d_e, d_e);
    return {select(on_edge, at_edge.major, result.major), select(on_edge, at_edge.middle, result.middle),
        select(on_edge, at_edge.minor, result.minor)};
  }

  /// True where a Newton step still matters: the strength changed by more than round-off over it, and so did its slope.
  /// strength: before the step; a long step back from an overshoot leads to where far more of it is left than it says.
  template <class R>
  auto unsettled(R step, const Strength<R>& strength) const
  {
    const auto long_way_back = R(-steepest) * step > R(1.0);
    return (abs(step) * R(steepest) > R(settled_change)) &
           (long_way_back | (abs(step) * strength.fall > R(settled_strength) * strength.su));
  }

  /// Solves s1 - s3 - 4 G d = 2 S_u(eps_eq_p + d) for d >= 0. From d = 0 the first step overshoots, the rest fall.
  /// Lanes that have settled keep their answer, so that it does not depend on the other lanes.
  template <class R>
  void solve_plane(const Sorted<R>& trial, R eps_eq_p, Strength<R> strength, R& d) const
  {
    const R radius = (trial.major - trial.minor) * R(0.5);
    auto open = d <= R(0.0);
    for (int step = 0; step < plane_steps; ++step) {
      const R excess = radius - R(2.0 * shear) * d - strength.su;
      const R next = max(R(0.0), d + excess / (R(2.0 * shear) - strength.fall));
      const auto moves = open & unsettled(next - d, strength);
      d = select(open, next, d);
      if (!any_of(moves)) return;
      open = moves;
      strength = strength_at(eps_eq_p + d);
    }
  }

  template <class R>
  Excess<R> excess_of_plane(const Sorted<R>& trial, R eps_eq_p, R d, R factor) const
  {
    const Strength<R> at = strength_at(eps_eq_p + d);
    return {(trial.major - trial.minor) * R(0.5) - factor * at.su - R(2.0 * shear) * d,
        factor * at.fall - R(2.0 * shear), -at.su};
  }

  /// |t - S e|, |a| = sqrt(1/2 a:a), with t the trial deviator and e the edge, and how it falls with S.
  template <class R>
  struct EdgeDistance {
    R distance, slope;
  };

  template <class R>
  EdgeDistance<R> distance_to_edge(const Sorted<R>& trial, const Sorted<R>& edge, R p, R su) const
  {
    const R a = trial.major - p - su * edge.major, b = trial.middle - p - su * edge.middle;
    const R c = trial.minor - p - su * edge.minor;
    const R distance = max(sqrt((a * a + b * b + c * c) * R(0.5)), R(tiny * shear));
    return {distance, (a * edge.major + b * edge.middle + c * edge.minor) * R(0.5) / distance};
  }

  /// Negative where the strength exceeds the trial stress.
  template <class R>
  Excess<R> excess_of_edge(const Sorted<R>& trial, const Sorted<R>& edge, R p, R eps_eq_p, R d, R factor) const
  {
    const Strength<R> at = strength_at(eps_eq_p + d);
    const EdgeDistance<R> to = distance_to_edge(trial, edge, p, factor * at.su);
    const R slope = abs(to.slope), distance = select(to.slope > R(0.0), to.distance, -to.distance);
    return {distance - R(2.0 * shear) * d, slope * factor * at.fall - R(2.0 * shear), -slope * at.su};
  }

  /// Solves 2 G d = |t - S_u(eps_eq_p + d) e|. d: in that of the plane, out the answer.
  template <class R>
  Sorted<R> return_to_edge(const Sorted<R>& trial, const Sorted<R>& edge, R eps_eq_p, Real dt, R& d) const
  {
    const R p = (trial.major + trial.middle + trial.minor) * R(1.0 / 3.0);
    auto open = d >= R(0.0);
    R su(0.0);
    for (int step = 0; step < edge_steps; ++step) {
      const Strength<R> strength = strength_at(eps_eq_p + d);
      const EdgeDistance<R> to = distance_to_edge(trial, edge, p, strength.su);
      const R next = max(R(0.0), d - (R(2.0 * shear) * d - to.distance) / (R(2.0 * shear) - to.slope * strength.fall));
      const R at_next = strength.su - (next - d) * strength.fall;  // to second order in a step that has settled
      const auto moves = open & unsettled(next - d, strength);
      su = select(open, at_next, su);
      d = select(open, next, d);
      if (!any_of(moves)) break;
      open = moves;
    }
    if (rate.acts()) {
      const auto excess = [&](R at, R factor) { return excess_of_edge(trial, edge, p, eps_eq_p, at, factor); };
      const R factor = rate.solve(excess, dt, d);
      su = factor * strength_at(eps_eq_p + d).su;
    }
    return {p + su * edge.major, p + su * edge.middle, p + su * edge.minor};
  }

  /// sigma : d_eps_p [J/m^3] with d_eps_p,i = (trial_i - returned_i) / 2G.
  template <class R>
  R plastic_work(const Sorted<R>& trial, const Sorted<R>& returned) const
  {
    const R sum = returned.major * (trial.major - returned.major) + returned.middle * (trial.middle - returned.middle) +
                  returned.minor * (trial.minor - returned.minor);
    return sum * R(0.5 / shear);
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return shear; }
  Real derived_value(int, const State& at) const { return strength_at(at[0]).su; }
  /// Of the slower fall.
  P softened_strain() const
  {
    const P none(std::numeric_limits<Real>::infinity());
    const P first = select((eta > P(0.0)) & (su_peak > su_residual), P(3.0) / eta, none);  // exp(-3) = 5 %
    const P second = select((eta_remoulding > P(0.0)) & (su_residual > su_remoulded), P(3.0) / eta_remoulding, none);
    return select(second < none, select(first < none, max(first, second), second), first);
  }
  template <class R>
  TrescaLaw<R, tears> softened_at(R k) const
  {
    return {R(shear), R(bulk), strength_at(k).su, {R(rate.per_tenfold), R(rate.rate_ref)}, R(tension_cutoff)};
  }

  std::vector<ParameterProblem> check() const;
  std::vector<ParameterProblem> check_within_point() const;

  static constexpr Real tiny = 1e-30;  // keeps 0/0 from lanes that are not on an edge
  P shear;                             // G [Pa]
  P bulk;                              // K [Pa]
  P su_peak;                           // S_u,p [Pa]
  P su_residual;                       // S_u,r [Pa]
  P eta;                               // shape factor [-]
  P su_remoulded;                      // [Pa]
  P eta_remoulding;                    // [-]
  RateFactor<P> rate;
  P tension_cutoff;  // [Pa]
  P steepest;        // the larger of the shape factors that act [-]
};

template <class P, bool tears>
std::vector<ParameterProblem> TrescaLaw<P, tears>::check() const
{
  std::vector<ParameterProblem> problems;
  if (su_residual > su_peak)
    problems.push_back({"su_residual", "the residual strength exceeds the peak strength",
        fmt::format("su_residual = {} Pa, at most su_peak = {} Pa.", su_residual, su_peak)});
  if (su_remoulded > su_residual)
    problems.push_back({"su_remoulded", "the remoulded strength exceeds the residual strength",
        fmt::format("su_remoulded = {} Pa, at most su_residual = {} Pa.", su_remoulded, su_residual)});
  if (rate.acts() && std::isinf(rate.rate_ref))
    problems.push_back({"rate_mu", "`rate_mu` needs `rate_ref`",
        fmt::format("rate_mu = {} is the gain of strength per tenfold rate; it needs the rate above which it counts.\n"
                    "Give rate_ref, half the engineering shear strain rate of the test that gave su_peak.\n"
                    "A triaxial test at 1 %/h: 2.4e-6 1/s (docs/softening_laws.md).",
            rate.per_tenfold)});
  return problems;
}

template <class P, bool tears>
std::vector<ParameterProblem> TrescaLaw<P, tears>::check_within_point() const
{
  std::vector<ParameterProblem> problems;
  const Real first = eta * (su_peak - su_residual), second = eta_remoulding * (su_residual - su_remoulded);
  const Real factor = 1.0 + most_decades * rate.per_tenfold, steepness = factor * (first + second), limit = 1.5 * shear;
  if (steepness > limit) {
    const bool by_first = first >= second;
    const std::string words = fmt::format("{}eta (su_peak - su_residual){}{}", rate.acts() ? "(1 + 9 rate_mu) (" : "",
        second > 0.0 ? " + eta_remoulding (su_residual - su_remoulded)" : "", rate.acts() ? ")" : "");
    const Real rest = limit / factor - (by_first ? second : first);
    const std::string advice =
        rest > 0.0 ? fmt::format("Use {} <= {:.3g}, or a stiffer soil.", by_first ? "eta" : "eta_remoulding",
                         rest / (by_first ? su_peak - su_residual : su_residual - su_remoulded))
                   : std::string("Use smaller shape factors, or a stiffer soil.");
    problems.push_back({by_first ? "eta" : "eta_remoulding", "softening is too steep",
        fmt::format("{} = {:.3g} Pa, at most 1.5 G = {:.3g} Pa\n"
                    "(beyond sqrt(3) G the return mapping has no unique answer). {}",
            words, steepness, limit, advice)});
  }
  return problems;
}

template <class P>
using TrescaSoftening = TrescaLaw<P, false>;
template <class P>
using TornTresca = TrescaLaw<P, true>;

}  // namespace

TERP_MATERIAL_THAT_TEARS(
    tresca_softening, TrescaSoftening, TornTresca, "Tresca with exponential softening of the undrained shear strength")

}  // namespace terp
