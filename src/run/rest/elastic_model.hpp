// The soil of a case without any limit to its strength: where soil that cannot stand, or shall not yield yet, comes to
// rest. Not for: the search itself (initial).
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/observer.hpp"
#include "run/loop/state.hpp"

namespace terp {

/// The case with every law that has a strength replaced by linear_elastic of the same stiffness, and contact planes
/// with adhesion or friction that never slip. The points carry the rows of `others` too, with their initial values.
Model build_elastic_model(const Case& c, const SharedMesh& mesh, int threads, const RowTable& others);

/// The state of such a model with the rows of `table` alone, as a model of that table can restore it.
StateImage image_of_rows(const State& state, const RowTable& table);

}  // namespace terp
