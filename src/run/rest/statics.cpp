// Both halves of a step are kernels (mpm/step/kernels.hpp).

#include "run/rest/statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real most = 0.99;  // of the mass: single grains on a slope may hang in the air

/// The value that this share of the mass does not exceed. list: pairs of value and mass.
Real quantile_by_mass(std::vector<std::pair<Real, Real>>& list, Real share)
{
  std::ranges::sort(list);
  Real all = 0.0, sum = 0.0;
  for (const auto& [value, mass] : list) all += mass;
  for (const auto& [value, mass] : list)
    if ((sum += mass) >= share * all) return value;
  return 0.0;
}

}  // namespace

Statics::Statics(const Model& model, State& state, Workspace& work) : model_(model), state_(state), work_(work)
{
  start_.keep(model, state, work);
  begin_search(0.0, work);
}

void Statics::find_forces(Real held_share)
{
  model_.find_forces(model_, state_, work_);
  ratio_ = of_most_ = std::numeric_limits<Real>::infinity();
  if (!work_.finite) return;
  forces_.clear(), all_.clear();
  std::vector<std::pair<Real, Real>> parts;
  Real sum = 0.0, weight = 0.0;
  const Real g = std::hypot(work_.gravity[0], work_.gravity[1]);
  for (const Index i : work_.active_nodes) {
    const NodeValues& node = work_.node[i];
    Vec<2> force = node.internal;
    all_.insert(all_.end(), force.begin(), force.end());
    if (!held_.empty())
      for (int d = 0; d < 2; ++d) force[d] -= held_share * held_[all_.size() - 2 + static_cast<std::size_t>(d)];
    if (model_.with.sides->boundary.at(i) != nullptr) force = model_.with.sides->boundary.free_force(i, force, 1.0);
    forces_.insert(forces_.end(), force.begin(), force.end());
    sum += std::abs(force[0]) + std::abs(force[1]);
    weight += node.mass * (std::abs(work_.gravity[0]) + std::abs(work_.gravity[1]));
    if (node.mass > 0.0) parts.emplace_back(std::hypot(force[0], force[1]) / (node.mass * g), node.mass);
  }
  ratio_ = sum / weight;
  of_most_ = quantile_by_mass(parts, most);
}

void Statics::hold_forces() { held_ = all_; }

void Statics::strain(std::span<const Real> u)
{
  std::size_t k = 0;
  for (const Index i : work_.active_nodes)
    for (Real& v : work_.node[i].v) v = u[k++] / model_.dt;
  model_.strain(model_, state_, work_);
}

}  // namespace terp
