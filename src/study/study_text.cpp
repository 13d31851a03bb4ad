#include "study/study_text.hpp"

#include "study/fragility_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

std::string p_text(Real p) { return fmt::format("{:.3g}", p); }

std::string line_of_event(const char* name, const EventEstimate& e, const std::string& words)
{
  return fmt::format("  {:<8}{:<36}{} of {}  {}\n", name, estimate_text(e), e.happened, e.solved, words);
}

std::string rho(const std::optional<Real>& value) { return value ? fmt::format("{:+.2f}", *value) : "-"; }

std::string sensitivity_lines(const StudyEstimates& e)
{
  std::string out = "  what matters: rank correlation of inputs with a slide, and with the height that remains\n";
  for (const Sensitivity& s : e.sensitivities)
    out += fmt::format("    {:>6}{:>8}  {}\n", rho(s.with_slide), rho(s.with_height), s.input);
  return out;
}

std::string sweep_lines(const Study& study, const Realisations& rows, Index n)
{
  const auto names = study.input_names();
  std::string out = "  " + std::string("run");
  for (const std::string& name : names) out += "  " + name;
  out += "  slide  flood  slid m^2  remains m\n";
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    out += fmt::format("  {:>3}", k);
    for (std::size_t i = 0; i < names.size(); ++i)
      out += fmt::format("  {:>{}}", input_text(study, i, r.inputs[i]), names[i].size());
    out += r.solved() ? fmt::format("  {:>5}  {:>5}  {:>8.3g}  {:>9.4g}\n", r.slid ? "yes" : "no",
                            !r.judges_flood ? "-"
                            : r.flooded     ? "yes"
                                            : "no",
                            r.outcomes[outcome_number("slide_volume")], r.outcomes[outcome_number("residual_height")])
                      : "  " + r.fault + '\n';
  }
  return out;
}

std::string quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

std::string estimate_text(const EventEstimate& event)
{
  if (event.solved + event.failed == 0) return "-";
  const auto p = event.probability();
  return fmt::format("{}, {} to {}", p ? p_text(*p) : "-", p_text(event.bounds.low), p_text(event.bounds.high));
}

std::string slide_words(const StudySettings& s)
{
  return fmt::format("a slide: {:g} m^2 or more moved by more than {:g} m", s.event.volume, s.event.displacement);
}

std::string worth_of_residual_strength(const StudyEstimates& e)
{
  if (!e.judges_flood || e.slide.happened == 0) return "";
  const auto p = e.flood_after_slide.probability();
  return fmt::format(
      "Of 100 slides {:.0f} flood the land ({:.0f} to {:.0f}): that is what the residual strength is worth.",
      100.0 * p.value_or(0.0), 100.0 * e.flood_after_slide.bounds.low, 100.0 * e.flood_after_slide.bounds.high);
}

std::vector<std::string> remarks_on_study(const Study& study, const Realisations& rows, const StudyEstimates& e)
{
  std::vector<std::string> remarks;
  for (const FaultCount& fault : e.faults)
    remarks.push_back(fmt::format(
        "{} realisation{} failed, first {}: {}", fault.n, fault.n == 1 ? "" : "s", fault.first, fault.what));
  if (!e.faults.empty())
    remarks.push_back(
        "Failed realisations count in both bounds: as if nothing happened in the lower one, as if it did in "
        "the upper one.");
  if (!e.rule_met)
    remarks.push_back(
        fmt::format("The stop rule is not met yet: {} of at most {} realisations. The same command goes on.", e.n_made,
            study.n_realisations));
  if (e.n_beyond > 0)
    remarks.push_back(
        fmt::format("{} more realisations are solved, but lie behind a gap or behind the stop rule; they "
                    "are not in the table.",
            e.n_beyond));
  if (study.settings.estimator == Estimator::latin_hypercube)
    remarks.push_back(
        "The bounds are those of independent realisations. A Latin hypercube is usually better, never "
        "known to be: no bound is proven for it.");
  if (study.settings.fragility)
    for (std::string& remark : remarks_on_fragility(study, estimate_fragility(study, rows)))
      remarks.push_back(std::move(remark));
  if (!e.judges_flood) remarks.push_back("Nothing is said of a flood: the case has no water level (docs/flood.md).");
  return remarks;
}

std::string study_text(const Study& study, const Realisations& rows)
{
  const StudySettings& s = study.settings;
  const StudyEstimates e = estimate(study, rows);
  std::string out = fmt::format("{}: {} realisations, {} solved, {} failed, {:.2g} s each\n",
      s.title.empty() ? s.name : s.title, e.n_made, e.slide.solved, e.slide.failed, e.mean_wall_s);
  if (s.estimator == Estimator::sweep) {
    out += sweep_lines(study, rows, e.n_made);
  } else if (s.fragility) {
    out += fragility_text(study, estimate_fragility(study, rows)) + sensitivity_lines(e);
  } else {
    out += fmt::format("  probabilities with {:g} % bounds\n", 100.0 * s.confidence);
    out += line_of_event("P(I)", e.slide, slide_words(s));
    if (e.judges_flood) {
      out += line_of_event("P(F)", e.flood, flood_words);
      out += line_of_event("P(F|I)", e.flood_after_slide, "of the slides");
    }
    if (const std::string worth = worth_of_residual_strength(e); !worth.empty()) out += "  " + worth + '\n';
    out += sensitivity_lines(e);
  }
  for (const std::string& remark : remarks_on_study(study, rows, e)) out += "  note: " + remark + '\n';
  return out;
}

std::string study_csv(const Study& study, const Realisations& rows)
{
  bool met = false;
  const Index n = count_in_table(study, rows, met);
  std::string out = "realisation,solved,slide,flood";
  for (const std::string& name : study.input_names()) out += ',' + quoted(name);
  for (const OutcomeInfo& outcome : study_outcomes()) out += fmt::format(",{}", outcome.info.name);
  out += ",fault\n";
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    out += fmt::format("{},{:d},{:d},{}", k, r.solved(), r.slid, r.judges_flood ? (r.flooded ? "1" : "0") : "nan");
    for (std::size_t i = 0; i < r.inputs.size(); ++i)
      out += i < study.settings.sweep.size() ? ',' + quoted(input_text(study, i, r.inputs[i]))
                                             : fmt::format(",{}", r.inputs[i]);
    for (std::size_t i = 0; i < study_outcomes().size(); ++i)
      out += r.solved() ? fmt::format(",{}", r.outcomes[i]) : ",nan";
    out += ',' + (r.fault.empty() ? "" : quoted(r.fault)) + '\n';
  }
  return out;
}

}  // namespace terp
