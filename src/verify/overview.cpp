// The page is its own store: a line of the table begins with the name of its case as a link, an item of the list of
// reasons with the name in bold. Reading takes these two marks, and the heading behind which the reasons are those of
// regression rows. So the words around them may change.
#include "verify/overview.hpp"

#include "math/utf8.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <sstream>

namespace terp {
namespace {

constexpr std::size_t widest = 120;  // columns of a line of the documents
constexpr const char* regression_heading = "## Regression";

std::string nearest_to_bound(const CaseRows& c)
{
  const Row* nearest = nullptr;
  for (const Row& r : c.rows)
    if (r.verdict == Verdict::pass && r.used >= 0.0 && (nearest == nullptr || r.used > nearest->used)) nearest = &r;
  if (nearest == nullptr) return "-";
  return fmt::format(
      "{:.0f} % of {}: {}, {}", 100.0 * nearest->used, nearest->tolerance, nearest->quantity, nearest->run);
}

/// Lines of a document, those after the first indented by two.
std::string wrapped(const std::string& text)
{
  std::string out, word;
  std::size_t column = 0;
  for (std::istringstream words(text); words >> word;) {
    if (column > 0 && column + 1 + count_letters(word) > widest) out += "\n ", column = 1;
    if (column > 0) out += ' ', ++column;
    out += word, column += count_letters(word);
  }
  return out + '\n';
}

/// The reasons of rows that do not agree, or of the regression rows, each once with the number of its rows.
std::string reasons_of(const CaseRows& c, bool of_regressions)
{
  std::string out;
  for (const std::string& remark : remarks_of(c, of_regressions)) {
    const auto n = std::ranges::count_if(c.rows, [&](const Row& r) { return remark_of(r) == remark; });
    out += wrapped(fmt::format("- **{}**, {} row{}: {}", c.name, n, n == 1 ? "" : "s", for_markdown(remark)));
  }
  return out;
}

/// Text between two marks; empty: they are not there.
std::string between(const std::string& text, std::string_view before, std::string_view after)
{
  if (!text.starts_with(before)) return "";
  const std::size_t end = text.find(after, before.size());
  return end == std::string::npos ? "" : text.substr(before.size(), end - before.size());
}

/// Number that a column of a line of the table holds, alone or before a bracket; 0: it holds none.
int number_in(const std::string& line, int column)
{
  std::size_t start = 0;  // behind the bar that begins the column
  for (int bars = 0; start < line.size() && bars <= column; ++start)
    bars += line[start] == '|' && (start == 0 || line[start - 1] != '\\') ? 1 : 0;
  int number = 0;
  if (start + 1 >= line.size()) return 0;
  const char* const end = line.data() + line.size();
  const std::string_view behind(std::from_chars(line.data() + start + 1, end, number).ptr, end);
  return behind.starts_with(" |") || behind.starts_with(" (") ? number : 0;
}

}  // namespace

Overview overview_of(const std::vector<CaseRows>& cases)
{
  Overview overview;
  for (const CaseRows& c : cases) {
    const Counts n = count({c});
    const std::string fail = n.fail > 0 ? fmt::format(" ({} FAIL)", n.fail) : "";
    overview[c.name] = {
        .line = fmt::format("| [{0}](../cases/verification/{0}/README.md) | {1} | {2} | {3}{4} | {5} | {6} |", c.name,
            for_markdown(c.title), n.rows(), n.red + n.fail, fail, n.regression, for_markdown(nearest_to_bound(c))),
        .rows = n.rows(),
        .red = n.red + n.fail,
        .regression = n.regression,
        .reasons = reasons_of(c, false),
        .regressions = reasons_of(c, true)};
  }
  return overview;
}

Overview read_overview(const std::string& page)
{
  Overview overview;
  bool of_regressions = false;
  std::string line, *reasons = nullptr;
  for (std::istringstream lines(page); std::getline(lines, line);) {
    of_regressions |= line == regression_heading;
    if (const std::string name = between(line, "| [", "]"); !name.empty())
      overview[name] = {
          .line = line, .rows = number_in(line, 2), .red = number_in(line, 3), .regression = number_in(line, 4)};
    else if (const std::string of = between(line, "- **", "**"); !of.empty() && overview.contains(of))
      reasons = of_regressions ? &overview[of].regressions : &overview[of].reasons, *reasons += line + '\n';
    else if (reasons != nullptr && line.starts_with("  "))
      *reasons += line + '\n';
    else
      reasons = nullptr;
  }
  return overview;
}

std::string overview_page(const Overview& overview, const std::string& head)
{
  int rows = 0, red = 0, regression = 0;
  std::string table, reasons, regressions;
  for (const auto& [name, entry] : overview) {
    rows += entry.rows, red += entry.red, regression += entry.regression;
    table += entry.line + '\n', reasons += entry.reasons, regressions += entry.regressions;
  }
  if (!reasons.empty()) reasons = "\n## Red\n\n" + reasons;
  if (!regressions.empty()) regressions = fmt::format("\n{}\n\n{}", regression_heading, regressions);
  return fmt::format(
      "# Verification\n\nWritten by `terp verify`; not to be changed by hand.\n\n{} rows: {} pass, {} red, {} "
      "regression.\n\n{}\n| case | | rows | red | regression | nearest to its bound "
      "|\n|---|---|---|---|---|---|\n{}{}{}",
      rows, rows - red - regression, red, regression, head, table, reasons, regressions);
}

}  // namespace terp
