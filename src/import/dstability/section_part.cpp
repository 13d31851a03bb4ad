// Cuts are rounded outwards, to metres and half metres, so that a small change of the drawing keeps the part. A cut
// that would save less than a metre is not made.

#include "import/dstability/section_part.hpp"

#include "math/errors.hpp"
#include "import/dstability/section_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real nothing = 1e-6;         // [m^2]: a smaller rest of a layer is none
constexpr Real of_height = 3.0;        // room beyond the toe over the height of the dike,
constexpr Real of_soft_soil = 2.0;     // and over the thickness of the undrained soil
constexpr Real below = 0.5;            // room below, over the height
constexpr Real level_ground = 0.05;    // height over thickness, of ground without a dike
constexpr Real toe_over_height = 0.1;  // how far the ground at the toe stands over the lowest place
constexpr Real least_saved = 1.0;      // [m]: less is not cut off

Real lowest_undrained(const std::vector<DrawnRegion>& drawn, const std::vector<bool>& is_undrained)
{
  Real low = 1e30;
  for (std::size_t k = 0; k < drawn.size(); ++k)
    for (const Vec<2>& x : drawn[k].polygon)
      if (is_undrained[k]) low = std::min(low, x[1]);
  return low;
}

/// Where the ground, from the crest on, first comes down to near its lowest place.
Vec<2> toe_of(const std::vector<Vec<2>>& from_crest)
{
  const Real low = std::ranges::min(from_crest, {}, [](const Vec<2>& at) { return at[1]; })[1];
  const Real level = low + toe_over_height * (from_crest.front()[1] - low);
  return *std::ranges::find_if(from_crest, [&](const Vec<2>& at) { return at[1] <= level; });
}

}  // namespace

SectionPart part_that_matters(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    Vec<2> crest_place, const std::vector<bool>& is_undrained)
{
  const std::vector<Vec<2>> ground = ground_line(drawn, excavations);
  const BoundingBox box = box_around(drawn);
  const auto crest =
      std::ranges::min_element(ground, {}, [&](const Vec<2>& at) { return std::abs(at[0] - crest_place[0]); });
  const Real low = std::ranges::min(ground, {}, [](const Vec<2>&at) { return at[1]; })[1], height = (*crest)[1] - low;
  SectionPart part;
  if (!(height > level_ground * ((*crest)[1] - box.low[1]))) return part;
  const Real soft = std::min(lowest_undrained(drawn, is_undrained), low);
  const auto room = [&](Vec<2> toe) { return of_height * height + of_soft_soil * std::max(toe[1] - soft, 0.0); };
  const Vec<2> left = toe_of({std::make_reverse_iterator(crest + 1), ground.rend()});
  const Vec<2> right = toe_of({crest, ground.end()});
  part.toes = {left[1], right[1]};
  part.between = {std::floor(left[0] - room(left)), std::ceil(right[0] + room(right))};
  part.base = std::floor(2.0 * (std::min(soft, low - height) - below * height)) / 2.0;
  if (part.between[0] < box.low[0] + least_saved) part.between[0] = box.low[0];
  if (part.between[1] > box.high[0] - least_saved) part.between[1] = box.high[0];
  if (part.base < box.low[1] + least_saved) part.base = box.low[1];
  part.why = fmt::format(
      "Beyond the toes at x = {:.1f} and {:.1f} m it has three times the height of the dike ({:.2f} m) and twice the "
      "thickness of the undrained soil there; below the undrained soil half the height.",
      left[0], right[0], height);
  return part;
}

std::optional<Real> inner_toe(const SectionPart& part, const std::string& river, Real named, Real land)
{
  if (part.why.empty()) return std::nullopt;
  const auto [left, right] = part.toes;
  const Real toe = river == "left" ? right : river == "right" ? left : std::max(left, right);
  return std::round(1e3 * std::max(std::isfinite(named) ? named : toe, land)) * 1e-3;
}

std::vector<DrawnRegion> part_of(const std::vector<DrawnRegion>& drawn, const SectionPart& part)
{
  std::vector<DrawnRegion> taken;
  for (const DrawnRegion& region : drawn) {
    Polygon polygon = clip_to_box(region.polygon, {{part.between[0], part.base}, {part.between[1], 1e9}});
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    if (std::abs(signed_area(polygon)) < nothing) polygon.clear();
    taken.push_back({region.name, std::move(polygon)});
  }
  if (std::ranges::all_of(taken, [](const DrawnRegion& r) { return r.polygon.empty(); })) {
    const BoundingBox box = box_around(drawn);
    throw InputError({"", "there is no soil in this part of the section",
        fmt::format("Got --between {:g},{:g} --base {:g}; the soil lies from x = {:g} to {:g} m, z = {:g} to {:g} m.",
            part.between[0], part.between[1], part.base, box.low[0], box.high[0], box.low[1], box.high[1]),
        ""});
  }
  return taken;
}

std::string describe(const SectionPart& part, const std::vector<DrawnRegion>& drawn)
{
  const BoundingBox box = box_around(drawn);
  const bool is_narrow = part.between[0] > box.low[0] || part.between[1] < box.high[0];
  if (!is_narrow && part.base <= box.low[1]) return "";
  return fmt::format(
      "Only the part from x = {:g} to {:g} m and above z = {:g} m was taken over. {}{}--between {:g},{:g} --base {:g} "
      "takes all of it.",
      std::max(part.between[0], box.low[0]), std::min(part.between[1], box.high[0]), std::max(part.base, box.low[1]),
      part.why, part.why.empty() ? "" : " ", box.low[0], box.high[0], box.low[1]);
}

}  // namespace terp
