// What earlier stages of a file have of the ground of the analysed one: an embankment, a berm, a ditch that came later.
// Not for: what it does to strengths (preload.hpp, section.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/project.hpp"

#include <optional>

namespace terp {

struct EarlierGround {
  Sentence sentence;      ///< which stages, and what that means for a run
  bool is_other = false;  ///< the ground has another height somewhere; else only layers or loads are others
};

/// Stages before `stage` with other ground between two x, layers or loads. None: there are no such stages.
/// column: width of the strips in which heights are compared [m].
std::optional<EarlierGround> earlier_ground(
    const StixProject& project, std::size_t scenario, std::size_t stage, Vec<2> between, Real column);

}  // namespace terp
