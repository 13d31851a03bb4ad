// The table is kept as text, so that what is printed for a user is what is read without one. The order of rows decides:
// the first row with a pattern of the name counts, then one with a pattern of the code, then one with a word that is
// part of the name, even inside a longer word. So "organic clay" must stand before "clay".

#include "import/dstability/soil_defaults.hpp"

#include "model/bodies/csv_rows.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <regex>

namespace terp {
namespace {

const std::vector<std::string> columns_of_defaults = {"kind", "words", "patterns", "weight", "stiffness_ratio",
    "shear_modulus", "poisson_undrained", "poisson_drained", "k0", "friction", "cohesion", "S", "m", "pop", "least_su",
    "cov_S", "cov_pop", "cov_friction", "cov_cohesion"};

// Weights, S, m, POP and phi: means of the Schematiseringshandleiding macrostabiliteit, tables 7.1 to 7.4, rounded.
// G over s_u, G and nu: those of cases/dike, softer for peat. K0 = 1 - sin phi' of normally consolidated soil, rounded.
// Coefficients of variation of the mean of a section: own choice, within what docs/probability.md calls usual.
const std::string default_table =
    R"(# What a D-Stability file or a drawing does not say of a soil. Change it: terp import --soil-defaults FILE.
# patterns: regular expressions, in lower case; one that is the whole name or code of a soil makes it this kind.
# words: any of them in a name that no pattern fits does. The first row first; the last row takes all others.
# weight [kN/m3], stiffness_ratio G/su [-], shear_modulus of drained soil [MPa], friction [deg], cohesion [kPa],
# S and m of SHANSEP [-], pop [kPa], least_su [kPa]. From a D-Stability file: stiffness_ratio to k0, and least_su.
# cov_...: coefficients of variation [-] of `--study` where the file has no distributions; 0: not drawn.
kind,words,patterns,weight,stiffness_ratio,shear_modulus,poisson_undrained,poisson_drained,)"
    R"(k0,friction,cohesion,S,m,pop,least_su,cov_S,cov_pop,cov_friction,cov_cohesion
peat,peat veen,[hp]_(?!aa)[a-z][a-z][a-z]?_vk? v[[0-9].*,10.8,50,0.5,0.45,0.3,0.5,30,1,0.38,0.9,18,2,0.15,0.35,0.1,0.3
organic clay,organic humeus humous gyttja detritus,)"
    R"([hp]_(?!aa)[a-z][a-z][a-z]?_ko,13.5,75,1,0.45,0.3,0.55,28,1,0.29,0.9,18,2,0.15,0.35,0.1,0.3
embankment,embankment dike dijk levee ophoog berm core kern,)"
    R"([hp]_aa_.*,17.5,100,3,0.45,0.3,0.5,32,1,0.31,0.9,30,2,0.15,0.35,0.08,0.3
clay,clay klei,)"
    R"([hp]_[a-z][a-z][a-z]?_(k|k_shallow|k_deep|sd) k[[0-9].*,)"
    R"(15.5,100,2,0.45,0.3,0.55,28,1,0.25,0.9,22,2,0.15,0.35,0.1,0.3
silt,silt leem loam loess zavel,)"
    R"([hp]_[a-z][a-z][a-z]?_(k&s|k&z|z&k|l) l[[].*,18,100,3,0.45,0.3,0.5,30,1,0.30,0.9,22,2,0.15,0.35,0.08,0.3
gravel,gravel grind,[hp]_[a-z][a-z][a-z]?_g g[[].*,20,300,20,0.45,0.3,0.45,35,0,0,0.9,0,2,0.15,0.35,0.05,0.3
sand,sand zand aquifer,)"
    R"([hp]_[a-z][a-z][a-z]?_(z|zf|zm|zg|z&g) zp?[[].*,19.5,300,12,0.45,0.3,0.5,32,0,0,0.9,0,2,0.15,0.35,0.05,0.3
other,*,,18,100,3,0.45,0.3,0.5,30,1,0,0.9,0,2,0.15,0.35,0.1,0.3
)";

std::string lower(std::string_view text)
{
  std::string copy(text);
  std::ranges::transform(copy, copy.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return copy;
}

std::vector<std::string> words_in(std::string_view text)
{
  std::vector<std::string> words(1);
  for (const char c : lower(text))
    if (c == ' ' && !words.back().empty())
      words.emplace_back();
    else if (c != ' ')
      words.back() += c;
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Whether a name without what its author hung on it is one of the patterns of a kind.
bool fits(const SoilKind& kind, const std::string& name)
{
  static const std::regex without_friction("[ _]?s, ?phi=0$");
  const std::string text = std::regex_replace(lower(name), without_friction, "");
  return std::ranges::any_of(kind.patterns, [&](const std::regex& pattern) { return std::regex_match(text, pattern); });
}

struct Column {
  const char* name;
  Real SoilKind::*member;
  Real low, high;
};
// S = 0: drained. The rest: what a law takes, and what no soil exceeds.
const Column numbers[] = {{"weight", &SoilKind::weight, 9.0, 30.0},
    {"stiffness_ratio", &SoilKind::stiffness_ratio, 10.0, 2000.0},
    {"shear_modulus", &SoilKind::shear_modulus, 0.01, 1e4},
    {"poisson_undrained", &SoilKind::poisson_undrained, 0.0, 0.4999},
    {"poisson_drained", &SoilKind::poisson_drained, 0.0, 0.4999}, {"k0", &SoilKind::k0, 0.1, 5.0},
    {"friction", &SoilKind::friction, 0.0, 60.0}, {"cohesion", &SoilKind::cohesion, 0.0, 1e4},
    {"S", &SoilKind::ratio, 0.0, 2.0}, {"m", &SoilKind::exponent, 0.01, 1.0}, {"pop", &SoilKind::pop, 0.0, 1e4},
    {"least_su", &SoilKind::least_strength, 0.01, 1e4}, {"cov_S", &SoilKind::cov_ratio, 0.0, 1.0},
    {"cov_pop", &SoilKind::cov_pop, 0.0, 1.0}, {"cov_friction", &SoilKind::cov_friction, 0.0, 1.0},
    {"cov_cohesion", &SoilKind::cov_cohesion, 0.0, 1.0}};

}  // namespace

const std::string& soil_defaults_table() { return default_table; }

std::vector<SoilKind> read_soil_defaults(const std::string& path, const std::string& text)
{
  std::vector<SoilKind> kinds;
  CsvFaults faults(path, "the table of soil defaults",
      "terp import --soil-defaults-table prints the table that holds without it, with its units.");
  read_csv_rows(text, columns_of_defaults, faults, [&](std::span<const std::string> cells, Index line) {
    SoilKind kind{};
    kind.kind = cells[0];
    kind.words = words_in(cells[1]);
    for (const std::string& pattern : words_in(cells[2])) try {
        kind.patterns.emplace_back(pattern);
      } catch (const std::regex_error&) {
        faults.add(line, fmt::format("`{}` is not a regular expression", pattern));
      }
    if (kind.kind.empty()) faults.add(line, "a row needs a kind");
    if (kind.words.empty()) faults.add(line, "a row needs words, or * in the last row");
    for (std::size_t k = 0; k < std::size(numbers); ++k) {
      const auto& [name, member, low, high] = numbers[k];
      const Real value = finite_number_in_csv(cells[k + 3], name, line, faults);
      kind.*member = value;
      if (value < low || value > high)
        faults.add(line, fmt::format("{} is {:g}; allowed is {:g} to {:g}", name, value, low, high));
    }
    kinds.push_back(std::move(kind));
  });
  faults.stop_if_any();
  return kinds;
}

const SoilKind& kind_of_soil(const std::vector<SoilKind>& kinds, const std::string& name, const std::string& code)
{
  for (const std::string& of : {name, code})
    for (const SoilKind& kind : kinds)
      if (fits(kind, of)) return kind;
  const std::string text = lower(name);
  for (const SoilKind& kind : kinds)
    for (const std::string& word : kind.words)
      if (text.find(word) != std::string::npos) return kind;
  return kinds.back();
}

}  // namespace terp
