// One material point in the hands of a test: strain it, read what the law made of it.
#pragma once

#include "math/tensor.hpp"
#include "soil/laws/material.hpp"
#include "math/pack.hpp"
#include "support/random.hpp"
#include "support/test.hpp"

namespace terp::test {

using Stress = SymTensor<Real, 2>;

/// A law with its parameters in the order of its table. The arrays of one call hold eight points.
class Probe {
 public:
  Probe(const MaterialType& type, const std::vector<Real>& parameters) : Probe(type, parameters, {}, {}) {}
  /// Parameters left out have their defaults. varying: numbers of those that the point brings along; own: their values.
  Probe(const MaterialType& type, const std::vector<Real>& parameters, const std::vector<int>& varying,
      std::vector<Real> own)
      : own_parameters(std::move(own)), type_(&type), law_(type.make_varying(type.complete(parameters), varying))
  {
    for (const StateInfo& info : type.state) state.push_back(info.initial);
  }

  Real dt = 1e-3;           ///< length of each step [s]
  Real at_strength = 1.0;   ///< by which strengths are divided
  Real scale = 1.0;         ///< of softening, h/t_ref; of laws that take one
  Stress sigma{};           ///< [Pa]
  std::vector<Real> state;  ///< in the order of the law's table
  std::vector<Real> own_parameters;
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
    Lanes lanes(points[0]->state.size(), points[0]->own_parameters.size(), d_eps.size());
    for (int k = 0; k < pack_width; ++k) {
      const bool used = k < static_cast<int>(d_eps.size());
      for (int c = 0; c < 4; ++c) {
        lanes.sigma[c][k] = used ? points[k]->sigma[c] : 1e4 * std::sin(stray + 3.0 * k + c);
        lanes.scale[k] = used ? points[k]->scale : 1.0;
        lanes.d_eps[c][k] = used ? d_eps[k][c] : 1e-2 * std::cos(stray + k + 5.0 * c);
      }
      for (std::size_t s = 0; s < lanes.n_state; ++s) lanes.rows[s][k] = used ? points[k]->state[s] : 0.01 * k;
      for (std::size_t s = lanes.n_state; s < lanes.rows.size(); ++s)
        lanes.rows[s][k] = used ? points[k]->own_parameters[s - lanes.n_state] : 0.0;  // as the padding of a block
    }
    StressArrays<2> arrays = lanes.arrays(points[0]->dt);
    arrays.at_strength = points[0]->at_strength;
    points[0]->law_->update(arrays);
    for (int k = 0; k < static_cast<int>(d_eps.size()); ++k) {
      for (int c = 0; c < 4; ++c) points[k]->sigma[c] = lanes.sigma[c][k];
      for (std::size_t s = 0; s < lanes.n_state; ++s) points[k]->state[s] = lanes.rows[s][k];
      points[k]->plastic_work = lanes.plastic_work[k];
    }
  }

  /// The same where all eight lanes hold this point: then a law may take a shorter way.
  void strain_in_all_lanes(const Stress& d_eps)
  {
    std::vector<Probe> copies(pack_width, *this);
    std::array<Probe*, pack_width> points;
    for (int k = 0; k < pack_width; ++k) points[k] = &copies[k];
    strain_together(points, std::vector<Stress>(pack_width, d_eps), 0);
    *this = copies[0];
  }

  const MaterialType& type() const { return *type_; }
  const Material& law() const { return *law_; }
  Moduli moduli() { return law_->moduli_at({{.data = state.data()}, {.data = own_parameters.data()}}, sigma); }
  Real derived(int k) { return law_->derived(k, {{.data = state.data()}, {.data = own_parameters.data()}}); }

 private:
  struct Lanes {
    struct alignas(64) Row {
      Real value[pack_width];
      Real& operator[](int k) { return value[k]; }
    };
    alignas(64) Real sigma[4][pack_width], d_eps[4][pack_width], scale[pack_width], plastic_work[pack_width];
    std::vector<Row> rows;  // state, then parameters of the points
    std::size_t n_state, n_points;

    Lanes(std::size_t state, std::size_t parameters, std::size_t points)
        : rows(state + parameters), n_state(state), n_points(points)
    {
    }

    StressArrays<2> arrays(Real dt)
    {
      StressArrays<2> a{};
      for (int c = 0; c < 4; ++c) a.sigma[c] = sigma[c];
      for (int c = 0; c < 4; ++c) a.d_eps[c] = d_eps[c];
      a.law.state = {.data = reinterpret_cast<Real*>(rows.data()), .stride = pack_width};
      a.law.parameters = {.data = a.law.state(n_state), .stride = pack_width};
      a.softening_scale = scale;
      a.plastic_work = plastic_work;
      a.n = pack_width;
      a.n_points = static_cast<Index>(n_points);
      a.dt = dt;
      return a;
    }
  };
  const MaterialType* type_;
  std::shared_ptr<const Material> law_;  // a copy of a point has the same law
};

/// Strains by n equal parts.
inline void strain_in_parts(Probe& point, Stress d_eps, int n)
{
  for (int k = 0; k < 4; ++k) d_eps[k] /= n;
  for (int k = 0; k < n; ++k) point.strain(d_eps);
}

/// Each component between -size and size.
inline Stress random_tensor(Real size, Random& random)
{
  Stress tensor;
  for (int c = 0; c < 4; ++c) tensor[c] = random.between(-size, size);
  return tensor;
}

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

inline testing::Matcher<const ParameterProblem&> problem(
    const std::string& parameter, const std::string& what, const std::string& detail)
{
  return AllOf(testing::Field("parameter", &ParameterProblem::parameter, parameter),
      testing::Field("what", &ParameterProblem::what, what),
      testing::Field("detail", &ParameterProblem::detail, detail));
}

}  // namespace terp::test
