// The kind of field `random`: a mean, and a Gaussian random field about it. docs/probability.md.
#pragma once

#include "io/case/field_kinds.hpp"
#include "model/soils/gaussian_field.hpp"

namespace terp {

/// What the table says.
struct RandomField {
  GaussianFieldCase field;
  FieldMarginal marginal = FieldMarginal::lognormal;
  Real cov = 0.0;
  FieldValue mean;
};
/// value: the table of the key `random`. None, with a problem added, if it is not allowed.
std::optional<RandomField> read_random_field(const Node& value, const FieldContext& context);

/// The same as a value at each place. None, with a problem added, if it is not allowed.
std::optional<FieldValue> read_random(const Node& value, const FieldContext& context);

/// Words of `distribution`, in the order of FieldMarginal.
std::vector<std::string> random_distributions();
/// Words of `correlation`, and what each means.
std::vector<std::string> random_correlations();
const CorrelationKind& correlation_named(std::string_view name);

/// What `terp explain field` says of the keys.
std::string describe_random_keys();

}  // namespace terp
