// An exception is a fault of the realisation only if the soil or the input is to blame; others end the study. A stop is
// no fault: the realisation is drawn again later. Outcomes are kept by their place in the table, without names, in the
// files of a study.

#include "batch/realise.hpp"

#include "math/philox.hpp"
#include "mpm/points/moved.hpp"
#include "run/measure/followers.hpp"
#include "io/case/printable.hpp"
#include "model/ground/ground_section.hpp"
#include "run/loop/guards.hpp"
#include "run/report/mesh_frame.hpp"
#include "run/rest/no_equilibrium.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "run/loop/stages.hpp"
#include "run/stability/factor_of_safety.hpp"
#include "batch/points.hpp"
#include "os/thread_time.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();

/// A part of the ground, and how far it came until displacement was counted anew, or since; infinite for what left.
struct WayOfSoil {
  Real way, volume;  ///< [m], [m^2]
};

std::vector<WayOfSoil> ways_of_ground(const Simulation& s)
{
  const State& state = s.state;
  const std::vector<std::uint8_t> ground = ground_of(s.model);
  std::vector<WayOfSoil> ways;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (is_ground(ground, block))
      ways.push_back({farthest_way(block, lane, state.x_initial, state.moved_before), block.row(Rows::volume)[lane]});
  });
  for (const LeftPoint& point : state.left) ways.push_back({std::numeric_limits<Real>::infinity(), point.volume});
  return ways;
}

Real moved_volume_of(const Simulation& s, const Summary&, const EventRule& event)
{
  Real volume = 0.0;
  for (const WayOfSoil& soil : ways_of_ground(s))
    if (soil.way > event.displacement) volume += soil.volume;
  return volume;
}

/// How far soil of the event's volume has come, all of it at least so far: this varies with the input even where
/// nothing slides.
Real displacement_of_volume(const Simulation& s, const Summary&, const EventRule& event)
{
  std::vector<WayOfSoil> ways = ways_of_ground(s);
  std::ranges::sort(ways, std::ranges::greater(), &WayOfSoil::way);
  constexpr Real most = 1e6;  // [m]
  Real volume = 0.0;
  for (const WayOfSoil& soil : ways)
    if ((volume += soil.volume) >= event.volume) return std::min(soil.way, most);
  return 0.0;
}

/// 1 where soil moves so fast at the end, or that of a stage, that, for as long again, it would go as far as the event
/// asks, or far enough to change the verdict.
Real still_moves(const Simulation& s, const Summary& summary, const EventRule& event)
{
  if (summary.flood && summary.flood->still_moves) return 1.0;
  const auto& done = s.state.stages_done;
  const auto& stages = s.model.description.stages;
  for (std::size_t k = 0; k < done.size() && k < stages.size(); ++k)  // NaN: not looked at
    if (!done[k].at_rest && done[k].fastest * done[k].end > event.displacement &&
        !is_decided_later(s.model.description, k))
      return 1.0;
  if (!done.empty() && (done.back().at_rest || done.back().known_for > 0.0)) return 0.0;
  const NodeMotion motion = map_motion(s.model, s.state);  // points move against each other at rest, too
  Real fastest = 0.0;                                      // [m/s]
  for (std::size_t k = 0; k < motion.mass.size(); ++k)
    fastest = std::max(fastest, std::hypot(motion.velocity[2 * k], motion.velocity[2 * k + 1]));
  return fastest * s.state.time > event.displacement ? 1.0 : 0.0;
}

template <Real FloodSummary::*member>
Real of_flood(const Summary& summary)
{
  return summary.flood && std::isfinite((*summary.flood).*member) ? (*summary.flood).*member : none;
}

template <std::optional<Real> Summary::*member>
Real of_summary(const Summary& summary)
{
  return (summary.*member).value_or(none);
}

const OutcomeInfo outcomes[] = {
    {{"slide_volume", "m^2", "volume that slid", "volume that moved farther than the displacement of the event"},
        nullptr, moved_volume_of},
    {{"event_displacement", "m", "displacement of the event's volume", "as much soil as makes the event moved farther"},
        nullptr, displacement_of_volume},
    {{"residual_height", "m", "highest ground that remains", "at the end (docs/flood.md)"},
        of_summary<&Summary::residual_height>},
    {{"freeboard", "m", "freeboard that remains", "of the highest ground over the water, at the end"},
        of_flood<&FloodSummary::freeboard>},
    {{"width_at_level", "m", "width at the water level", "of the ground, at the end"},
        of_flood<&FloodSummary::width_at_level>},
    {{"slides", "-", "slides", "how often the crest retreated by much (docs/formats.md)"},
        [](const Summary& s) { return static_cast<Real>(s.slides.size()); }},
    {{"first_slide_time", "s", "time of the first slide", "when the crest began to retreat"},
        of_summary<&Summary::first_slide_time>},
    {{"flood_time", "s", "time of the flood", "first time the ground no longer held the water"},
        [](const Summary& s) { return s.flood ? s.flood->first_time_below.value_or(none) : none; }},
    {{"near", "-", "near a flood", "1 where the ground was below the water briefly or by little: it counts as F"},
        [](const Summary& s) { return s.flood && s.flood->verdict == FloodVerdict::near ? 1.0 : 0.0; }},
    {{"held", "-", "held at first",
         "1 where the soil slides as drawn, and was held and released ([held] of the study)"},
        nullptr, [](const Simulation&, const Summary&, const EventRule&) { return 0.0; }},
    {{"still_moves", "-", "still moves", "1 where soil moves so fast at the end that I or F may change"}, nullptr,
        still_moves},
    {{"max_eps_eq_p", "-", "largest eps_eq_p", "at the end"}, of_summary<&Summary::max_eps_eq_p>},
    {{"end_time", "s", "time at the end", "of the run"}, nullptr,
        [](const Simulation& s, const Summary&, const EventRule&) { return s.state.time; }},
};

std::string on_one_line(std::string text)
{
  for (char& c : text)
    if (c == '\n' || c == '\t' || c == '\r') c = ' ';
  const auto both_blank = [](char a, char b) { return a == ' ' && b == ' '; };
  text.erase(std::unique(text.begin(), text.end(), both_blank), text.end());
  constexpr std::size_t longest = 400;
  return printable(text.size() > longest ? text.substr(0, longest) + " ..." : text);
}

/// "error: case.toml:12:3: what" -> what of the first error that the case reports.
std::string fault_of_case(const std::string& message)
{
  const std::size_t begin = message.find("error: ");
  std::string text = begin == std::string::npos ? message : message.substr(begin + 7);
  if (const std::size_t more = text.find("error: "); more != std::string::npos) text.resize(more);
  if (const std::size_t end = text.find("nothing was run"); end != std::string::npos)
    text.resize(text.rfind('\n', end));
  return text;
}

bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b)
{
  return std::ranges::equal(a, b, [](Real x, Real y) {
    return (std::isnan(x) && std::isnan(y)) || std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool is_audited(const Study& study, Index number)
{
  const Real u = philox_uniform({static_cast<std::uint32_t>(number), 0, stream_of_audit, 0},
      {static_cast<std::uint32_t>(study.settings.seed), 0});
  return u < study.settings.two_stage.audit;
}

/// What is not known to stand is run. So a search that fails costs time, and no truth.
Screening screen(const Study& study, const Case& c, Index number, const std::atomic<bool>& stop)
{
  if (study.settings.estimator != Estimator::two_stage) return Screening::none;
  try {
    if (try_factor(c, study.settings.two_stage.factor, {}, stop).verdict != TrialVerdict::stable)
      return Screening::falls;
  } catch (const RunError&) {
    return Screening::falls;
  }
  return is_audited(study, number) ? Screening::audited : Screening::skipped;
}

/// False: stopped before its end.
bool run_to_end(const Study& study, const Case& c, const std::atomic<bool>& stop, Realisation& result)
{
  const SharedMesh mesh =
      study.shares_mesh ? study.mesh_of(result.number) : std::make_shared<const Mesh<2>>(build_mesh(c));
  Simulation simulation(c, mesh, 1, all_followers());
  result.judges_flood = simulation.model.flood_level.is_known();
  const EventRule& event = study.settings.event;
  if (simulation.run(stop) != Outcome::finished) return false;
  if (const Real share = unexplained_share(simulation.state); share > unexplained_that_fails) {
    result.fault =
        fmt::format("its energy is wrong: nothing explains {:.2g} % of what came from outside", 100.0 * share);
    return true;
  }
  read_outcomes(simulation, event, result);
  return true;
}

/// Soil that slides as drawn is held and released, if the study says how. False: stopped before its end.
bool solve(const Study& study, const Draw& draw, const std::atomic<bool>& stop, Realisation& result)
{
  const CaseFile file = case_of(study, draw);
  result.screening = screen(study, file.values, result.number, stop);
  if (stop.load()) return false;
  if (result.skipped()) return true;
  try {
    return run_to_end(study, file.values, stop, result);
  } catch (const SlidesAsDrawn&) {
    if (draw.held.empty()) throw;
  }
  result.is_held = true;
  return run_to_end(study, read_case_text(study.case_text, study.case_path, held_changes(draw)).values, stop, result);
}

}  // namespace

std::span<const OutcomeInfo> study_outcomes() { return outcomes; }

std::size_t outcome_number(std::string_view name)
{
  const auto found = std::ranges::find(outcomes, name, [](const OutcomeInfo& outcome) { return outcome.info.name; });
  TERP_ASSERT(found != std::end(outcomes));
  return static_cast<std::size_t>(found - std::begin(outcomes));
}

std::vector<std::string> differing_outcomes(const std::vector<Real>& kept, const std::vector<Real>& now)
{
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::size(outcomes); ++k)
    if (!same_bits({kept[k]}, {now[k]})) names.emplace_back(outcomes[k].info.name);
  return names;
}

bool Realisation::knows_flood() const
{
  static const std::size_t still_moves = outcome_number("still_moves");
  return solved() && judges_flood && (flooded || outcomes.size() <= still_moves || outcomes[still_moves] != 1.0);
}

bool Realisation::same_as(const Realisation& other) const
{
  return number == other.number && fault == other.fault && screening == other.screening && slid == other.slid &&
         flooded == other.flooded && judges_flood == other.judges_flood && same_bits(inputs, other.inputs) &&
         same_bits(outcomes, other.outcomes);
}

void read_outcomes(const Simulation& simulation, const EventRule& event, Realisation& r)
{
  const Summary summary = summarise(simulation.model, simulation.state);
  for (const OutcomeInfo& outcome : outcomes)
    r.outcomes.push_back(
        outcome.of_summary != nullptr ? outcome.of_summary(summary) : outcome.of_run(simulation, summary, event));
  r.outcomes[outcome_number("held")] = r.is_held ? 1.0 : 0.0;
  r.slid = r.outcomes[outcome_number("slide_volume")] >= event.volume;
  r.judges_flood = summary.flood.has_value();
  r.flooded = r.judges_flood && (summary.flood->verdict == FloodVerdict::floods ||
                                    summary.flood->verdict == FloodVerdict::near);  // on the safe side
}

std::optional<Realisation> realise(const Study& study, Index number, const Draw& draw, const std::atomic<bool>& stop)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double processor_before = thread_seconds();
  Realisation result{.number = number};
  try {
    result.inputs = draw.inputs;
    if (!solve(study, draw, stop, result)) return std::nullopt;
  } catch (const CaseError& error) {
    result.fault = on_one_line("refused: " + fault_of_case(error.what()));
  } catch (const InputError& error) {
    result.fault = on_one_line(std::string("refused: ") + error.what());
  } catch (const SlidesAsDrawn& error) {
    result.slid = true;
    const std::string why = error.what();
    result.fault = on_one_line("slides as drawn: " + why.substr(0, why.find("\n  likely")));
  } catch (const RunError& error) {
    if (stop.load()) return std::nullopt;
    result.fault = on_one_line(std::string("stopped itself: ") + error.what());
  }
  if (!result.solved()) result.outcomes.clear();
  result.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  result.processor_s = thread_seconds() - processor_before;
  return result;
}

}  // namespace terp
