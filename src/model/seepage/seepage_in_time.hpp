// Levels that change over hours, and the water in the soil that follows them.
// Not for: reading their table (io/files), nor the steady flow that they begin from (computed_water.hpp).
#pragma once

#include "model/seepage/computed_water.hpp"

#include <functional>
#include <string>
#include <vector>

namespace terp {

/// Levels of river, ponds and heads at sides by their names, linear between times.
struct LevelWave {
  std::vector<std::string> names;
  std::vector<Real> times;                ///< ascending [s]
  std::vector<std::vector<Real>> levels;  ///< by time, of each name [m]
};

/// Levels of a time, those of the ends before and after [m].
std::vector<Real> levels_at(const LevelWave& wave, Real time);

/// The wave with rows at these times, too, which lie within it [s].
LevelWave with_times(LevelWave wave, const std::vector<Real>& times);

/// The conditions of a time. Throws InputError for a name that the case does not have.
SeepageCase conditions_at(const SeepageCase& of, const LevelWave& wave, Real time);

/// Steps of at most this length that end at all times of the wave [s].
std::vector<Real> times_of_steps(const LevelWave& wave, Real longest);

/// Water of a moment; the first is the steady one of the first levels.
using WaterAtTime = std::function<void(Real time, const SeepageCase& conditions, const ComputedWater& water)>;
void follow_levels(const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of, const LevelWave& wave,
    Real longest_step, Real band, const WaterAtTime& use);

}  // namespace terp
