// Picard steps with Anderson's mixing, from a wide band of suction to the narrow one: from a poor start a narrow band
// dries the soil at a drain and floods it again, without end. A surface has its condition weakly (Nitsche), so the
// equations are symmetric. A place of a seepage face takes part while water comes out of it.

#include "model/seepage/free_surface.hpp"

#include "math/sparse_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace terp {
namespace {

constexpr Real beta = 10.0;           // of Nitsche's penalty
constexpr std::size_t remembers = 6;  // steps of Anderson's mixing
constexpr Real mixing = 0.5;
constexpr Real least_flow = 1e-7;         // of k times the height: below it nothing flows
constexpr int changes_allowed = 12;       // of a place of a seepage face before it stays as it is
constexpr int permeability_settles = 10;  // iterations after which that of the surface only falls
constexpr Real balance_bound = 5e-4, misfit_bound = 1e-3;

using Corners = Quad4::PerCorner<Real>;

/// Of 4 x 4 numbers the lower half, row by row.
using LowerHalf = std::array<Real, 10>;

constexpr std::size_t lower(int i, int j) { return static_cast<std::size_t>(i * (i + 1) / 2 + j); }

Real at_corners(const Mesh<2>& mesh, Index cell, const Corners& shape, std::span<const Real> values)
{
  const auto& nodes = mesh.cells[cell];
  return shape[0] * values[nodes[0]] + shape[1] * values[nodes[1]] + shape[2] * values[nodes[2]] +
         shape[3] * values[nodes[3]];
}

/// Of the columns of a matrix the combination that brings b nearest to zero: b + sum c_k column_k. Columns that hardly
/// differ from others have none.
std::vector<Real> nearest(std::vector<std::vector<Real>> columns, std::vector<Real> b)
{
  const std::size_t n = columns.size();
  std::vector<std::vector<Real>> r(n, std::vector<Real>(n, 0.0));
  std::vector<Real> d(n, 0.0), c(n, 0.0);
  const auto product = [](const std::vector<Real>& u, const std::vector<Real>& v) {
    return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
  };
  std::vector<char> counts(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Real>& q = columns[k];
    const Real before = std::sqrt(product(q, q));
    for (std::size_t j = 0; j < k; ++j) {
      if (!counts[j]) continue;
      r[j][k] = product(columns[j], q);
      for (std::size_t i = 0; i < q.size(); ++i) q[i] -= r[j][k] * columns[j][i];
    }
    r[k][k] = std::sqrt(product(q, q));
    counts[k] = r[k][k] > 1e-8 * before;
    if (!counts[k]) continue;
    for (Real& value : q) value /= r[k][k];
    d[k] = -product(q, b);
    for (std::size_t i = 0; i < q.size(); ++i) b[i] += d[k] * q[i];
  }
  for (std::size_t k = n; k-- > 0;) {
    if (!counts[k]) continue;
    c[k] = d[k];
    for (std::size_t j = k + 1; j < n; ++j) c[k] -= r[k][j] * c[j];
    c[k] /= r[k][k];
  }
  return c;
}

class Flow {
 public:
  Flow(const Mesh<2>& mesh, const FlowSoil& soil, std::size_t parts, const FlowOptions& options,
      const std::optional<FlowStep>& step)
      : mesh_(mesh), soil_(soil), parts_(parts), options_(options), step_(step)
  {
    find_unknowns();
    stiffness_.resize(soil.places.size());
    for (std::size_t q = 0; q < soil.places.size(); ++q) {
      const FlowPlace& place = soil.places[q];
      for (int i = 0; i < 4; ++i) {
        const Vec<2> flux = place.k.times(place.gradient[i]);
        for (int j = 0; j <= i; ++j)
          stiffness_[q][lower(i, j)] = place.weight * (flux[0] * place.gradient[j][0] + flux[1] * place.gradient[j][1]);
      }
      most_k_ = std::max({most_k_, place.is_soil ? place.k.horizontal : 0.0, place.is_soil ? place.k.vertical : 0.0});
    }
    if (step_) held_before_ = held(step_->heads);
  }

  FlowResult solve(std::span<const Real> start)
  {
    const std::size_t n = mesh_.nodes.size();
    h_.assign(n, 0.0);
    Real full = -std::numeric_limits<Real>::infinity();
    for (const SurfacePlace& place : soil_.surface)
      if (place.condition != FlowCondition::seep) full = std::max(full, place.head);
    if (!std::isfinite(full))
      for (const FlowPlace& place : soil_.places) full = std::max(full, place.x[1]);
    for (std::size_t i = 0; i < n; ++i) h_[i] = unknown_[i] < 0 ? mesh_.nodes[i][1] : start.empty() ? full : start[i];
    const Real narrow = options_.band.width;
    if (!options_.is_saturated && !step_)
      for (const Real times : {16.0, 4.0}) {
        options_.band.width = times * narrow;
        iterate(1e-3, 30);
      }
    options_.band.width = narrow;
    const bool ended = iterate(options_.tolerance, options_.most_iterations);
    return result(ended);
  }

 private:
  /// Nodes of cells with soil that hang together with water; debris in the air has no equation.
  void find_unknowns()
  {
    const std::size_t n = mesh_.nodes.size();
    std::vector<Index> parent(n);
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&](Index i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    std::vector<char> has_soil(n, 0), is_led(n, 0);
    for (const FlowPlace& place : soil_.places) {
      const auto& nodes = mesh_.cells[place.cell];
      for (const Index i : nodes) {
        has_soil[i] = 1;
        if (place.is_soil) parent[root(i)] = root(nodes[0]);
      }
    }
    for (const SurfacePlace& place : soil_.surface)
      if (place.condition != FlowCondition::seep) is_led[root(mesh_.cells[place.cell][0])] = 1;
    if (step_) std::ranges::fill(is_led, 1);  // what is stored leads
    unknown_.assign(n, -1);
    for (std::size_t i = 0; i < n; ++i)
      if (has_soil[i] && is_led[root(static_cast<Index>(i))]) {
        unknown_[i] = static_cast<Index>(nodes_.size());
        nodes_.push_back(static_cast<Index>(i));
      }
  }

  Real psi_at(const FlowPlace& place, std::span<const Real> heads) const
  {
    return at_corners(mesh_, place.cell, place.shape, heads) - place.x[1];
  }

  Real relative(const FlowPlace& place) const
  {
    return options_.is_saturated || !place.is_soil ? 1.0 : options_.band.relative_permeability(psi_at(place, h_));
  }

  /// 1 in saturated cells, 0 where the mean k_r is below one half: there the condition is a penalty alone.
  void find_surface_permeability(bool may_grow)
  {
    std::vector<Real> sum(mesh_.cells.size(), 0.0), area(mesh_.cells.size(), 0.0);
    for (std::size_t q = 0; q < soil_.places.size(); ++q) {
      const FlowPlace& place = soil_.places[q];
      if (!place.is_soil) continue;
      sum[place.cell] += place.weight * k_r_[q];
      area[place.cell] += place.weight;
    }
    surface_k_r_.resize(soil_.surface.size(), 1.0);
    for (std::size_t q = 0; q < soil_.surface.size(); ++q) {
      const Index cell = soil_.surface[q].cell;
      const Real now = std::clamp(2.0 * sum[cell] / area[cell] - 1.0, 0.0, 1.0);
      surface_k_r_[q] = may_grow ? now : std::min(surface_k_r_[q], now);
    }
  }

  static Real penalty(const SurfacePlace& place)
  {
    return place.condition == FlowCondition::leak ? place.penalty : beta * place.penalty;
  }

  /// Not in debris in the air.
  bool has_equation(std::size_t q) const { return unknown_[mesh_.cells[soil_.surface[q].cell][0]] >= 0; }

  /// Outflow of a place of the surface if it takes part [m/s].
  Real outflow(std::size_t q) const
  {
    const SurfacePlace& place = soil_.surface[q];
    return penalty(place) * (at_corners(mesh_, place.cell, place.shape, h_) - place.head) +
           surface_k_r_[q] * at_corners(mesh_, place.cell, place.flux, h_);
  }

  /// Water that the soil about the nodes holds per area of section [m].
  std::vector<Real> held(std::span<const Real> heads) const
  {
    std::vector<Real> sum(nodes_.size(), 0.0);
    for (const FlowPlace& place : soil_.places) {
      if (!place.is_soil) continue;
      const Real psi = psi_at(place, heads);
      const Real water =
          place.storage.yield * options_.band.saturation(psi) + place.storage.elastic * (psi + place.x[1]);
      spread(place, water, sum);
    }
    return sum;
  }

  void spread(const FlowPlace& place, Real value, std::vector<Real>& sum) const
  {
    for (int i = 0; i < 4; ++i)
      if (const Index u = unknown_[mesh_.cells[place.cell][i]]; u >= 0) sum[u] += place.weight * place.shape[i] * value;
  }

  /// K and b of the heads as they are, with the places of the surface that take part.
  void assemble()
  {
    std::vector<LowerHalf> cells(mesh_.cells.size(), LowerHalf{});
    std::vector<char> has(mesh_.cells.size(), 0);
    b_.assign(nodes_.size(), 0.0);
    for (std::size_t q = 0; q < soil_.places.size(); ++q) {
      const Index cell = soil_.places[q].cell;
      has[cell] = 1;
      for (std::size_t k = 0; k < 10; ++k) cells[cell][k] += k_r_[q] * stiffness_[q][k];
    }
    for (std::size_t q = 0; q < soil_.surface.size(); ++q) {
      const SurfacePlace& place = soil_.surface[q];
      has[place.cell] = 1;
      const Real C = penalty(place), w = place.weight, k_r = surface_k_r_[q];
      const Corners &N = place.shape, &f = place.flux;
      if (!on_[q]) {
        const Real share = C > 0.0 ? w * k_r * k_r / C : 0.0;
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j <= i; ++j) cells[place.cell][lower(i, j)] -= share * f[i] * f[j];
        continue;
      }
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j <= i; ++j)
          cells[place.cell][lower(i, j)] += w * (C * N[i] * N[j] + k_r * (N[i] * f[j] + f[i] * N[j]));
        if (const Index u = unknown_[mesh_.cells[place.cell][i]]; u >= 0)
          b_[u] += w * place.head * (C * N[i] + k_r * f[i]);
      }
    }
    entries_.clear();
    for (Index cell = 0; cell < mesh_.n_cells(); ++cell) {
      if (!has[cell]) continue;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= i; ++j) {
          const Index u = unknown_[mesh_.cells[cell][i]], v = unknown_[mesh_.cells[cell][j]];
          if (u >= 0 && v >= 0) entries_.push_back({std::max(u, v), std::min(u, v), cells[cell][lower(i, j)]});
        }
    }
    if (step_) add_storage();
  }

  void add_storage()
  {
    std::vector<Real> capacity(nodes_.size(), 0.0);
    for (const FlowPlace& place : soil_.places)
      if (place.is_soil)
        spread(place, place.storage.yield * options_.band.saturation_slope(psi_at(place, h_)) + place.storage.elastic,
            capacity);
    const std::vector<Real> now = held(h_);
    for (std::size_t u = 0; u < nodes_.size(); ++u) {
      const auto i = static_cast<Index>(u);
      entries_.push_back({i, i, capacity[u] / step_->dt});
      b_[u] += (capacity[u] * h_[nodes_[u]] - (now[u] - held_before_[u])) / step_->dt;
    }
  }

  /// K h - b.
  std::vector<Real> residual() const
  {
    std::vector<Real> r(b_.size());
    for (std::size_t u = 0; u < r.size(); ++u) r[u] = b_[u];
    for (const MatrixEntry& e : entries_) {
      r[e.row] -= e.value * h_[nodes_[e.column]];
      if (e.row != e.column) r[e.column] -= e.value * h_[nodes_[e.row]];
    }
    return r;
  }

  /// Which places of seepage faces take part, as water comes out of them. Returns how many changed.
  int switch_places()
  {
    int flips = 0;
    for (std::size_t q = 0; q < on_.size(); ++q) {
      const bool now = soil_.surface[q].condition != FlowCondition::seep || outflow(q) > 0.0;
      if (now == static_cast<bool>(on_[q])) continue;
      if (!is_first_ && ++turns_[q] > changes_allowed) continue;
      on_[q] = now;
      ++flips;
    }
    if (is_first_) flips = 0;
    is_first_ = false;
    return flips;
  }

  /// Change of h at the places of the soil that counts, over the height.
  Real size_of(const std::vector<Real>& dh) const
  {
    Real most = 0.0;
    for (const FlowPlace& place : soil_.places)
      if (place.is_soil) most = std::max(most, std::abs(at_corners(mesh_, place.cell, place.shape, dh)));
    return most / std::max(soil_.height, 1e-9);
  }

  struct Past {
    std::vector<Real> h, dh;
  };

  void mix(std::vector<Past>& past, const std::vector<Real>& dh)
  {
    std::vector<std::vector<Real>> df, dx;
    for (std::size_t k = 0; k + 1 < past.size(); ++k) {
      df.push_back(past[k].dh), dx.push_back(past[k].h);
      for (std::size_t u = 0; u < dh.size(); ++u) df.back()[u] -= past.back().dh[u], dx.back()[u] -= past.back().h[u];
    }
    const std::vector<Real> c = nearest(df, dh);
    std::vector<Real> x(dh.size()), rest = dh;
    for (std::size_t u = 0; u < dh.size(); ++u) x[u] = past.back().h[u];
    for (std::size_t k = 0; k < c.size(); ++k)
      for (std::size_t u = 0; u < dh.size(); ++u) x[u] += c[k] * dx[k][u], rest[u] += c[k] * df[k][u];
    for (std::size_t u = 0; u < dh.size(); ++u) h_[nodes_[u]] = x[u] + mixing * rest[u];
  }

  bool iterate(Real tolerance, int most)
  {
    const std::size_t n = nodes_.size(), n_surface = soil_.surface.size();
    if (n == 0) return true;
    on_.assign(n_surface, 0), turns_.assign(n_surface, 0), is_first_ = true;
    k_r_.resize(soil_.places.size());
    Real last = std::numeric_limits<Real>::infinity();
    std::vector<Past> past;
    for (int it = 1; it <= most; ++it) {
      ++iterations_;
      for (std::size_t q = 0; q < soil_.places.size(); ++q) k_r_[q] = relative(soil_.places[q]);
      find_surface_permeability(it <= permeability_settles);
      const int flips = switch_places();
      assemble();
      factor_.factor(static_cast<Index>(n), entries_);
      if (!factor_.is_factored()) return false;
      std::vector<Real> dh = residual();
      factor_.solve(dh, dh);
      std::vector<Real> of_nodes(h_.size(), 0.0), now(n);
      for (std::size_t u = 0; u < n; ++u) of_nodes[nodes_[u]] = dh[u], now[u] = h_[nodes_[u]];
      change_ = size_of(of_nodes);
      if (!std::isfinite(change_)) return false;
      if (change_ > 2.0 * last) past.clear();
      last = change_;
      past.push_back({std::move(now), dh});
      if (past.size() > remembers + 1) past.erase(past.begin());
      if (past.size() > 1 && flips <= 1 + static_cast<int>(n_surface / 50)) {
        mix(past, dh);
      } else {
        past.erase(past.begin(), past.end() - 1);
        for (std::size_t u = 0; u < n; ++u) h_[nodes_[u]] += dh[u];
      }
      if (change_ >= tolerance || flips > 0) continue;
      find_imbalance();
      if (imbalance_ > balance_bound && tolerance < 1e-4) continue;
      if (misfit_ > misfit_bound) {  // the places that were kept must fit
        std::ranges::fill(turns_, 0);
        past.clear();
        continue;
      }
      return true;
    }
    return false;
  }

  void find_imbalance()
  {
    Real sum = 0.0, flow = 0.0, wrong = 0.0;
    for (std::size_t q = 0; q < on_.size(); ++q) {
      if (!has_equation(q)) continue;
      const Real t = soil_.surface[q].weight * outflow(q);
      const bool is_face = soil_.surface[q].condition == FlowCondition::seep;
      if (is_face && static_cast<bool>(on_[q]) != (t > 0.0)) wrong += std::abs(t);
      if (!on_[q]) continue;
      sum += t;
      flow += std::abs(t);
    }
    const Real scale = std::max(flow, least_flow * most_k_ * soil_.height);
    imbalance_ = step_ ? 0.0 : std::abs(sum) / scale;
    misfit_ = wrong / scale;
  }

  FlowResult result(bool ended)
  {
    FlowResult result;
    result.heads = h_, result.change = change_, result.iterations = iterations_;
    for (const Index u : unknown_) result.has_flow.push_back(u >= 0);
    result.outflow.resize(parts_, 0.0);
    if (!nodes_.empty()) find_imbalance();
    for (std::size_t q = 0; q < soil_.surface.size(); ++q) {
      const bool is_on = !nodes_.empty() && on_[q] != 0 && has_equation(q);
      result.is_wet.push_back(is_on);
      result.q.push_back(is_on ? outflow(q) : 0.0);
      result.outflow[soil_.surface[q].part] += soil_.surface[q].weight * result.q.back();
    }
    result.imbalance = imbalance_, result.misfit = misfit_;
    result.counts = ended && imbalance_ <= balance_bound && misfit_ <= misfit_bound;
    return result;
  }

  const Mesh<2>& mesh_;
  const FlowSoil& soil_;
  std::size_t parts_;
  FlowOptions options_;
  std::optional<FlowStep> step_;
  std::vector<Index> unknown_;        // by nodes: number of the equation; -1: none
  std::vector<Index> nodes_;          // by equations
  std::vector<LowerHalf> stiffness_;  // by places, saturated
  std::vector<Real> h_, b_, k_r_, surface_k_r_, held_before_;
  std::vector<char> on_;
  std::vector<int> turns_;
  std::vector<MatrixEntry> entries_;
  SparseCholesky factor_;
  Real most_k_ = 0.0, change_ = 0.0, imbalance_ = 0.0, misfit_ = 0.0;
  int iterations_ = 0;
  bool is_first_ = true;
};

}  // namespace

FlowResult find_flow(const Mesh<2>& mesh, const FlowSoil& soil, std::size_t parts, const FlowOptions& options,
    std::span<const Real> start, const std::optional<FlowStep>& step)
{
  return Flow(mesh, soil, parts, options, step).solve(start);
}

}  // namespace terp
