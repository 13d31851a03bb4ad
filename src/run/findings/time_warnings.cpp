// Times are compared with those in which waves cross the soil: compression waves of the fastest soil for what must be
// longer, shear waves of the slowest for what must be shorter.

#include "run/findings/time_warnings.hpp"

#include "run/findings/soil_size.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

struct WaveSpeeds {
  Real fastest = 0.0, slowest = INFINITY;  ///< of compression, of shear [m/s]
};

WaveSpeeds wave_speeds(const Model& model)
{
  WaveSpeeds speeds;
  for (const SoilMaterial& soil : model.materials) {
    const Real shear = soil.law->shear_modulus();
    if (!is_used(model, soil.name) || shear == 0.0) continue;
    speeds.fastest = std::max(speeds.fastest, std::sqrt(soil.law->p_wave_modulus() / soil.density));
    speeds.slowest = std::min(speeds.slowest, std::sqrt(shear / soil.density));
  }
  return speeds;
}

void find_short_rest(const Case& whole, const SoilSize& soil, const WaveSpeeds& speeds, std::vector<Problem>& warnings)
{
  const auto rests = [](const StageCase& stage) { return stage.until == Until::at_rest; };
  const bool any = whole.time.until == Until::at_rest || std::ranges::any_of(whole.stages, rests);
  const Real half_period = 2.0 * soil.height / speeds.fastest;
  if (!any || speeds.fastest == 0.0 || !(whole.time.rest_time < half_period)) return;
  warnings.push_back({"time.rest_time", "soil that turns back counts as at rest",
      fmt::format("Got {:.3g} s; half a period of the quickest vibration of {:.3g} m of soil takes {:.3g} s. Give some "
                  "0.5 s or more.",
          whole.time.rest_time, soil.height, half_period),
      "time.rest_time", false, {"time"}});
}

void find_long_relaxation(
    const Model& model, const SoilSize& soil, const WaveSpeeds& speeds, Real longest, std::vector<Problem>& warnings)
{
  const Real time = model.method.relaxation_time;
  const bool is_slow = std::isfinite(speeds.slowest) && time > 4.0 * soil.height / speeds.slowest;
  if (!(time > 0.0) || (!is_slow && !(time > longest))) return;
  warnings.push_back({"method.relaxation_time", "the relaxation is too slow to take anything away",
      fmt::format("Got {:.3g} s; {}. Usual: 0.05 s for soil in metres.", time,
          is_slow ? fmt::format("a shear wave swings through {:.3g} m of soil in {:.3g} s", soil.height,
                        4.0 * soil.height / speeds.slowest)
                  : fmt::format("the run takes {:.3g} s", longest)),
      "method.relaxation_time", false, {"method"}});
}

/// A stage that brings other water or loads within less than half a period of the quickest vibration strikes the soil.
void find_sudden_stages(
    const Case& whole, const SoilSize& soil, const WaveSpeeds& speeds, std::vector<Problem>& warnings)
{
  const Real half_period = 2.0 * soil.height / speeds.fastest;
  std::string water(name_of_start);
  const std::vector<LoadCase>* loads = &whole.loads;
  const auto same_pressure = [](const LoadCase& a, const LoadCase& b) { return a.pressure == b.pressure; };
  for (std::size_t k = 0; k < whole.stages.size(); ++k) {
    const StageCase& stage = whole.stages[k];
    const std::vector<LoadCase>& now = stage.changed ? stage.changed->loads : *loads;
    const bool other_water = !stage.water.empty() && stage.water != water;
    const bool other_loads = !std::ranges::equal(now, *loads, same_pressure);
    if (other_water) water = stage.water;
    loads = &now;
    if ((!other_water && !other_loads) || speeds.fastest == 0.0 || stage.ramp >= half_period) continue;
    warnings.push_back({fmt::format("stage[{}].ramp", k),
        fmt::format("the {} of the stage `{}` come{} at once", other_water ? "water" : "loads", stage.name,
            other_water ? "s" : ""),
        fmt::format(
            "The ramp is {:.3g} s; half a period of the quickest vibration of {:.3g} m of soil takes {:.3g} s. The "
            "soil is\nstruck, and swings to twice what the change asks. Give a `ramp` of some seconds.",
            stage.ramp, soil.height, half_period),
        "stage.ramp", false, {fmt::format("stage[{}]", k)}});
  }
}

/// Damping against the mean of a force over several swings acts on what lasts, and hardly ends.
void find_long_averaging(
    const Model& model, const SoilSize& soil, const WaveSpeeds& speeds, Real longest, std::vector<Problem>& warnings)
{
  const Real time = model.damping.averaging_time, swing = 4.0 * soil.height / speeds.slowest;
  if (!std::isfinite(speeds.slowest) || !(time > swing) || time > longest) return;
  warnings.push_back({"forces.damping.averaging_time", "the averaging time is longer than the swings of the soil",
      fmt::format("Got {:.4g} s; a shear wave swings through {:.3g} m of soil in {:.3g} s. Usual: the time in which a "
                  "compression wave\ncrosses the soil once or twice, here {:.2g} s.",
          time, soil.height, swing, 2.0 * soil.height / speeds.fastest),
      "forces.damping.averaging_time", false, {"forces.damping"}});
}

void find_output_of_all_steps(const Model& model, std::vector<Problem>& warnings)
{
  constexpr Real far_below = 0.1;  // of the time step
  const OutputCase& output = (model.whole ? *model.whole : model.description).output;
  const OutputCase defaults;
  const auto check = [&](const char* key, const char* what, Real every, Real by_default) {
    if (!(every > 0.0) || every == by_default || !(every < far_below * model.dt)) return;
    warnings.push_back({key, fmt::format("{} is written in each time step", what),
        fmt::format("Got {:.3g} s; the step is {:.3g} s, and the run takes {} steps.", every, model.dt, model.n_steps),
        key});
  };
  check("output.fields.every", "a frame", output.fields_every, defaults.fields_every);
  check("output.ledger.every", "a row of the ledger", output.ledger_every, defaults.ledger_every);
  check("output.history.every", "a row of the named points", output.history_every, defaults.history_every);
  check("output.checkpoint.every", "a checkpoint", output.checkpoint_every, defaults.checkpoint_every);
}

}  // namespace

void find_odd_times(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole ? *model.whole : model.description;
  const SoilSize soil = measure_soil(model, state);
  const WaveSpeeds speeds = wave_speeds(model);
  find_short_rest(whole, soil, speeds, warnings);
  find_long_relaxation(model, soil, speeds, whole.time.end, warnings);
  find_long_averaging(model, soil, speeds, whole.time.end, warnings);
  find_sudden_stages(whole, soil, speeds, warnings);
  find_output_of_all_steps(model, warnings);
}

}  // namespace terp
