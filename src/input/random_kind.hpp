// The kind of field `random`: a mean, and a Gaussian random field about it. docs/probability.md.
#pragma once

#include "input/field_kinds.hpp"

namespace terp {

/// value: the table of the key `random`. None, with a problem added, if it is not allowed.
std::optional<FieldValue> read_random(const Node& value, const FieldContext& context);

/// Words of `distribution`, in the order of FieldMarginal.
std::vector<std::string> random_distributions();

/// What `terp explain field` says of the keys.
std::string describe_random_keys();

}  // namespace terp
