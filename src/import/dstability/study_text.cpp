// One number for each parameter of a soil, which all its materials follow by formulas: below and above the water, and
// as a face. So D-Stability has it, whose deviations are those of the mean of a section. c' and phi' of the file are
// drawn, and c* and phi* of the case follow them.

#include "import/dstability/study_text.hpp"

#include "math/errors.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace terp {
namespace {

constexpr const char* factor_name = "model_factor";
constexpr Real longest = 60.0;  // of the last stage [s]: twice that of a run, as a study counts what moves as unknown
constexpr Real radian = std::numbers::pi / 180.0;
constexpr Real most_of_mean = 0.25;  // by which what a yield stress owes to a POP may differ from the mean of that POP

bool is_random(const StixParameter& p) { return p.is_probabilistic && p.deviation > 0.0 && p.mean > 0.0; }

bool is_random(const StixPreload& preload) { return preload.kind == StixPreload::Kind::pop && is_random(preload.pop); }

/// Each state up to a stage of a scenario.
template <class Project, class Visit>
void for_each_state(Project& project, std::size_t scenario, std::size_t stage, Visit visit)
{
  for (std::size_t k = 0; k <= stage; ++k) {
    auto& of = project.scenarios[scenario].stages[k];
    for (auto& point : of.state_points) visit(point.preload);
    for (auto& line : of.state_lines)
      for (auto& value : line.values) visit(value.above), visit(value.below);
  }
}

bool is_staged(const StudyPlan& plan) { return !plan.stages.first.empty(); }

std::string nine_digits(Real value) { return fmt::format("{:.9g}", value); }

/// The numbers that are drawn, and the keys that follow them.
class StudyNumbers {
 public:
  explicit StudyNumbers(const StudyPlan& plan) : plan_(plan) {}

  void add_model_factor()
  {
    if (!(plan_.model_factor.deviation > 0.0)) return;
    if (!is_staged(plan_)) {
      report_.push_back("The model factor is not drawn: the case has one stage alone.");
      return;
    }
    declare(factor_name, "-", plan_.model_factor, "model factor of the file: strengths are divided by it in the flood");
    if (plan_.stages.is_held) follow("stage[0].set.at_strength", fmt::format("0.5 * {}", factor_name));
    follow("stage[1].set.at_strength", factor_name);
  }

  void add(const SoilUse& use)
  {
    const StixSoil& soil = *use.soil;
    const SoilKind& kind = kind_of_soil(*plan_.kinds, soil.name, soil.code);
    const std::string key = fmt::format("material.{}.", use.name);
    switch (use.above ? soil.above : soil.below) {
      case StixStrengthModel::shansep:
        draw(use, "S", "-", soil.ratio, kind.cov_ratio,
            [&](const std::string& S) { follow(key + "su_peak.shansep.S", fmt::format("min({}, 1.99)", S)); });
        draw(use, "m", "-", soil.exponent, 0.0, [&](const std::string& m) { follow(key + "su_peak.shansep.m", m); });
        add_pop(use, kind, key + "su_peak.shansep.pop");
        break;
      case StixStrengthModel::su_table: add_table(use, kind, key + "su_peak.table"); break;
      case StixStrengthModel::advanced: add_friction(use, soil.advanced, kind, key, true); break;
      case StixStrengthModel::classic: add_friction(use, soil.classic, kind, key, false); break;
      default:
        report_.push_back(fmt::format("{}: its strength is a table over the stress, which is not drawn.", use.name));
    }
  }

  bool empty() const { return numbers_.empty(); }
  bool has_factor() const
  {
    return numbers_.starts_with(fmt::format("\n[[random]]\nname         = \"{}\"", factor_name));
  }
  std::string text() const { return numbers_ + (follow_.empty() ? "" : "\n[follow]\n" + follow_); }
  std::vector<std::string> report() const { return report_; }

 private:
  using Use = std::function<void(const std::string& name)>;

  void follow(const std::string& key, const std::string& formula)
  {
    follow_ += fmt::format(
        "\"{}\" = {}\n", key, formula.starts_with('[') || formula.starts_with('{') ? formula : '"' + formula + '"');
  }

  /// A distribution of the file, else one of the plain value with a coefficient of variation; neither: none.
  StixParameter distribution_of(const StixParameter& p, Real cov) const
  {
    if (plan_.is_of_file) return is_random(p) ? p : StixParameter{};
    if (!(cov > 0.0 && p.value > 0.0)) return {};
    return {.value = p.value, .mean = p.value, .deviation = cov * p.value, .is_probabilistic = true};
  }

  /// Declared once for a soil. Gives its name, or "" where it is not drawn.
  std::string name_of(const SoilUse& use, const char* letter, const char* unit, const StixParameter& p, Real cov)
  {
    const StixParameter d = distribution_of(p, cov);
    if (!is_random(d)) return "";
    const std::string name = fmt::format("{}_{}", letter, key_of_name(use.soil->name));
    if (std::ranges::find(names_, name) == names_.end())
      declare(name, unit, d, fmt::format("soil `{}`", use.soil->name));
    return name;
  }

  void draw(const SoilUse& use, const char* letter, const char* unit, const StixParameter& p, Real cov, const Use& then)
  {
    if (const std::string name = name_of(use, letter, unit, p, cov); !name.empty()) then(name);
  }

  void declare(const std::string& name, const std::string& unit, const StixParameter& d, const std::string& of)
  {
    names_.push_back(name);
    const bool is_exponent = name.starts_with("m_");
    const std::string source = plan_.is_of_file ? "of the file" : "NOT of the file: by kind of soil";
    numbers_ += fmt::format(
        "\n[[random]]\nname         = \"{}\"\nunit         = \"{}\"\ndistribution = \"{}\"  # {}, {}\nmean         = "
        "{}\nsd           = {}\n{}",
        name, unit, is_exponent ? "truncated_normal" : "lognormal", printable_name(of), source, nine_digits(d.mean),
        nine_digits(d.deviation), is_exponent ? "lowest       = 0.1\nhighest      = 1.0\n" : "");
    report_.push_back(fmt::format("{}, {}: mean {:.4g}, standard deviation {:.3g}{}, {}.", name, of, d.mean,
        d.deviation, unit == "-" ? "" : ' ' + unit, source));
  }

  /// No comment is ended by a name of the file.
  static std::string printable_name(std::string text)
  {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    return text;
  }

  void add_pop(const SoilUse& use, const SoilKind& kind, const std::string& key)
  {
    if (!use.pop) {
      report_.push_back(fmt::format("POP of `{}` is not drawn: no POP{} makes most of the yield stress of {}.",
          use.soil->name, plan_.is_of_file ? " with a distribution" : "", use.name));
      return;
    }
    StixParameter d{.mean = use.pop->mean, .deviation = use.pop->deviation, .is_probabilistic = true};
    if (!plan_.is_of_file) d.deviation = kind.cov_pop * d.mean;
    if (!is_random(d)) return;
    const std::string name = "pop_" + use.name;
    declare(name, "Pa", d, fmt::format("POP of `{}`", use.soil->name));
    follow(key, use.pop->rest == 0.0 ? name : fmt::format("max({} + {}, 0)", name, nine_digits(use.pop->rest)));
  }

  void add_table(const SoilUse& use, const SoilKind& kind, const std::string& key)
  {
    const StixTable& table = use.soil->su_table;
    const StixParameter share{
        .value = 1.0, .mean = 1.0, .deviation = table.variation, .is_probabilistic = table.is_probabilistic};
    draw(use, "su", "-", share, kind.cov_ratio, [&](const std::string& f) {
      std::string rows;
      for (const Vec<2>& row : table.rows)
        rows += fmt::format("{}[{}, \"max({} * {}, {})\"]", rows.empty() ? "" : ", ", nine_digits(row[0]),
            nine_digits(row[1]), f, nine_digits(1e3 * kind.least_strength));
      follow(key, "[" + rows + "]");
    });
  }

  /// c* and phi* of c' and phi' (soil_strength.hpp), or these.
  void add_friction(
      const SoilUse& use, const StixFriction& f, const SoilKind& kind, const std::string& key, bool is_reduced)
  {
    const std::string c = name_of(use, "c", "Pa", f.cohesion, kind.cov_cohesion),
                      phi = name_of(use, "phi", "-", f.friction, kind.cov_friction);
    if (c.empty() && phi.empty()) return;
    const bool has_cohesion = value_of(f.cohesion, StixBasis::mean) > 0.0;
    const auto plain = [](const StixParameter& p) { return nine_digits(value_of(p, StixBasis::mean)); };
    std::string cohesion = c.empty() ? plain(f.cohesion) : c, friction = phi.empty() ? plain(f.friction) : phi;
    if (is_reduced) {
      const Real dilatancy = value_of(f.dilatancy, StixBasis::mean),
                 psi = std::isnan(dilatancy) ? 0.0 : dilatancy * radian;
      const std::string angle = fmt::format("({} * {})", friction, nine_digits(radian));
      const std::string by_dilatancy = psi > 0.0 ? fmt::format(" * {} / (1 - {} * sin{})", nine_digits(std::cos(psi)),
                                                       nine_digits(std::sin(psi)), angle)
                                                 : "";
      if (has_cohesion) cohesion = fmt::format("{} * cos{}{}", cohesion, angle, by_dilatancy);
      friction = fmt::format("atan(sin{}{}) / {}", angle, by_dilatancy, nine_digits(radian));
      if (psi > 0.0 && !phi.empty())
        follow(key + "dilatancy_angle", fmt::format("min({}, {})", nine_digits(dilatancy), friction));
    }
    if (!phi.empty()) follow(key + "friction_angle", fmt::format("min({}, 60)", friction));
    if (!has_cohesion) return;
    if (use.face_cohesion > 0.0) {
      const std::string face = fmt::format("max({}, {})", nine_digits(use.face_cohesion), cohesion);
      follow(key + "cohesion",
          fmt::format("{{ depth = [[0, \"{0}\"], [{1:g}, \"{0}\"], [{1:g}, \"{2}\"], [50, \"{2}\"]] }}", face,
              face_depth, cohesion));
    } else {
      follow(key + "cohesion", cohesion);
    }
  }

  const StudyPlan& plan_;
  std::vector<std::string> names_, report_;
  std::string numbers_, follow_;
};

/// { name = "rise", ... }
std::string inline_table(const CaseTableText& table, bool has_factor)
{
  std::string text;
  for (const CaseLine& line : table.lines)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", line.key, line.value);
  if (has_factor)
    for (const auto& [plain, drawn] :
        {std::pair("at_strength = 0.5", "0.5 * model_factor"), {"at_strength = 1.0", factor_name}})
      if (const std::size_t at = text.find(plain); at != std::string::npos)
        text.replace(at, std::string_view(plain).size(), fmt::format("at_strength = \"{}\"", drawn));
  return "{ " + text + " }";
}

std::string held_text(const StudyPlan& plan, bool has_factor)
{
  if (plan.stages.is_held) return "";
  StagePlan held = plan.stages;
  held.is_held = true;
  held.longest = longest;
  std::string text =
      "\n# What cannot stand as drawn is held while the river rises, and then released: so it is known what is left.\n"
      "[held]\n";
  if (!is_staged(plan)) text += "time = { rest_speed = 4e-3, rest_time = 2.0 }\n";
  for (const std::string& set : plan.held_sets) text += set + '\n';
  text += "stage = [\n";
  for (const CaseTableText& stage : stage_tables(held)) text += "  " + inline_table(stage, has_factor) + ",\n";
  return text + "]\n";
}

}  // namespace

bool has_distributions(const StixProject& project, std::size_t scenario, std::size_t stage)
{
  bool found = false;
  for_each_state(project, scenario, stage, [&](const StixPreload& preload) { found = found || is_random(preload); });
  for (const StixLayer& layer : project.scenarios[scenario].stages[stage].layers) {
    const StixSoil& soil = project.soils[*layer.soil];
    const bool has_table = soil.su_table.is_probabilistic && soil.su_table.variation > 0.0;
    for (const StixStrengthModel model : {soil.above, soil.below}) switch (model) {
        case StixStrengthModel::shansep: found = found || is_random(soil.ratio) || is_random(soil.exponent); break;
        case StixStrengthModel::su_table: found = found || has_table; break;
        case StixStrengthModel::advanced:
          found = found || is_random(soil.advanced.cohesion) || is_random(soil.advanced.friction);
          break;
        case StixStrengthModel::classic:
          found = found || is_random(soil.classic.cohesion) || is_random(soil.classic.friction);
          break;
        default: break;
      }
  }
  return found;
}

StixParameter model_factor_of(const StixScenario& scenario, std::size_t stage)
{
  for (const StixCalculation& c : scenario.calculations)
    if (c.stage == stage && c.kind == StixCalculationKind::probabilistic && c.model_factor_deviation > 0.0)
      return {.mean = c.model_factor, .deviation = c.model_factor_deviation, .is_probabilistic = true};
  return {};
}

RandomPops::RandomPops(const StixSection& section, std::size_t scenario, std::size_t stage, bool of_file)
    : section_(&section)
{
  const auto pop_of = [&](const StixPreload& preload) -> std::optional<RandomPop> {
    if (preload.kind != StixPreload::Kind::pop || (of_file && !is_random(preload))) return std::nullopt;
    return of_file ? RandomPop{preload.pop.mean, preload.pop.deviation, 0.0} : RandomPop{};
  };
  std::vector<RandomPop> found;
  for_each_state(section.project(), scenario, stage, [&](const StixPreload& preload) {
    if (const auto pop = pop_of(preload); pop && std::ranges::find(found, *pop) == found.end()) found.push_back(*pop);
  });
  for (const RandomPop& pop : found) {
    Without& without = without_.emplace_back(Without{std::make_unique<StixProject>(section.project()), nullptr, pop});
    for_each_state(*without.project, scenario, stage, [&](StixPreload& preload) {
      if (pop_of(preload) == pop) preload.pop.value = preload.pop.mean = 0.0;
    });
    without.section = std::make_unique<StixSection>(*without.project, scenario, stage, section.basis());
  }
}

std::optional<RandomPop> RandomPops::at(const std::vector<Vec<2>>& places) const
{
  for (const Without& without : without_) {
    Real sum = 0.0, n = 0.0;
    for (const Vec<2>& x : places)
      if (const auto with = section_->at(x), less = without.section->at(x); with && less)
        sum += with->yield_stress - less->yield_stress, n += 1.0;
    if (n == 0.0) return std::nullopt;
    RandomPop pop = without.pop;
    const Real mean = sum / n;
    if (pop.mean == 0.0) pop.mean = std::round(mean);  // of no distribution
    constexpr Real least = 1e3;                        // [Pa]
    if (mean > least && std::abs(mean - pop.mean) < most_of_mean * pop.mean) return pop;
  }
  return std::nullopt;
}

StudyText study_text(const StudyPlan& plan)
{
  StudyNumbers numbers(plan);
  numbers.add_model_factor();
  for (const SoilUse* use : plan.uses) numbers.add(*use);
  if (numbers.empty())
    throw InputError({plan.title, "nothing of this section is random",
        "The file gives its soils no distribution, and no coefficient of variation of their kinds fits one. Leave "
        "--study out.",
        ""});
  StudyText text;
  text.source = plan.is_of_file ? filled<reported_texts::study_of_file>() : filled<reported_texts::study_not_of_file>();
  const char* const stage = is_staged(plan) || plan.stages.is_held ? "stage[1]" : "time";
  text.file = fmt::format(
      "# A study of the section beside it: terp study run, docs/probability.md. Written by terp import --study.\n# {}\n"
      "# One number per soil, no random field: the deviations are those of the mean of a section.\n\n"
      "title = {}\n{}case  = \"case.toml\"\nseed  = 1\n\n[set]\n\"body.*.points_per_cell\" = [2, 2]  # 1.5 times as "
      "fast "
      "as "
      "4 x 4 (docs/probability.md)\n{}",
      text.source.en, in_quotes(plan.title),
      plan.is_of_file ? "" : fmt::format("note  = {}\n", in_quotes(text.source.en)),
      plan.stages.has_flood
          ? fmt::format("\"{}.at_most\" = {:.1f}  # s\n", stage, plan.stages.is_held ? longest + 12.0 : longest)
          : "");
  text.file += numbers.text() + held_text(plan, numbers.has_factor());
  text.file += fmt::format(
      "\n[estimator]\nkind = \"monte_carlo\"\n\n[stop]\nnumber = 200\n\n[events]\nvolume       = {}  # m2: a slide\n"
      "displacement = 0.5  # m\n",
      number_text(plan.slide));
  text.report = numbers.report();
  text.report.insert(text.report.begin(), text.source.en);
  if (plan.has_films) text.report.push_back("Films keep the strength of the border that they have in the case.");
  return text;
}

}  // namespace terp
