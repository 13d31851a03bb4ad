// The first key whose values are all numbers is the axis. Realisations that agree in the words of all other keys are
// one line. Of many lines a few are drawn, evenly from the first to the last. A result that hardly differs over the
// whole sweep is a sentence, and one that no realisation has is left out.

#include "batch/study_page.hpp"

#include "io/case/keys.hpp"
#include "io/case/units.hpp"
#include "page/plain_page.hpp"
#include "batch/study_text.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace terp {
namespace {

constexpr std::size_t most_lines = 6;  // of a chart
constexpr Real same_share = 1e-4;      // of a value; results that differ by less are called the same

struct SweepResult {
  std::string name, unit;
  std::function<Real(const Realisation&)> value;  ///< nan: not known
};

std::string with_unit(const std::string& label, std::string_view unit)
{
  return unit.empty() || unit == "-" ? label : fmt::format("{} [{}]", label, unit);
}

/// The two events first: soil that slides as drawn has no other result.
std::vector<SweepResult> sweep_results(const Realisations& rows, Index n)
{
  bool judges_flood = false;
  for (Index k = 0; k < n; ++k) judges_flood = judges_flood || rows.at(k).judges_flood;
  const auto yes = [](bool happened) { return happened ? 1.0 : 0.0; };
  std::vector<SweepResult> results{
      {"slide, I (1: yes)", "", [yes](const Realisation& r) { return r.failed() ? std::nan("") : yes(r.slid); }}};
  if (judges_flood)
    results.push_back({"flood, F (1: yes)", "",
        [yes](const Realisation& r) { return r.solved() && r.judges_flood ? yes(r.flooded) : std::nan(""); }});
  for (const OutcomeInfo& outcome : study_outcomes())
    results.push_back({std::string(outcome.info.label), std::string(outcome.info.unit),
        [k = outcome_number(outcome.info.name)](
            const Realisation& r) { return r.solved() ? r.outcomes[k] : std::nan(""); }});
  return results;
}

/// Values of the other keys, in words; in the order of the realisations, so of the study file.
std::vector<std::string> other_keys(const Study& study, const Realisation& r, std::size_t key)
{
  std::vector<std::string> words;
  for (std::size_t i = 0; i < study.settings.sweep.size(); ++i)
    if (i != key) words.push_back(input_text(study, i, r.inputs[i]));
  return words;
}

struct SweepLines {
  std::vector<std::string> names;  ///< of all combinations of the other keys, as they come
  std::vector<std::size_t> drawn;  ///< numbers of those that fit: evenly from the first to the last
};

SweepLines lines_of(const Study& study, const Realisations& rows, Index n, std::size_t key)
{
  SweepLines lines;
  for (Index k = 0; k < n; ++k) {
    const std::string name = fmt::format("{}", fmt::join(other_keys(study, rows.at(k), key), ", "));
    if (std::ranges::find(lines.names, name) == lines.names.end()) lines.names.push_back(name);
  }
  const std::size_t m = std::min(lines.names.size(), most_lines);
  for (std::size_t k = 0; k < m; ++k) lines.drawn.push_back(m > 1 ? k * (lines.names.size() - 1) / (m - 1) : 0);
  return lines;
}

/// Values of a key as numbers, of texts with units too; nothing if one of them is a word.
std::vector<Real> numbers_of(const SweepKey& key)
{
  std::vector<Real> numbers;
  for (const Node& value : key.values)
    if (const auto number = number_of(value, unit_at(key.key))) numbers.push_back(*number);
  if (numbers.size() != key.values.size()) numbers.clear();
  return numbers;
}

LineChart chart_over(const Study& study, const Realisations& rows, Index n, std::size_t key, const SweepLines& lines,
    const SweepResult& result)
{
  const SweepKey& swept = study.settings.sweep[key];
  const std::string& name = swept.key;
  const std::vector<Real> numbers = numbers_of(swept);
  const auto at = [&](const Realisation& r) {  // of texts the input is the place in the list
    return swept.is_of_numbers() ? r.inputs[key] : numbers[static_cast<std::size_t>(r.inputs[key])];
  };
  LineChart chart{
      .title = result.name, .x_label = with_unit(name, unit_at(name)), .y_label = with_unit(result.name, result.unit)};
  for (const std::size_t number : lines.drawn) {
    const std::size_t style = chart.lines.size();
    chart.lines.push_back(
        {.name = lines.names[number], .points = {}, .style = style, .dashes = static_cast<int>(style), .marks = true});
    for (Index k = 0; k < n; ++k)
      if (const Real value = result.value(rows.at(k));
          std::isfinite(value) &&
          fmt::format("{}", fmt::join(other_keys(study, rows.at(k), key), ", ")) == lines.names[number])
        chart.lines.back().points.push_back({at(rows.at(k)), value});
  }
  return chart;
}

struct Extent {
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  bool is_empty() const { return low > high; }
  bool is_one_value() const { return high - low <= same_share * std::max(std::abs(low), std::abs(high)); }
};

Extent extent_of(const Realisations& rows, Index n, const SweepResult& result)
{
  Extent extent;
  for (Index k = 0; k < n; ++k)
    if (const Real value = result.value(rows.at(k)); std::isfinite(value))
      extent.low = std::min(extent.low, value), extent.high = std::max(extent.high, value);
  return extent;
}

std::string words_of_lines(const Study& study, std::size_t key, const SweepLines& lines)
{
  std::vector<std::string> others;
  for (std::size_t i = 0; i < study.settings.sweep.size(); ++i)
    if (i != key) others.push_back(study.settings.sweep[i].key);
  if (others.empty()) return "";
  std::string text = fmt::format("A line for each value of {}", fmt::join(others, ", "));
  if (lines.drawn.size() < lines.names.size())
    text += fmt::format("; {} of {} are drawn", lines.drawn.size(), lines.names.size());
  return text + ". ";
}

}  // namespace

std::string sweep_section(const Study& study, const Realisations& rows, Index n)
{
  const auto& sweep = study.settings.sweep;
  const auto at = std::ranges::find_if(sweep, [](const SweepKey& key) { return !numbers_of(key).empty(); });
  if (at == sweep.end()) return "";  // the table says it all
  const auto key = static_cast<std::size_t>(at - sweep.begin());
  const SweepLines lines = lines_of(study, rows, n, key);
  std::vector<LineChart> charts;
  std::vector<std::string> same;
  for (const SweepResult& result : sweep_results(rows, n)) {
    const Extent extent = extent_of(rows, n, result);
    if (extent.is_empty()) continue;
    if (extent.is_one_value())
      same.push_back(fmt::format("{} {:.4g}", with_unit(result.name, result.unit), extent.high));
    else
      charts.push_back(chart_over(study, rows, n, key, lines, result));
  }
  std::string words = words_of_lines(study, key, lines);
  if (!same.empty()) words += fmt::format("The same in all realisations that are solved: {}.", fmt::join(same, ", "));
  return "<section><h2>Results over " + html_cell("code", at->key) + "</h2>\n" + html_figures(charts) +
         (words.empty() ? "" : html_cell("p", words, " class=\"muted\"")) + "</section>\n";
}

}  // namespace terp
