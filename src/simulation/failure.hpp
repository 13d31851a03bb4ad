// How the soil fails, as it is followed during a run: front, crest, what moved, slip surfaces. Definitions:
// docs/formats.md. Not for: when a slide began and stopped (events/crest, from the rows).
#pragma once

#include "simulation/model.hpp"
#include "simulation/observer.hpp"
#include "simulation/state.hpp"
#include "simulation/summary.hpp"
#include "simulation/totals.hpp"

namespace terp {

/// Looks at the section as it is now, and forgets what was followed before.
void start_following(const Model& model, Columns columns, State& state);

/// The columns in which the strain of each slope counts, in the order of state.slopes.
std::vector<Columns> shear_columns(const State& state);

/// Enters front, crest and moved volume into the row and the state; keeps the slip surface if the strain has never
/// grown faster in this slide. The row must hold time and nodal kinetic energy; the audit remembers the strain of the
/// row before.
void follow_failure(const Model& model, const Totals& totals, State& state, LedgerRow& row);

/// Fills what the summary says of the failure.
void summarise_failure(const Model& model, const State& state, Summary& summary);

}  // namespace terp
