// The stages of an imported case: the daily one until rest, the analysed one, and a trigger.
// Not for: the water of a stage (water_text.hpp), which level or factor a trigger has (trigger.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/case_text.hpp"

namespace terp {

struct TriggerStage {
  std::string name = {};               ///< of the stage; empty: none
  std::string comment = {};            ///< why, and what it does
  std::string water = {};              ///< situation that it goes to; empty: the water stays
  std::vector<std::string> sets = {};  ///< KEY = VALUE
};

struct StagePlan {
  std::string first = {}, analysed = {};  ///< labels in the file; first empty: the analysed stage has none before it
  std::string water = {};                 ///< situation of the analysed stage; empty: that of the start
  std::vector<std::string> sets = {};
  bool is_held = false;  ///< strengths are doubled until the first stage is at rest: for soil that cannot stand
  TriggerStage trigger = {};
};

inline Sentence held_sentence()
{
  return {
      "The soil is held until it is at rest: strengths are doubled, then taken back to those of the file. It would "
      "not stand otherwise.",
      "De grond wordt vastgehouden tot hij in rust is: sterktes zijn verdubbeld en dan weer die van het bestand. "
      "Anders zou hij niet blijven staan."};
}

/// In their order; none: the run is one of the analysed stage alone.
std::vector<CaseTableText> stage_tables(const StagePlan& plan);

}  // namespace terp
