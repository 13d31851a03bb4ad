// How the soil fails, as it is followed during a run: front, crest, what moved, slip surfaces. Definitions: docs/formats.md.
// Not for: when a slide began and stopped (events/crest, from the rows).
#pragma once

#include "simulation/model.hpp"
#include "simulation/observer.hpp"
#include "simulation/state.hpp"
#include "simulation/summary.hpp"

namespace terp {

/// Looks at the section as it is now, and forgets what was followed before.
void start_following(Columns columns, State& state);

/// Enters front, crest and moved volume into the row and the state; keeps the slip surface if the strain has never grown faster in this
/// slide. The row must hold time and nodal kinetic energy, the audit the growth of the strain since the row before.
void follow_failure(const Model& model, State& state, LedgerRow& row);

/// Fills what the summary says of the failure.
void summarise_failure(const Model& model, const State& state, Summary& summary);

}  // namespace terp
