#include "dstability/river_side.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real least_river = 0.05;  // [m] of water on the ground at an end of the section
constexpr Real least_apart = 0.01;  // [m] between the phreatic lines at both ends; nearer ones are level
constexpr Real high_land = 0.1;     // of the relief, over the ground at an end that is no high land
constexpr Real inside = 1e-6;       // [m] from an end
constexpr Real outside = 0.01;      // [m] beyond an end: coordinates of drawings are in cm

/// On which side of the point of the land that of the water lies; empty: the file does not give both.
std::string side_of(Real water, Real land)
{
  return !std::isfinite(water - land) || water == land ? "" : water < land ? "left" : "right";
}

/// The end that the file names by its points of the embankment; empty: it names none. Its doubt: that they contradict
/// each other, or lie outside of the section.
StixRiver named_river(const StixEmbankment& at, Vec<2> ends)
{
  const std::string tops = side_of(at.top_water, at.top_land), toes = side_of(at.toe_water, at.toe_land);
  StixRiver river{.side = tops.empty() ? toes : tops, .origin = "the water side of the embankment in the file"};
  if (!tops.empty() && !toes.empty() && tops != toes)
    river.doubt = fmt::format(
        "The file has the top of its embankment's water side at the {} end, but its toe at the {} end. The river is "
        "taken to be at the {} end.",
        tops, toes, river.side);
  for (const Real x : {at.top_water, at.top_land, at.toe_water, at.toe_land})
    if (!river.side.empty() && river.doubt.empty() && (x < ends[0] - outside || x > ends[1] + outside))
      river.doubt = fmt::format(
          "The file has a point of its embankment at x = {:.2f} m, outside of the section ({:.2f} to {:.2f} m). The "
          "river is taken to be at the {} end.",
          x, ends[0], ends[1], river.side);
  return river;
}

/// No dike lies between an end and the highest ground: the water in it is that of the land.
bool is_high_land(const StixSection& section, Vec<2> ends, Real end)
{
  constexpr int n = 200;
  Real high = -1e30, low = 1e30;
  for (int k = 0; k <= n; ++k) {
    const Real ground = section.column(std::lerp(ends[0] + inside, ends[1] - inside, Real(k) / n)).ground();
    if (std::isfinite(ground)) high = std::max(high, ground), low = std::min(low, ground);
  }
  return high - section.column(end).ground() < high_land * (high - low);
}

const char* other_end(const std::string& side) { return side == "left" ? "right" : "left"; }

}  // namespace

bool water_stands_at(const StixSection& section, Real x)
{
  return section.column(x).now().water().free_water() > least_river;
}

StixRiver find_river(const StixSection& section, Vec<2> ends)
{
  const Real at[2] = {ends[0] + inside, ends[1] - inside};
  const bool is_wet[2] = {water_stands_at(section, at[0]), water_stands_at(section, at[1])};
  const Real level[2] = {
      section.column(at[0]).now().water().phreatic(), section.column(at[1]).now().water().phreatic()};
  const bool differ = std::abs(level[0] - level[1]) > least_apart;  // both without water: not a number, false
  const std::string higher = !differ ? "" : level[0] > level[1] ? "left" : "right";
  const auto at_end = [](const std::string& side) { return side == "right" ? 1 : 0; };

  if (StixRiver river = named_river(section.stage().embankment, ends); !river.side.empty()) {
    const std::string& named = river.side;
    const char* other = other_end(named);
    if (river.doubt.empty() && higher == other && is_wet[at_end(other)])
      river.doubt = fmt::format(
          "The file has its embankment's water side at the {} end, but water stands on the ground at the {} end, and "
          "higher: {:.2f} m, not {:.2f} m. The river is taken to be at the {} end.",
          named, other, level[at_end(other)], level[at_end(named)], named);
    return river;
  }
  if (!is_wet[0] && !is_wet[1]) return {};
  if (higher.empty() && is_wet[0] && is_wet[1])
    return {.doubt = fmt::format(
                "Water stands equally high on the ground at both ends of the section ({:.2f} m), and the file names no "
                "water side of the embankment: the end of the river is not known.",
                level[0])};
  const bool is_land = !higher.empty() && !is_wet[at_end(higher)] && is_high_land(section, ends, at[at_end(higher)]);
  if (higher.empty() || is_land)
    return {.side = is_wet[0] ? "left" : "right", .origin = "the end where water stands on the ground"};
  StixRiver river{.side = higher, .origin = "the end where the water stands higher"};
  if (!is_wet[at_end(higher)])
    river.doubt = fmt::format(
        "The phreatic line is higher at the {} end ({:.2f} m, below the ground), but water stands on the ground at the "
        "{} end alone ({:.2f} m), and the file names no water side of the embankment. The river is taken to be at the "
        "{} "
        "end.",
        higher, level[at_end(higher)], other_end(higher), level[at_end(other_end(higher))], higher);
  return river;
}

std::string no_flood_because(const StixSection& section, const StixRiver& river, Real end, Real cell)
{
  if (!water_stands_at(section, end))
    return fmt::format("No water stands on the ground at {} of the section",
        river.side.empty() ? "either end" : fmt::format("the river's end ({})", river.side));
  const Real level = section.column(end).now().water().phreatic();
  const Real a_cell_inside = end + (river.side == "right" ? -cell : cell);
  if (level > section.column(a_cell_inside).ground()) return "";
  return fmt::format("The water at the river's end ({:.2f} m) stands on less than a cell of ground", level);
}

Sentence river_above_crest(Real level, Real crest)
{
  return {
      fmt::format("The river of this stage ({:.2f} m) stands above the crest ({:.2f} m): it floods without any slide. "
                  "A lower water_level judges a slide.",
          level, crest),
      fmt::format(
          "De rivier van deze fase ({:.2f} m) staat boven de kruin ({:.2f} m): overstroming zonder afschuiving. "
          "Een lagere water_level beoordeelt een afschuiving.",
          level, crest)};
}

void check_river_to_move(const StixSection& section, const StixRiver& river, Real x)
{
  const std::string& stage = section.stage().label;
  if (!river.doubt.empty())
    throw InputError({stage, "the side of the river is in doubt: its level is not changed",
        river.doubt + " Give the points of the embankment in D-Stability. --trigger strength needs no river.", ""});
  if (river.side.empty() || !std::isfinite(section.column(x).now().water().phreatic()))
    throw InputError({stage, "there is no river whose level could be changed",
        "No water stands on the ground at either end of the section, and the file names no water side of the "
        "embankment. --trigger strength needs no river.",
        ""});
}

}  // namespace terp
