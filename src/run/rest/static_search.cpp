// How it thinks: u += K^-1 R is the answer of elastic soil. Soil that yields needs more, and the last few answers tell
// how much (Anderson acceleration, Walker and Ni 2011, SIAM J. Numer. Anal. 49, in the norm of energy). What an update
// changes beside that, as slip in cut cells and pressures of patches, comes to rest in a tail of updates by increments,
// as in a run.

#include "run/rest/static_search.hpp"

#include "run/rest/search_windows.hpp"
#include "run/rest/statics.hpp"
#include "run/rest/stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace terp {
namespace {

constexpr int n_parts = 10;         // of the forces out of balance (decision 0082)
constexpr Real inner_limit = 5e-4;  // of force over weight, after each part but the last
constexpr std::size_t n_remembered = 8;
constexpr Real blown_up = 3.0;  // over the least force so far: what is remembered does not hold any more
constexpr int most_iterations = 600, most_in_tail = 300;
constexpr int watched = 25, n_watched = 2;  // iterations between two looks; looks in which the force has to fall
constexpr Real least_fall = 0.9;            // over them
constexpr int least_in_tail = 3;

Real dot(const NodeVector& a, const NodeVector& b)
{
  Real sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

NodeVector difference(const NodeVector& a, const NodeVector& b)
{
  NodeVector c(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) c[k] = a[k] - b[k];
  return c;
}

/// Of Anderson's method: how displacements, answers and forces changed in the last iterations.
class Memory {
 public:
  void forget() { changes_.clear(), has_last_ = false; }

  /// Adds to u what the forces r ask for. g: K^-1 r.
  void advance(const NodeVector& r, const NodeVector& g, NodeVector& u)
  {
    if (has_last_) changes_.push_back({difference(u, u_), difference(g, g_), difference(r, r_)});
    if (changes_.size() > n_remembered) changes_.pop_front();
    u_ = u, g_ = g, r_ = r, has_last_ = true;
    const std::vector<Real> gamma = shares(r);
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += g[k];
    for (std::size_t a = 0; a < gamma.size(); ++a)
      for (std::size_t k = 0; k < u.size(); ++k) u[k] -= gamma[a] * (changes_[a].u[k] + changes_[a].g[k]);
  }

 private:
  struct Change {
    NodeVector u, g, r;
  };

  /// gamma of A gamma = b, with A_ab = dg_a . dr_b and b_a = dg_a . r: A is symmetric, as g is K^-1 r.
  std::vector<Real> shares(const NodeVector& r) const
  {
    const std::size_t n = changes_.size();
    std::vector<std::vector<Real>> a(n, std::vector<Real>(n));
    std::vector<Real> x(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) a[i][j] = dot(changes_[i].g, changes_[j].r);
      a[i][i] *= 1.0 + 1e-10;  // changes that are nearly the same
      x[i] = dot(changes_[i].g, r);
    }
    for (std::size_t i = 0; i < n; ++i) {  // A = L L^T
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
        if (j < i) a[i][j] /= a[j][j];
      }
      if (!(a[i][i] > 0.0)) return {};
      a[i][i] = std::sqrt(a[i][i]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= a[i][k] * x[k];
      x[i] /= a[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) x[i] -= a[k][i] * x[k];
      x[i] /= a[i][i];
    }
    return x;
  }

  std::deque<Change> changes_;
  NodeVector u_, g_, r_;
  bool has_last_ = false;
};

/// Whether the least force so far still falls.
class Watch {
 public:
  bool falls(Real ratio)
  {
    least_ = std::min(least_, ratio);
    if (++n_ % watched == 0) looks_.push_back(least_);
    const std::size_t n = looks_.size();
    return n <= n_watched || looks_[n - 1] <= least_fall * looks_[n - 1 - n_watched];
  }

 private:
  int n_ = 0;
  Real least_ = std::numeric_limits<Real>::infinity();
  std::vector<Real> looks_;
};

class StaticSearch {
 public:
  StaticSearch(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop,
      const SearchCallback& report, std::int64_t& n_iterations)
      : soil_(model, state, work), stop_(stop), report_(report), n_(n_iterations), initial_(model.description.initial)
  {
    find_forces(0.0);
    if (!soil_.is_finite()) return;
    soil_.strain(NodeVector(soil_.forces().size(), 0.0));  // stress beyond the strength comes back to it
    find_forces(0.0);
    soil_.hold_forces();
  }

  StaticEnd run()
  {
    if (!soil_.is_finite()) return give_up();
    const SparseCholesky stiffness = factor_stiffness(soil_.model(), soil_.state(), soil_.work());
    if (!stiffness.is_factored()) return give_up();
    for (int part = 1; part <= n_parts; ++part)
      if (!come_to_rest(stiffness, part)) return give_up();
    return settle_by_increments(stiffness) ? StaticEnd::rests : give_up();
  }

 private:
  StaticEnd give_up()
  {
    soil_.go_back_to_start();
    return stop_.load() ? StaticEnd::stopped : StaticEnd::unknown;
  }

  void find_forces(Real held)
  {
    soil_.find_forces(held);
    ++n_;
    if (report_) report_({n_, soil_.ratio(), std::nullopt});
  }

  bool may_go_on(int n) const
  {
    return !stop_.load() && n < most_iterations && n_ < initial_.max_steps && soil_.is_finite();
  }

  bool is_within(Real limit, Real of_most) const { return soil_.ratio() <= limit && soil_.ratio_of_most() <= of_most; }

  bool come_to_rest(const SparseCholesky& stiffness, int part)
  {
    const Real held = 1.0 - static_cast<Real>(part) / n_parts;
    find_forces(held);
    soil_.keep();
    NodeVector u(soil_.forces().size(), 0.0), best = u, g(u.size());
    Memory memory;
    Watch watch;
    Real least = std::numeric_limits<Real>::infinity();
    for (int n = 0; may_go_on(n); ++n) {
      if (n > 0) {
        soil_.go_back();
        soil_.strain(u);
        find_forces(held);
      }
      if (part < n_parts ? is_within(inner_limit, 10.0 * part_out_of_balance)
                         : is_within(initial_.limit, part_out_of_balance))
        return true;
      if (!watch.falls(soil_.ratio())) return false;
      if (soil_.ratio() < least) least = soil_.ratio(), best = u;
      if (soil_.ratio() > blown_up * least) {
        memory.forget();
        u = best;
        soil_.go_back(), soil_.strain(u), find_forces(held);
      }
      stiffness.solve(soil_.forces(), g);
      memory.advance(soil_.forces(), g, u);
    }
    return false;
  }

  /// v = ((2 - c) v + 2 K^-1 R)/(2 + c) with the damping c of the motion as it is, at least 1: an over-damped motion,
  /// which does not yield on its way.
  bool settle_by_increments(const SparseCholesky& stiffness)
  {
    NodeVector v(soil_.forces().size(), 0.0), force_of_v = v, before = soil_.forces(), a(v.size());
    Real c = 2.0;
    Watch watch;
    soil_.strain(v);
    for (int n = 0; may_go_on(n) && n < most_in_tail; ++n) {
      find_forces(0.0);
      const NodeVector& r = soil_.forces();
      if (n >= least_in_tail && is_within(initial_.limit, part_out_of_balance)) return true;
      if (!watch.falls(soil_.ratio())) return false;
      const Real inertia = dot(v, force_of_v);
      const Real square = inertia > 0.0 && n > 1 ? std::max(dot(v, difference(before, r)) / inertia, 0.0) : 1.0;
      c = std::max(c + 0.2 * (std::min(2.0 * std::sqrt(square), 1.9) - c), 1.0);
      stiffness.solve(r, a);
      for (std::size_t k = 0; k < v.size(); ++k) {
        v[k] = ((2.0 - c) * v[k] + 2.0 * a[k]) / (2.0 + c);
        force_of_v[k] = ((2.0 - c) * force_of_v[k] + 2.0 * r[k]) / (2.0 + c);  // K v
      }
      before = r;
      soil_.strain(v);
    }
    return false;
  }

  Statics soil_;
  const std::atomic<bool>& stop_;
  const SearchCallback& report_;
  std::int64_t& n_;
  const InitialCase& initial_;
};

}  // namespace

StaticEnd search_statically(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop,
    const SearchCallback& report, std::int64_t& n_iterations)
{
  if (model.gravity == Vec<2>{0.0, 0.0} || work.active_nodes.empty()) return StaticEnd::unknown;
  return StaticSearch(model, state, work, stop, report, n_iterations).run();
}

}  // namespace terp
