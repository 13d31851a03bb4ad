// A Gaussian random field over the section, the same on any mesh: a function of the seed, the number of the realisation
// and the place. The correlation is separable: rho(|dx|/theta_x) rho(|dy|/theta_y) of a kind (correlation_kind.hpp).
// docs/probability.md. Not for: how a case file writes it (io/case/random_kind).
#pragma once

#include "model/soils/correlation_kind.hpp"
#include "model/case/parameter_field.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace terp {

/// Value z of a standard normal variable with Phi(z) = p, 0 < p < 1, to 1e-15 relative.
Real normal_quantile(Real p);

/// A value that is known at a place, as the score of a standard normal variable.
struct KnownScore {
  Vec<2> x;  ///< [m]
  Real score;
};

struct GaussianFieldCase {
  std::uint32_t seed = 0, realisation = 0;
  Vec<2> scale{1.0, 1.0};                ///< of fluctuation, theta_x and theta_y [m]
  Vec<2> low{0.0, 0.0}, high{0.0, 0.0};  ///< corners of the box in which it has values [m]
  /// Numbers of independent fields and their weights, whose squares add up to one: correlated fields share some.
  std::vector<std::pair<std::uint32_t, Real>> parts = {{0, 1.0}};
  std::vector<KnownScore> known = {};  ///< the field has these scores there (kriging of the residual)
  const CorrelationKind* correlation = correlation_kinds().data();
};

/// Standard normal values on a grid whose nodes stand at whole multiples of an eighth of the scales of fluctuation,
/// counted from x = y = 0; a place takes the value of the nearest node. So neither the mesh nor the box changes a
/// value.
class GaussianField {
 public:
  /// Known scores at one node count with their mean. Throws RunError where one of them follows from the others, which
  /// are so close, or contradicts them.
  explicit GaussianField(const GaussianFieldCase& field);

  /// Not a number outside of the box.
  Real at(Vec<2> x) const;

  /// Nodes that must be made for it: all between x = y = 0 and the box, or all that a moving average takes.
  static double n_nodes(const GaussianFieldCase& field);

  static constexpr Real nodes_per_scale = 8.0;

 private:
  /// Nodes along one direction: those with values, and all that are made for them.
  struct Axis {
    Real spacing;  ///< [m]
    Index first, last, begin, end;
    Axis(Real low, Real high, Real scale, const CorrelationKind& kind);
    Index n() const { return last - first + 1; }
    Index node_of(Real x) const;
  };
  /// Independent standard normal numbers of one node of a field: which one, column, row.
  using Noise = std::function<Real(std::size_t, Index, Index)>;

  void add_chains(const Noise& noise, Real weight);
  void add_averages(const Noise& noise, Real weight);
  void add_to_row(Index j, Real weight, const std::vector<Real>& row);  ///< row: from x_.begin on
  void condition(const std::vector<KnownScore>& known);
  std::vector<std::pair<std::array<Index, 2>, Real>> by_node(const std::vector<KnownScore>& known) const;
  Real& value(Index i, Index j);

  const CorrelationKind& kind_;
  Vec<2> low_, high_;
  Axis x_, y_;
  std::vector<Real> values_;  ///< shape [n_y, n_x]
};

enum class FieldMarginal { lognormal, normal };

/// Value over mean at a score, of mean 1 and that coefficient of variation.
Real value_over_mean(FieldMarginal marginal, Real cov, Real score);
/// The score of a value over mean; not a number where no score has it.
Real score_of(FieldMarginal marginal, Real cov, Real value);

/// mean(x) times the field's value over mean.
FieldValue by_random(const GaussianFieldCase& field, FieldMarginal marginal, Real cov, FieldValue mean);

}  // namespace terp
