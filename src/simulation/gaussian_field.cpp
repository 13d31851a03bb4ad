// How it thinks: the field is a Markov chain along x times one along y. A stationary chain may be built from any node
// outwards on both sides, so all chains begin at node 0: what a node gets then depends on the nodes between it and 0
// alone, and not on how far the box reaches.

#include "simulation/gaussian_field.hpp"

#include "base/errors.hpp"
#include "base/philox.hpp"
#include "parallel/functions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>

namespace terp {
namespace {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
constexpr std::uint32_t of_fields = 0x80000000U;  // keeps fields apart from the variables of a study

Real ratio_of(std::span<const Real> numerator, std::span<const Real> denominator, Real r)
{
  Real above = 0.0, below = 0.0;
  for (std::size_t k = numerator.size(); k-- > 0;) above = above * r + numerator[k];
  for (std::size_t k = denominator.size(); k-- > 0;) below = below * r + denominator[k];
  return above / below;
}

/// Solves C w = b for a symmetric positive definite C, which is overwritten. False if it is not.
bool solve_cholesky(std::vector<Real>& c, std::vector<Real>& b)
{
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = c[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= c[i * n + k] * c[j * n + k];
      if (i == j && !(sum > 0.0)) return false;
      c[i * n + j] = i == j ? std::sqrt(sum) : sum / c[j * n + j];
    }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= c[i * n + k] * b[k];
    b[i] /= c[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= c[k * n + i] * b[k];
    b[i] /= c[i * n + i];
  }
  return true;
}

}  // namespace

// Wichura, Algorithm AS 241, Applied Statistics 37 (1988) 477-484, PPND16.
Real normal_quantile(Real p)
{
  static constexpr Real a[] = {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
      1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4, 3.3430575583588128105e4,
      2.5090809287301226727e3};
  static constexpr Real b[] = {1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3,
      2.1213794301586595867e4, 3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3};
  static constexpr Real c[] = {1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0,
      3.64784832476320460504e0, 1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2,
      7.74545014278341407640e-4};
  static constexpr Real d[] = {1.0, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
      1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4, 1.05075007164441684324e-9};
  static constexpr Real e[] = {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0,
      2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5,
      2.01033439929228813265e-7};
  static constexpr Real f[] = {1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
      7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15};
  const Real q = p - 0.5;
  if (std::abs(q) <= 0.425) return q * ratio_of(a, b, 0.180625 - q * q);
  const Real r = std::sqrt(-logarithm(q < 0.0 ? p : 1.0 - p));
  const Real size = r <= 5.0 ? ratio_of(c, d, r - 1.6) : ratio_of(e, f, r - 5.0);
  return q < 0.0 ? -size : size;
}

GaussianField::Axis::Axis(Real low, Real high, Real scale)
    : spacing(scale / nodes_per_scale), ratio(exponential(-2.0 / nodes_per_scale)), rest(std::sqrt(1.0 - ratio * ratio))
{
  first = node_of(low), last = node_of(high);
  begin = std::min(first, Index{0}), end = std::max(last, Index{0});
}

Index GaussianField::Axis::node_of(Real x) const { return static_cast<Index>(std::floor(x / spacing + 0.5)); }

double GaussianField::n_nodes(const GaussianFieldCase& field)
{
  double n = 1.0;
  for (std::size_t d = 0; d < 2; ++d)
    n *= 1.0 + (std::max(field.high[d], 0.0) - std::min(field.low[d], 0.0)) * nodes_per_scale / field.scale[d];
  return n;
}

Real& GaussianField::value(Index i, Index j)
{
  return values_[static_cast<std::size_t>(j - y_.first) * static_cast<std::size_t>(x_.n()) +
                 static_cast<std::size_t>(i - x_.first)];
}

GaussianField::GaussianField(const GaussianFieldCase& field)
    : low_(field.low),
      high_(field.high),
      x_(field.low[0], field.high[0], field.scale[0]),
      y_(field.low[1], field.high[1], field.scale[1]),
      values_(static_cast<std::size_t>(x_.n()) * static_cast<std::size_t>(y_.n()), 0.0)
{
  for (const auto& [number, weight] : field.parts) add(number, weight, field);
  if (!field.known.empty()) condition(field.known);
}

void GaussianField::add(std::uint32_t number, Real weight, const GaussianFieldCase& field)
{
  const auto n = static_cast<std::size_t>(x_.end - x_.begin + 1);
  std::vector<Real> middle(n), row(n);
  const auto at = [&](std::vector<Real>& line, Index i) -> Real& {
    return line[static_cast<std::size_t>(i - x_.begin)];
  };
  const auto noise = [&](Index i, Index j) {
    return normal_quantile(philox_uniform(
        {field.realisation, of_fields | number, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)},
        {field.seed, 0}));
  };
  std::vector<Real> line(n);
  const auto chain_along_x = [&](Index j) {
    at(line, 0) = noise(0, j);
    for (Index i = 1; i <= x_.end; ++i) at(line, i) = x_.ratio * at(line, i - 1) + x_.rest * noise(i, j);
    for (Index i = -1; i >= x_.begin; --i) at(line, i) = x_.ratio * at(line, i + 1) + x_.rest * noise(i, j);
  };
  const auto keep = [&](Index j) {
    if (j < y_.first || j > y_.last) return;
    for (Index i = x_.first; i <= x_.last; ++i) value(i, j) += weight * at(row, i);
  };
  chain_along_x(0);
  middle = row = line;
  keep(0);
  const auto go_on = [&](Index j) {
    chain_along_x(j);
    for (std::size_t k = 0; k < n; ++k) row[k] = y_.ratio * row[k] + y_.rest * line[k];
    keep(j);
  };
  for (Index j = 1; j <= y_.end; ++j) go_on(j);
  row = middle;
  for (Index j = -1; j >= y_.begin; --j) go_on(j);
}

std::vector<std::pair<std::array<Index, 2>, Real>> GaussianField::by_node(const std::vector<KnownScore>& known) const
{
  std::map<std::array<Index, 2>, std::pair<Real, int>> sums;
  for (const KnownScore& k : known) {
    auto& [sum, n] = sums[{x_.node_of(k.x[0]), y_.node_of(k.x[1])}];
    sum += k.score, ++n;
  }
  std::vector<std::pair<std::array<Index, 2>, Real>> means;
  for (const auto& [node, sum] : sums) means.emplace_back(node, sum.first / sum.second);
  return means;
}

/// g + sum_k rho(x, x_k) w_k with C w = known - g: the field given what is known (simple kriging of the residual).
void GaussianField::condition(const std::vector<KnownScore>& known)
{
  const auto nodes = by_node(known);
  const std::size_t n = nodes.size();
  const auto powers = [](const Axis& axis) {  // rho by the number of nodes between two
    std::vector<Real> rho(static_cast<std::size_t>(axis.n()), 1.0);
    for (std::size_t k = 1; k < rho.size(); ++k) rho[k] = rho[k - 1] * axis.ratio;
    return rho;
  };
  const std::vector<Real> rho_x = powers(x_), rho_y = powers(y_);
  const auto rho = [&](std::array<Index, 2> a, std::array<Index, 2> b) {
    return rho_x[static_cast<std::size_t>(std::abs(a[0] - b[0]))] *
           rho_y[static_cast<std::size_t>(std::abs(a[1] - b[1]))];
  };
  std::vector<Real> c(n * n), w(n);
  for (std::size_t i = 0; i < n; ++i) {
    w[i] = nodes[i].second - value(nodes[i].first[0], nodes[i].first[1]);
    for (std::size_t j = 0; j < n; ++j) c[i * n + j] = rho(nodes[i].first, nodes[j].first);
  }
  if (!solve_cholesky(c, w)) throw RunError("known values of a random field contradict each other");
  for (Index j = y_.first; j <= y_.last; ++j)
    for (Index i = x_.first; i <= x_.last; ++i)
      for (std::size_t k = 0; k < n; ++k) value(i, j) += rho({i, j}, nodes[k].first) * w[k];
}

Real GaussianField::at(Vec<2> x) const
{
  for (std::size_t d = 0; d < 2; ++d)
    if (!(x[d] >= low_[d] && x[d] <= high_[d])) return none;
  const auto i = static_cast<std::size_t>(x_.node_of(x[0]) - x_.first),
             j = static_cast<std::size_t>(y_.node_of(x[1]) - y_.first);
  return values_[j * static_cast<std::size_t>(x_.n()) + i];
}

Real value_over_mean(FieldMarginal marginal, Real cov, Real score)
{
  if (marginal == FieldMarginal::normal) return 1.0 + cov * score;
  const Real variance = logarithm(1.0 + cov * cov);
  return exponential(std::sqrt(variance) * score - 0.5 * variance);
}

Real score_of(FieldMarginal marginal, Real cov, Real value)
{
  if (marginal == FieldMarginal::normal) return (value - 1.0) / cov;
  const Real variance = logarithm(1.0 + cov * cov);
  return value > 0.0 ? (logarithm(value) + 0.5 * variance) / std::sqrt(variance) : none;
}

FieldValue by_random(const GaussianFieldCase& field, FieldMarginal marginal, Real cov, FieldValue mean)
{
  return [made = std::make_shared<const GaussianField>(field), marginal, cov, mean = std::move(mean)](
             const PlaceInSoil& at) { return mean(at) * value_over_mean(marginal, cov, made->at(at.x)); };
}

}  // namespace terp
