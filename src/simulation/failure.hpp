// How the soil fails, as it is followed during a run: front, crest, what moved, slip surfaces. Definitions:
// docs/formats.md. Not for: when a slide began and stopped (events/crest, from the rows).
#pragma once

#include "simulation/ledger_context.hpp"
#include "simulation/summary.hpp"

namespace terp {

/// Looks at the section as it is now, and forgets what was followed before.
void start_following(const Model& model, Columns columns, State& state);

/// The columns in which the strain of each slope counts, in the order of state.slopes.
std::vector<Columns> shear_columns(const State& state);

/// Columns of ledger.csv.
inline constexpr std::array failure_columns{
    QuantityInfo{"front_x", "m", "front", "front of the slope to the right"},
    QuantityInfo{"crest_x", "m", "crest", "x of the crest of the slope to the right"},
    QuantityInfo{"crest_y", "m", "height of the crest", "height of the surface there"},
    QuantityInfo{"front_left_x", "m", "front to the left", "front of the slope to the left"},
    QuantityInfo{"crest_left_x", "m", "crest to the left", "x of the crest of the slope to the left"},
    QuantityInfo{"crest_left_y", "m", "height of the crest to the left", "height of the surface there"},
    QuantityInfo{"moved_volume", "m^2", "volume that moved", "volume of the points that moved"},
};

/// Enters the columns of the failure into `values`, which are NaN; keeps the slip surface if the strain has never grown
/// faster in this slide. The audit remembers the strain of the row before.
void follow_failure(const LedgerContext& context, State& state, std::span<Real> values);

/// Fills what the summary says of the failure.
void summarise_failure(const Model& model, const State& state, Summary& summary);

}  // namespace terp
