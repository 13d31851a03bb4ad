// The caller collects sentences while it imports; here they get their final order. First come the origin and the
// weights, then the caller's sections, then what no file of this kind can say. A section without sentences is printed
// with "nothing", so that a reader sees that it was not forgotten.

#include "import/dstability/folder_report.hpp"

#include "import/dstability/case_text.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

std::string weights_table(const std::map<std::string, SoilSum>& weights)
{
  std::string text = "\n## Weight\n\n| material | area [m2] | weight [kN/m] |\n|---|---|---|\n";
  const auto row = [&](const std::string& name, const SoilSum& sum) {
    text += fmt::format("| {} | {:.6f} | {:.6f} |\n", name, sum.area, sum.weight / 1e3);
  };
  SoilSum all;
  for (const auto& [material, sum] : weights) {
    row(material, sum);
    all += sum;
  }
  row("all", all);
  return text;
}

const std::vector<std::string> not_in_the_file{
    "Softening: the soils of this case do not soften. Give `sensitivity` and `eta` (docs/softening_laws.md), and a "
    "softening length, to see how far a slide goes.",
    "Stiffness and K0: defaults by kind of soil. `terp import --soil-defaults-table` prints them, "
    "`--soil-defaults FILE` takes others."};

}  // namespace

std::string text_of(const FolderReport& report)
{
  std::string text = fmt::format("# {}\n\n", report.title);
  for (const std::string& line : report.head) text += line + "\n";
  text += weights_table(report.weights);
  const auto add = [&](const std::string& title, const std::vector<std::string>& lines) {
    text += fmt::format("\n## {}\n\n", title);
    for (const std::string& line : lines) text += "- " + line + "\n";
    if (lines.empty()) text += "- nothing\n";
  };
  for (const auto& [title, lines] : report.sections) add(title, lines);
  add("Not in any file of this kind", not_in_the_file);
  return text;
}

std::vector<std::string> origin_comments(
    const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis)
{
  const char* const values = basis == StixBasis::design ? "design values (5 % fractiles)"
                             : basis == StixBasis::mean ? "means"
                                                        : "deterministic values";
  const StixScenario& of = project.scenarios[scenario];
  return {fmt::format("Written by terp import from {} ({}, content version {}).", project.path, project.application,
              project.content_version),
      fmt::format("Scenario {} {}, stage {} {}. Strengths: {}. What was assumed, moved and left out: report.md.",
          scenario + 1, in_quotes(of.label), stage + 1, in_quotes(of.stages[stage].label), values),
      "Units: m, s, Pa, kg unless one stands with the number. x and y are the file's x and z."};
}

}  // namespace terp
