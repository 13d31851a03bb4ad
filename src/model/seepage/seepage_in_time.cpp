#include "model/seepage/seepage_in_time.hpp"

#include "math/closest.hpp"
#include "math/errors.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

constexpr int most_halvings = 6;  // of a step in time

/// The level that a name of the wave stands for; nullptr: none.
Real* level_called(SeepageCase& of, const std::string& name)
{
  if (name == "river") return of.river ? &of.river->level : nullptr;
  for (PondCase& pond : of.ponds)
    if (pond.name == name) return &pond.level;
  for (SideHead& side : of.boundary)
    if (side.name == name && side.head.size() == 1) return &side.head[0][1];
  return nullptr;
}

std::vector<std::string> names_of_levels(const SeepageCase& of)
{
  std::vector<std::string> names;
  if (of.river) names.emplace_back("river");
  for (const PondCase& pond : of.ponds)
    if (!pond.name.empty()) names.push_back(pond.name);
  for (const SideHead& side : of.boundary)
    if (!side.name.empty() && side.head.size() == 1) names.push_back(side.name);
  return names;
}

}  // namespace

std::vector<Real> levels_at(const LevelWave& wave, Real time)
{
  const auto after = std::ranges::upper_bound(wave.times, time);
  if (after == wave.times.begin()) return wave.levels.front();
  if (after == wave.times.end()) return wave.levels.back();
  const auto k = static_cast<std::size_t>(after - wave.times.begin());
  const Real share = (time - wave.times[k - 1]) / (wave.times[k] - wave.times[k - 1]);
  std::vector<Real> levels = wave.levels[k - 1];
  for (std::size_t n = 0; n < levels.size(); ++n) levels[n] = std::lerp(levels[n], wave.levels[k][n], share);
  return levels;
}

LevelWave with_times(LevelWave wave, const std::vector<Real>& times)
{
  for (const Real time : times) {
    const auto at = std::ranges::lower_bound(wave.times, time);
    if (at != wave.times.end() && *at == time) continue;
    wave.levels.insert(wave.levels.begin() + (at - wave.times.begin()), levels_at(wave, time));
    wave.times.insert(at, time);
  }
  return wave;
}

SeepageCase conditions_at(const SeepageCase& of, const LevelWave& wave, Real time)
{
  SeepageCase now = of;
  const std::vector<Real> levels = levels_at(wave, time);
  for (std::size_t n = 0; n < wave.names.size(); ++n) {
    Real* level = level_called(now, wave.names[n]);
    if (level == nullptr) {
      const std::vector<std::string> known = names_of_levels(of);
      throw InputError(Problem{"water", fmt::format("there is no level `{}` in this water", wave.names[n]),
          did_you_mean(wave.names[n], known) + fmt::format("Levels of this case: {}", fmt::join(known, ", ")),
          "water.river"});
    }
    *level = levels[n];
  }
  return now;
}

std::vector<Real> times_of_steps(const LevelWave& wave, Real longest)
{
  std::vector<Real> times{wave.times.front()};
  for (std::size_t k = 1; k < wave.times.size(); ++k) {
    const Real from = wave.times[k - 1], way = wave.times[k] - from;
    const auto n = static_cast<int>(std::max(std::ceil(way / longest * (1.0 - 1e-12)), 1.0));
    for (int i = 1; i <= n; ++i) times.push_back(i == n ? wave.times[k] : from + way * i / n);
  }
  return times;
}

void follow_levels(const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of, const LevelWave& wave,
    Real longest_step, Real band, const WaterAtTime& use)
{
  const std::vector<Real> times = times_of_steps(wave, longest_step);
  SeepageCase conditions = conditions_at(of, wave, times.front());
  ComputedWater water = compute_water(mesh, section, conditions, {.band = band, .stores = true}, "water");
  use(times.front(), conditions, water);
  // A step that finds no flow is taken in two halves.
  const std::function<void(Real, Real, int)> go = [&](Real from, Real to, int halvings) {
    const std::vector<Real> before = water.flow.heads;
    conditions = conditions_at(of, wave, to);
    try {
      water = compute_water(
          mesh, section, conditions, {.band = band, .stores = true, .step = FlowStep{to - from, before}}, "water");
    } catch (const InputError&) {
      if (halvings == most_halvings) throw;
      const Real middle = 0.5 * (from + to);
      go(from, middle, halvings + 1);
      go(middle, to, halvings + 1);
    }
  };
  for (std::size_t k = 1; k < times.size(); ++k) {
    go(times[k - 1], times[k], 0);
    use(times[k], conditions, water);
  }
}

}  // namespace terp
