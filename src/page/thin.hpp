// Frames that nobody misses when the run is played. Not for: what else makes a page smaller (shown).
#pragma once

#include "page/shown.hpp"
#include "run/report/summary.hpp"

namespace terp {

/// Times of which the page has pictures, or marks on its bar [s].
std::vector<Real> moments_of(const Summary& summary);

/// Leaves out frames between which hardly anything moves and no colour changes much; never those of the moments. Runs
/// of the same times keep the same frames, so that they are seen side by side at one time.
void leave_out_unmissed_frames(std::vector<ShownRun>& runs);

}  // namespace terp
