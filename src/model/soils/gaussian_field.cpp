// How it thinks: along y the field is a chain whose noise, node by node, is an independent chain along x. A stationary
// chain may be built from any node outwards on both sides, so all chains begin at node 0: what a node gets then depends
// on the nodes between it and 0 alone, and not on how far the box reaches. Backwards it is the same chain, with odd
// derivatives of the other sign. A moving average takes the noise of the nodes around, of which as many are made.

#include "model/soils/gaussian_field.hpp"

#include "math/errors.hpp"
#include "math/nan.hpp"
#include "math/philox.hpp"
#include "math/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>

namespace terp {
namespace {

constexpr std::uint32_t of_fields = 0x80000000U;  // keeps fields apart from the variables of a study

Real ratio_of(std::span<const Real> numerator, std::span<const Real> denominator, Real r)
{
  Real above = 0.0, below = 0.0;
  for (std::size_t k = numerator.size(); k-- > 0;) above = above * r + numerator[k];
  for (std::size_t k = denominator.size(); k-- > 0;) below = below * r + denominator[k];
  return above / below;
}

/// Lower triangular L with L L^T = C, in place. What a row is left of its variance by those before is the square of its
/// diagonal; a row where that is round-off ends it. Returns the number of rows.
std::size_t factor(std::vector<Real>& c, std::size_t n)
{
  constexpr Real round_off = 1e-11;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = c[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= c[i * n + k] * c[j * n + k];
      if (i == j && !(sum > round_off)) return i;
      c[i * n + j] = i == j ? std::sqrt(sum) : sum / c[j * n + j];
    }
  return n;
}

/// b = L^-1 b
void solve_lower(const std::vector<Real>& l, std::vector<Real>& b)
{
  for (std::size_t i = 0, n = b.size(); i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l[i * n + k] * b[k];
    b[i] /= l[i * n + i];
  }
}

/// b = L^-T b
void solve_upper(const std::vector<Real>& l, std::vector<Real>& b)
{
  for (std::size_t n = b.size(), i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= l[k * n + i] * b[k];
    b[i] /= l[i * n + i];
  }
}

/// A value that others leave little room for, and that lies far off: a smooth field that met it would swing wildly
/// beside it. scores: known ones, l: factor of their correlations. Returns its number, or how many there are.
std::size_t contradiction_in(std::vector<Real> scores, const std::vector<Real>& l)
{
  constexpr Real little = 0.1, far = 5.0;  // of a standard deviation; of what is left of it
  solve_lower(l, scores);
  for (std::size_t i = 0, n = scores.size(); i < n; ++i)
    if (l[i * n + i] < little && std::abs(scores[i]) > far) return i;
  return scores.size();
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

namespace {

constexpr Real node_spacing = 1.0 / GaussianField::nodes_per_scale;

/// Nodes beside one that its moving average takes.
Index reach_of(const CorrelationKind& kind)
{
  return static_cast<Index>(moving_average(kind, node_spacing).size() / 2);
}

/// StepState of a chain at all nodes of a line, or of the nodes of a row.
using States = std::array<std::vector<Real>, LineChain::most_states>;

/// to = A from + L w, node by node; `from` and `to` may be the same.
void take_step(const LineChain& chain, const States& from, const States& w, States& to, std::size_t node)
{
  std::array<Real, LineChain::most_states> next{};
  for (std::size_t a = 0; a < chain.n_states; ++a) {
    for (std::size_t b = 0; b < chain.n_states; ++b) next[a] += chain.step[a][b] * from[b][node];
    for (std::size_t b = 0; b <= a; ++b) next[a] += chain.noise[a][b] * w[b][node];
  }
  for (std::size_t a = 0; a < chain.n_states; ++a) to[a][node] = next[a];
}

void start(const LineChain& chain, const States& w, States& to, std::size_t node)
{
  for (std::size_t a = 0; a < chain.n_states; ++a) {
    Real sum = 0.0;
    for (std::size_t b = 0; b <= a; ++b) sum += chain.start[a][b] * w[b][node];
    to[a][node] = sum;
  }
}

/// The same state, seen in the other direction.
void turn_round(States& states)
{
  for (Real& value : states[1]) value = -value;
}

/// From node 0 to both ends; noise(k, i): number k of node i.
template <class F>
void make_chain(const LineChain& chain, Index begin, Index end, std::vector<Real>& line, F noise)
{
  States state, w, first;
  for (std::size_t a = 0; a < chain.n_states; ++a) state[a].resize(1), w[a].resize(1);
  const auto draw = [&](Index i) {
    for (std::size_t k = 0; k < chain.n_states; ++k) w[k][0] = noise(k, i);
  };
  const auto go_on = [&](Index i) {
    draw(i);
    take_step(chain, state, w, state, 0);
    line[static_cast<std::size_t>(i - begin)] = state[0][0];
  };
  draw(0);
  start(chain, w, state, 0);
  line[static_cast<std::size_t>(-begin)] = state[0][0];
  first = state;
  for (Index i = 1; i <= end; ++i) go_on(i);
  state = first;
  turn_round(state);
  for (Index i = -1; i >= begin; --i) go_on(i);
}

}  // namespace

GaussianField::Axis::Axis(Real low, Real high, Real scale, const CorrelationKind& kind)
    : spacing(scale / nodes_per_scale)
{
  first = node_of(low), last = node_of(high);
  if (kind.chain != nullptr)
    begin = std::min(first, Index{0}), end = std::max(last, Index{0});
  else
    begin = first - reach_of(kind), end = last + reach_of(kind);
}

Index GaussianField::Axis::node_of(Real x) const { return static_cast<Index>(std::floor(x / spacing + 0.5)); }

double GaussianField::n_nodes(const GaussianFieldCase& field)
{
  const bool is_chain = field.correlation->chain != nullptr;
  double n = 1.0;
  for (std::size_t d = 0; d < 2; ++d)
    n *= is_chain
             ? 1.0 + (std::max(field.high[d], 0.0) - std::min(field.low[d], 0.0)) * nodes_per_scale / field.scale[d]
             : 1.0 + (field.high[d] - field.low[d]) * nodes_per_scale / field.scale[d] +
                   2.0 * static_cast<double>(reach_of(*field.correlation));
  return n;
}

Real& GaussianField::value(Index i, Index j)
{
  return values_[static_cast<std::size_t>(j - y_.first) * static_cast<std::size_t>(x_.n()) +
                 static_cast<std::size_t>(i - x_.first)];
}

GaussianField::GaussianField(const GaussianFieldCase& field)
    : kind_(*field.correlation),
      low_(field.low),
      high_(field.high),
      x_(field.low[0], field.high[0], field.scale[0], kind_),
      y_(field.low[1], field.high[1], field.scale[1], kind_),
      values_(static_cast<std::size_t>(x_.n()) * static_cast<std::size_t>(y_.n()), 0.0)
{
  for (const auto& part : field.parts) {
    const Noise noise = [&](std::size_t k, Index i, Index j) {
      return normal_quantile(philox_uniform(
          {field.realisation, of_fields | part.first, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)},
          {field.seed, static_cast<std::uint32_t>(k)}));
    };
    kind_.chain != nullptr ? add_chains(noise, part.second) : add_averages(noise, part.second);
  }
  if (!field.known.empty()) condition(field.known);
}

void GaussianField::add_to_row(Index j, Real weight, const std::vector<Real>& row)
{
  if (j < y_.first || j > y_.last) return;
  for (Index i = x_.first; i <= x_.last; ++i) value(i, j) += weight * row[static_cast<std::size_t>(i - x_.begin)];
}

void GaussianField::add_chains(const Noise& noise, Real weight)
{
  const LineChain chain = kind_.chain(node_spacing);
  const auto n = static_cast<std::size_t>(x_.end - x_.begin + 1);
  States row, lines, middle;
  for (std::size_t a = 0; a < chain.n_states; ++a) row[a].resize(n), lines[a].resize(n);
  const auto make_lines = [&](Index j) {
    for (std::size_t a = 0; a < chain.n_states; ++a)
      make_chain(chain, x_.begin, x_.end, lines[a],
          [&](std::size_t k, Index i) { return noise(a * chain.n_states + k, i, j); });
  };
  const auto go_on = [&](Index j) {
    make_lines(j);
    for (std::size_t node = 0; node < n; ++node) take_step(chain, row, lines, row, node);
    add_to_row(j, weight, row[0]);
  };
  make_lines(0);
  for (std::size_t node = 0; node < n; ++node) start(chain, lines, row, node);
  middle = row;
  add_to_row(0, weight, row[0]);
  for (Index j = 1; j <= y_.end; ++j) go_on(j);
  row = middle;
  turn_round(row);
  for (Index j = -1; j >= y_.begin; --j) go_on(j);
}

void GaussianField::add_averages(const Noise& noise, Real weight)
{
  const std::vector<Real> weights = moving_average(kind_, node_spacing);
  const auto n = static_cast<std::size_t>(x_.end - x_.begin + 1), reach = weights.size() / 2;
  std::vector<Real> drawn(n), row(n, 0.0);
  for (Index j = y_.begin; j <= y_.end; ++j) {
    for (std::size_t i = 0; i < n; ++i) drawn[i] = noise(0, x_.begin + static_cast<Index>(i), j);
    for (std::size_t i = reach; i + reach < n; ++i) {
      row[i] = 0.0;
      for (std::size_t k = 0; k < weights.size(); ++k) row[i] += weights[k] * drawn[i - reach + k];
    }
    for (std::size_t k = 0; k < weights.size(); ++k)
      add_to_row(j - static_cast<Index>(reach) + static_cast<Index>(k), weight * weights[k], row);
  }
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
  const std::vector<Real> rho_x = rho_of_nodes(kind_, node_spacing, static_cast<std::size_t>(x_.n())),
                          rho_y = rho_of_nodes(kind_, node_spacing, static_cast<std::size_t>(y_.n()));
  const auto rho = [&](std::array<Index, 2> a, std::array<Index, 2> b) {
    return rho_x[static_cast<std::size_t>(std::abs(a[0] - b[0]))] *
           rho_y[static_cast<std::size_t>(std::abs(a[1] - b[1]))];
  };
  std::vector<Real> c(n * n), w(n), scores(n);
  for (std::size_t i = 0; i < n; ++i) {
    scores[i] = nodes[i].second;
    w[i] = nodes[i].second - value(nodes[i].first[0], nodes[i].first[1]);
    for (std::size_t j = 0; j < n; ++j) c[i * n + j] = rho(nodes[i].first, nodes[j].first);
  }
  const auto refuse = [&](std::size_t i, const char* why) {
    throw RunError(
        fmt::format("In a field so smooth the one at ({:g}, {:g}) m follows from those around it{}.\nLeave "
                    "some out, or take a correlation that is less smooth.",
            static_cast<Real>(nodes[i].first[0]) * x_.spacing, static_cast<Real>(nodes[i].first[1]) * y_.spacing, why));
  };
  if (const std::size_t i = factor(c, n); i < n) refuse(i, "");
  if (const std::size_t i = contradiction_in(scores, c); i < n) refuse(i, ", and contradicts them");
  solve_lower(c, w);
  solve_upper(c, w);
  for (Index j = y_.first; j <= y_.last; ++j)
    for (Index i = x_.first; i <= x_.last; ++i)
      for (std::size_t k = 0; k < n; ++k) value(i, j) += rho({i, j}, nodes[k].first) * w[k];
}

Real GaussianField::at(Vec<2> x) const
{
  for (std::size_t d = 0; d < 2; ++d)
    if (!(x[d] >= low_[d] && x[d] <= high_[d])) return nan;
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
  return value > 0.0 ? (logarithm(value) + 0.5 * variance) / std::sqrt(variance) : nan;
}

FieldValue by_random(const GaussianFieldCase& field, FieldMarginal marginal, Real cov, FieldValue mean)
{
  return [made = std::make_shared<const GaussianField>(field), marginal, cov, mean = std::move(mean)](
             const PlaceInSoil& at) { return mean(at) * value_over_mean(marginal, cov, made->at(at.x)); };
}

}  // namespace terp
