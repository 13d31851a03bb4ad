// Drained soil gets the strength that D-Stability has on a slip plane: c* and phi* of the Davis reduction. A slope of
// soil without dilatancy finds a mechanism with nearly all of tan phi' (docs/strength.md, "Friction and dilatancy"), so
// the plain pair would make the section stronger than in the file.

#include "import/dstability/soil_text.hpp"

#include "math/errors.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace terp {
namespace {

constexpr Real degrees = 180.0 / std::numbers::pi;
constexpr Real largest_friction = 60.0;  // [degrees] that the law takes

/// A slip circle carries no tension either.
CaseLine no_tension() { return {"tension_cutoff", "0.0", "the soil cracks; not in the file"}; }

/// A number of a soil: what it is called, its unit, and what a case takes.
struct SoilNumber {
  const char *name, *unit;
  Real si;  ///< one of its unit
  Real low, high;
};
constexpr SoilNumber weight_of_soil{"unit weight", "kN/m3", 1e3, 0.1, 100.0};
constexpr SoilNumber cohesion_of_soil{"cohesion", "kPa", 1e3, 0.0, 1e4};
constexpr SoilNumber friction_of_soil{"friction angle", "degrees", 1.0, 0.0, largest_friction};
constexpr SoilNumber dilatancy_of_soil{"dilatancy", "degrees", 1.0, 0.0, largest_friction};
constexpr SoilNumber ratio_of_soil{"shear strength ratio S", "", 1.0, 1e-3, 2.0};
constexpr SoilNumber exponent_of_soil{"strength increase exponent m", "", 1.0, 1e-3, 1.0};
constexpr SoilNumber table_of_soil{"table of strength", "kPa", 1e3, 0.0, 1e5};

/// The numbers of a soil as the calculation takes them. Faults are collected.
class SoilNumbers {
 public:
  SoilNumbers(const SoilUse& use, StixBasis basis) : use_(use), basis_(basis) {}

  Real at(const StixParameter& parameter, const SoilNumber& number)
  {
    const Real value = value_of(parameter, basis_);
    if (std::isnan(value) && basis_ != StixBasis::deterministic && parameter.is_probabilistic)
      add(fmt::format("its {} has no {}", number.name, basis_ == StixBasis::mean ? "mean" : "design value"),
          basis_ == StixBasis::mean ? "A mean is not in the file." : "It needs a mean and a standard deviation.");
    else
      check(value, number);
    return value;
  }

  void check(Real value, const SoilNumber& number)
  {
    const bool is_empty = std::isnan(value);
    if (value >= number.low * number.si && value <= number.high * number.si) return;
    add(fmt::format("its {} {}", number.name,
            is_empty ? "is empty" : fmt::format("is {:g} {}", value / number.si, number.unit)),
        fmt::format(
            "Allowed are {:g} to {:g}{}{}.", number.low, number.high, *number.unit == 0 ? "" : " ", number.unit));
  }

  void check_table(const StixTable& table, const char* name)
  {
    if (table.rows.empty()) add(fmt::format("its {} has no rows", name), "A strength needs one at least.");
    for (const Vec<2>& row : table.rows) check(row[1], table_of_soil);
    if (basis_ == StixBasis::design && table.is_probabilistic && std::isnan(table.variation))
      add(fmt::format("its {} has no design value", name), "It needs a coefficient of variation.");
  }

  void add(const std::string& what, const std::string& detail)
  {
    problems_.push_back({fmt::format("soil `{}`", use_.soil->name), what,
        fmt::format("{} It is asked for {} the phreatic line in stage `{}`. Correct it in D-Stability.", detail,
            use_.above ? "above" : "below", use_.stage),
        ""});
  }

  void stop_if_any() const
  {
    if (!problems_.empty()) throw InputError(problems_);
  }

 private:
  const SoilUse& use_;
  StixBasis basis_;
  std::vector<Problem> problems_;
};

/// Throws InputError, a problem for each number that is empty or out of range.
void check_numbers(const SoilUse& use, StixStrengthModel model, StixBasis basis, const std::string& word)
{
  const StixSoil& soil = *use.soil;
  SoilNumbers numbers(use, basis);
  numbers.check(use.above ? soil.weight_above : soil.weight_below, weight_of_soil);
  const auto check_friction = [&](const StixFriction& f) {
    numbers.at(f.cohesion, cohesion_of_soil);
    return numbers.at(f.friction, friction_of_soil);
  };
  switch (model) {
    case StixStrengthModel::advanced: {
      const Real friction = check_friction(soil.advanced), dilatancy = value_of(soil.advanced.dilatancy, basis);
      if (std::isnan(dilatancy)) break;  // taken as zero, which the report says
      numbers.check(dilatancy, dilatancy_of_soil);
      if (dilatancy > friction)
        numbers.add(fmt::format("its dilatancy is {:g} degrees", dilatancy),
            fmt::format("At most the friction angle, {:g} degrees.", friction));
      break;
    }
    case StixStrengthModel::classic: check_friction(soil.classic); break;
    case StixStrengthModel::shansep:
      numbers.at(soil.ratio, ratio_of_soil);
      numbers.at(soil.exponent, exponent_of_soil);
      break;
    case StixStrengthModel::su_table: numbers.check_table(soil.su_table, "SuTable"); break;
    case StixStrengthModel::sigma_tau_table: numbers.check_table(soil.sigma_tau_table, "SigmaTauTable"); break;
    case StixStrengthModel::none:
    case StixStrengthModel::unknown:
      numbers.add(fmt::format("its strength is `{}`, which Terp cannot take over", word),
          "Known are MohrCoulombAdvanced, MohrCoulombClassic, CPhi, Su, SuTable and SigmaTauTable.");
  }
  numbers.stop_if_any();
}

void add_common(const SoilUse& use, const SoilKind& kind, bool drained, SoilText& text)
{
  const Real weight = use.above ? use.soil->weight_above : use.soil->weight_below;
  auto& lines = text.material.lines;
  lines.push_back({"density", in_quotes(kilo_text(weight, "kN/m3")),
      fmt::format("weight {} the phreatic line", use.above ? "above" : "below")});
  const std::string origin = fmt::format("not in the file: default of {}", kind.kind);
  if (drained)
    lines.push_back({"shear_modulus", in_quotes(fmt::format("{:g} MPa", kind.shear_modulus)), origin});
  else
    lines.push_back({"stiffness_ratio", fmt::format("{:g}", kind.stiffness_ratio), "G over su_peak; " + origin});
  lines.push_back(
      {"poisson_ratio", fmt::format("{:g}", drained ? kind.poisson_drained : kind.poisson_undrained), origin});
  lines.push_back({"k0", fmt::format("{:g}", kind.k0), origin});
  lines.push_back(no_tension());
}

/// The straight line nearest to a table up to a stress: cohesion [Pa] and tan of its slope.
Vec<2> line_through(const StixTable& table, Real largest_stress, StixBasis basis)
{
  Real n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (int k = 0; k <= 20; ++k) {
    const Real stress = largest_stress * k / 20.0, strength = table_strength(table, stress, basis);
    n += 1.0, x += stress, y += strength, xx += stress * stress, xy += stress * strength;
  }
  const Real slope = std::max(0.0, (n * xy - x * y) / (n * xx - x * x));
  return {std::max(0.0, (y - slope * x) / n), slope};
}

/// Friction as the case takes it: c + sigma'_n tan phi on slip planes, dilating by no more than phi.
struct CaseFriction {
  Real cohesion;   ///< [Pa]
  Real friction;   ///< [degrees]
  Real dilatancy;  ///< [degrees]
};

void add_friction(const SoilUse& use, SoilText& text, const CaseFriction& f, const std::string& origin)
{
  auto& lines = text.material.lines;
  lines.push_back({"friction_angle", fmt::format("{:.9g}", f.friction), "degrees; " + origin});
  const std::string cohesion = in_quotes(kilo_text(f.cohesion, "kPa"));
  if (use.face_cohesion > f.cohesion) {
    const std::string face = in_quotes(kilo_text(use.face_cohesion, "kPa"));
    lines.push_back({"cohesion",
        fmt::format("{{ depth = [[0, {0}], [{1:g}, {0}], [{1:g}, {2}], [50, {2}]] }}", face, face_depth, cohesion),
        fmt::format("below {:g} m {}", face_depth, origin)});
    text.assumed.push_back(
        filled<reported_texts::face_cohesion>(use.name, use.face_cohesion / 1e3, face_depth, f.cohesion / 1e3));
  } else {
    lines.push_back({"cohesion", cohesion, origin});
  }
  lines.push_back({"dilatancy_angle", fmt::format("{:.9g}", f.dilatancy), "degrees"});
}

/// That of a material of the model with dilatancy. Notes what was reduced.
CaseFriction reduced_friction(const SoilUse& use, SoilText& text, StixBasis basis)
{
  const StixFriction& f = use.soil->advanced;
  const Real cohesion = value_of(f.cohesion, basis), friction = value_of(f.friction, basis),
             given = value_of(f.dilatancy, basis), dilatancy = std::isnan(given) ? 0.0 : given;
  if (std::isnan(given)) text.assumed.push_back(filled<reported_texts::no_dilatancy>(use.name));
  if (dilatancy >= friction) return {cohesion, friction, friction};
  const DavisStrength on_planes = davis_reduced(cohesion, friction, dilatancy);
  text.assumed.push_back(filled<reported_texts::reduced_friction>(
      use.name, friction, cohesion / 1e3, on_planes.friction, on_planes.cohesion / 1e3, dilatancy));
  return {on_planes.cohesion, on_planes.friction, std::min(dilatancy, on_planes.friction)};
}

/// That of the straight line nearest to the table of a soil.
CaseFriction friction_of_table(const SoilUse& use, SoilText& text, StixBasis basis)
{
  const Real up_to = std::max(use.largest_stress, 10e3);
  const Vec<2> line = line_through(use.soil->sigma_tau_table, up_to, basis);
  const Real friction = degrees * std::atan(line[1]);
  text.assumed.push_back(filled<reported_texts::line_of_table>(use.soil->name, up_to / 1e3, line[0] / 1e3, line[1]));
  if (friction > largest_friction)
    text.assumed.push_back(filled<reported_texts::steep_line>(use.name, friction, largest_friction));
  return {line[0], std::min(friction, largest_friction), 0.0};
}

/// Soil that the file gives no strength at all: D-Stability takes none, a run cannot begin with none.
bool has_no_strength(const StixFriction& f, StixBasis basis)
{
  return !(value_of(f.cohesion, basis) > 0.0) && !(value_of(f.friction, basis) > 0.0);
}

void add_drained(const SoilUse& use, StixStrengthModel model, StixBasis basis, const SoilKind& kind, SoilText& text)
{
  const StixSoil& soil = *use.soil;
  if (model != StixStrengthModel::sigma_tau_table &&
      has_no_strength(model == StixStrengthModel::advanced ? soil.advanced : soil.classic, basis)) {
    add_friction(
        use, text, {1e3 * kind.least_strength, 0.0, 0.0}, fmt::format("none in the file: least_su of {}", kind.kind));
    text.material.lines.push_back({"drainage", "\"drained\"", ""});
    text.assumed.push_back(filled<reported_texts::no_strength>(soil.name,
        use.above ? filled<reported_texts::above_it>() : filled<reported_texts::below_it>(), kind.least_strength));
    return;
  }
  if (model == StixStrengthModel::advanced) {
    const StixFriction& f = soil.advanced;
    add_friction(use, text, reduced_friction(use, text, basis),
        fmt::format("on slip planes; the file's are {:g} degrees and {:g} kPa", value_of(f.friction, basis),
            value_of(f.cohesion, basis) / 1e3));
  } else if (model == StixStrengthModel::classic) {
    const StixFriction& f = soil.classic;
    add_friction(use, text, {value_of(f.cohesion, basis), value_of(f.friction, basis), 0.0}, "of the file");
  } else {
    add_friction(use, text, friction_of_table(use, text, basis), "straight line through the file's SigmaTauTable");
  }
}

std::string water_option(const SoilUse& use)
{
  return use.strength_water.empty() ? "" : fmt::format(", water = {}", in_quotes(use.strength_water));
}

void add_undrained(const SoilUse& use, StixStrengthModel model, StixBasis basis, const SoilKind& kind, SoilText& text)
{
  const StixSoil& soil = *use.soil;
  auto& lines = text.material.lines;
  if (model == StixStrengthModel::shansep) {
    lines.push_back({"su_peak",
        fmt::format("{{ shansep = {{ S = {:.9g}, m = {:.9g}, {}{}, minimum = \"{:g} kPa\" }} }}",
            value_of(soil.ratio, basis), value_of(soil.exponent, basis), use.preload.value, water_option(use),
            kind.least_strength),
        fmt::format("S and m of the file; {}; minimum: default of {}", use.preload.comment, kind.kind)});
  } else {
    std::string rows;
    for (const Vec<2>& row : soil.su_table.rows)
      rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", in_quotes(kilo_text(row[0], "kPa")),
          in_quotes(
              kilo_text(std::max(table_strength(soil.su_table, row[0], basis), 1e3 * kind.least_strength), "kPa")));
    lines.push_back({"su_peak", fmt::format("{{ table = [{}]{} }}", rows, water_option(use)),
        fmt::format(
            "SuTable of the file over sigma'_v; at least {:g} kPa: default of {}", kind.least_strength, kind.kind)});
  }
  text.assumed.push_back(filled<reported_texts::least_su>(use.name, kind.least_strength));
}

}  // namespace

PreloadText grid_preload(const std::string& file, bool of_all_stages, Real pop)
{
  return {fmt::format("yield_stress = {{ csv = {} }}{}", in_quotes(file),
              pop > 0.0 ? fmt::format(", pop = \"{:g} kPa\"", pop / 1e3) : ""),
      fmt::format("yield stress of {} on a grid, from the states of the file{}",
          of_all_stages ? "all stages" : "this stage", pop > 0.0 ? "; the POP that the study draws beside it" : "")};
}

std::string kilo_text(Real value, const char* unit) { return fmt::format("{:.9g} {}", value / 1e3, unit); }

bool same_above_and_below(const StixSoil& soil)
{
  return soil.above == soil.below && soil.weight_above == soil.weight_below;
}

bool has_su(const StixSoil& soil)
{
  const auto is_su = [](StixStrengthModel m) {
    return m == StixStrengthModel::shansep || m == StixStrengthModel::su_table;
  };
  return is_su(soil.below) || is_su(soil.above);
}

bool is_shansep(const StixSoil& soil, int zone)
{
  return (zone == 2 ? soil.above : soil.below) == StixStrengthModel::shansep;
}

SoilText soil_text(const SoilUse& use, StixBasis basis, const std::vector<SoilKind>& kinds)
{
  const StixSoil& soil = *use.soil;
  const StixStrengthModel model = use.above ? soil.above : soil.below;
  const SoilKind& kind = kind_of_soil(kinds, soil.name, soil.code);
  check_numbers(use, model, basis, use.above ? soil.above_word : soil.below_word);
  SoilText text;
  text.material.name = use.name;
  text.material.comment = fmt::format("Soil {} ({}){}{}: {} of the file. Kind: {}.", in_quotes(soil.name), soil.code,
      use.where.empty() ? "" : ", ", use.where, use.above ? soil.above_word : soil.below_word, kind.kind);
  auto& lines = text.material.lines;
  const bool drained = model != StixStrengthModel::shansep && model != StixStrengthModel::su_table;
  lines.push_back(drained ? CaseLine{"model", "\"mohr_coulomb\"", "drained"}
                          : CaseLine{"model", "\"tresca_softening\"", "undrained, without softening"});
  add_common(use, kind, drained, text);
  if (drained)
    add_drained(use, model, basis, kind, text);
  else
    add_undrained(use, model, basis, kind, text);
  const bool has_colour =
      soil.colour.size() == 9 && soil.colour.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (has_colour) lines.push_back({"color", in_quotes('#' + soil.colour.substr(3)), "of the file"});
  text.assumed.push_back(filled<reported_texts::stiffness>(use.name, kind.kind));
  if (soil.name.ends_with("phi=0")) text.assumed.push_back(filled<reported_texts::strength_taken_away>(soil.name));
  return text;
}

std::string strength_water_key(const SoilUse& use)
{
  const StixStrengthModel model = use.above ? use.soil->above : use.soil->below;
  if (model == StixStrengthModel::shansep) return fmt::format("material.{}.su_peak.shansep.water", use.name);
  return model == StixStrengthModel::su_table ? fmt::format("material.{}.su_peak.water", use.name) : "";
}

CaseMaterialText default_soil_text(const std::string& name, const std::string& label, const SoilKind& kind)
{
  const std::string origin = fmt::format("default of {}: fill in your own", kind.kind);
  CaseMaterialText text{
      name, fmt::format("Layer {} of the drawing. Nothing but its name is known.", in_quotes(label)), {}};
  const bool drained = kind.ratio == 0.0;
  text.lines = {{"model", drained ? "\"mohr_coulomb\"" : "\"tresca_softening\"",
                    drained ? "drained" : "undrained, without softening"},
      {"density", fmt::format("\"{:g} kN/m3\"", kind.weight), origin}};
  if (drained) {
    text.lines.push_back({"shear_modulus", fmt::format("\"{:g} MPa\"", kind.shear_modulus), origin});
    text.lines.push_back({"friction_angle", fmt::format("{:g}", kind.friction), "degrees; " + origin});
    text.lines.push_back({"cohesion", fmt::format("\"{:g} kPa\"", kind.cohesion), origin});
  } else {
    text.lines.push_back({"stiffness_ratio", fmt::format("{:g}", kind.stiffness_ratio), "G over su_peak; " + origin});
    text.lines.push_back({"su_peak",
        fmt::format("{{ shansep = {{ S = {:g}, m = {:g}, pop = \"{:g} kPa\", minimum = \"{:g} kPa\" }} }}", kind.ratio,
            kind.exponent, kind.pop, kind.least_strength),
        origin});
  }
  text.lines.push_back(
      {"poisson_ratio", fmt::format("{:g}", drained ? kind.poisson_drained : kind.poisson_undrained), origin});
  text.lines.push_back({"k0", fmt::format("{:g}", kind.k0), origin});
  text.lines.push_back(no_tension());
  return text;
}

}  // namespace terp
