// What makes an imported section fail that stands by itself: weaker soil, or a higher river. docs/dstability.md.
// Not for: the search for the factor by which the soil must be weaker (stability).
#pragma once

#include "import/dstability/section.hpp"

#include <optional>
#include <string>

namespace terp {

enum class TriggerKind { none, strength, water };

struct FolderTrigger {
  TriggerKind kind = TriggerKind::none;
  Real value = not_given;   ///< factor by which strengths are divided [-]; level of the river [m], not given: the crest
  std::string origin = {};  ///< of the factor, a sentence
  bool needs_hold = false;  ///< none is needed: the section fails at its own strengths
};

/// What a search for the factor of safety has found [-].
struct FoundFactors {
  std::optional<Real> stands = {};  ///< largest at which the section stands
  std::optional<Real> fails = {};   ///< smallest at which it fails
  std::optional<Real> creeps = {};  ///< largest of which nothing is known, as it only crept
};

/// The trigger of weaker soil: the smallest factor at which the section fails. Where nothing failed there is none.
/// Throws RunError where the search found nothing.
FolderTrigger trigger_after(const FoundFactors& found);

/// How far below the crest the river is brought: by as much as the crest may settle before it counts as damage
/// (docs/flood.md) [m].
Real river_below_crest(Real height_of_dike);

/// Where the river is and how high it stands, in an analysed stage.
struct RiverInStage {
  bool at_left = true;
  Vec<2> ends{};                   ///< x of the section [m]
  Real level = 0.0;                ///< of the river [m]
  Real inland = 0.0;               ///< phreatic line at the other end [m]
  Real crest = 0.0, height = 0.0;  ///< elevation of the crest, height of the dike [m]
};

/// The stage with its river at another level [m]. Each head rises by the same share of its height over `inland` as the
/// river does: the answer of a linear aquifer, also where the river is the lower one. Ground that was dry stays so.
/// Throws InputError for water of a mesh, water that is level, or a level that no ground reaches.
StixStage with_river_at(const StixSection& section, const RiverInStage& river, Real level);

struct RaisedRiver {
  Real level = 0.0;     ///< [m]
  StixStage stage;      ///< with it
  std::string comment;  ///< what rises, from where to where
};

/// The river at the level asked for [m]; not given: just below the crest. Throws InputError for a level that is not
/// between the river and the crest.
RaisedRiver raise_river(const StixSection& section, const RiverInStage& river, Real asked);

/// The project with one more stage after one of a scenario, in place of those that followed it.
StixProject with_stage(StixProject project, std::size_t scenario, std::size_t after, StixStage stage);

}  // namespace terp
