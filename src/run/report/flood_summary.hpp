// Whether the ground still holds the water: the verdict of a run, with its numbers. Definitions: docs/flood.md.
#pragma once

#include "model/ground/section.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace terp {

/// near: the ground was below the level, but not by enough, for long enough, or to the end.
enum class FloodVerdict { stands, damaged, moving, near, floods };

struct FloodVerdictInfo {
  std::string_view name;   ///< in summary.json
  std::string_view words;  ///< for people
};
/// In the order of the enum.
inline constexpr std::array<FloodVerdictInfo, 5> flood_verdicts{
    {{"stands", "stands"}, {"damaged", "damaged, holds the water"}, {"still_moving", "still moving, not decided"},
        {"near", "floods briefly or by little, uncertain"}, {"floods", "floods"}}};

inline const FloodVerdictInfo& info_of(FloodVerdict verdict)
{
  return flood_verdicts[static_cast<std::size_t>(verdict)];
}

/// What was done to the section to make it fail: the verdict is not that of the section as it is.
struct FloodTrigger {
  std::string stage = {};                   ///< with which it began; empty: it acts in the whole run
  Real at_strength = 1.0;                   ///< all strengths were divided by it [-]
  std::optional<Real> river = {};           ///< level to which the river was brought [m]
  std::optional<FloodVerdict> before = {};  ///< verdict when it began; none: it acts in the whole run
};

/// "after strengths were divided by 1.12".
std::string trigger_words(const FloodTrigger& trigger);

/// A profile that is looked for inside the ground: level at the water over its width, with slopes of 1:n to both sides.
struct ProfileInGround {
  Real width = 0.0;            ///< [m]
  Real slope = 0.0;            ///< n [-]
  std::optional<Real> x = {};  ///< left end of its top where it fits [m]; none: it fits nowhere
};

struct FloodSummary {
  static constexpr Real none = std::numeric_limits<Real>::quiet_NaN();

  std::optional<FloodVerdict> verdict;  ///< of the run so far; none: the run has not ended, and does not flood so far
  Real water_level = none;              ///< [m]
  std::string water_level_origin = {};  ///< where it comes from, in words
  std::optional<Facing> river = {};     ///< the end of the section that the river is at
  Real residual_height = none;          ///< of the highest ground at the end [m]
  Real freeboard = none;                ///< of it over the water level [m]
  Real width_at_level = none;           ///< of the ground at the water level, at the end [m]
  Real intact_width = none;             ///< of that, with eps_eq_p below the limit [m]
  std::optional<Real> first_time_damaged;   ///< [s]
  std::optional<Real> first_time_below;     ///< of the flood [s]
  std::optional<Real> below_for;            ///< how long the ground was below the level without a break, last [s]
  std::optional<Real> below_by;             ///< by how much at most in that time [m]
  std::optional<Real> at_strength_damaged;  ///< at the first of these times, in a stage whose ramp changes it [-]
  std::optional<Real> at_strength_below;    ///< at the second
  std::string stage_damaged = {};    ///< name of the stage in which the first of these times lies; empty: of none
  std::string stage_below = {};      ///< of the second
  std::string stage = {};            ///< the last one so far, to whose end heights and widths belong
  std::optional<Real> fastest_node;  ///< at the end, or where `stage_moving` ended [m/s]
  Real fastest_x = none, fastest_y = none;  ///< where soil moves fastest then [m]; NaN: it does not move
  std::string fastest_soil = {};            ///< which soil that is
  /// Where the run or a stage ended: it was to end at rest and did not, or, for as long again, the soil would go far
  /// enough to matter.
  bool still_moves = false;
  std::string stage_moving =
      {};  ///< at the end of which it does: the last one, or the first one before; empty: of none
  bool moves_at_end() const { return stage_moving.empty() || stage_moving == stage; }
  std::optional<Real> ravelled_volume;  ///< that moved from above flood.least_depth; none: it is 0 [m^2]
  std::optional<Real> ravelled_depth;   ///< of it the deepest first place below the ground [m]
  std::optional<Real> margin;  ///< of damaged ground over what floods, so small that the verdict is not sure [m]
  std::optional<ProfileInGround> profile;  ///< flood.smallest_profile; none: not asked
  std::string criterion = {};              ///< by which it floods, in words
  std::optional<FloodTrigger> trigger;     ///< none: the verdict is that of the section as it is
};

/// "a profile of 3 m at the water level with slopes of 1:2 fits inside the ground, from x = 14.0 to 17.0 m".
std::string profile_words(const ProfileInGround& profile);

/// "at the end", or of which stage: where soil still moves.
std::string moving_when(const FloodSummary& flood);

/// What moves then, how fast and where.
std::string motion_words(const FloodSummary& flood);

/// A run that has not ended has a verdict only where it floods so far.
void withhold_verdict(FloodSummary& flood);

/// The verdict, with its numbers, the times at which it was first true and the stage in which that was: a clause,
/// without the stop at its end. What triggered it stands first.
std::string flood_clause(const FloodSummary& flood);

/// What the verdict does not know.
inline constexpr std::string_view flood_caution = "Water that would flow over is not simulated.";

}  // namespace terp
