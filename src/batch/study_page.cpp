// Sentences come from study_text. Of two levels of cells only fine realisations are shown, as P is theirs; levels of a
// load are never counted together. Inputs have the order of Study::input_names; fields are the last of them, and labels
// count on that.

#include "batch/study_page.hpp"

#include "io/case/keys.hpp"
#include "page/plain_page.hpp"
#include "batch/adaptive.hpp"
#include "batch/fragility_text.hpp"
#include "batch/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace terp {
namespace {

constexpr Index most_rows = 500;    // of the table; results.csv has all
constexpr Index most_places = 200;  // of a line over the realisations

std::string bounds_cell(const EventEstimate& e)
{
  if (e.solved + e.failed == 0) return html_cell("td", "-");
  return html_cell("td", fmt::format("{:.3g} to {:.3g}", e.bounds.low, e.bounds.high));
}

std::string event_row(const Study& study, const char* name, const char* meaning, const EventEstimate& e)
{
  const auto p = e.probability();
  return "<tr>" + html_cell("th", name) + html_cell("td", p ? fmt::format("{:.3g}", *p) : "-") + bounds_cell(e) +
         html_cell("td", fmt::format("{} of {}{}{}", e.happened, e.solved, words_of_counted(study),
                             e.failed > 0 ? fmt::format(", {} unknown", e.failed) : "")) +
         html_cell("td", meaning) + "</tr>\n";
}

std::string answer(const Study& study, const StudyEstimates& e)
{
  const EventEstimate& event = e.judges_flood ? e.flood : e.slide;
  const auto p = event.probability();
  const std::string what = e.judges_flood ? "The land floods" : "The slope slides";
  if (!p)
    return event.solved + event.failed == 0
               ? "No realisation is solved yet."
               : fmt::format(
                     "{} with a probability that is not known; with {:g} % confidence it lies between {:.2g} and "
                     "{:.2g}.",
                     what, 100.0 * study.settings.confidence, event.bounds.low, event.bounds.high);
  std::string text = fmt::format("{} with probability {:.2g}; {} {:g} % confidence it lies between {:.2g} and {:.2g}.",
      what, *p, is_of_points(study.settings.estimator) ? "as far as independent realisations would say, with" : "with",
      100.0 * study.settings.confidence, event.bounds.low, event.bounds.high);
  if (is_of_points(study.settings.estimator)) text += " No bound is proven for points that fill the space evenly.";
  if (event.failed > 0) text += ' ' + missing_words(event);
  if (e.judges_flood && e.slide.probability())
    text += fmt::format(
        " A slide happens with probability {:.2g}. {}", *e.slide.probability(), worth_of_residual_strength(e));
  return text;
}

std::string probability_section(const Study& study, const StudyEstimates& e)
{
  const bool is_cube = is_of_points(study.settings.estimator);
  std::string rows = event_row(study, "P(I)", slide_words(study.settings).c_str(), e.slide);
  if (e.judges_flood) {
    rows += event_row(study, "P(F)", flood_words, e.flood);
    rows += event_row(study, "P(F|I)", "the land floods, where there is a slide", e.flood_after_slide);
  }
  return "<section><h2>Probabilities</h2>\n" + html_cell("p", answer(study, e), " class=\"answer\"") + '\n' +
         html_table(
             {"", "estimate",
                 fmt::format("{:g} % bounds{}", 100.0 * study.settings.confidence, is_cube ? ", if independent" : ""),
                 "realisations", "meaning"},
             rows) +
         html_cell("p",
             words_of_probability +
                 std::string(
                     is_cube ? " They are by Clopper and Pearson, as of independent realisations: of studies of these "
                             : " They are by Clopper and Pearson: of all studies like this one ") +
                 "at least that share has the true probability between them.",
             " class=\"muted\"") +
         "</section>\n";
}

ChartLine line_of(const char* name, std::size_t style, int dashes)
{
  return {.name = name, .points = {}, .style = style, .dashes = dashes, .marks = false};
}

LineChart convergence_chart(const Study& study, const Realisations& rows, bool of_flood)
{
  LineChart chart{.title = of_flood ? "P(F) over the realisations" : "P(I) over the realisations",
      .x_label = "realisations",
      .y_label = "probability"};
  const std::size_t style = of_flood ? 1 : 0;
  chart.lines = {line_of("estimate", style, 0), line_of("bounds, of each n alone", style, 2), line_of("", style, 2)};
  const Index n_made = TableCounter(study, rows).n(), stride = 1 + n_made / most_places;
  Sample sample(study.settings);
  for (Index k = 0; k < n_made; ++k) {
    sample.take(rows.at(k), study.is_coarse(k));
    if ((k + 1) % stride != 0 && k + 1 != n_made) continue;
    const EventEstimate event = of_flood ? sample.flood() : sample.slide();
    const auto n = static_cast<Real>(k + 1);
    chart.lines[0].points.push_back({n, event.probability().value_or(std::nan(""))});
    chart.lines[1].points.push_back({n, event.bounds.low});
    chart.lines[2].points.push_back({n, event.bounds.high});
  }
  return chart;
}

bool is_unit(std::string_view unit) { return !unit.empty() && unit != "-"; }

/// An outcome of a part of the realisations; name: in the legend, empty: none.
struct Group {
  std::string name;
  std::vector<Real> values;
};

ChartLine steps_of(const Group& group, Real low, Real size, std::size_t n_classes)
{
  std::vector<Real> counts(n_classes, 0.0);
  for (const Real value : group.values)
    counts[std::min(n_classes - 1, static_cast<std::size_t>(std::max((value - low) / size, 0.0)))] += 1.0;
  ChartLine line{.name = group.name, .points = {{low, 0.0}}, .style = 0, .dashes = 0, .marks = false};
  for (std::size_t k = 0; k < n_classes; ++k) {
    line.points.push_back({low + static_cast<Real>(k) * size, counts[k]});
    line.points.push_back({low + static_cast<Real>(k + 1) * size, counts[k]});
  }
  line.points.push_back({low + static_cast<Real>(n_classes) * size, 0.0});
  return line;
}

LineChart histogram(const std::string& title, const std::string& label, std::vector<Group> groups)
{
  LineChart chart{.title = title, .x_label = label, .y_label = "realisations"};
  std::size_t most = 0;
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  for (Group& group : groups) {
    std::erase_if(group.values, [](Real value) { return !std::isfinite(value); });
    most = std::max(most, group.values.size());
    for (const Real value : group.values) low = std::min(low, value), high = std::max(high, value);
  }
  if (most < 2) return chart;
  const auto n =
      static_cast<std::size_t>(std::clamp(2.0 * std::cbrt(static_cast<Real>(most)), 5.0, 40.0));  // rule of Rice
  const Real size = high > low ? (high - low) / static_cast<Real>(n) : 1.0;
  for (const Group& group : groups) {
    ChartLine line = steps_of(group, low, size, n);
    line.style = chart.lines.size(), line.dashes = static_cast<int>(chart.lines.size());
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

/// By the levels of a load. Of two levels of cells those of the fine one, of which P is.
std::vector<Group> outcomes_of(const Study& study, const Realisations& rows, Index n, std::string_view name)
{
  std::vector<Group> groups(static_cast<std::size_t>(study.n_levels()));
  if (const auto& load = study.settings.fragility)
    for (std::size_t k = 0; k < groups.size(); ++k)
      groups[k].name = fmt::format("{:g}{}", load->levels[k], is_unit(load->unit) ? " " + load->unit : "");
  for (Index k = 0; k < n; ++k)
    if (rows.at(k).solved() && !study.is_coarse(k))
      groups[study.level_of(k)].values.push_back(rows.at(k).outcomes[outcome_number(name)]);
  return groups;
}

/// Names of inputs that fit a table: of keys what tells them apart.
std::vector<std::string> input_labels(const Study& study)
{
  std::vector<std::string> labels = study.input_names();
  const std::size_t first_field = labels.size() - study.settings.fields.size();
  for (std::size_t k = 0; k < labels.size(); ++k) {
    if (k >= first_field) labels[k] = study.settings.fields[k - first_field].key + ", field";
    constexpr std::string_view common = "material.";
    if (labels[k].starts_with(common)) labels[k].erase(0, common.size());
  }
  return labels;
}

/// The label of an input that is drawn, with its unit; a field is a share of its trend.
std::string label_with_unit(const Study& study, std::size_t number, const std::string& label)
{
  const std::vector<std::string> names = study.input_names();
  const bool is_field = number + study.settings.fields.size() >= names.size();
  const std::string unit = is_field || number < study.settings.sweep.size() ? "" : unit_at(names[number]);
  return unit.empty() || unit == "-" ? label : fmt::format("{} [{}]", label, unit);
}

std::string bar(const std::optional<Real>& rho)
{
  if (!rho) return html_cell("td", "-");
  constexpr Real half = 60.0;  // [px]
  const Real size = std::abs(*rho) * half, left = *rho < 0.0 ? half - size : half;
  return fmt::format(
      "<td><svg viewBox=\"0 0 170 14\" style=\"width:170px\" role=\"img\" aria-label=\"{0:+.2f}\"><path d=\"M60 0v14\" "
      "stroke=\"#566270\"/><rect x=\"{1:.1f}\" y=\"2\" width=\"{2:.1f}\" height=\"10\" fill=\"{3}\"/><text x=\"166\" "
      "y=\"12\" text-anchor=\"end\" font-size=\"12\">{0:+.2f}</text></svg></td>",
      *rho, left, size, *rho < 0.0 ? "#c14f00" : "#0067a5");
}

std::string sensitivity_section(const Study& study, const StudyEstimates& e)
{
  std::string rows;
  const std::vector<std::string> labels = input_labels(study);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const Sensitivity& s = e.sensitivities[k];
    rows += "<tr>" + html_cell("th", labels[k]) + bar(s.with_slide) + bar(s.with_height) + "</tr>\n";
  }
  return "<section><h2>What matters</h2>\n" +
         html_table({"", fmt::format("with {}", info_of(study.settings.estimator).inputs_go_with),
                        "with the height that remains"},
             rows) +
         "<p class=\"muted\">Spearman's rank correlation: +1 or -1 where the input decides alone, near 0 where it does "
         "not matter. Of n realisations, one below 2/sqrt(n) may be chance. Keys are written without "
         "<code>material.</code>; of a field it is the mean over its trend.</p></section>\n";
}

/// What became of a realisation, in words; those with the same words are one kind.
std::string kind_of(const Realisation& r)
{
  if (r.skipped()) return "not run: stands at the factor";
  if (r.failed()) return "failed";
  if (r.slides_as_drawn()) return "slides as drawn";
  const std::string flood = !r.judges_flood ? "" : r.flooded ? ", and the land floods" : ", and holds the water";
  if (!r.slid) return (r.flooded ? "no slide" : "stands") + flood;
  const Real slides = r.outcomes[outcome_number("slides")];  // of the crest
  return (slides > 1.0 ? "slides more than once" : slides == 0.0 ? "slides beside the crest" : "slides") + flood;
}

Real median_of(std::vector<Real> values)
{
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

using KindMembers = std::vector<const Realisation*>;

/// The realisations of each kind at a level of the load, the most frequent kind first.
std::vector<std::pair<std::string, KindMembers>> kinds_at(
    const Study& study, const Realisations& rows, Index n, std::size_t level)
{
  std::map<std::string, KindMembers> kinds;
  for (Index k = 0; k < n; ++k)
    if (!study.is_coarse(k) && study.level_of(k) == level) kinds[kind_of(rows.at(k))].push_back(&rows.at(k));
  std::vector<std::pair<std::string, KindMembers>> sorted(kinds.begin(), kinds.end());
  std::ranges::stable_sort(sorted, std::greater(), [](const auto& kind) { return kind.second.size(); });
  return sorted;
}

std::string kind_cells(const KindMembers& members, std::size_t n_counted)
{
  const auto cell = [](Real value) {
    return html_cell("td", std::isfinite(value) ? fmt::format("{:.4g}", value) : "-");
  };
  std::vector<Real> volumes, heights;
  for (const Realisation* r : members)
    for (const auto& [name, values] : {std::pair("slide_volume", &volumes), std::pair("residual_height", &heights)})
      if (const Real value = r->solved() ? r->outcomes[outcome_number(name)] : std::nan(""); std::isfinite(value))
        values->push_back(value);
  const Real volume = median_of(volumes), height = median_of(heights);
  const auto typical = std::ranges::find_if(members,
      [&](const Realisation* r) { return r->solved() && r->outcomes[outcome_number("slide_volume")] == volume; });
  const Real share = static_cast<Real>(members.size()) / static_cast<Real>(n_counted);
  return html_cell("td", fmt::format("{}", members.size())) + html_cell("td", fmt::format("{:.3g} %", 100.0 * share)) +
         cell(volume) + cell(height) +
         html_cell("td", fmt::format("{}", (typical != members.end() ? *typical : members.front())->number));
}

/// Each kind with how often it happened, and a realisation to be opened. Of a load each level by itself: how often a
/// kind came at all levels together is no probability.
std::string kinds_section(const Study& study, const Realisations& rows, Index n)
{
  const auto& load = study.settings.fragility;
  std::vector<std::string> titles{
      "", "realisations", "share", "slid [m^2], median", "remains [m], median", "for example"};
  if (load) titles.insert(titles.begin(), load->label());
  std::string cells;
  for (std::size_t level = 0; level < static_cast<std::size_t>(study.n_levels()); ++level) {
    const auto kinds = kinds_at(study, rows, n, level);
    std::size_t n_counted = 0;
    for (const auto& kind : kinds) n_counted += kind.second.size();
    for (const auto& [kind, members] : kinds)
      cells += "<tr>" + (load ? html_cell("th", fmt::format("{:g}", load->levels[level])) : "") +
               html_cell("th", kind) + kind_cells(members, n_counted) + "</tr>\n";
  }
  return "<section><h2>What happened</h2>\n" + html_table(titles, cells) +
         "<p class=\"muted\">Slides are counted as retreats of the crest (docs/formats.md); a slide beside it leaves "
         "the crest where it is. The example is the one with the median volume: <code>terp study run STUDY.toml --keep "
         "N</code> opens it.</p></section>\n";
}

std::string realisation_row(const Study& study, const Realisation& r)
{
  std::string row = "<tr>" + html_cell("th", fmt::format("{}", r.number));
  for (const RowLabel& label : row_labels(study)) row += html_cell("td", label.word(study, r));
  row += html_cell("td", r.failed() ? "failed" : r.skipped() ? "not run" : r.slid ? "slide" : "stands");
  row += html_cell("td", r.failed() || r.skipped() || !r.judges_flood ? "-"
                         : r.slides_as_drawn()                        ? "not known"
                         : r.flooded                                  ? "floods"
                                                                      : "holds");
  for (std::size_t i = 0; i < r.inputs.size(); ++i) row += html_cell("td", input_text(study, i, r.inputs[i]));
  for (const char* name : {"slide_volume", "residual_height", "first_slide_time", "flood_time"}) {
    const Real value = r.solved() ? r.outcomes[outcome_number(name)] : std::nan("");
    row += html_cell("td", std::isfinite(value) ? fmt::format("{:.4g}", value) : "-");
  }
  return row + html_cell("td", r.fault) + "</tr>\n";
}

std::string realisations_section(const Study& study, const Realisations& rows, Index n)
{
  std::vector<std::string> titles = {""};
  for (const RowLabel& label : row_labels(study)) titles.emplace_back(label.name);
  titles.insert(titles.end(), {"I", "F"});
  const std::vector<std::string> labels = input_labels(study);
  for (std::size_t i = 0; i < labels.size(); ++i) titles.push_back(label_with_unit(study, i, labels[i]));
  for (const char* title : {"slid [m^2]", "remains [m]", "slides at [s]", "floods at [s]", "why there is no result"})
    titles.emplace_back(title);
  std::string cells;
  for (Index k = 0; k < std::min(n, most_rows); ++k) cells += realisation_row(study, rows.at(k));
  return "<section><h2>Realisations</h2>\n" + html_table(titles, cells) +
         fmt::format(
             "<p class=\"muted\">{}<code>terp study run STUDY.toml --keep 17</code> solves realisation 17 once "
             "more, with the same bits, and with all that the report of a run shows.</p></section>\n",
             n > most_rows ? fmt::format("The first {} of {}; results.csv has all. ", most_rows, n) : "");
}

std::string notes(const std::vector<std::string>& remarks)
{
  return remarks.empty() ? "" : "<div class=\"notice\">" + html_list(remarks, "") + "</div>\n";
}

std::string footer(const std::string& written, const char* more)
{
  return fmt::format("terp {}, {}.{}", TERP_VERSION, written, more);
}

const std::string& title_of(const StudySettings& s) { return s.title.empty() ? s.name : s.title; }

}  // namespace

std::string page_of_study(const Study& study, const Realisations& rows, const std::string& written)
{
  const StudyEstimates e = estimate(study, rows);
  const bool adaptive = info_of(study.settings.estimator).adaptive;
  std::string body = notes(remarks_on_study(study, rows, e));
  if (study.settings.estimator == Estimator::sweep) {
    body += sweep_section(study, rows, e.n_made);
  } else if (adaptive) {
    body += adaptive_section(study, e.adaptive.result);
  } else {
    std::vector<LineChart> charts;
    if (study.settings.fragility) {
      body += fragility_section(study, estimate_fragility(study, rows));
    } else {
      body += probability_section(study, e);
      if (e.judges_flood) charts.push_back(convergence_chart(study, rows, true));
      charts.push_back(convergence_chart(study, rows, false));
    }
    charts.push_back(histogram(
        "Highest ground that remains", "height at the end [m]", outcomes_of(study, rows, e.n_made, "residual_height")));
    charts.push_back(
        histogram("Volume that slid", "volume that slid [m^2]", outcomes_of(study, rows, e.n_made, "slide_volume")));
    body += fmt::format(
                "<section><h2>{}</h2>\n", study.settings.fragility ? "What remains" : "How sure, and what remains") +
            html_figures(charts) + "</section>\n";
    body += kinds_section(study, rows, e.n_made);
    body += sensitivity_section(study, e);
  }
  body += realisations_section(study, rows, e.n_made);
  return plain_page({.title = title_of(study.settings),
      .name = title_of(study.settings) + ": study",
      .subtitle = fmt::format("{} realisations of {}, {}", e.n_made, study.settings.case_path, counts_text(e.counts)),
      .body = body,
      .footer = footer(written, " All realisations: results.csv")});
}

std::string page_of_samples(const Study& study, Index n, const std::string& written)
{
  const std::vector<std::string> names = input_labels(study);
  std::vector<std::vector<Real>> columns(names.size());
  for (Index k = 0; k < n; ++k) {
    const Draw draw = draw_realisation(study, study.first_of_turn(k * study.n_levels()));
    for (std::size_t i = 0; i < names.size(); ++i) columns[i].push_back(draw.inputs[i]);
  }
  std::vector<LineChart> charts;
  for (std::size_t i = 0; i < names.size(); ++i)
    charts.push_back(histogram(names[i], label_with_unit(study, i, names[i]), {{"", columns[i]}}));
  std::string fields;
  constexpr Index n_pictures = 4;
  for (std::size_t k = 0; k < study.settings.fields.size(); ++k) {
    fields +=
        "<section><h2>Field of " + html_cell("code", study.settings.fields[k].key) + "</h2>\n<div class=\"charts\">";
    for (Index r = 0; r < std::min(n, n_pictures); ++r)
      fields += "<figure>" + field_picture(study, k, r) + "</figure>\n";
    fields += "</div></section>\n";
  }
  return plain_page({.title = title_of(study.settings),
      .name = title_of(study.settings) + ": samples",
      .subtitle = fmt::format("What {} realisations of {} would be drawn with", n, study.settings.case_path),
      .body = "<section><h2>Histograms of the input</h2>\n" + html_figures(charts) + "</section>\n" + fields,
      .footer = footer(written, "")});
}

}  // namespace terp
