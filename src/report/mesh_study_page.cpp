#include "report/mesh_study_page.hpp"

#include "output/svg.hpp"
#include "report/line_chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

// The look of the report page (web/src/style.css) where it has the same parts.
constexpr const char* style = R"(
:root { font: 15px/1.5 "Segoe UI", system-ui, -apple-system, "Helvetica Neue", "Noto Sans", "Liberation Sans", Arial,
  sans-serif; font-variant-numeric: tabular-nums; color-scheme: light; }
body { margin: 0; background: #f3f5f7; color: #18212b; }
h1, h2, h3, p, table, ul, figure { margin: 0; padding: 0; }
h1 { font-size: 1.2rem; font-weight: 650; } h2 { font-size: 1.25rem; font-weight: 650; margin-bottom: 10px; }
h3 { font-size: 1rem; font-weight: 650; margin: 18px 0 8px; }
.top { padding: 12px 24px; background: #fff; border-bottom: 1px solid #d5dbe1; }
.top p, .muted, footer { color: #566270; font-size: 0.87rem; }
main { padding: 8px 24px 24px; max-width: 1500px; margin: 0 auto; }
section { margin-top: 26px; }
.answer { background: #fff; border-left: 3px solid #0b5f9e; padding: 10px 14px; border-radius: 0 6px 6px 0; }
.notice { background: #fff5df; border-left: 3px solid #e3b04b; padding: 8px 12px; border-radius: 0 6px 6px 0;
  margin-top: 10px; }
.notice ul, .words { padding-left: 1.1em; }
.scroll { overflow-x: auto; }
table { background: #fff; border: 1px solid #d5dbe1; border-radius: 8px; border-spacing: 0; border-collapse: separate;
  font-size: 0.9rem; margin-top: 12px; }
th, td { padding: 4px 14px; border-top: 1px solid #eaeef2; text-align: right; white-space: nowrap; }
thead th { border-top: 0; font-weight: 650; } tbody th { color: #566270; font-weight: 500; text-align: left; }
.unit { text-align: left; color: #566270; padding-left: 0; }
.depends td:last-child, .some_sizes td:last-child { color: #b3261e; font-weight: 650; }
.same td:last-child, .settled td:last-child { color: #00694b; }
td:last-child, thead th:last-child { text-align: left; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(400px, 100%), 1fr)); gap: 12px; }
figure { background: #fff; border: 1px solid #d5dbe1; border-radius: 8px; padding: 8px 10px 10px; break-inside: avoid; }
svg { display: block; width: 100%; height: auto; }
footer { padding: 8px 24px 28px; max-width: 1500px; margin: 0 auto; }
@media print {
  @page { size: A4 portrait; margin: 14mm; }
  :root { font-size: 9.5pt; }
  body { background: #fff; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  main, .top, footer { padding-left: 0; padding-right: 0; }
  .scroll { overflow: visible; } table { width: 100%; font-size: 8pt; } th, td { padding: 2px 5px; }
  tbody th, td:last-child { white-space: normal; }
  .charts { grid-template-columns: 1fr 1fr; } table, figure { border-color: #d5dbe1; }
  h2, h3 { break-after: avoid; } tr { break-inside: avoid; }
}
)";

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

std::string cell(const char* tag, const std::string& text, const char* attributes = "")
{
  return fmt::format("<{0}{2}>{1}</{0}>", tag, escaped_for_markup(text), attributes);
}

std::string percent(std::optional<Real> share) { return share ? percent_text(*share) : "-"; }

std::string row_of(const StudyQuantity& q)
{
  const RunMeasure& m = q.measure;
  std::string row = fmt::format("<tr class=\"{}\">", info_of(q.answer).key) + cell("th", m.label) +
                    cell("td", m.unit == "-" ? "" : m.unit, " class=\"unit\"");
  for (const auto& value : q.values) row += cell("td", text_of(m, value));
  row += cell("td", percent(q.relative_change()));
  row += cell("td", q.has_order ? fmt::format("{:.2f}", q.estimate.order) : "-");
  row += cell("td", q.has_order ? text_of(m, q.estimate.limit) : "-") + cell("td", percent(q.relative_error()));
  return row + cell("td", info_of(q.answer).words) + "</tr>\n";
}

std::string table_of(const StudiedSequence& s)
{
  std::string head = "<tr><th></th><th></th>";
  for (const StudyRun& run : s.sequence.runs) head += cell("th", fmt::format("{:g} m", run.cell));
  for (const char* title : {"change", "order", "limit", "error", ""}) head += cell("th", title);
  std::string rows;
  for (const StudyQuantity& q : s.quantities)
    if (q.has_values()) rows += row_of(q);
  return fmt::format(
      "<div class=\"scroll\"><table><thead>{}</tr></thead>\n<tbody>{}</tbody></table></div>\n", head, rows);
}

std::string list_of(const std::vector<std::string>& items, const char* name)
{
  std::string list;
  for (const std::string& item : items) list += cell("li", item) + '\n';
  return list.empty() ? "" : fmt::format("<ul{}>{}</ul>\n", name, list);
}

std::string figures(const std::vector<LineChart>& charts)
{
  std::string all;
  for (const LineChart& chart : charts)
    if (const std::string svg = draw_chart(chart); !svg.empty()) all += "<figure>" + svg + "</figure>\n";
  return all.empty() ? "" : "<div class=\"charts\">" + all + "</div>\n";
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
        .lines = {},
        .bars = {},
        .x_from_zero = true};
    for (std::size_t j = 0; j < study.sequences.size(); ++j) {
      const StudiedSequence& s = study.sequences[j];
      const StudyQuantity& q = s.quantities[k];
      ChartLine line{.name = study.sequences.size() > 1 ? s.sequence.name : "",
          .points = {},
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
  return figures(charts);
}

/// A column of the ledger over time, thinned out to what a chart can show, times a factor.
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
        .y_label = is_energy ? "kJ/m" : std::string(info.unit),
        .lines = {},
        .bars = {}};
    const auto n = static_cast<int>(sequence.runs.size());
    for (int k = 0; k < n; ++k) {
      const StudyRun& run = sequence.runs[static_cast<std::size_t>(k)];
      if (run.fault.empty())
        chart.lines.push_back({fmt::format("{:g} m", run.cell), over_time(run.results, column, is_energy ? 1e-3 : 1.0),
            static_cast<std::size_t>(n - 1 - k), n - 1 - k});
    }
    charts.push_back(std::move(chart));
  }
  return figures(charts);
}

std::string section_of(const StudiedSequence& s, Real tolerance)
{
  std::string html =
      "<section>" + cell("h2", s.sequence.name) + '\n' + cell("p", answer_of(s, tolerance), " class=\"answer\"") + '\n';
  if (const std::string remarks = list_of(remarks_on(s.sequence), ""); !remarks.empty())
    html += "<div class=\"notice\">" + remarks + "</div>\n";
  if (!s.quantities.empty()) html += table_of(s);
  std::vector<std::string> sentences;
  for (const StudyQuantity& q : s.quantities)
    if (q.has_values()) sentences.push_back(sentence_on(q));
  html += "<h3>In words</h3>\n" + list_of(sentences, " class=\"words\"");
  return html + "<h3>Over time</h3>\n" + time_charts(s.sequence) + "</section>\n";
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
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{0}: cell sizes</title><style>{1}</style></head>\n<body>\n<header "
      "class=\"top\"><h1>{0}</h1><p>Does the result depend on the mesh? {2}, a change counts from {3} on</p></header>\n"
      "<main>{4}{5}</main>\n<footer>terp {6}, {7}. The numbers: convergence.json</footer>\n</body></html>\n",
      escaped_for_markup(title), style, escaped_for_markup(study.case_name), percent(study.tolerance), body, about,
      TERP_VERSION, escaped_for_markup(written));
}

}  // namespace terp
