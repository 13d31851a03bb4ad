#include "report/story.hpp"

#include "events/moved.hpp"
#include "results/compare.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real much_imbalance = 0.05;  // of the energy exchanged; also the limit of the program's warning
constexpr Real hardly_moved = 0.01;    // share of the volume
constexpr Real still_moving = 0.01;    // kinetic energy at the end over its largest

/// First, last and largest entry of a column; NaN without rows.
struct Extent {
  Real first = std::nan(""), last = std::nan(""), largest = std::nan("");
};

Extent extent_of(const RunResults& run, std::string_view column)
{
  const auto* values = run.ledger.find(column);
  if (values == nullptr || values->empty()) return {};
  return {values->front(), values->back(), *std::max_element(values->begin(), values->end())};
}

std::string ordinal(std::size_t k)
{
  constexpr std::array words{"first", "second", "third", "fourth", "fifth"};
  return k < words.size() ? words[k] : fmt::format("{}th", k + 1);
}

/// Of the nodes, which see no noise of points within a cell; of the points in a run of an earlier terp.
Extent kinetic_energy_of(const RunResults& run)
{
  return extent_of(run, run.ledger.find("kinetic_nodal") != nullptr ? "kinetic_nodal" : "kinetic");
}

std::string end_of_slide(const RunResults& run, std::size_t k)
{
  const auto& slides = run.summary.values.slides;
  const Slide& slide = slides[k].slide;
  if (slide.stops)
    return fmt::format("At {:.2f} s it has slowed to a tenth of its largest kinetic energy.", *slide.stops);
  if (k + 1 < slides.size())
    return "It has not slowed to a tenth of its largest kinetic energy when the next one begins.";
  const Extent kinetic = kinetic_energy_of(run), time = extent_of(run, "time");
  if (!(slide.kinetic_peak > 0.0) || std::isnan(kinetic.last)) return "";
  return fmt::format("It still moves at {:.2f} s, with {:.0f} % of its largest kinetic energy.", time.last,
      100.0 * kinetic.last / slide.kinetic_peak);
}

/// " on the slope to the left", or with a river which side that is; nothing where all slides are to the right.
std::string side_of(const Summary& s, Facing facing)
{
  const std::vector<SlideSummary>& slides = s.slides;
  if (s.flood && s.flood->river) return facing == *s.flood->river ? " on the river's side" : " on the land's side";
  const bool all_right =
      std::ranges::all_of(slides, [](const SlideSummary& s) { return s.slide.facing == Facing::right; });
  return all_right ? "" : facing == Facing::left ? " on the slope to the left" : " on the slope to the right";
}

/// Whether the ground holds the water, and what that says nothing of.
void tell_flood(const Summary& s, std::vector<std::string>& story)
{
  if (!s.flood) return;
  std::string text = flood_sentence(*s.flood);
  text[0] = static_cast<char>(std::toupper(text[0]));
  const std::string& origin = s.flood->water_level_origin;
  story.push_back(fmt::format("Verdict: {} The criterion: {}. {}{}", text, s.flood->criterion,
      origin.empty() ? "" : fmt::format("The water level is {}. ", origin), flood_caution));
}

std::string water_in_words(const std::string& name)
{
  return name == "start" ? "at the start" : fmt::format("of the situation \"{}\"", name);
}

/// Which water strengths belong to; materials with the same are one sentence.
void tell_strength_water(const Summary& s, std::vector<std::string>& story)
{
  std::vector<std::pair<std::string, std::string>> sentences;  // what follows from which water, and whose it is
  for (const StrengthWater& strength : s.strength_water) {
    std::string water =
        fmt::format("{} follows from sigma'_v in the water {}", strength.parameter, water_in_words(strength.stress));
    if (strength.daily) water += ", and from sigma'_p in the water " + water_in_words(*strength.daily);
    const auto same = std::ranges::find(sentences, water, &std::pair<std::string, std::string>::first);
    if (same == sentences.end())
      sentences.emplace_back(water, strength.material);
    else
      same->second += ", " + strength.material;
  }
  for (const auto& [water, whose] : sentences) story.push_back(fmt::format("Strength of {}: {}.", whose, water));
}

/// The stages, and how each ended.
void tell_stages(const Summary& s, std::vector<std::string>& story)
{
  std::string text;
  for (const StageSummary& stage : s.stages) {
    if (stage.name.empty()) continue;
    text += fmt::format("{}{} from {:.2f} to {:.2f} s", text.empty() ? "Stages: " : "; ", stage.name,
        stage.record.start, stage.record.end);
    if (stage.record.at_rest)
      text += ", at rest";
    else if (std::isfinite(stage.record.fastest))
      text += fmt::format(", not at rest (the fastest node: {:.2g} m/s)", stage.record.fastest);
  }
  if (!text.empty()) story.push_back(text + ".");
}

void tell_slides(const RunResults& run, std::vector<std::string>& story)
{
  const auto& slides = run.summary.values.slides;
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const Slide& slide = slides[k].slide;
    story.push_back(
        fmt::format("The {} slide begins at {:.2f} s{}: the crest retreats from x = {:.2f} m to {:.2f} m. {}",
            ordinal(k), slide.begins, side_of(run.summary.values, slide.facing), slide.crest_from, slide.crest_to,
            end_of_slide(run, k)));
  }
  if (!slides.empty()) return;
  story.push_back(run.summary.values.moved_fraction < hardly_moved
                      ? "The soil holds: there is no slide."
                      : "Soil moves, but the crest does not retreat as in a slide.");
}

/// How far the front came, or why there is none.
std::string front_sentence(const Summary& s)
{
  if (!s.facing) return "The section has no slope: there is no front and no crest.";
  const bool known = std::isfinite(s.front_x) && std::isfinite(s.run_out);
  if (s.free_toe)
    return known ? fmt::format("The front has run out by {:.2f} m, to x = {:.2f} m.", s.run_out, s.front_x)
                 : "No soil is left, and no front.";
  const std::string why = "The soil fills the section to its side, so its toe is not free: ";
  if (!known) return why + "no soil has come out of the slope.";
  const std::string how_far = s.run_out > 0.0 ? fmt::format("{:.2f} m beyond the toe of the slope", s.run_out)
                                              : std::string("not beyond the toe of the slope");
  return why + fmt::format("what moved reaches x = {:.2f} m, {}.", s.front_x, how_far);
}

void tell_motion(const RunResults& run, std::vector<std::string>& story)
{
  const Summary& s = run.summary.values;
  const Extent time = extent_of(run, "time"), kinetic = kinetic_energy_of(run);
  story.push_back(fmt::format("{}, {:.2f} m² of soil ({:.1f} % of the section) have moved by more than {:.2g} m. {}",
      std::isnan(time.last) ? "At the end" : fmt::format("By {:.2f} s", time.last), s.moved_volume,
      100.0 * s.moved_fraction, s.moved_distance, front_sentence(s)));
  if (s.intact_fraction && s.moved_fraction > hardly_moved)
    story.push_back(fmt::format("Of the soil that moved, {:.1f} % is intact: its plastic strain is below {:g}.",
        100.0 * *s.intact_fraction, intact_strain));
  if (s.crest_x && s.crest_y)
    story.push_back(
        fmt::format("The first surface still stands up to x = {:.2f} m, y = {:.2f} m.", *s.crest_x, *s.crest_y));
  if (s.residual_height)
    story.push_back(fmt::format("The highest ground that remains stands at {:.2f} m.", *s.residual_height));
  if (!s.crest_x && !s.slides.empty()) story.push_back("Nothing of the first surface stands.");
  const bool told = !s.slides.empty() && !s.slides.back().slide.stops;
  const bool at_rest = !s.stages.empty() && s.stages.back().record.at_rest;
  if (!told && !at_rest && kinetic.last > still_moving * kinetic.largest)
    story.push_back(fmt::format("At the end the soil still moves, with {:.0f} % of its largest kinetic energy.",
        100.0 * kinetic.last / kinetic.largest));
}

void tell_softening(const RunResults& run, std::vector<std::string>& story)
{
  const auto& softened = run.summary.values.softened_fraction;
  if (softened.empty() || softened.back().second == 0.0) return;
  story.push_back(
      fmt::format("{:.1f} % of the soil has lost more than half of its strength.", 100.0 * softened.back().second));
}

void tell_history(const RunResults& run, std::vector<std::string>& story)
{
  const Summary& s = run.summary.values;
  if (s.points_eps_eq_p_fell == 0) return;
  story.push_back(
      fmt::format("At {} of {} points the plastic strain fell at some time{}. The law of the soil does not allow it: "
                  "{} averages the history of neighbouring points.",
          s.points_eps_eq_p_fell, s.n_points, s.points_su_rose > 0 ? " and strength came back" : "",
          scheme_title(s.scheme)));
}

}  // namespace

std::vector<std::string> tell_story(const RunResults& run)
{
  if (summary_is_behind(run))
    return {fmt::format("The run has come to {:.2f} s. What happened is told when it ends or is stopped.",
        extent_of(run, "time").last)};
  std::vector<std::string> story;
  tell_flood(run.summary.values, story);
  tell_stages(run.summary.values, story);
  tell_slides(run, story);
  tell_motion(run, story);
  tell_softening(run, story);
  tell_strength_water(run.summary.values, story);
  tell_history(run, story);
  return story;
}

std::vector<std::string> find_cautions(const RunResults& run)
{
  const Summary& s = run.summary.values;
  std::vector<std::string> cautions;
  const auto add = [&](bool so, std::string text) {
    if (so) cautions.push_back(std::move(text));
  };
  add(!run.summary.finished, fmt::format("The run has not reached its end: the last row of its ledger is at {:.3g} s.",
                                 extent_of(run, "time").last));
  if (summary_is_behind(run)) return cautions;
  add(s.energy_balance_error > much_imbalance,
      fmt::format("The energy balance is off by {:.2g} % of the energy exchanged.", 100.0 * s.energy_balance_error));
  add(s.clamped_points > 0, fmt::format("{} points had to be put back at a wall of the mesh.", s.clamped_points));
  add(s.points_left > 0, fmt::format("{} points left the mesh through open sides.", s.points_left));
  return cautions;
}

std::vector<Check> list_checks(const RunResults& run)
{
  const Summary& s = run.summary.values;
  if (summary_is_behind(run)) return {{"The run reached its end", "no", false}};  // the rest is not known yet
  return {{"The run reached its end", run.summary.finished ? "yes" : "no", run.summary.finished},
      {"Energy balance error (at most 5 %)", fmt::format("{:.2g} %", 100.0 * s.energy_balance_error),
          s.energy_balance_error <= much_imbalance},
      {"Points put back at walls", std::to_string(s.clamped_points), s.clamped_points == 0},
      {"Points whose plastic strain ever fell", std::to_string(s.points_eps_eq_p_fell), s.points_eps_eq_p_fell == 0},
      {"Points whose strength ever rose", std::to_string(s.points_su_rose), s.points_su_rose == 0}};
}

}  // namespace terp
