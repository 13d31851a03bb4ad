// Undrained strength that depends on the direction of shearing: active, direct and passive (NGI-ADP; Grimstad, Andresen
// and Jostad 2012; ellipse of Davis and Christian 1971). Total stress.
//
//   ((x - c)/a)^2 + (y/b)^2 <= 1      x = (sigma_xx - sigma_yy)/2,  y = sigma_xy in the soil's axes
//   a = (S_A + S_P)/2,  c = (S_A - S_P)/2,  b = S_D;  all times share + (1 - share) exp(-eta e)
//
// In the plane of the section: sigma_zz and the mean stress in the plane stay elastic, unless a limit of tension acts
// on the principal stresses (tension.hpp). Equal strengths are Tresca's law where sigma_zz is the middle principal
// stress, as it is in undrained plane strain.
//
// The elastic stiffness is the same in x and y, so that the return is to the nearest point of the ellipse: one equation
// for a given strength, one around it for softening. Not for: the way to the peak, which is elastic.

#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/law.hpp"
#include "soil/laws/material_axes.hpp"
#include "soil/laws/mohr_coulomb_return.hpp"
#include "soil/laws/softening_return.hpp"
#include "soil/laws/softening_shape.hpp"
#include "soil/laws/tension.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

constexpr ParameterInfo strength_info(std::string_view name, Real typical, std::string_view meaning)
{
  return {.name = name,
      .unit = "Pa",
      .range = positive,
      .typical = typical,
      .meaning = meaning,
      .usual = between(100.0, 1e7),
      .reduction = Reduction::divide,
      .may_vary = true};
}

constexpr RatioInfo part_of_active(std::string_view name, std::string_view meaning)
{
  return {.name = name, .of = "su_active", .range = positive, .usual = between(0.2, 1.2), .meaning = meaning};
}

/// tears: with a limit of tension that acts.
template <class P, bool tears>
struct AdpLaw {
  static constexpr std::string_view equations =
      "((x - c)/a)^2 + (y/b)^2 <= 1    x = (sigma_xx - sigma_yy)/2, y = sigma_xy in the soil's axes\n"
      "a = (su_active + su_passive)/2,  c = (su_active - su_passive)/2,  b = su_direct\n"
      "all three strengths times residual_share + (1 - residual_share) exp(-eta eps_eq_p)\n"
      "eps_eq_p = sum sqrt(1/2 de_p : de_p)                                  Eq. (6)\n"
      "a limit of tension, off by default: sigma_1 <= tension_cutoff, of all three principal stresses; flow (1, 0, 0)\n"
      "Exact implicit return. In the plane of the section: equal strengths are Tresca's law while sigma_zz is the\n"
      "middle principal stress. Needs eta (1 - residual_share) (|c| + max(a, b)) <= 1.5 G. docs/strength.md.\n";
  static constexpr std::array parameters{
      with_ratio(
          shear_modulus_info, {.name = "stiffness_ratio",
                                  .of = "su_active",
                                  .range = positive,
                                  .usual = between(20.0, 2000.0),
                                  .meaning = "G / S_A, instead of shear_modulus: G = stiffness_ratio su_active"}),
      poisson_ratio_info,
      strength_info("su_active", 12e3, "S_A, strength where the vertical stress is the largest pressure"),
      with_ratio(strength_info("su_direct", 9e3, "S_D, strength in direct simple shear"),
          part_of_active("direct_ratio", "S_D / S_A, instead of su_direct")),
      with_ratio(strength_info("su_passive", 6e3, "S_P, strength where the horizontal stress is the largest pressure"),
          part_of_active("passive_ratio", "S_P / S_A, instead of su_passive")),
      ParameterInfo{.name = "residual_share",
          .unit = "-",
          .range = {0.0, 1.0, true, false},
          .typical = 0.3,
          .meaning = "share of all three strengths that softening leaves",
          .fallback = 1.0,
          .acts_with = "eta",
          .may_vary = true},
      eta_info,
      axis_angle_info,
      tension_cutoff_info,
  };
  static constexpr auto state = with_opening<tears>(std::array{StateInfo{
      "eps_eq_p", "-", Averaging::cell, "accumulated equivalent plastic strain, Eq. (6)", Role::plastic_strain}});
  using State = std::array<Real, state.size()>;
  static constexpr std::array derived{
      DerivedInfo{"su_active", "Pa", "current strength where the vertical stress is the largest pressure"},
      DerivedInfo{"su_direct", "Pa", "current strength in direct simple shear"},
      DerivedInfo{"su_passive", "Pa", "current strength where the horizontal stress is the largest pressure"},
  };
  static constexpr bool total_stress = true;

  explicit AdpLaw(std::span<const P> v)
      : shear(v[0]),
        bulk(bulk_from_poisson(v[0], v[1])),
        strength{v[2], v[3], v[4]},
        residual(v[5]),
        eta(v[6]),
        axes(v[7]),
        tension_cutoff(v[8])
  {
  }
  /// With strengths that stay as they are.
  AdpLaw(P shear_, P bulk_, const std::array<P, 3>& strength_, const MaterialAxes<P>& axes_, P cutoff)
      : shear(shear_), bulk(bulk_), strength(strength_), residual(1.0), eta(0.0), axes(axes_), tension_cutoff(cutoff)
  {
  }

  /// Half the difference of the direct stresses in the plane, and the shear stress [Pa].
  template <class R>
  struct Shear {
    R x, y;
    R size() const { return sqrt(x * x + y * y); }
  };
  /// All of a stress: its shear, the mean of the direct stresses in the plane, and sigma_zz [Pa].
  template <class R>
  struct Whole {
    Shear<R> shear;
    R mean, zz;
  };
  template <class Truth, class R>
  friend Whole<R> select(Truth m, const Whole<R>& a, const Whole<R>& b)
  {
    return {{select(m, a.shear.x, b.shear.x), select(m, a.shear.y, b.shear.y)}, select(m, a.mean, b.mean),
        select(m, a.zz, b.zz)};
  }
  template <class R>
  struct Ellipse {
    R a, b, c;
    /// Above 1 outside.
    R square(const Shear<R>& s) const
    {
      const R u = (s.x - c) / a, v = s.y / b;
      return u * u + v * v;
    }
  };

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, state.size()>& at, const SymTensor<R, Dim>& d_eps, Real) const
  {
    static_assert(Dim == 2, "the strength is one of the plane of the section");
    const R before = mean_of_direct(sigma), tension(tension_cutoff);
    R work(0.0);
    add_elastic_stress(sigma, d_eps, bulk, shear);
    if constexpr (tears)
      if (any_of(at[1] > R(0.0))) work = close_opening(sigma, at[1], before, trace(d_eps), tension, bulk);
    Whole<R> trial{{(sigma[0] - sigma[1]) * R(0.5), sigma[3]}, (sigma[0] + sigma[1]) * R(0.5), sigma[2]};
    axes.enter(trial.shear.x, trial.shear.y);
    const Ellipse<R> peak = ellipse_at(at[0]);
    auto yields = peak.square(trial.shear) > R(1.0 + yield_round_off);
    R d_e(0.0);
    Whole<R> to = trial;
    if (any_of(yields)) {
      to = select(
          yields, follow(trial, at[0], d_e, [&](const auto& ellipse) { return return_to(trial, ellipse); }), trial);
      work = select(yields, work_of(trial, to), work);
    }
    if constexpr (tears) {
      const R slack = R(1e-12) * (abs(trial.mean) + abs(trial.zz) + trial.shear.size() + peak.a);
      const auto opens = max(to.mean + to.shear.size(), to.zz) - tension > slack;
      if (any_of(opens)) {
        R torn;
        const auto both = [&](const auto& ellipse) { return return_to_both(trial, ellipse); };
        to = select(opens, follow(trial, at[0], torn, both), to);
        d_e = select(opens, torn, d_e);
        at[1] = select(opens, open(trial, tension, slack, to), at[1]);
        sigma[2] = select(opens, to.zz, sigma[2]);
        work = select(opens, work_of(trial, to), work);
        yields = yields | opens;
      }
    }
    if (!any_of(yields)) return work;

    Shear<R> back = to.shear;
    axes.leave(back.x, back.y);
    sigma[0] = select(yields, to.mean + back.x, sigma[0]);
    sigma[1] = select(yields, to.mean - back.x, sigma[1]);
    sigma[3] = select(yields, back.y, sigma[3]);
    at[0] = select(yields, at[0] + d_e, at[0]);
    return work;
  }

  /// sigma : d_eps_p of a return [J/m^3]; never negative, but for round-off.
  template <class R>
  R work_of(const Whole<R>& trial, const Whole<R>& to) const
  {
    const R x = trial.shear.x - to.shear.x, y = trial.shear.y - to.shear.y;
    const R mean = trial.mean - to.mean, zz = trial.zz - to.zz, third(1.0 / 3.0);
    const R p = (R(2.0) * to.mean + to.zz) * third, gone_p = (R(2.0) * mean + zz) * third;
    const R direct = R(2.0) * (to.mean - p) * (mean - gone_p) + (to.zz - p) * (zz - gone_p);
    const R by_shear = (to.shear.x * x + to.shear.y * y) * R(1.0 / shear);  // 2 (x e_x + y e_y)
    return max(R(0.0), by_shear + direct * R(0.5 / shear) + p * gone_p * R(1.0 / bulk));
  }

  /// The part of a return in Eq. (6): sqrt(1/2 dev:dev) over 2 G.
  template <class R>
  R strain_of(const Whole<R>& trial, const Whole<R>& to) const
  {
    const R x = trial.shear.x - to.shear.x, y = trial.shear.y - to.shear.y;
    const R direct = (trial.mean - to.mean) - (trial.zz - to.zz);
    return sqrt(x * x + y * y + direct * direct * R(1.0 / 3.0)) * R(0.5 / shear);
  }

  /// The principal stresses of the plane and of zz, from large to small.
  template <class R>
  static Sorted<R> principal(const Whole<R>& s)
  {
    const R r = s.shear.size();
    return sort_principal_values(PlanePrincipal<R>{s.mean + r, s.mean - r, s.zz, R(1.0), R(0.0)});
  }
  /// The stress with these principal values, in the directions of `s`.
  template <class R>
  static Whole<R> with_principal(const Whole<R>& s, const Sorted<R>& values)
  {
    const R r = s.shear.size();
    PlanePrincipal<R> p{s.mean + r, s.mean - r, s.zz, R(1.0), R(0.0)};
    assign_by_rank(values, p);
    const R part = (p.a - p.b) * R(0.5) / max(r, R(tiny));
    return {{s.shear.x * part, s.shear.y * part}, (p.a + p.b) * R(0.5), p.zz};
  }

  template <class R>
  R open(const Whole<R>& trial, R tension, R slack, Whole<R>& to) const
  {
    Sorted<R> s = principal(to);
    const R opening = come_apart(principal(trial), tension, slack, bulk, s);
    const auto apart = s.minor >= tension;
    to = select(apart, Whole<R>{{R(0.0), R(0.0)}, tension, tension}, to);
    return opening;
  }

  /// The return to both surfaces, each of which is convex: the nearest point of both in elastic energy, by returns to
  /// the one and the other in turn, each from where it was with what its last return took away (Dykstra 1983).
  template <class R>
  Whole<R> return_to_both(const Whole<R>& trial, const Ellipse<R>& to) const
  {
    const MohrCoulombReturn<R, P> cut(
        {R(0.0), R(1.0), R(0.0), R(far_off), R(tension_cutoff)}, bulk, shear);  // tension alone
    const R fine = R(settled) * (abs(trial.mean) + abs(trial.zz) + trial.shear.size() + to.a);
    Whole<R> at = trial, from;
    Shear<R> by_ellipse{R(0.0), R(0.0)};
    Whole<R> by_tension{{R(0.0), R(0.0)}, R(0.0), R(0.0)};
    auto open = to.a > R(0.0);
    for (int k = 0; k < most_trials && any_of(open); ++k) {
      from = at;
      from.shear = {at.shear.x + by_ellipse.x, at.shear.y + by_ellipse.y};
      Whole<R> in = return_to(from, to);
      const Shear<R> taken{from.shear.x - in.shear.x, from.shear.y - in.shear.y};
      from = {{in.shear.x + by_tension.shear.x, in.shear.y + by_tension.shear.y}, in.mean + by_tension.mean,
          in.zz + by_tension.zz};
      const Whole<R> next = with_principal(from, cut(principal(from)));
      const Whole<R> torn{
          {from.shear.x - next.shear.x, from.shear.y - next.shear.y}, from.mean - next.mean, from.zz - next.zz};
      const auto moves = max(max(abs(next.shear.x - at.shear.x), abs(next.shear.y - at.shear.y)),
                             max(abs(next.mean - at.mean), abs(next.zz - at.zz))) > fine;
      at = select(open, next, at);
      by_tension = select(open, torn, by_tension);
      by_ellipse = {select(open, taken.x, by_ellipse.x), select(open, taken.y, by_ellipse.y)};
      open = open & moves;
    }
    at = return_to(at, to);  // what is left is round-off: on the ellipse, and no more than the limit in tension
    at.mean = min(at.mean, R(tension_cutoff) - at.shear.size());
    return at;
  }

  bool softens() const { return any_of(eta * (P(1.0) - residual) > P(0.0)); }

  template <class R>
  R share_at(R eps_eq_p) const
  {
    return softens() ? R(residual) + R(1.0 - residual) * exponential(R(-eta) * eps_eq_p) : R(1.0);
  }

  template <class R>
  Ellipse<R> ellipse_at(R eps_eq_p) const
  {
    const R share = share_at(eps_eq_p);
    return {share * R((strength[0] + strength[2]) * 0.5), share * R(strength[1]),
        share * R((strength[0] - strength[2]) * 0.5)};
  }

  /// The return for the strength that belongs to the strain of the step. d_e: out, its part of Eq. (6).
  template <class R, class Return>
  Whole<R> follow(const Whole<R>& trial, R eps_eq_p, R& d_e, const Return& return_at) const
  {
    const Whole<R> none{{R(0.0), R(0.0)}, R(0.0), R(0.0)};
    const R size = strain_of(trial, none);  // the surface holds the stress zero: no return is longer, but in its mean
    return return_softening(
        [&](R d, R& made) {
          const Whole<R> to = return_at(ellipse_at(eps_eq_p + d));
          made = strain_of(trial, to);
          return to;
        },
        R(eta * (P(1.0) - residual)) > R(0.0), R(2.0) * size, R(settled) * (size + R(1.0) / max(R(eta), R(tiny))), d_e);
  }

  /// The nearest point of an ellipse to one outside: q(m) = ((X - c) a/(a^2 + m), Y b/(b^2 + m)) has the length 1.
  /// 1/|q| is concave in m and nearly straight, so that Newton's steps from m = 0 grow towards the root; of a circle
  /// the first is exact. A stress inside stays where it is.
  template <class R>
  Whole<R> return_to(const Whole<R>& trial, const Ellipse<R>& to) const
  {
    const R aa = to.a * to.a, bb = to.b * to.b, X = trial.shear.x - to.c, Y = trial.shear.y;
    R m(0.0);
    auto open = to.square(trial.shear) > R(1.0);
    for (int k = 0; k < most_steps && any_of(open); ++k) {
      const R u = X * to.a / (aa + m), v = Y * to.b / (bb + m), square = max(u * u + v * v, R(tiny));
      const R fall = max(u * u / (aa + m) + v * v / (bb + m), R(tiny));
      const R step = square * (sqrt(square) - R(1.0)) / fall;
      m = select(open, max(R(0.0), m + step), m);
      open = open & (step > R(settled) * (min(aa, bb) + m));
    }
    const auto moves = m > R(0.0);
    return {{select(moves, to.c + X * (aa / (aa + m)), trial.shear.x), Y * (bb / (bb + m))}, trial.mean, trial.zz};
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return shear; }
  Real derived_value(int k, const State& at) const { return strength[k] * share_at(at[0]); }
  P softened_strain() const
  {
    return select(eta * (P(1.0) - residual) > P(0.0), P(3.0) / eta, P(std::numeric_limits<Real>::infinity()));
  }
  template <class R>
  AdpLaw<R, tears> softened_at(R k) const
  {
    const R share = share_at(k);
    return {R(shear), R(bulk), {R(strength[0]) * share, R(strength[1]) * share, R(strength[2]) * share},
        {R(axes.cos_2), R(axes.sin_2)}, R(tension_cutoff)};
  }

  std::vector<ParameterProblem> check() const { return {}; }
  std::vector<ParameterProblem> check_within_point() const;

  static constexpr Real tiny = 1e-30;             // keeps 0/0 from stresses and brackets of no size
  static constexpr Real yield_round_off = 2e-11;  // of a returned stress, as in tresca_softening.cpp
  static constexpr Real settled = 1e-15;          // of m and of the strain: round-off
  static constexpr Real far_off = 1e30;           // a cohesion that no stress reaches [Pa]
  static constexpr int most_steps = 40, most_trials = 60;
  P shear;                    // G [Pa]
  P bulk;                     // K [Pa]
  std::array<P, 3> strength;  // active, direct, passive [Pa]
  P residual;                 // [-]
  P eta;                      // [-]
  MaterialAxes<P> axes;
  P tension_cutoff;  // [Pa]
};

template <class P, bool tears>
std::vector<ParameterProblem> AdpLaw<P, tears>::check_within_point() const
{
  // The distance to the ellipse grows with the share by at most its size in any direction, |c| + max(a, b).
  const Real size =
      0.5 * std::abs(strength[0] - strength[2]) + std::max(0.5 * (strength[0] + strength[2]), strength[1]);
  const Real per_eta = (1.0 - residual) * size, limit = 1.5 * shear;
  if (eta * per_eta <= limit) return {};
  return {{"eta", "softening is too steep",
      fmt::format("eta (1 - residual_share) (|c| + max(a, b)) = {:.3g} Pa, at most 1.5 G = {:.3g} Pa\n"
                  "(beyond 2 G the return mapping has no unique answer). Use eta <= {:.3g}, or a stiffer soil.",
          eta * per_eta, limit, limit / per_eta)}};
}

template <class P>
using NgiAdp = AdpLaw<P, false>;
template <class P>
using TornAdp = AdpLaw<P, true>;

}  // namespace

TERP_MATERIAL_THAT_TEARS(ngi_adp, NgiAdp, TornAdp,
    "undrained strength by direction of shearing: active, direct, passive; exponential softening")

}  // namespace terp
