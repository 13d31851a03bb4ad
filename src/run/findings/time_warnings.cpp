// Times are compared with those in which waves cross the soil: compression waves of the fastest soil for what must be
// longer, shear waves of the slowest for what must be shorter.

#include "run/findings/time_warnings.hpp"

#include "run/findings/soil_size.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace terp {
namespace {

struct WaveSpeeds {
  Real fastest = 0.0, slowest = INFINITY;  ///< of compression, of shear [m/s]
  Real stiffest = 0.0;                     ///< the fastest of shear [m/s]
};

WaveSpeeds wave_speeds(const Model& model)
{
  WaveSpeeds speeds;
  for (const SoilMaterial& soil : model.materials) {
    const Real shear = soil.law->shear_modulus();
    if (!is_used(model, soil.name) || shear == 0.0) continue;
    speeds.fastest = std::max(speeds.fastest, std::sqrt(soil.law->p_wave_modulus() / soil.density));
    speeds.slowest = std::min(speeds.slowest, std::sqrt(shear / soil.density));
    speeds.stiffest = std::max(speeds.stiffest, std::sqrt(shear / soil.density));
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

/// What brings the points to rest within a step, and hides a slide: relaxation, viscous damping beyond that which lets
/// the softest soil creep back without a swing.
void find_strong_damping(const Model& model, const Case& whole, const SoilSize& soil, const WaveSpeeds& speeds,
    std::vector<Problem>& warnings)
{
  if (const Real time = model.method.relaxation_time; time > 0.0 && time <= model.dt)
    warnings.push_back({"method.relaxation_time", "the relaxation time is not longer than a time step",
        fmt::format("Got {:.3g} s; the step is {:.3g} s: points lose all that the mesh does not see in each step. "
                    "Usual: 0.05 s for soil in metres.",
            time, model.dt),
        "method.relaxation_time", false, {"method"}});
  const bool staged = !whole.stages.empty() && whole.stages.back().changed;
  const Real viscous = (staged ? *whole.stages.back().changed : whole).forces.viscous_damping,
             critical = std::numbers::pi * speeds.slowest / soil.height;
  if (!whole.flood.asks() || !std::isfinite(critical) || soil.g == 0.0 || !(viscous > critical)) return;
  warnings.push_back({"forces.damping.viscous", "viscous damping lets soil creep and not slide",
      fmt::format(
          "Got {:.3g} 1/s; from {:.3g} 1/s on the softest soil does not swing back, and soil that falls reaches "
          "{:.2g} m/s at most.\nUsual: a tenth of it, or local damping.",
          viscous, critical, soil.g / viscous),
      "forces.damping.viscous", false, {"forces.damping"}});
}

/// Soil that counts as at rest with forces out of balance that move it on: docs/stages.md has the share of the weight.
void find_loose_rest(const Case& whole, const SoilSize& soil, const WaveSpeeds& speeds, std::vector<Problem>& warnings)
{
  constexpr Real most = 5e-3;  // of the weight; 2e-4 with the defaults
  const TimeCase& time = whole.time;
  for (std::size_t k = 0; k < whole.stages.size() && soil.g > 0.0; ++k) {
    const StageCase& stage = whole.stages[k];
    const Real alpha = (stage.changed ? *stage.changed : whole).forces.local_damping;
    const Real share = time.rest_speed / (soil.g * (1.0 - alpha) * time.rest_time);
    if (stage.until != Until::at_rest || time.rest_by != RestBy::fastest || !(share > most)) continue;
    warnings.push_back({fmt::format("stage[{}].set", k),
        fmt::format("the stage `{}` counts soil as at rest that still falls", stage.name),
        fmt::format("With local damping of {:g}, {:g} m/s in {:g} s is reached by forces of {:.2g} of the weight. Give "
                    "less damping, or a lower\ntime.rest_speed.",
            alpha, time.rest_speed, time.rest_time, share),
        "time.rest_speed", false, {"time", "stage"}});
  }
  const Real swing = 4.0 * soil.height / speeds.slowest, limit = whole.initial.limit,
             way = 0.5 * limit * soil.g * swing * swing;
  if (whole.initial.stress != InitialStress::equilibrium || !std::isfinite(swing) || !(way > soil.cell)) return;
  warnings.push_back({"initial.limit", "the search for equilibrium ends before it has found one",
      fmt::format(
          "Got {:g}: forces of {:g} of the weight are left, which move soil by {:.2g} m while it swings once; a "
          "cell is {:.2g} m. Usual: 1e-4.",
          limit, limit, way, soil.cell),
      "initial.limit", false, {"initial"}});
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

/// The run ends before the quickest shear wave has crossed the soil, or a stage takes hours for what comes in some
/// swings. A run of a step or two is asked for its start.
void find_other_time_scales(const Model& model, const Case& whole, const SoilSize& soil, const WaveSpeeds& speeds,
    std::vector<Problem>& warnings)
{
  constexpr Real most_swings = 500.0, few_steps = 10.0;
  const Real end = whole.time.end, crossing = soil.height / speeds.stiffest, swing = 4.0 * soil.height / speeds.slowest;
  if (speeds.fastest == 0.0 || soil.g == 0.0) return;
  if (end > few_steps * model.dt && end < crossing)
    warnings.push_back({"time.end", "the run ends before a shear wave has crossed the soil",
        fmt::format("It takes {:.3g} s; the quickest one needs {:.3g} s through {:.3g} m of soil. Times are "
                    "in s: a slide\ntakes some seconds.",
            end, crossing, soil.height),
        "time.end", false, {"stage"}});
  for (std::size_t k = 0; k < whole.stages.size(); ++k)
    if (const StageCase& stage = whole.stages[k]; stage.ramp > most_swings * swing)
      warnings.push_back({fmt::format("stage[{}].ramp", k),
          fmt::format("the ramp of the stage `{}` is far longer than the soil needs", stage.name),
          fmt::format("It takes {:.4g} s; a shear wave swings through {:.3g} m of soil in {:.3g} s, and a ramp of ten "
                      "such times is slow.\nTimes of a run are those of a slide: hours of a river are some 10 s.",
              stage.ramp, soil.height, swing),
          "stage.ramp", false, {fmt::format("stage[{}]", k)}});
}

/// The last stage ends as its water or loads are there in full: what they do comes after.
void find_short_end(const Case& whole, const SoilSize& soil, const WaveSpeeds& speeds, std::vector<Problem>& warnings)
{
  const Real swing = 4.0 * soil.height / speeds.slowest;
  if (whole.stages.empty() || !std::isfinite(speeds.slowest)) return;
  const StageCase& last = whole.stages.back();
  const Real longest = last.until == Until::end ? last.duration : last.at_most;
  if (!(last.ramp > 0.0) || !(longest > 0.0) || longest - last.ramp >= 0.25 * swing) return;
  warnings.push_back({fmt::format("stage[{}].ramp", whole.stages.size() - 1),
      fmt::format("the stage `{}` ends as its ramp does", last.name),
      fmt::format("The ramp takes {:.4g} s of {:.4g} s, and the soil swings once in {:.3g} s: it has no time to fail "
                  "under what is then\nthere in full. Give the stage some seconds more.",
          last.ramp, longest, swing),
      "stage.ramp", false, {fmt::format("stage[{}]", whole.stages.size() - 1)}});
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

/// Intervals of the output far below the time step, or far beyond the end: a run that is cut short keeps those that it
/// has, and the last checkpoint is there in any case. Of rare rows in a case with [flood] another warning speaks.
void find_odd_intervals(const Model& model, std::vector<Problem>& warnings)
{
  constexpr Real far_below = 0.1, far_beyond = 10.0;  // of the time step, of the end
  const Case& whole = model.whole();
  const OutputCase &output = whole.output, defaults;
  const auto check = [&](const char* key, const char* what, Real every, Real by_default, bool is_needed) {
    if (!(every > 0.0) || every == by_default) return;
    if (every < far_below * model.dt)
      warnings.push_back({key, fmt::format("a {} is written in each time step", what),
          fmt::format(
              "Got {:.3g} s; the step is {:.3g} s, and the run takes {} steps.", every, model.dt, model.n_steps),
          key});
    else if (is_needed && whole.time.end > 0.0 && every > far_beyond * whole.time.end)
      warnings.push_back({key, fmt::format("no {} is written between start and end", what),
          fmt::format("Got {:.4g} s; the run takes {:.4g} s at most. Give less; 0 writes the first and the last alone.",
              every, whole.time.end),
          key, false, {"time.end", "stage"}});
  };
  check("output.fields.every", "frame", output.fields_every, defaults.fields_every, true);
  check("output.ledger.every", "row of the ledger", output.ledger_every, defaults.ledger_every, !whole.flood.asks());
  check("output.history.every", "row of the named points", output.history_every, defaults.history_every,
      !output.history_points.empty());
  check("output.checkpoint.every", "checkpoint", output.checkpoint_every, defaults.checkpoint_every, false);
}

}  // namespace

void find_odd_times(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const SoilSize soil = measure_soil(model, state);
  const WaveSpeeds speeds = wave_speeds(model);
  find_short_rest(whole, soil, speeds, warnings);
  find_long_relaxation(model, soil, speeds, whole.time.end, warnings);
  find_long_averaging(model, soil, speeds, whole.time.end, warnings);
  find_strong_damping(model, whole, soil, speeds, warnings);
  find_loose_rest(whole, soil, speeds, warnings);
  find_sudden_stages(whole, soil, speeds, warnings);
  find_short_end(whole, soil, speeds, warnings);
  find_other_time_scales(model, whole, soil, speeds, warnings);
  find_odd_intervals(model, warnings);
}

}  // namespace terp
