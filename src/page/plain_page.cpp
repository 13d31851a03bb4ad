// Plain text is escaped here, where it enters the page. Bodies, rows of tables and rules of style are HTML or CSS
// already, and their makers answer for them. The Content-Security-Policy allows nothing but the style in the file: no
// script runs and nothing is loaded.

#include "page/plain_page.hpp"

#include "io/files/svg.hpp"

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

}  // namespace

std::string html_cell(const char* tag, const std::string& text, const char* attributes)
{
  return fmt::format("<{0}{2}>{1}</{0}>", tag, escaped_for_markup(text), attributes);
}

std::string html_table(const std::vector<std::string>& titles, const std::string& rows)
{
  std::string head;
  for (const std::string& title : titles) head += html_cell("th", title);
  return fmt::format(
      "<div class=\"scroll\"><table><thead><tr>{}</tr></thead>\n<tbody>{}</tbody></table></div>\n", head, rows);
}

std::string html_list(const std::vector<std::string>& items, const char* name)
{
  std::string list;
  for (const std::string& item : items) list += html_cell("li", item) + '\n';
  return list.empty() ? "" : fmt::format("<ul{}>{}</ul>\n", name, list);
}

std::string html_figures(const std::vector<LineChart>& charts)
{
  std::string all;
  for (const LineChart& chart : charts)
    if (const std::string svg = draw_chart(chart); !svg.empty()) all += "<figure>" + svg + "</figure>\n";
  return all.empty() ? "" : "<div class=\"charts\">" + all + "</div>\n";
}

std::string plain_page(const PlainPage& page)
{
  return fmt::format(
      "<!doctype html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"><meta http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; style-src 'unsafe-inline'\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{}</title><style>{}{}</style></head>\n<body>\n<header "
      "class=\"top\"><h1>{}</h1><p>{}</p></header>\n<main>{}</main>\n<footer>{}</footer>\n</body></html>\n",
      page.language, escaped_for_markup(page.name), style, page.style, escaped_for_markup(page.title),
      escaped_for_markup(page.subtitle), page.body, escaped_for_markup(page.footer));
}

}  // namespace terp
