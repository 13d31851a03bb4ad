// Agreement of the pairs is reported for each event. What two levels save is reported of the flood where floods are
// judged, else of the slide. A group that has coarse realisations but no solved pair is named, as there is no estimate
// without one. With a fragility curve only failures are reported here, since counts of different levels of the load do
// not add up.

#include "batch/study_text.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

/// "3 of 40 coarse realisations flood the land. ..."
std::string pairs_text(const TwoLevelCounts& c, const char* verb, const char* event)
{
  const std::int64_t unknown = c.with.unknown + c.without.unknown;
  return fmt::format(
      "{} of {} coarse realisations {}. Of {} pairs {} have the {} on both levels, {} lost it with the fine case, {} "
      "gained it{}. If the coarse case were right, {} would be ",
      c.coarse, c.n, verb, c.with.n + c.without.n, c.with.happened, event, c.lost(), c.gained(),
      unknown > 0 ? fmt::format(", of {} it is not known", unknown) : "", event[0] == 'f' ? "P(F)" : "P(I)");
}

/// Which pairs are missing for an estimate; empty: none.
std::string missing_group(const TwoLevelCounts& c, const char* event)
{
  const char* which = c.coarse > 0 && c.with.known() == 0        ? "with"
                      : c.coarse < c.n && c.without.known() == 0 ? "without"
                                                                 : nullptr;
  if (which == nullptr) return "";
  return fmt::format(
      "No pair {} a coarse {} is solved: what such a coarse realisation is worth is not known, and there "
      "is no estimate. Give more pairs.",
      which, event);
}

std::string savings_text(const TwoLevelCounts& c, const LevelSavings& s)
{
  std::string text =
      fmt::format("A coarse realisation took {:.2g} s of processor time, a fine one {:.2g} s. ", s.coarse_s, s.fine_s);
  text += fmt::format(
      "Monte Carlo with the fine case alone would have taken {}about {:.2g} times as long for the same variance.",
      s.same_bounds ? fmt::format("{:.2g} times as long for bounds as narrow, ", *s.same_bounds) : "", s.same_variance);
  if (c.lost() + c.gained() == 0) text += " No pair differs, and half a pair is counted as if it did.";
  return text;
}

std::string best_text(const TwoLevelCounts& c, const LevelSavings& s)
{
  if (s.best_same_variance <= 1.0)
    return "By these pairs the two levels agree too little for what a coarse realisation costs: Monte Carlo with the "
           "fine case alone is at least as fast. Give the coarse case finer cells, or leave it out.";
  return fmt::format(
      "By these {} pairs the variance is least for the time with about {:.2g} pairs for 100 coarse "
      "realisations; Monte Carlo would then take {:.2g} times as long. Narrow bounds take more pairs.",
      c.with.n + c.without.n, 100.0 * s.best_share, s.best_same_variance);
}

}  // namespace

std::vector<std::string> remarks_on_levels(const Study& study, const StudyEstimates& e)
{
  std::vector<std::string> remarks;
  if (!study.coarse) return remarks;
  if (const std::int64_t n = e.sample.coarse().failed; n > 0)
    remarks.push_back(
        fmt::format("{} coarse realisation{} failed: on the coarse level {} without an event, which the "
                    "pairs correct.",
            n, n == 1 ? "" : "s", n == 1 ? "it counts as one" : "they count as some"));
  if (study.settings.fragility) return remarks;  // each level of the load has its own
  const Real confidence = study.settings.confidence;
  const auto add = [&](StudyEvent event, const char* verb, const char* name) {
    const TwoLevelCounts& c = e.sample.levels().of(event);
    remarks.push_back(pairs_text(c, verb, name) + estimate_text(c.coarse_alone(confidence)) + '.');
    if (std::string missing = missing_group(c, name); !missing.empty()) remarks.push_back(std::move(missing));
  };
  add(StudyEvent::slide, "slide", "slide");
  if (e.judges_flood) add(StudyEvent::flood, "flood the land", "flood");
  const char* p = e.judges_flood ? "P(F)" : "P(I)";
  const TwoLevelCounts& headline = e.sample.levels().of(e.judges_flood ? StudyEvent::flood : StudyEvent::slide);
  if (const auto savings = find_savings(headline, e.coarse_s, e.fine_s, confidence)) {
    if (const auto rough = headline.rough_bounds(confidence))
      remarks.push_back(fmt::format(
          "The bounds are proven and wide: with few pairs nearly those of the pairs alone. By its variance {} lies "
          "roughly between {:.3g} and {:.3g}, which is not proven.",
          p, rough->low, rough->high));
    remarks.push_back(savings_text(headline, *savings));
    remarks.push_back(best_text(headline, *savings));
  } else {
    remarks.emplace_back(
        "What two levels save is not known: it takes coarse realisations with and without the event, "
        "and pairs of both.");
  }
  return remarks;
}

}  // namespace terp
