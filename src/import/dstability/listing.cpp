// Nothing is computed here: how a stored result stands to Terp's own comes from the caller. Text of the file is passed
// on as it is; the caller makes it safe for a terminal. Columns are as wide as their longest cell, counted in letters
// of UTF-8 and not in bytes.

#include "import/dstability/listing.hpp"

#include "import/dstability/ground_column.hpp"
#include "import/dstability/stix_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace terp {
namespace {

std::string number(Real value, int digits = 2)
{
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

std::string plural(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

/// Extent of the layers: "x -100 to 150 m, z -15 to 12.66 m".
std::string extent_of(const StixStage& stage)
{
  const auto [low, high] = box_around(stage.layers);
  if (stage.layers.empty()) return "nothing";
  return fmt::format("x {:.1f} to {:.1f} m, z {:.2f} to {:.2f} m", low[0], high[0], low[1], high[1]);
}

std::string water_of(const StixWater& water)
{
  if (water.is_mesh) return fmt::format("water mesh of {}", plural(water.mesh.size(), "triangle"));
  if (!water.phreatic) return "no water";
  const StixLine& line = water.head_lines[*water.phreatic].line;
  const auto [low, high] = std::ranges::minmax_element(line, {}, [](const Vec<2>& p) { return p[1]; });
  return fmt::format("phreatic line {:.2f} to {:.2f} m, {}", (*low)[1], (*high)[1],
      plural(water.reference_lines.size(), "reference line"));
}

std::string stage_line(const StixStage& stage, std::size_t number)
{
  std::string text = fmt::format("  stage {}  \"{}\"\n           {}; {}; {}", number, stage.label,
      plural(stage.layers.size(), "layer"), extent_of(stage), water_of(stage.water));
  const auto add = [&](std::size_t n, const char* what) {
    if (n > 0) text += "; " + plural(n, what);
  };
  add(stage.excavations.size(), "excavation");
  add(stage.added_layers.size(), "added layer");
  add(stage.loads.size(), "uniform load");
  add(stage.state_points.size(), "state point");
  add(stage.state_lines.size(), "state line");
  return text + "\n";
}

std::string result_text(const StixCalculation& calculation)
{
  if (!calculation.result) return "not computed";
  const StixResult& result = *calculation.result;
  if (result.is_reliability)
    return fmt::format(
        "beta = {}{}", number(result.reliability_index, 3), result.converged.value_or(true) ? "" : ", not converged");
  return "F = " + number(result.factor_of_safety, 4);
}

std::size_t letters_in(const std::string& text)
{
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Rows with the columns of one width each, two spaces apart; the last column is as wide as it is.
std::string aligned(const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k == widths.size()) widths.push_back(0);
      widths[k] = std::max(widths[k], letters_in(row[k]));
    }
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t k = 0; k < row.size(); ++k) line += fmt::format(" {:<{}}", row[k], widths[k] + 1);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string calculation_lines(const StixProject& project, std::size_t s, const StixVerdict& verdict)
{
  std::vector<std::vector<std::string>> rows;
  const StixScenario& scenario = project.scenarios[s];
  for (std::size_t k = 0; k < scenario.calculations.size(); ++k) {
    const StixCalculation& c = scenario.calculations[k];
    const bool is_of_last = c.stage + 1 == scenario.stages.size();
    rows.push_back({fmt::format("calculation {}", k + 1),
        fmt::format("\"{}\"{}", c.label, is_of_last ? "" : fmt::format(" of stage {}", c.stage + 1)),
        c.method.empty() ? "-" : c.method, c.kind_word.empty() ? "-" : c.kind_word, result_text(c),
        c.result ? verdict(s, k) : "", c.result ? c.result->name : ""});
  }
  return aligned(rows);
}

/// "Su S 0.22, m 0.90": a model with its parameters.
std::string strength_of(const StixSoil& soil, StixStrengthModel model, const std::string& word)
{
  const auto value = [](const StixParameter& p, Real unit, int digits) {
    const std::string mark = p.is_probabilistic ? fmt::format(" ({}; {})", number(p.mean / unit, digits),
                                                      number(p.deviation / unit, digits + 1))
                                                : "";
    return number(p.value / unit, digits) + mark;
  };
  switch (model) {
    case StixStrengthModel::advanced:
      return fmt::format("c' {} phi' {} psi {}", value(soil.advanced.cohesion, pa_per_kpa, 1),
          value(soil.advanced.friction, 1.0, 1), value(soil.advanced.dilatancy, 1.0, 1));
    case StixStrengthModel::classic:
      return fmt::format(
          "c' {} phi' {} (classic)", value(soil.classic.cohesion, pa_per_kpa, 1), value(soil.classic.friction, 1.0, 1));
    case StixStrengthModel::shansep:
      return fmt::format("S {} m {}", value(soil.ratio, 1.0, 3), value(soil.exponent, 1.0, 3));
    case StixStrengthModel::su_table: return fmt::format("s_u table, {}", plural(soil.su_table.rows.size(), "row"));
    case StixStrengthModel::sigma_tau_table:
      return fmt::format("sigma-tau table, {}", plural(soil.sigma_tau_table.rows.size(), "row"));
    case StixStrengthModel::none: return "none";
    case StixStrengthModel::unknown: break;
  }
  return fmt::format("`{}`, not known", word);
}

std::set<std::size_t> soils_in_use(const StixProject& project)
{
  std::set<std::size_t> used;
  for (const StixScenario& scenario : project.scenarios)
    for (const StixStage& stage : scenario.stages)
      for (const StixLayer& layer : stage.layers)
        if (layer.soil) used.insert(*layer.soil);
  return used;
}

std::string soil_table(const StixProject& project)
{
  std::vector<std::vector<std::string>> rows{
      {"", "weight [kN/m3]", "strength above the phreatic line", "and below it"}};
  for (const std::size_t k : soils_in_use(project)) {
    const StixSoil& soil = project.soils[k];
    rows.push_back({soil.name, number(soil.weight_above / pa_per_kpa) + " / " + number(soil.weight_below / pa_per_kpa),
        strength_of(soil, soil.above, soil.above_word), strength_of(soil, soil.below, soil.below_word)});
  }
  return fmt::format("soils in use: {} of {}\n", rows.size() - 1, project.soils.size()) + aligned(rows) +
         "  c' in kPa, angles in degrees; (mean; standard deviation) of what is probabilistic\n";
}

}  // namespace

const char* word_of(StixStrengthModel model)
{
  switch (model) {
    case StixStrengthModel::none: return "none";
    case StixStrengthModel::advanced: return "advanced";
    case StixStrengthModel::classic: return "classic";
    case StixStrengthModel::shansep: return "shansep";
    case StixStrengthModel::su_table: return "su_table";
    case StixStrengthModel::sigma_tau_table: return "sigma_tau_table";
    case StixStrengthModel::unknown: break;
  }
  return "unknown";
}

std::string listing_of(const StixProject& project, const StixVerdict& verdict)
{
  std::string text = fmt::format("{}: {}, content version {}\n", project.path,
      project.application.empty() ? "unknown program" : project.application,
      project.content_version.empty() ? "not given" : project.content_version);
  for (std::size_t s = 0; s < project.scenarios.size(); ++s) {
    text += fmt::format("\nscenario {}  \"{}\"\n", s + 1, project.scenarios[s].label);
    for (std::size_t k = 0; k < project.scenarios[s].stages.size(); ++k)
      text += stage_line(project.scenarios[s].stages[k], k + 1);
    text += calculation_lines(project, s, verdict);
  }
  text += "\n" + soil_table(project);
  if (!project.remarks.empty()) text += "\nleft out, or not understood:\n";
  for (const StixRemark& remark : project.remarks) text += fmt::format("  {}: {}\n", remark.where, remark.what);
  return text;
}

}  // namespace terp
