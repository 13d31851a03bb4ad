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
  bool is_held = false;    ///< strengths are doubled while the river rises: for soil that cannot stand
  bool has_flood = false;  ///< the case asks for a verdict on the water
  Real longest = 30.0;     ///< of the last stage, beyond the ramp in which strengths go back [s]
  TriggerStage trigger = {};
};

inline Sentence held_sentence()
{
  return {
      "The soil is held at first: its strengths are doubled while the river rises, and go back to those of the file "
      "within 12 s after it. It would not stand otherwise.",
      "De grond wordt eerst vastgehouden: zijn sterktes zijn verdubbeld terwijl de rivier stijgt, en gaan daarna in 12 "
      "s "
      "terug naar die van het bestand. Anders zou hij niet blijven staan."};
}

/// Value of `until`.
inline constexpr const char* until_rest = "\"at_rest\"";
/// That of the run or of its last stage: with the verdict, where the case asks for one.
inline const char* last_end(bool has_flood) { return has_flood ? "\"verdict\"" : until_rest; }

/// In their order; none: the run is one of the analysed stage alone.
std::vector<CaseTableText> stage_tables(const StagePlan& plan);

}  // namespace terp
