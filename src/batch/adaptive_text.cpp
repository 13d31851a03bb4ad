// The realisations are no random sample, so P is never a share of them. An estimate has a lognormal distribution here,
// so its bounds are a factor about it. The design point comes in standard normal variables and is shown in the units of
// the keys.

#include "io/case/keys.hpp"
#include "model/soils/gaussian_field.hpp"
#include "batch/adaptive.hpp"
#include "batch/fragility.hpp"
#include "batch/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

const char* event_name(const Study& study) { return study.settings.adaptive.of_flood ? "P(F)" : "P(I)"; }

std::string result_words(const Study& study, const ReliabilityResult& r)
{
  if (r.probability == 0.0)
    return "not known: no place that the method tried hit the event" +
           (r.at_most < 1.0 ? fmt::format("; roughly, it is not above {:.2g}", r.at_most) : std::string());
  std::string text = fmt::format("{:.3g}, beta {:.3f}", r.probability, reliability_index(r.probability));
  if (const auto bounds = rough_bounds(study, r))
    text += fmt::format(", coefficient of variation {:.2g}, roughly {:.3g} to {:.3g} with {:g} % confidence", *r.cov,
        bounds->low, bounds->high, 100.0 * study.settings.confidence);
  return text;
}

std::string design_value(const Study& study, const std::vector<Real>& values, std::size_t k)
{
  const auto& [key, is_name, unit, path, distribution] = study.settings.numbers[k];
  return fmt::format("{} = {:.5g}{}", key, values[k], unit.empty() || unit == "-" ? "" : ' ' + unit);
}

std::string event_words(const Study& study)
{
  return study.settings.adaptive.of_flood ? flood_words : slide_words(study.settings);
}

}  // namespace

// ln P of a lognormal estimate has the variance ln(1 + cov^2); unlike a normal one it is never negative.
std::optional<Bounds> rough_bounds(const Study& study, const ReliabilityResult& r)
{
  if (!r.cov) return std::nullopt;
  const Real factor =
      std::exp(normal_quantile(0.5 + 0.5 * study.settings.confidence) * std::sqrt(std::log1p(*r.cov * *r.cov)));
  return Bounds{r.probability / factor, std::min(1.0, r.probability * factor)};
}

std::string adaptive_text(const Study& study, const Realisations& rows, const ReliabilityResult& r)
{
  std::string out = fmt::format("  {:<8}{}; {} realisations\n          {}\n", event_name(study), result_words(study, r),
      rows.size(), event_words(study));
  if (r.design_point.empty()) return out;
  out += "  design point, the most probable place of the event, and influence (squares of direction cosines)\n";
  const std::vector<Real> values = draw_at(study, r.design_point).inputs;
  for (std::size_t k = 0; k < values.size(); ++k)
    out += fmt::format("    {:>6.3f}  {}\n", r.importance[k], design_value(study, values, k));
  return out;
}

std::vector<std::string> remarks_on_adaptive(const Study& study, const Realisations& rows, const StudyEstimates& e)
{
  std::vector<std::string> remarks;
  const auto& r = e.adaptive.result;
  const std::int64_t n_known =
      study.settings.adaptive.of_flood ? e.counts.judged : e.counts.solved + e.counts.slid_as_drawn;
  if (const std::int64_t n = e.counts.n() - n_known; n > 0)
    remarks.push_back(fmt::format("Of {} realisations it is not known: each counts as the event.", n));
  if (!e.adaptive.fault.empty()) {
    remarks.push_back(e.adaptive.fault);
    return remarks;
  }
  if (!r) {
    remarks.push_back(
        fmt::format("The method is not at its end: {} realisations so far. The same command goes on.", rows.size()));
    return remarks;
  }
  remarks.emplace_back(info_of(study.settings.estimator).remark);
  if (!r->converged)
    remarks.emplace_back(
        "The search ended at a place that is not on the limit state: it is no design point. Give a larger `number` and "
        "begin anew (--force), or choose `subset`.");
  return remarks;
}

}  // namespace terp
