// A level without any realisation is left out of the charts. The answer is that of a flood where floods are judged,
// else that of a slide. It has three forms: no distribution of the load, levels of which nothing is known, and a
// probability over all levels. The last one gives two pairs of bounds, since the curve between its levels is an
// assumption; the second needs a curve that rises.

#include "page/plain_page.hpp"
#include "batch/fragility_text.hpp"
#include "batch/study_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace terp {
namespace {

using EventOfLevel = EventEstimate LevelEstimate::*;

void add_curve(const FragilityCurve& curve, const char* name, EventOfLevel event, std::size_t style, LineChart& chart)
{
  ChartLine p{.name = name, .points = {}, .style = style, .dashes = 0, .marks = true},
      low{.name = fmt::format("{}, bounds", name), .points = {}, .style = style, .dashes = 2, .marks = false},
      high{.name = "", .points = {}, .style = style, .dashes = 2, .marks = false};
  for (const LevelEstimate& at : curve.levels) {
    const EventEstimate& e = at.*event;
    if (e.solved + e.failed == 0) continue;
    p.points.push_back({at.level, e.probability().value_or(std::nan(""))});
    low.points.push_back({at.level, e.bounds.low});
    high.points.push_back({at.level, e.bounds.high});
  }
  for (ChartLine* line : {&p, &low, &high}) chart.lines.push_back(std::move(*line));
}

std::vector<LineChart> charts_of(const Study& study, const FragilityCurve& curve)
{
  const FragilityLoad& load = *study.settings.fragility;
  std::vector<LineChart> charts;
  LineChart fragility{.title = "Fragility curve", .x_label = load.label(), .y_label = "probability"};
  add_curve(curve, "slide, P(I|h)", &LevelEstimate::slide, 0, fragility);
  if (curve.judges_flood) add_curve(curve, "flood, P(F|h)", &LevelEstimate::flood, 1, fragility);
  charts.push_back(std::move(fragility));
  if (curve.judges_flood) {
    LineChart worth{.title = "Floods among slides", .x_label = load.label(), .y_label = "probability"};
    add_curve(curve, "P(F|I, h)", &LevelEstimate::flood_after_slide, 2, worth);
    charts.push_back(std::move(worth));
  }
  if (load.distribution) {
    LineChart loads{
        .title = "Distribution of the load", .x_label = load.label(), .y_label = "probability not exceeded"};
    ChartLine line{.name = "", .points = {}, .style = 3, .dashes = 0, .marks = false};
    constexpr int n = 100;
    const Real low = std::min(load.levels.front(), load.distribution->quantile(0.01)),
               high = std::max(load.levels.back(), load.distribution->quantile(0.99));
    for (int k = 0; k <= n; ++k) {
      const Real h = low + (high - low) * k / n;
      line.points.push_back({h, load.distribution->probability(h)});
    }
    loads.lines.push_back(std::move(line));
    charts.push_back(std::move(loads));
  }
  return charts;
}

std::string cells_of(const EventEstimate& e, bool with_beta)
{
  const auto p = e.probability();
  std::string cells = html_cell("td", p ? fmt::format("{:.3g}", *p) : "-") +
                      html_cell("td", p ? fmt::format("{:.3g} to {:.3g}", e.bounds.low, e.bounds.high) : "-");
  if (with_beta) cells += html_cell("td", p ? fmt::format("{:.2f}", reliability_index(*p)) : "-");
  return cells;
}

std::string table_of_levels(const Study& study, const FragilityCurve& curve)
{
  const std::string bounds = fmt::format("{:g} % bounds", 100.0 * study.settings.confidence);
  std::string rows;
  for (const LevelEstimate& at : curve.levels)
    rows += "<tr>" + html_cell("th", fmt::format("{:g}", at.level)) + cells_of(at.slide, true) +
            cells_of(at.flood, true) + cells_of(at.flood_after_slide, false) + "</tr>\n";
  return html_table(
      {study.settings.fragility->label(), "P(I|h)", bounds, "beta", "P(F|h)", bounds, "beta", "P(F|I, h)", bounds},
      rows);
}

std::string answer(const Study& study, const FragilityCurve& curve)
{
  const FragilityLoad& load = *study.settings.fragility;
  const auto& integral = curve.judges_flood ? curve.flood : curve.slide;
  const char* event = curve.judges_flood ? "The land floods" : "The slope slides";
  EventEstimate all;
  for (const LevelEstimate& at : curve.levels) {
    const EventEstimate& e = curve.judges_flood ? at.flood : at.slide;
    all.solved += e.solved, all.failed += e.failed;
  }
  const std::string missing = all.failed > 0 ? ' ' + missing_words(all) : "";
  if (!integral)
    return fmt::format("{} with the probabilities below, at each {}. {}{}", event, load.name,
        load.distribution ? "For one probability over all levels, each level needs realisations of which it is known."
                          : "For one probability over all levels, give the distribution of the load in [fragility].",
        missing);
  std::string text = fmt::format(
      "{} with probability {:.2g}, over the distribution of the {}. ", event, integral->probability, load.name);
  text += fmt::format(
      "With {:g} % confidence it lies between {:.2g} and {:.2g} if the curve is straight between its levels and level "
      "beyond them{}.",
      100.0 * study.settings.confidence, integral->of_line.low, integral->of_line.high,
      integral->rising
          ? fmt::format(", and between {:.2g} and {:.2g} if it is only known to rise", integral->rising->low,
                integral->rising->high)
          : "; it falls from one level to a higher one by more than chance, so that no bounds of a rising curve hold");
  if (curve.judges_flood) text += fmt::format(" A slide happens with probability {:.2g}.", curve.slide->probability);
  return text + missing;
}

}  // namespace

std::string fragility_section(const Study& study, const FragilityCurve& curve)
{
  return "<section><h2>Fragility</h2>\n" + html_cell("p", answer(study, curve), " class=\"answer\"") + '\n' +
         html_figures(charts_of(study, curve)) + table_of_levels(study, curve) +
         html_cell("p",
             fmt::format("I is {}; F is: {}. {}The samples are the same at all levels. Bounds of a level are those of "
                         "Clopper and Pearson; bounds over all levels hold at all of them at once. Where the load is a "
                         "year's highest water, the probability is per year; it is of this section alone. "
                         "fragility.csv has the table{}.",
                 slide_words(study.settings), flood_words,
                 curve.judges_flood ? "P(F|I, h) is the share of the slides at a level that flood the land: it says "
                                      "what the residual strength of the dike is worth there. "
                                    : "",
                 is_water_level(*study.settings.fragility)
                     ? ", fragility_slide.json and fragility_flood.json have it for D-Stability"
                     : ""),
             " class=\"muted\"") +
         "</section>\n";
}

}  // namespace terp
