// What [flood] says of ground that does not hold the water from the start.

#include "simulation/flood_warnings.hpp"

#include "simulation/ground_section.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace terp {

std::vector<Problem> find_flood_warnings(const Model& model, const State& state)
{
  const FloodCase& flood = model.description.flood;
  const Real level = flood_level(flood);
  if (std::isnan(level)) return {};
  const StandingGround ground = standing_ground(model, state.points);
  const Barrier barrier = find_barrier(ground, columns_of_barrier(ground));
  std::vector<Real> heights;
  std::ranges::copy_if(ground.heights, std::back_inserter(heights), [](Real h) { return std::isfinite(h); });
  if (heights.empty()) return {};
  std::vector<Problem> warnings;
  const auto warn = [&](const char* key, std::string what, std::string detail) {
    warnings.push_back({std::string("flood.") + key, std::move(what), std::move(detail), std::string("flood.") + key});
  };
  const Real needed = level + flood.smallest_freeboard;
  if (barrier.height < needed)
    warn("water_level", "it floods from the start",
        fmt::format("The highest ground between river and land stands at {:.4g} m, less than {:.4g} m.", barrier.height,
            needed));
  else if (barrier.width < flood.smallest_width)
    warn("smallest_width", "it floods from the start",
        fmt::format("The ground is {:.4g} m wide at {:.4g} m, less than {:.4g} m.", barrier.width, level,
            flood.smallest_width));
  if (std::ranges::min(heights) >= level)
    warn("water_level", "no ground lies below the water",
        fmt::format("The lowest ground stands at {:.4g} m: nothing has to be kept dry at {:.4g} m.",
            std::ranges::min(heights), level));
  const Real at_river = flood.river == RiverSide::left ? heights.front() : heights.back();
  if (flood.river != RiverSide::deduced && at_river >= level)
    warn("river", "the river's end of the section lies above the water",
        fmt::format(
            "The ground there stands at {:.4g} m, the water at {:.4g} m. Name the other end.", at_river, level));
  return warnings;
}

}  // namespace terp
