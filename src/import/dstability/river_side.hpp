// At which end of a stage the river is: what the file says, or its water. docs/dstability.md, "The river".
// Not for: its level under a trigger (trigger.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/section.hpp"

#include <string>

namespace terp {

struct StixRiver {
  std::string side = {};    ///< "left", "right"; empty: it cannot be told
  std::string origin = {};  ///< how the side is known, in words
  Sentence doubt = {};      ///< what speaks against it, a sentence; empty: nothing
};

/// Whether water stands on the ground at x.
bool water_stands_at(const StixSection& section, Real x);

/// Between two ends [m].
StixRiver find_river(const StixSection& section, Vec<2> ends);

/// That a case has no [flood], and why: no river to hold back at an end [m] of a section with cells of that size [m].
/// Empty: there is one.
Sentence no_flood_because(const StixSection& section, const StixRiver& river, Real end, Real cell);

/// What a river above the crest [m] means for the verdict.
Sentence river_above_crest(Real level, Real crest);

/// Throws InputError unless the river can get another level: its side is known without doubt, and its water.
/// x: of its end [m].
void check_river_to_move(const StixSection& section, const StixRiver& river, Real x);

}  // namespace terp
