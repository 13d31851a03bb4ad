// Both tables have the same cells, so the page and the terminal cannot disagree. Widths count letters, not bytes.
// Remarks stand under a table, each once, as many runs may be red for one reason. Of the two, only the terminal names a
// row that is declared red but agrees; the page counts such rows.

#include "verify/report.hpp"

#include "math/utf8.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace terp {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t k = text.find(what); k != std::string::npos; k = text.find(what, k + by.size()))
    text.replace(k, what.size(), by);
  return text;
}

constexpr int n_columns = 8;
constexpr std::array<const char*, n_columns> heads{
    "quantity", "run", "reference", "Terp", "error", "tolerance", "result", "source"};

const char* word(const Row& r)
{
  switch (r.verdict) {
    case Verdict::pass: return "pass";
    case Verdict::regression: return "regression";
    case Verdict::red: return "red";
    case Verdict::fail: break;
  }
  return r.declared_regression ? "FAIL: regression, misses" : "FAIL";
}

bool agrees_though_red(const Row& r)
{
  return r.declared_red && (r.verdict == Verdict::pass || r.verdict == Verdict::regression);
}

std::array<std::string, n_columns> cells_of(const Row& r)
{
  return {r.quantity, r.run, r.reference, r.terp, r.error, r.tolerance, word(r), r.source};
}

std::string padded(const std::string& text, std::size_t width)
{
  return text + std::string(width - std::min(width, count_letters(text)), ' ');
}

std::string markdown_head(const std::vector<CaseRows>& cases, const std::string& head)
{
  return fmt::format("# Verification\n\nWritten by `terp verify`; not to be changed by hand.\n\n{}.\n\n{}\n",
      counts_text(count(cases)), head);
}

}  // namespace

std::string remark_of(const Row& r)
{
  if (r.verdict == Verdict::pass || r.remark.empty()) return "";
  return fmt::format("{}: {}", r.quantity == "the run" ? r.run : r.quantity, r.remark);
}

std::vector<std::string> remarks_of(const CaseRows& c, bool of_regressions)
{
  std::vector<std::string> remarks;
  for (const Row& r : c.rows) {
    if ((r.verdict == Verdict::regression) != of_regressions) continue;
    const std::string remark = remark_of(r);
    if (!remark.empty() && std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
  }
  return remarks;
}

std::string for_markdown(const std::string& text)
{
  return replaced(replaced(replaced(replaced(text, "<", "\\<"), "|", "\\|"), "*", "\\*"), "\n", " ");
}

Counts count(const std::vector<CaseRows>& cases)
{
  Counts counts;
  for (const CaseRows& c : cases)
    for (const Row& r : c.rows) {
      switch (r.verdict) {
        case Verdict::pass: ++counts.pass; break;
        case Verdict::regression: ++counts.regression; break;
        case Verdict::red: ++counts.red; break;
        case Verdict::fail: ++counts.fail; break;
      }
      counts.agree_declared_red += agrees_though_red(r) ? 1 : 0;
    }
  return counts;
}

std::string counts_text(const Counts& n)
{
  std::string text = fmt::format("{} rows: {} pass, {} red", n.rows(), n.pass, n.red + n.fail);
  if (n.regression > 0) text += fmt::format(", {} regression", n.regression);
  if (n.red > 0) text += fmt::format(" ({} known, with the reason)", n.red);
  if (n.agree_declared_red > 0) text += fmt::format(" ({} declared red, but agree)", n.agree_declared_red);
  if (n.fail > 0) text += fmt::format(" ({} not known: FAIL)", n.fail);
  return text;
}

std::string text_table(const CaseRows& c)
{
  std::array<std::size_t, n_columns> widths{};
  for (int k = 0; k < n_columns; ++k) widths[k] = count_letters(heads[k]);
  for (const Row& r : c.rows) {
    const auto cells = cells_of(r);
    for (int k = 0; k < n_columns; ++k) widths[k] = std::max(widths[k], count_letters(cells[k]));
  }
  std::string out = fmt::format("{}: {}\n ", c.name, c.title);
  for (int k = 0; k + 1 < n_columns; ++k) out += " " + padded(heads[k], widths[k]) + " ";
  out += fmt::format(" {}\n", heads[n_columns - 1]);
  for (const Row& r : c.rows) {
    const auto cells = cells_of(r);
    out += " ";
    for (int k = 0; k + 1 < n_columns; ++k) out += " " + padded(cells[k], widths[k]) + " ";
    out += fmt::format(" {}\n", cells[n_columns - 1]);
  }
  for (const Row& r : c.rows)
    if (agrees_though_red(r))
      out += fmt::format(
          "  ? {}, {}: declared red in expected.toml, but agrees. Take `red` away, or name in `red_runs` the runs that "
          "it is true of.\n",
          r.quantity, r.run);
  for (const std::string& remark : remarks_of(c, false))
    out += fmt::format("  ! {}\n", replaced(remark, "\n", "\n    "));
  for (const std::string& remark : remarks_of(c, true)) out += fmt::format("  = regression, no pass: {}\n", remark);
  return out;
}

std::string markdown_page(const std::vector<CaseRows>& cases, const std::string& head)
{
  std::string out = markdown_head(cases, head);
  for (const CaseRows& c : cases) {
    out += fmt::format("\n## {0}\n\n{1}: [`cases/verification/{0}`](../cases/verification/{0}/README.md)\n\n|", c.name,
        for_markdown(c.title));
    for (const char* name : heads) out += fmt::format(" {} |", name);
    out += "\n|";
    for (int k = 0; k < n_columns; ++k) out += "---|";
    out += '\n';
    for (const Row& r : c.rows) {
      out += '|';
      for (const std::string& cell : cells_of(r)) out += fmt::format(" {} |", for_markdown(cell));
      out += '\n';
    }
    for (const std::string& remark : remarks_of(c, false)) out += fmt::format("\n**Red.** {}\n", for_markdown(remark));
    for (const std::string& remark : remarks_of(c, true))
      out += fmt::format("\n**Regression.** {}\n", for_markdown(remark));
  }
  return out;
}

}  // namespace terp
