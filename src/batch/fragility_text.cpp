// Each form has its own sign for what is not known: "-" in text, nan in the table, no point for D-Stability.
// D-Stability gets a curve only of a water level, so a key of the water must be the load itself. Remarks speak of what
// a curve takes for granted: that it rises, and that little comes from beyond its levels.

#include "batch/fragility_text.hpp"

#include "batch/study_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

std::string beta_text(const EventEstimate& e)
{
  const auto p = e.probability();
  return p ? fmt::format("{:.2f}", reliability_index(*p)) : "-";
}

std::string line_of_integral(const char* name, const CurveIntegral& i)
{
  return fmt::format("  {:<8}{:.3g}; straight between levels, level beyond {:.3g} to {:.3g}; {}\n", name, i.probability,
      i.of_line.low, i.of_line.high,
      i.rising ? fmt::format("never falling {:.3g} to {:.3g}", i.rising->low, i.rising->high)
               : "no bounds of a curve that never falls");
}

std::string distribution_words(const FragilityLoad& load)
{
  const Distribution& d = *load.distribution;
  return fmt::format("{} distribution with 50 % {:.4g}, 90 % {:.4g}, 99 % {:.4g}",
      all_distributions()[static_cast<std::size_t>(d.kind)].name, d.quantile(0.5), d.quantile(0.9), d.quantile(0.99));
}

std::string csv_of(const EventEstimate& e)
{
  const auto p = e.probability();
  return p ? fmt::format(",{},{},{},{}", *p, e.bounds.low, e.bounds.high, reliability_index(*p)) : ",nan,nan,nan,nan";
}

void add_remarks(const FragilityLoad& load, const char* name, const std::optional<CurveIntegral>& i,
    std::vector<std::string>& remarks)
{
  constexpr Real much = 0.1;
  if (!i) return;
  const auto share = [](Real part, Real all) { return all > 0.0 ? part / all : 0.0; };
  const Real of_p = share(i->beyond, i->probability), of_most = share(i->beyond_at_most, i->of_line.high);
  if (std::max(of_p, of_most) > much)
    remarks.push_back(
        fmt::format("{:.0f} % of {}, and {:.0f} % of its upper bound, come from loads beyond {:g} to {:g}, where the "
                    "curve is not known and is taken as at its ends. Add levels there.",
            100.0 * of_p, name, 100.0 * of_most, load.levels.front(), load.levels.back()));
  if (!i->rising)
    remarks.push_back(fmt::format(
        "{} is lower at a higher level, by more than chance: a curve that never falls has no bounds here.", name));
}

void add_falling(Index n, const char* what, std::vector<std::string>& remarks)
{
  if (n > 0)
    remarks.push_back(fmt::format(
        "In {} case{} the same sample {} at one level and does not at a higher one: the curve need not rise, "
        "and the bounds of a curve that never falls do not hold.",
        n, n == 1 ? "" : "s", what));
}

bool has_finite_index(const EventEstimate& e)
{
  const auto p = e.probability();
  return p && *p > 0.0 && *p < 1.0;
}

void add_left_out(const FragilityCurve& curve, std::vector<std::string>& remarks)
{
  const auto n_without = [&](EventEstimate LevelEstimate::*event) {
    return std::ranges::count_if(curve.levels, [&](const LevelEstimate& at) { return !has_finite_index(at.*event); });
  };
  const auto slides = n_without(&LevelEstimate::slide),
             floods = curve.judges_flood ? n_without(&LevelEstimate::flood) : 0;
  if (slides + floods > 0)
    remarks.push_back(fmt::format(
        "Where nothing happened, or all, beta is not finite: the curve for D-Stability lacks {} of {} levels for I{}.",
        slides, curve.levels.size(), curve.judges_flood ? fmt::format(", {} for F", floods) : ""));
}

/// The formula is the load, here or as a coordinate, and nothing made of it, as a rise or a freeboard would be.
bool has_load_itself(const Node& value)
{
  return (value.kind == NodeKind::text && value.text == "h") || std::ranges::any_of(value.items, has_load_itself);
}

}  // namespace

bool is_water_level(const FragilityLoad& load)
{
  const auto is_of_water = [](const auto& change) {
    return (change.first.starts_with("water.") || change.first == "flood.water_level") &&
           has_load_itself(change.second);
  };
  return load.unit == "m" && std::ranges::any_of(load.set, is_of_water);
}

std::string fragility_text(const Study& study, const FragilityCurve& curve)
{
  const FragilityLoad& load = *study.settings.fragility;
  std::string out = fmt::format(
      "  {}, at each level, with {:g} % bounds; beta = -Phi^-1(P)\n", load.label(), 100.0 * study.settings.confidence);
  out += fmt::format(
      "  {:>9}  {:<28}{:>6}  {:<28}{:>6}  {}\n", load.name.substr(0, 9), "P(I)", "beta", "P(F)", "beta", "P(F|I)");
  for (const LevelEstimate& at : curve.levels)
    out += fmt::format("  {:>9.5g}  {:<28}{:>6}  {:<28}{:>6}  {}\n", at.level, estimate_text(at.slide),
        beta_text(at.slide), estimate_text(at.flood), beta_text(at.flood), estimate_text(at.flood_after_slide));
  if (!curve.slide) return out;
  out += fmt::format("  over the {}\n", distribution_words(load)) + line_of_integral("P(I)", *curve.slide);
  if (curve.flood) out += line_of_integral("P(F)", *curve.flood);
  return out;
}

std::vector<std::string> remarks_on_fragility(const Study& study, const FragilityCurve& curve)
{
  std::vector<std::string> remarks;
  const FragilityLoad& load = *study.settings.fragility;
  add_falling(curve.n_falling_slides, "slides", remarks);
  add_falling(curve.n_falling_floods, "floods the land", remarks);
  add_remarks(load, "P(I)", curve.slide, remarks);
  add_remarks(load, "P(F)", curve.flood, remarks);
  if (is_water_level(load)) add_left_out(curve, remarks);
  return remarks;
}

std::string fragility_csv(const Study& study, const FragilityCurve& curve)
{
  const FragilityLoad& load = *study.settings.fragility;
  std::vector<Real> weights(load.levels.size(), std::nan(""));
  if (load.distribution) weights = level_weights(load.levels, *load.distribution);
  std::string out = "level,solved,failed,slides,floods";
  for (const char* event : {"I", "F", "F_after_I"}) out += fmt::format(",P_{0},P_{0}_low,P_{0}_high,beta_{0}", event);
  out += ",weight\n";
  for (std::size_t k = 0; k < curve.levels.size(); ++k) {
    const LevelEstimate& at = curve.levels[k];
    out += fmt::format("{},{},{},{},{}", at.level, at.slide.solved, at.slide.failed, at.slide.happened,
        curve.judges_flood ? fmt::format("{}", at.flood.happened) : "nan");
    out += csv_of(at.slide) + csv_of(at.flood) + csv_of(at.flood_after_slide) + fmt::format(",{}\n", weights[k]);
  }
  return out;
}

std::string continu_inzicht_csv(const FragilityCurve& curve, bool of_flood)
{
  std::string out = "section_id,failuremechanism_id,measure_id,hydraulicload,failure_probability\n";
  Real largest = 1e-200;
  for (const LevelEstimate& at : curve.levels) {
    const auto p = (of_flood ? at.flood : at.slide).probability();
    if (!p) continue;
    largest = std::max(largest, *p);
    out += fmt::format("0,0,0,{},{}\n", at.level, largest);
  }
  return out;
}

std::string dstability_curve(const Study& study, const FragilityCurve& curve, bool of_flood)
{
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const LevelEstimate& at : curve.levels) {
    const EventEstimate& e = of_flood ? at.flood : at.slide;
    if (!has_finite_index(e)) continue;
    points.push_back({{"Label", fmt::format("{} {:g}, {} of {}{}", study.settings.fragility->name, at.level, e.happened,
                                    e.solved, e.failed > 0 ? fmt::format(", {} unknown", e.failed) : "")},
        {"Beta", reliability_index(*e.probability())}, {"WaterLevel", at.level},
        {"Contributions", nlohmann::ordered_json::array()}});
  }
  return nlohmann::ordered_json{{"Calculations", points}, {"Stochasts", nlohmann::ordered_json::array()},
             {"Correlations", nlohmann::ordered_json::array()}}
             .dump(2) +
         '\n';
}

}  // namespace terp
