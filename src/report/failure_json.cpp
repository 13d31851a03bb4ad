#include "report/failure_json.hpp"

#include "report/story.hpp"

namespace terp {
namespace {

void put_texts(JsonText& json, std::string_view key, const std::vector<std::string>& texts)
{
  json.key(key).begin_array();
  for (const auto& text : texts) json.value(text);
  json.end_array();
}

void put_slip(JsonText& json, const SlipSurface& slip)
{
  json.begin_object().entry("time", slip.time).key("points").begin_array();
  for (const Vec<2>& x : slip.line) json.begin_array().value(x[0]).value(x[1]).end_array();
  json.end_array().end_object();
}

void put_slide(JsonText& json, const SlideSummary& slide)
{
  json.begin_object()
      .entry("facing", slide.slide.facing == Facing::left ? "left" : "right")
      .entry("begins", slide.slide.begins)
      .entry("stops", slide.slide.stops);
  json.entry("crest_from", slide.slide.crest_from)
      .entry("crest_to", slide.slide.crest_to)
      .entry("kinetic_peak", slide.slide.kinetic_peak)
      .key("slip_surface");
  put_slip(json, slide.slip);
  json.end_object();
}

void put_events(JsonText& json, const Summary& s)
{
  json.key("events").begin_object().key("slides").begin_array();
  for (const auto& slide : s.slides) put_slide(json, slide);
  json.end_array();
  const auto slide_or_null = [&](std::string_view key, std::size_t k) {
    json.key(key);
    if (k < s.slides.size())
      put_slide(json, s.slides[k]);
    else
      json.null();
  };
  slide_or_null("first_slide", 0);
  slide_or_null("second_slide", 1);
  json.entry("moved_volume", s.moved_volume)
      .entry("moved_fraction", s.moved_fraction)
      .entry("moved_distance", s.moved_distance);
  json.entry("intact_fraction", s.intact_fraction).entry("free_toe", s.free_toe);
  json.key("facing");
  if (s.facing)
    json.value(*s.facing == Facing::left ? "left" : "right");
  else
    json.null();
  json.entry("run_out", s.run_out).entry("front_x", s.front_x).key("remaining_crest").begin_object();
  json.entry("x", s.crest_x).entry("y", s.crest_y).end_object().key("slip_surface");
  if (s.slides.empty())
    json.null();
  else
    put_slip(json, s.slides[0].slip);
  json.end_object();
}

}  // namespace

void put_failure(JsonText& json, const RunResults& run, const std::vector<std::string>& warnings)
{
  const Summary& s = run.summary.values;
  json.key("passes").begin_array();
  for (const PassTime& pass : s.passes)
    json.begin_object().entry("name", pass.name).entry("seconds", pass.seconds).end_object();
  json.end_array();
  if (summary_is_behind(run))
    json.key("events").null();
  else
    put_events(json, s);
  put_texts(json, "story", tell_story(run));
  std::vector<std::string> cautions = find_cautions(run);
  cautions.insert(cautions.end(), warnings.begin(), warnings.end());
  put_texts(json, "warnings", cautions);
  json.key("checks").begin_array();
  for (const Check& check : list_checks(run))
    json.begin_object()
        .entry("name", check.name)
        .entry("value", check.value)
        .entry("passed", check.passed)
        .end_object();
  json.end_array().key("audit");
  if (summary_is_behind(run)) return void(json.null());
  json.begin_object();
  json.entry("points", s.n_points)
      .entry("points_eps_eq_p_fell", s.points_eps_eq_p_fell)
      .entry("points_su_rose", s.points_su_rose);
  json.entry("energy_balance_error", s.energy_balance_error)
      .entry("clamped_points", s.clamped_points)
      .entry("points_left", s.points_left)
      .end_object();
}

}  // namespace terp
