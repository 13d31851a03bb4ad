// Nothing is judged here: run/measure/flood.cpp finds the numbers, and this file puts them into one clause. Each phrase
// brings its own separator and is empty where there is nothing to say. So the clause stays one sentence, whichever of
// the numbers a run has.

#include "run/report/flood_summary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace terp {

namespace {

/// "after strengths were divided by 1.12 (before that: stands): "
std::string trigger_phrase(const std::optional<FloodTrigger>& trigger)
{
  if (!trigger) return "";
  return trigger_words(*trigger) +
         (trigger->before ? fmt::format(" (before that: {}): ", info_of(*trigger->before).words) : ": ");
}

/// " at at_strength = 0.82": soil that is released fails where its strengths are divided by that.
std::string strength_phrase(const std::optional<Real>& at)
{
  return at ? fmt::format(" at at_strength = {:.2f}", *at) : "";
}

/// "; it began in the stage `daily`, before `flood`": a slide in daily water is no flood of the river.
std::string stage_phrase(const FloodSummary& flood)
{
  const std::string& began = flood.stage_damaged.empty() ? flood.stage_below : flood.stage_damaged;
  if (began.empty()) return "";
  if (!flood.stage_below.empty() && flood.stage_below != began)
    return fmt::format("; the damage began in the stage `{}`{}, the flood in `{}`{}", began,
        strength_phrase(flood.at_strength_damaged), flood.stage_below, strength_phrase(flood.at_strength_below));
  const std::string before = flood.stage != began ? fmt::format(", before `{}`", flood.stage) : "";
  const bool both = flood.at_strength_damaged && flood.at_strength_below;
  if (both)
    return fmt::format("; it began in the stage `{}`{}, the flood{}{}", began,
        strength_phrase(flood.at_strength_damaged), strength_phrase(flood.at_strength_below), before);
  return fmt::format("; it began in the stage `{}`{}{}", began,
      strength_phrase(flood.at_strength_damaged ? flood.at_strength_damaged : flood.at_strength_below), before);
}

}  // namespace

std::string profile_words(const ProfileInGround& profile)
{
  return fmt::format("a profile of {:g} m at the water level with slopes of 1:{:g} {}", profile.width, profile.slope,
      profile.x
          ? fmt::format("fits inside the ground, from x = {:.1f} to {:.1f} m", *profile.x, *profile.x + profile.width)
          : std::string("does not fit inside the ground"));
}

std::string trigger_words(const FloodTrigger& trigger)
{
  std::string words;
  if (trigger.at_strength != 1.0) words = fmt::format("after strengths were divided by {:g}", trigger.at_strength);
  if (trigger.river)
    words += fmt::format("{} the river {}brought to {:.2f} m", words.empty() ? "after" : " and",
        words.empty() ? "was " : "", *trigger.river);
  return words.empty() ? fmt::format("after the stage `{}`", trigger.stage) : words;
}

std::string moving_when(const FloodSummary& flood)
{
  return flood.moves_at_end() ? "at the end" : fmt::format("at the end of the stage `{}`", flood.stage_moving);
}

std::string motion_words(const FloodSummary& flood)
{
  return fmt::format("`{}` moves with {:.2g} m/s at x = {:.1f}, y = {:.1f} m", flood.fastest_soil,
      flood.fastest_node.value_or(FloodSummary::none), flood.fastest_x, flood.fastest_y);
}

void withhold_verdict(FloodSummary& flood)
{
  if (flood.verdict != FloodVerdict::floods) flood.verdict.reset();
}

std::string flood_clause(const FloodSummary& flood)
{
  const bool is_near = flood.verdict == FloodVerdict::near;
  const bool floods = is_near || flood.verdict == FloodVerdict::floods;
  const auto from = [](const char* what, const std::optional<Real>& time) {
    return time ? fmt::format(", {} {:.2f} s on", what, *time) : std::string();
  };
  const std::string verdict =
      trigger_phrase(flood.trigger) +
      std::string(flood.verdict ? info_of(*flood.verdict).words : "no verdict before the end of the run");
  const std::string since =
      (floods ? from("from", flood.first_time_below) : from("damaged from", flood.first_time_damaged)) +
      (is_near ? fmt::format(", below by {:.2f} m at most, last for {:.2f} s", flood.below_by.value_or(0.0),
                     flood.below_for.value_or(0.0))
               : "");
  if (!std::isfinite(flood.residual_height))
    return fmt::format("{}{}: no ground remains{}", verdict, since, stage_phrase(flood));
  const std::string width = flood.width_at_level > 0.0
                                ? fmt::format("; the ground is {:.2f} m wide there, {:.2f} m of it intact",
                                      flood.width_at_level, flood.intact_width)
                                : "";
  const std::string motion = flood.verdict != FloodVerdict::moving ? ""
                             : flood.moves_at_end()                ? "; " + motion_words(flood)
                                                    : fmt::format("; {} {}", moving_when(flood), motion_words(flood));
  const std::string profile = flood.profile ? "; " + profile_words(*flood.profile) : "";
  return fmt::format("{}{}: {} the highest ground stands at {:.2f} m, {:.2f} m {} the water at {:.2f} m{}{}{}{}",
      verdict, since, flood.verdict ? "at the end" : "so far", flood.residual_height, std::abs(flood.freeboard),
      flood.freeboard < 0.0 ? "below" : "above", flood.water_level, width, profile, motion, stage_phrase(flood));
}

}  // namespace terp
