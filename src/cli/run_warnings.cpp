// Each warning stands by itself. It is judged from the summary and the case, and changes neither results nor exit
// status. What may change the verdict on a flood comes first: soil not at rest, then a small margin. Each names the
// page of the documentation that explains it.

#include "cli/commands.hpp"
#include "io/case/printable.hpp"
#include "run/loop/guards.hpp"
#include "model/parts/model.hpp"
#include "run/report/summary.hpp"
#include "os/say.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

std::string why_not_at_rest(const TimeCase& time, Real fastest)
{
  if (time.rest_by == RestBy::mean)
    return fmt::format("more of it than a cell holds went farther than {:.2g} m within {:g} s",
        time.rest_speed * time.rest_time, time.rest_time);
  if (fastest < time.rest_speed)
    return fmt::format(
        "its fastest node was not slower than {:.2g} m/s for {:g} s after the last change of water and loads",
        time.rest_speed, time.rest_time);
  const std::string limit = fmt::format("{:g}", time.rest_speed);
  std::string speed;
  for (int digits = 2; digits <= 6 && (speed.empty() || speed == limit); ++digits)
    speed = fmt::format("{:.{}g}", fastest, digits);
  return fmt::format("its fastest node moved with {} m/s, limit {} m/s", speed, limit);
}

/// Stages, or the run, that were to end at rest and did not; a verdict on soil that still moves.
void warn_of_no_rest(const Summary& s, const Model& model, const std::string& folder)
{
  const TimeCase& time = model.description.time;
  for (const StageSummary& stage : s.stages) {
    const StageRecord& r = stage.record;
    if (r.at_rest || !std::isfinite(r.fastest)) continue;
    say(stderr,
        "warning: {}: {} ended after {:.4g} s, at t = {:.4g} s, before the soil was at rest: {}; see "
        "docs/stages.md#at-rest\n",
        folder, stage.name.empty() ? "the run" : fmt::format("the stage `{}`", stage.name), r.end - r.start, r.end,
        why_not_at_rest(time, r.fastest));
  }
  const bool ends_at_rest = !s.stages.empty() && std::isfinite(s.stages.back().record.fastest);
  const auto& flood = s.flood;
  if (!flood || !flood->still_moves || flood->first_time_below) return;
  if (const bool at_end = flood->moves_at_end(); !at_end || !ends_at_rest)
    say(stderr, "warning: {}: {} {}, so nothing is decided: end {} at rest, or later; see docs/stages.md#at-rest\n",
        folder, moving_when(*flood), motion_words(*flood), at_end ? "the run" : "that stage");
}

void warn_of_small_margin(const Summary& s, const std::string& folder)
{
  if (s.flood && s.flood->verdict == FloodVerdict::near)
    say(stderr,
        "warning: {}: the ground was below the water by little, for less than 2 s, or not to the end: finer cells may "
        "decide; see docs/flood.md#the-verdict\n",
        folder);
  if (s.flood && s.flood->margin)
    say(stderr,
        "warning: {}: the ground that remains is only {:.2f} m higher than holds the water: finer cells may "
        "decide; see docs/flood.md#how-sure-is-it\n",
        folder, *s.flood->margin);
}

}  // namespace

void warn_of(const Summary& s, const Model& model, const std::string& folder)
{
  warn_of_no_rest(s, model, folder);
  warn_of_small_margin(s, folder);
  constexpr double much = 0.05;
  if (s.unexplained_energy > unexplained_that_warns)
    say(stderr,
        "warning: {}: nothing explains {:.2g} % of the energy that came from outside; see "
        "docs/troubleshooting.md#the-energy-balance-is-off\n",
        folder, 100.0 * s.unexplained_energy);
  constexpr double many = 7.0;  // runs whose mean force is damped have 1.4 to 5.6
  const auto number = [&](const char* name) { return s.numbers.contains(name) ? s.numbers.at(name) : 0.0; };
  const double damping = number("damping_over_promised"), cells = number("softening_length_over_cell_reached");
  if (damping > many && number("damping_fraction") > much)
    say(stderr,
        "warning: {}: local damping took {:.2g} times the energy that its factor promises, so noise brakes the soil; "
        "see docs/troubleshooting.md#damping-took-more-than-it-promises\n",
        folder, damping);
  if (cells < 2.0 * (1.0 - 1e-9) && cells < number("softening_length_over_cell"))  // it was told of less at t = 0
    say(stderr,
        "warning: {}: soil came to cells of which its softening length holds {:.2g}; see docs/softening_length.md\n",
        folder, cells);
  if (const double lowest = number("lowest_library_strength"); lowest < 0.0)
    say(stderr,
        "warning: {}: a law of a library returned a strength of {:.3g} Pa, below zero; see "
        "docs/user_laws.md#the-keys\n",
        folder, lowest);
  for (const ReachedSide& reached : s.reached_sides)
    say(stderr,
        "warning: {}: soil {} the side `{}` of the mesh by t = {:.3g} s, which {}; see "
        "docs/troubleshooting.md#soil-reaches-the-side-of-the-mesh\n",
        folder, reached.rose ? "rose at" : "came to", printable(reached.side), reached.time,
        reached.rose ? "holds it back" : "acts on it from then on");
}

}  // namespace terp
