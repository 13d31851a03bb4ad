// The page judges nothing: answers, orders, limits and sentences are those of io/results/mesh_study. Over cell size a
// colour is a sequence, the first with a full line. Over time it is a cell size, the smallest with a full line. Charts
// over time are of the slope on the side that the first solved run faces.

#include "page/mesh_study_page.hpp"

#include "io/files/svg.hpp"
#include "page/plain_page.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr const char* about = R"(<section><h2>How to read this</h2>
<p><b>change</b>: between the two smallest sizes, as a share of the value; of a place, of its distance since t = 0, at
least one cell. <b>order</b>: observed order p of the three smallest sizes, whatever their ratios, from
(y<sub>3</sub> &minus; y<sub>2</sub>)/(y<sub>2</sub> &minus; y<sub>1</sub>) = r<sub>21</sub><sup>p</sup>
(r<sub>32</sub><sup>p</sup> &minus; 1)/(r<sub>21</sub><sup>p</sup> &minus; 1) (Celik et al., J. Fluids Eng. 130 (2008)
078001); size of a mesh: root of the mean area of its cells. <b>limit</b>: Richardson's extrapolation. <b>error</b>:
grid convergence index, 1.25 |y<sub>1</sub> &minus; y<sub>2</sub>|/(r<sub>21</sub><sup>p</sup> &minus; 1) (Roache,
J. Fluids Eng. 116 (1994) 405&ndash;413), of the smallest size. None of them where the values go up and down, where
their differences do not fall, or where p is not between 1/2 and 2.</p></section>
)";

std::string percent(std::optional<Real> share) { return share ? percent_text(*share) : "-"; }

std::string row_of(const StudyQuantity& q)
{
  const RunMeasure& m = q.measure;
  std::string row = fmt::format("<tr class=\"{}\">", info_of(q.answer).key) + html_cell("th", m.label) +
                    html_cell("td", m.unit == "-" ? "" : m.unit, " class=\"unit\"");
  for (const auto& value : q.values) row += html_cell("td", text_of(m, value));
  row += html_cell("td", percent(q.relative_change()));
  row += html_cell("td", q.has_order ? fmt::format("{:.2f}", q.estimate.order) : "-");
  row +=
      html_cell("td", q.has_order ? text_of(m, q.estimate.limit) : "-") + html_cell("td", percent(q.relative_error()));
  return row + html_cell("td", info_of(q.answer).words) + "</tr>\n";
}

std::string table_of(const StudiedSequence& s)
{
  std::vector<std::string> titles{"", ""};
  for (const StudyRun& run : s.sequence.runs) titles.push_back(fmt::format("{:g} m", run.cell));
  titles.insert(titles.end(), {"change", "order", "limit", "error", ""});
  std::string rows;
  for (const StudyQuantity& q : s.quantities)
    if (q.has_values()) rows += row_of(q);
  return html_table(titles, rows);
}

/// Each quantity over the size of the cells, all sequences in one chart; the limit at no size with its error.
std::string size_charts(const MeshStudy& study)
{
  std::vector<LineChart> charts;
  const auto& first = study.sequences[0].quantities;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const RunMeasure& m = first[k].measure;
    if (m.kind == MeasureKind::word) continue;
    LineChart chart{.title = m.label,
        .x_label = "size of the cells [m]",
        .y_label = m.unit == "-" ? "" : m.unit,
        .x_from_zero = true};
    for (std::size_t j = 0; j < study.sequences.size(); ++j) {
      const StudiedSequence& s = study.sequences[j];
      const StudyQuantity& q = s.quantities[k];
      ChartLine line{.name = study.sequences.size() > 1 ? s.sequence.name : "",
          .style = j,
          .dashes = static_cast<int>(j),
          .marks = true};
      for (std::size_t r = 0; r < q.values.size(); ++r)
        if (q.values[r]) line.points.push_back({s.sequence.runs[r].size, *q.values[r]});
      chart.lines.push_back(std::move(line));
      if (q.has_order) chart.bars.push_back({{0.0, q.estimate.limit}, q.estimate.uncertainty, j});
    }
    charts.push_back(std::move(chart));
  }
  return html_figures(charts);
}

std::vector<Vec<2>> over_time(const RunResults& run, std::string_view column, Real factor)
{
  constexpr std::size_t most = 400;
  std::vector<Vec<2>> points;
  const auto *time = run.ledger.find("time"), *values = run.ledger.find(column);
  if (time == nullptr || values == nullptr) return points;
  const std::size_t stride = 1 + time->size() / most;
  for (std::size_t k = 0; k < time->size(); k += stride) points.push_back({(*time)[k], factor * (*values)[k]});
  return points;
}

std::string time_charts(const StudySequence& sequence)
{
  const auto solved = std::ranges::find(sequence.runs, std::string(), &StudyRun::fault);
  if (solved == sequence.runs.end()) return "";
  const bool left = solved->results.summary.values.facing == Facing::left;
  const char *front = left ? "front_left_x" : "front_x", *crest = left ? "crest_left_x" : "crest_x",
             *height = left ? "crest_left_y" : "crest_y";
  std::vector<LineChart> charts;
  for (const char* column : {front, crest, height, "moved_volume", "kinetic", "plastic", "damping_work"}) {
    const QuantityInfo info = describe_column(column);
    const bool is_energy = info.unit == "J/m";
    LineChart chart{.title = std::string(info.label),
        .x_label = "time [s]",
        .y_label = is_energy ? "kJ/m" : std::string(info.unit)};
    const auto n = static_cast<int>(sequence.runs.size());
    for (int k = 0; k < n; ++k) {
      const StudyRun& run = sequence.runs[static_cast<std::size_t>(k)];
      if (run.fault.empty())
        chart.lines.push_back({fmt::format("{:g} m", run.cell), over_time(run.results, column, is_energy ? 1e-3 : 1.0),
            static_cast<std::size_t>(n - 1 - k), n - 1 - k});
    }
    charts.push_back(std::move(chart));
  }
  return html_figures(charts);
}

std::string section_of(const StudiedSequence& s, Real tolerance)
{
  std::string html = "<section>" + html_cell("h2", s.sequence.name) + '\n' +
                     html_cell("p", answer_of(s, tolerance), " class=\"answer\"") + '\n';
  if (const std::string remarks = html_list(remarks_on(s.sequence), ""); !remarks.empty())
    html += "<div class=\"notice\">" + remarks + "</div>\n";
  if (!s.quantities.empty()) html += table_of(s);
  std::vector<std::string> sentences;
  for (const StudyQuantity& q : s.quantities)
    if (q.has_values()) sentences.push_back(sentence_on(q));
  html += "<h3>In words</h3>\n" + html_list(sentences, " class=\"words\"");
  return html + "<h3>Over time</h3>\n" + time_charts(s.sequence) + "</section>\n";
}

/// All variants beside each other on the smallest cells that they have in common; empty with one sequence.
std::string section_of_variants(const MeshStudy& study)
{
  if (study.spreads.empty()) return "";
  std::vector<std::string> titles{"", ""};
  for (const StudiedSequence& s : study.sequences) titles.push_back(s.sequence.name);
  titles.insert(titles.end(), {"range", "share"});
  std::string rows;
  for (const StudySpread& s : study.spreads) {
    const RunMeasure& m = s.measure;
    rows += fmt::format("<tr class=\"{}\">", s.matters ? "depends" : "same") + html_cell("th", m.label) +
            html_cell("td", m.unit == "-" ? "" : m.unit, " class=\"unit\"");
    for (const auto& value : s.values) rows += html_cell("td", text_of(m, value));
    rows += html_cell("td", text_of(m, s.range)) + html_cell("td", percent(s.share)) + "</tr>\n";
  }
  return "<section><h2>All variants</h2>\n" + html_cell("p", answer_on_variants(study), " class=\"answer\"") + '\n' +
         html_table(titles, rows) + "</section>\n";
}

}  // namespace

std::string study_page(const MeshStudy& study, const std::string& written)
{
  const std::string& title = study.title.empty() ? study.case_name : study.title;
  std::string body;
  for (std::size_t k = 0; k < study.sequences.size(); ++k) {
    body += section_of(study.sequences[k], study.tolerance);
    if (k == 0) body += "<section><h2>Over the size of the cells</h2>\n" + size_charts(study) + "</section>\n";
  }
  return plain_page({.title = title,
      .name = title + ": cell sizes",
      .subtitle = fmt::format("Does the result depend on the mesh? {}, a change counts from {} on", study.case_name,
          percent(study.tolerance)),
      .body = body + section_of_variants(study) + about,
      .footer = fmt::format("terp {}, {}. The numbers: convergence.json", TERP_VERSION, written)});
}

}  // namespace terp
