// The water that stands on the ground at the ends of the section, as the case orders it.
// Not for: the level that the ground is judged against (flood_level.hpp).
#pragma once

#include "model/parts/model.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace terp {

/// The free water at an end of the section, and the situation in which it stands highest.
struct FreeWater {
  static constexpr Real none = -std::numeric_limits<Real>::infinity();

  Real level = none;           ///< [m]
  std::string situation = {};  ///< its name; empty: that of the start
};

/// The situations that the case asks for, by their numbers: that of the start, of the first stages, and those with a
/// time. Of the last ones all count, whenever the run ends: a run that goes on later is judged against the same level.
std::vector<std::size_t> situations_asked_for(const Case& whole, std::size_t n_stages);

/// The highest in these situations at the left and the right end of the soil. The model is that of a stage of the case.
/// None where a formula of the time or points of a file leave it open.
std::array<FreeWater, 2> free_water_at_ends(const Case& whole, const Model& model, std::size_t n_stages);

/// The river before a trigger brings it to the level of [flood].
struct RiverBeforeTrigger {
  std::size_t n_stages = 0;  ///< stages before that trigger; 0: there is none, or nothing is known of the river
  Real level = 0.0;          ///< of their own river, at most that of [flood] [m]; minus infinity: they have none
};

/// Of a run whose level is known.
RiverBeforeTrigger river_before_trigger(const Model& model);

}  // namespace terp
