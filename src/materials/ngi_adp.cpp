// Undrained strength that depends on the direction of shearing: active, direct and passive (NGI-ADP; Grimstad, Andresen
// and Jostad 2012; ellipse of Davis and Christian 1971). Total stress.
//
//   ((x - c)/a)^2 + (y/b)^2 <= 1      x = (sigma_xx - sigma_yy)/2,  y = sigma_xy in the soil's axes
//   a = (S_A + S_P)/2,  c = (S_A - S_P)/2,  b = S_D;  all times share + (1 - share) exp(-eta e)
//
// In the plane of the section: sigma_zz and the mean stress in the plane stay elastic. Equal strengths are Tresca's law
// where sigma_zz is the middle principal stress, as it is in undrained plane strain.
//
// The elastic stiffness is the same in x and y, so that the return is to the nearest point of the ellipse: one equation
// for a given strength, one around it for softening. Not for: the way to the peak, which is elastic.

#include "materials/elastic_constants.hpp"
#include "materials/law.hpp"
#include "materials/material_axes.hpp"
#include "materials/softening_shape.hpp"

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

template <class P>
struct NgiAdp {
  static constexpr std::string_view equations =
      "((x - c)/a)^2 + (y/b)^2 <= 1    x = (sigma_xx - sigma_yy)/2, y = sigma_xy in the soil's axes\n"
      "a = (su_active + su_passive)/2,  c = (su_active - su_passive)/2,  b = su_direct\n"
      "all three strengths times residual_share + (1 - residual_share) exp(-eta eps_eq_p)\n"
      "eps_eq_p = sum sqrt(1/2 de_p : de_p)                                  Eq. (6)\n"
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
  };
  static constexpr std::array state{
      StateInfo{
          "eps_eq_p", "-", Averaging::cell, "accumulated equivalent plastic strain, Eq. (6)", Role::plastic_strain},
  };
  static constexpr std::array derived{
      DerivedInfo{"su_active", "Pa", "current strength where the vertical stress is the largest pressure"},
      DerivedInfo{"su_direct", "Pa", "current strength in direct simple shear"},
      DerivedInfo{"su_passive", "Pa", "current strength where the horizontal stress is the largest pressure"},
  };
  static constexpr bool total_stress = true;

  explicit NgiAdp(std::span<const P> v)
      : shear(v[0]),
        bulk(bulk_from_poisson(v[0], v[1])),
        strength{v[2], v[3], v[4]},
        residual(v[5]),
        eta(v[6]),
        axes(v[7])
  {
  }
  /// With strengths that stay as they are.
  NgiAdp(P shear_, P bulk_, const std::array<P, 3>& strength_, const MaterialAxes<P>& axes_)
      : shear(shear_), bulk(bulk_), strength(strength_), residual(1.0), eta(0.0), axes(axes_)
  {
  }

  /// Half the difference of the direct stresses in the plane, and the shear stress [Pa].
  template <class R>
  struct Shear {
    R x, y;
  };
  template <class R>
  struct Ellipse {
    R a, b, c;
  };

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, 1>& state, const SymTensor<R, Dim>& d_eps, Real) const
  {
    static_assert(Dim == 2, "the strength is one of the plane of the section");
    add_elastic_stress(sigma, d_eps, bulk, shear);
    Shear<R> trial{(sigma[0] - sigma[1]) * R(0.5), sigma[3]};
    axes.enter(trial.x, trial.y);
    const Ellipse<R> peak = ellipse_at(state[0]);
    const R u = (trial.x - peak.c) / peak.a, v = trial.y / peak.b;
    const auto yields = u * u + v * v > R(1.0 + yield_round_off);
    if (!any_of(yields)) return R(0.0);

    R d_e(0.0);
    const Shear<R> to = softens() ? return_softening(trial, state[0], peak, d_e) : return_to(trial, peak, d_e);
    const R middle = (sigma[0] + sigma[1]) * R(0.5);
    Shear<R> back = to;
    axes.leave(back.x, back.y);
    sigma[0] = select(yields, middle + back.x, sigma[0]);
    sigma[1] = select(yields, middle - back.x, sigma[1]);
    sigma[3] = select(yields, back.y, sigma[3]);
    state[0] = select(yields, state[0] + d_e, state[0]);
    const R work = (to.x * (trial.x - to.x) + to.y * (trial.y - to.y)) * R(1.0 / shear);  // 2 (x e_x + y e_y)
    return select(yields, max(R(0.0), work), R(0.0));
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

  /// The nearest point of an ellipse to one outside: q(m) = ((X - c) a/(a^2 + m), Y b/(b^2 + m)) has the length 1.
  /// 1/|q| is concave in m and nearly straight, so that Newton's steps from m = 0 grow towards the root; of a circle
  /// the first is exact. d_e: out, half the distance over G, the step's part of Eq. (6). Inside: of no use.
  template <class R>
  Shear<R> return_to(const Shear<R>& trial, const Ellipse<R>& to, R& d_e) const
  {
    const R aa = to.a * to.a, bb = to.b * to.b, X = trial.x - to.c, Y = trial.y;
    R m(0.0);
    auto open = aa > R(0.0);
    for (int k = 0; k < most_steps && any_of(open); ++k) {
      const R u = X * to.a / (aa + m), v = Y * to.b / (bb + m), square = max(u * u + v * v, R(tiny));
      const R fall = max(u * u / (aa + m) + v * v / (bb + m), R(tiny));
      const R step = square * (sqrt(square) - R(1.0)) / fall;
      m = select(open, max(R(0.0), m + step), m);
      open = open & (step > R(settled) * (min(aa, bb) + m));
    }
    const R x = X * (aa / (aa + m)), y = Y * (bb / (bb + m));
    const R away_x = X * (m / (aa + m)), away_y = Y * (m / (bb + m));
    d_e = sqrt(away_x * away_x + away_y * away_y) * R(0.5 / shear);
    return {to.c + x, y};
  }

  /// Solves d = d_e(strength at eps_eq_p + d) by regula falsi (Illinois) between 0, where the left side is below, and
  /// the shear strain of the trial stress, where it is not: the ellipse holds the stress zero, which is that far.
  /// Lanes that have settled keep their answer, so that it does not depend on the other lanes.
  template <class R>
  Shear<R> return_softening(const Shear<R>& trial, R eps_eq_p, const Ellipse<R>& peak, R& d) const
  {
    const R size = sqrt(trial.x * trial.x + trial.y * trial.y) * R(0.5 / shear);
    const R round_off = R(settled) * (size + R(1.0) / max(R(eta), R(tiny)));
    R at_low, at_high, low(0.0), high = size;
    Shear<R> best = return_to(trial, peak, at_low);
    return_to(trial, ellipse_at(eps_eq_p + high), at_high);
    at_high = at_high - high;
    const auto softens_here = R(eta * (P(1.0) - residual)) > R(0.0);
    d = select(softens_here, R(0.0), at_low);
    auto open = softens_here & (at_low > round_off);
    auto was_below = R(0.0) > R(0.0), was_above = was_below;
    for (int k = 0; k < most_trials && any_of(open); ++k) {
      const R next = low + (high - low) * (at_low / (at_low - min(at_high, R(-tiny))));
      R d_e;
      const Shear<R> to = return_to(trial, ellipse_at(eps_eq_p + next), d_e);
      best = {select(open, to.x, best.x), select(open, to.y, best.y)};
      d = select(open, next, d);
      const R rest = d_e - next;
      const auto below = rest > R(0.0), above = rest <= R(0.0);
      at_high = select(below, select(was_below, at_high * R(0.5), at_high), rest);
      at_low = select(below, rest, select(was_above, at_low * R(0.5), at_low));
      was_below = below, was_above = above;
      low = select(below, next, low);
      high = select(below, high, next);
      open = open & (abs(rest) > round_off);
    }
    return best;
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return shear; }
  Real derived_value(int k, const std::array<Real, 1>& state) const { return strength[k] * share_at(state[0]); }
  P softened_strain() const
  {
    return select(eta * (P(1.0) - residual) > P(0.0), P(3.0) / eta, P(std::numeric_limits<Real>::infinity()));
  }
  template <class R>
  NgiAdp<R> softened_at(R k) const
  {
    const R share = share_at(k);
    return {R(shear), R(bulk), {R(strength[0]) * share, R(strength[1]) * share, R(strength[2]) * share},
        {R(axes.cos_2), R(axes.sin_2)}};
  }

  std::vector<ParameterProblem> check() const { return {}; }
  std::vector<ParameterProblem> check_within_point() const;

  static constexpr Real tiny = 1e-30;             // keeps 0/0 from stresses and brackets of no size
  static constexpr Real yield_round_off = 2e-11;  // of a returned stress, as in tresca_softening.cpp
  static constexpr Real settled = 1e-15;          // of m and of the strain: round-off
  static constexpr int most_steps = 40, most_trials = 60;
  P shear;                    // G [Pa]
  P bulk;                     // K [Pa]
  std::array<P, 3> strength;  // active, direct, passive [Pa]
  P residual;                 // [-]
  P eta;                      // [-]
  MaterialAxes<P> axes;
};

template <class P>
std::vector<ParameterProblem> NgiAdp<P>::check_within_point() const
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

}  // namespace

TERP_MATERIAL_DEFINITION(
    ngi_adp, NgiAdp, "undrained strength by direction of shearing: active, direct, passive; exponential softening")

}  // namespace terp
