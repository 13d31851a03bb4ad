#include "dstability/river_side.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real least_river = 0.05;  // [m] of water on the ground at an end of the section
constexpr Real least_apart = 0.01;  // [m] between the phreatic lines at both ends; nearer ones are level
constexpr Real least_dike = 0.1;    // of the relief, over the ground at an end that is no high land
constexpr Real inside = 1e-6;       // [m] from an end

/// The end that the file names by its points of the embankment; empty: it names none.
std::string named_side(const StixEmbankment& at)
{
  if (std::isfinite(at.top_water - at.top_land) && at.top_water != at.top_land)
    return at.top_water < at.top_land ? "left" : "right";
  if (std::isfinite(at.toe_water - at.toe_land) && at.toe_water != at.toe_land)
    return at.toe_water < at.toe_land ? "left" : "right";
  return "";
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
  return high - section.column(end).ground() < least_dike * (high - low);
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

  if (const std::string named = named_side(section.stage().embankment); !named.empty()) {
    StixRiver river{.side = named, .origin = "the water side of the embankment in the file"};
    const char* other = other_end(named);
    if (higher == other && is_wet[at_end(other)])
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

void check_river_to_raise(const StixSection& section, const StixRiver& river, Real x)
{
  const std::string& stage = section.stage().label;
  if (!river.doubt.empty())
    throw InputError({stage, "the side of the river is in doubt: it is not raised",
        river.doubt + " Give the points of the embankment in D-Stability, or try --trigger strength.", ""});
  if (river.side.empty() || !std::isfinite(section.column(x).now().water().phreatic()))
    throw InputError({stage, "there is no river to raise",
        "No water stands on the ground at either end of the section, and the file names no water side of the "
        "embankment. Try --trigger strength.",
        ""});
}

}  // namespace terp
