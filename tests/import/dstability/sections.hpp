// Small sections made by hand, for stresses that can be computed by hand.
#pragma once

#include "import/dstability/case_text.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/soil_defaults.hpp"
#include "support/test.hpp"

namespace terp::test {

inline StixLayer box_layer(const std::string& id, Vec<2> low, Vec<2> high, std::size_t soil)
{
  return {.id = id, .label = id, .outline = {{low[0], high[1]}, high, {high[0], low[1]}, low}, .soil = soil};
}

/// Sand (0): 18 and 20 kN/m3, c' 2 kPa, phi' 30; clay (1): 15 and 16 kN/m3, S 0.25, m 0.8, drained above the water.
inline std::vector<StixSoil> two_soils()
{
  StixSoil sand{.id = "s", .name = "sand", .weight_above = 18e3, .weight_below = 20e3};
  sand.above = sand.below = StixStrengthModel::advanced;
  sand.advanced = {{.value = 2e3}, {.value = 30.0}, {.value = 0.0}};
  StixSoil clay{.id = "c", .name = "clay", .weight_above = 15e3, .weight_below = 16e3};
  clay.above = StixStrengthModel::classic;
  clay.below = StixStrengthModel::shansep;
  clay.classic = {{.value = 5e3}, {.value = 25.0}, {}};
  clay.ratio = {.value = 0.25, .mean = 0.30, .deviation = 0.05, .is_probabilistic = true};
  clay.exponent = {.value = 0.8};
  return {sand, clay};
}

/// Clay from z = -6 to 0 m on sand from -10 to -6 m, x from 0 to 20 m; phreatic line at z = -1 m, water of 10 kN/m3.
inline StixStage clay_on_sand()
{
  StixStage stage;
  stage.id = "1", stage.label = "daily";
  stage.layers = {box_layer("clay", {0.0, -6.0}, {20.0, 0.0}, 1), box_layer("sand", {0.0, -10.0}, {20.0, -6.0}, 0)};
  stage.water.unit_weight = 10e3;
  stage.water.head_lines = {{.id = "p", .label = "phreatic", .line = {{0.0, -1.0}, {20.0, -1.0}}}};
  stage.water.phreatic = 0;
  return stage;
}

inline StixProject project_of(std::vector<StixStage> stages)
{
  StixProject project{.path = "hand.stix"};
  project.soils = two_soils();
  project.scenarios.push_back({.id = "0", .label = "", .stages = std::move(stages), .calculations = {}});
  return project;
}

/// What holds at a place in the last stage.
inline StixPlace place_in(const StixProject& project, Vec<2> place, StixBasis basis = StixBasis::deterministic)
{
  const auto found = StixSection(project, 0, project.scenarios[0].stages.size() - 1, basis).at(place);
  EXPECT_TRUE(found.has_value());
  return found.value_or(StixPlace{});
}

/// A project with a calculation that has a result, one that has none, and a remark.
inline StixProject listed_project()
{
  StixProject project = project_of({clay_on_sand()});
  project.application = "D-Stability 2026.01";
  project.content_version = "2";
  StixCalculation c{.label = "Bishop \xC3\xA9\xC3\xA9n", .method = "Bishop", .kind_word = "Design"};
  c.result = StixResult{.name = "bishop/bishopresult", .factor_of_safety = 1.23456};
  project.scenarios[0].calculations = {c, {.label = "Later", .method = "Spencer", .kind_word = "Deterministic"}};
  project.remarks = {{"soils.json", "A remark."}};
  return project;
}

inline const std::vector<SoilKind>& kinds()
{
  static const auto table = read_soil_defaults("table", soil_defaults_table());
  return table;
}

/// Empty: there is no such key.
inline std::string value_of_key(const std::vector<CaseLine>& lines, const std::string& key)
{
  const auto line = std::ranges::find(lines, key, &CaseLine::key);
  return line == lines.end() ? "" : line->value;
}

inline const auto always_fits = [](std::size_t, std::size_t) { return std::string("fits"); };

}  // namespace terp::test
