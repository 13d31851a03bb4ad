// A study whose method chooses the next realisations from the last ones (reliability.hpp): solved by the workers, and
// replayed from what is kept.
#pragma once

#include "batch/engine.hpp"

namespace terp {

/// How far a realisation is from the event of the study, at or below 0 where it happened. Of a slide: decades between
/// the displacement of the event's volume and that of the event. Of a flood: the freeboard [m], and where nothing slid
/// those decades too. A failed realisation counts as the event, as does one without a water level, or of a flood after
/// which no ground is left: -1.
Real limit_state_of(const StudySettings& settings, const Realisation& realisation);

/// As run_realisations. What is in `rows` is taken as it is, so that a study that was killed goes on to the same bits.
StudyEnd run_adaptive(const Study& study, const std::string& folder, const EngineOptions& options,
    const std::atomic<bool>& stop, Realisations& rows);

AdaptiveFound replay_adaptive(const Study& study, const Realisations& rows);

/// At the confidence of the study, of the lognormal distribution with the coefficient of variation of the estimate.
/// None where that is not known.
std::optional<Bounds> rough_bounds(const Study& study, const ReliabilityResult& result);

std::string adaptive_text(const Study& study, const Realisations& rows, const ReliabilityResult& result);
std::vector<std::string> remarks_on_adaptive(
    const Study& study, const Realisations& rows, const StudyEstimates& estimates);

}  // namespace terp
