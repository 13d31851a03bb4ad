// What speaks against the choice becomes a doubt in words: it does not stop an import, but forbids to move the level.

#include "import/dstability/river_side.hpp"

#include "math/errors.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real least_river = 0.05;  // [m] of water on the ground at an end of the section
constexpr Real least_apart = 0.01;  // [m] between the phreatic lines at both ends; nearer ones are level
constexpr Real high_land = 0.1;     // of the relief, over the ground at an end that is no high land

/// On which side of the point of the land that of the water lies; empty: the file does not give both.
std::string side_of(Real water, Real land)
{
  return !std::isfinite(water - land) || water == land ? "" : water < land ? "left" : "right";
}

Sentence in_words(const std::string& end)
{
  return end == "left" ? filled<reported_texts::left_end>() : filled<reported_texts::right_end>();
}

/// The end that the file names by its points of the embankment; empty: it names none. Its doubt: that they contradict
/// each other, or lie outside of the section.
StixRiver named_river(const StixEmbankment& at, Vec<2> ends)
{
  const std::string tops = side_of(at.top_water, at.top_land), toes = side_of(at.toe_water, at.toe_land);
  StixRiver river{.side = tops.empty() ? toes : tops, .origin = "the water side of the embankment in the file"};
  if (!tops.empty() && !toes.empty() && tops != toes)
    river.doubt = filled<reported_texts::tops_and_toes_differ>(in_words(tops), in_words(toes), in_words(river.side));
  for (const Real x : {at.top_water, at.top_land, at.toe_water, at.toe_land})
    if (!river.side.empty() && river.doubt.empty() && (x < ends[0] - beyond_end || x > ends[1] + beyond_end))
      river.doubt = filled<reported_texts::embankment_outside>(x, ends[0], ends[1], in_words(river.side));
  return river;
}

/// No dike lies between an end and the highest ground: the water in it is that of the land.
bool is_high_land(const StixSection& section, Vec<2> ends, Real end)
{
  constexpr int n = 200;
  Real high = -1e30, low = 1e30;
  for (int k = 0; k <= n; ++k) {
    const Real ground = section.column(std::lerp(ends[0] + just_inside, ends[1] - just_inside, Real(k) / n)).ground();
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
  const Real at[2] = {ends[0] + just_inside, ends[1] - just_inside};
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
      river.doubt = filled<reported_texts::water_at_other_end>(
          in_words(named), in_words(other), level[at_end(other)], level[at_end(named)], in_words(named));
    return river;
  }
  if (!is_wet[0] && !is_wet[1]) return {};
  if (higher.empty() && is_wet[0] && is_wet[1]) return {.doubt = filled<reported_texts::equally_high>(level[0])};
  const bool is_land = !higher.empty() && !is_wet[at_end(higher)] && is_high_land(section, ends, at[at_end(higher)]);
  if (higher.empty() || is_land)
    return {.side = is_wet[0] ? "left" : "right", .origin = "the end where water stands on the ground"};
  StixRiver river{.side = higher, .origin = "the end where the water stands higher"};
  if (!is_wet[at_end(higher)])
    river.doubt = filled<reported_texts::higher_but_dry>(in_words(higher), level[at_end(higher)],
        in_words(other_end(higher)), level[at_end(other_end(higher))], in_words(higher));
  return river;
}

Sentence no_flood_because(const StixSection& section, const StixRiver& river, Real end, Real cell)
{
  if (!water_stands_at(section, end))
    return river.side.empty() ? filled<reported_texts::dry_at_either_end>()
                              : filled<reported_texts::dry_at_the_river>(in_words(river.side));
  const Real level = section.column(end).now().water().phreatic();
  const Real a_cell_inside = end + (river.side == "right" ? -cell : cell);
  if (level > section.column(a_cell_inside).ground()) return {};
  return filled<reported_texts::narrow_river>(level);
}

Sentence river_above_crest(Real level, Real crest) { return filled<reported_texts::above_crest>(level, crest); }

void check_river_to_move(const StixSection& section, const StixRiver& river, Real x)
{
  const std::string& stage = section.stage().label;
  if (!river.doubt.empty())
    throw InputError({stage, "the side of the river is in doubt: its level is not changed",
        river.doubt.en + " Give the points of the embankment in D-Stability. --trigger strength needs no river.", ""});
  if (river.side.empty() || !std::isfinite(section.column(x).now().water().phreatic()))
    throw InputError({stage, "there is no river whose level could be changed",
        "No water stands on the ground at either end of the section, and the file names no water side of the "
        "embankment. --trigger strength needs no river.",
        ""});
}

}  // namespace terp
