// One material point in the hands of a test: strain it, read what the law made of it.
#pragma once

#include "base/tensor.hpp"
#include "materials/material.hpp"
#include "parallel/pack.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace terp::test {

using Stress = SymTensor<Real, 2>;

/// A law with its parameters in the order of its table. The arrays of one call hold eight points.
class Probe {
 public:
  Probe(const MaterialType& type, const std::vector<Real>& parameters) : type_(&type), law_(type.make(parameters)) {}

  static constexpr Real dt = 1e-3;  ///< length of each step [s]
  Stress sigma{};                   ///< [Pa]
  std::array<Real, max_state> state{};
  Real plastic_work = 0.0;  ///< of the last increment [J/m^3]

  /// One increment of this point alone: it takes lane 0, the other seven hold something else.
  void strain(const Stress& d_eps)
  {
    std::array<Probe*, 1> one{this};
    strain_together(one, {d_eps}, 7);
  }

  /// One increment of up to eight points of the same law in one call. stray: seed of what the unused lanes hold.
  template <class Probes>
  static void strain_together(Probes& points, const std::vector<Stress>& d_eps, int stray)
  {
    Lanes lanes;
    for (int k = 0; k < pack_width; ++k) {
      const bool used = k < static_cast<int>(d_eps.size());
      for (int c = 0; c < 4; ++c) {
        lanes.sigma[c][k] = used ? points[k]->sigma[c] : 1e4 * std::sin(stray + 3.0 * k + c);
        lanes.d_eps[c][k] = used ? d_eps[k][c] : 1e-2 * std::cos(stray + k + 5.0 * c);
      }
      for (int s = 0; s < max_state; ++s) lanes.state[s][k] = used ? points[k]->state[s] : 0.01 * k;
    }
    points[0]->law_->update(lanes.arrays());
    for (int k = 0; k < static_cast<int>(d_eps.size()); ++k) {
      for (int c = 0; c < 4; ++c) points[k]->sigma[c] = lanes.sigma[c][k];
      for (int s = 0; s < max_state; ++s) points[k]->state[s] = lanes.state[s][k];
      points[k]->plastic_work = lanes.plastic_work[k];
    }
  }

  const MaterialType& type() const { return *type_; }
  const Material& law() const { return *law_; }

 private:
  struct Lanes {
    alignas(64) Real sigma[4][pack_width], d_eps[4][pack_width], state[max_state][pack_width], plastic_work[pack_width];
    StressArrays<2> arrays()
    {
      StressArrays<2> a{};
      for (int c = 0; c < 4; ++c) a.sigma[c] = sigma[c];
      for (int c = 0; c < 4; ++c) a.d_eps[c] = d_eps[c];
      for (int s = 0; s < max_state; ++s) a.state[s] = state[s];
      a.plastic_work = plastic_work;
      a.n = pack_width;
      a.dt = dt;
      return a;
    }
  };
  const MaterialType* type_;
  std::unique_ptr<Material> law_;
};

/// Principal stresses from large to small, by the textbook formula [Pa].
inline std::array<Real, 3> sorted_principal(const Stress& s)
{
  const Real mean = 0.5 * (s[0] + s[1]), radius = std::hypot(0.5 * (s[0] - s[1]), s[3]);
  std::array<Real, 3> values{mean + radius, mean - radius, s[2]};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

/// The tensor seen from a frame turned by `angle` [rad] about zz.
inline Stress rotated(const Stress& s, Real angle)
{
  const Real c = std::cos(angle), d = std::sin(angle);
  return {{c * c * s[0] + d * d * s[1] + 2.0 * c * d * s[3], d * d * s[0] + c * c * s[1] - 2.0 * c * d * s[3], s[2],
      c * d * (s[1] - s[0]) + (c * c - d * d) * s[3]}};
}

}  // namespace terp::test
