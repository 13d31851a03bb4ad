// What happens at each place of the score, by ScorePlace (score.def).
#pragma once

#include "mpm/step/passes.hpp"
#include "mpm/step/score.hpp"

namespace terp {

inline constexpr PlaceInfo score_places[] = {
#define TERP_PLACE(name, over, pass, in, homes, text) {#name, Over::over, pass, in, homes, text},
#define TERP_WAIT(name, pass, homes, text) {#name, Over::wait, pass, in_all, homes, text},
#include "mpm/step/score.def"
#undef TERP_PLACE
#undef TERP_WAIT
};

}  // namespace terp
