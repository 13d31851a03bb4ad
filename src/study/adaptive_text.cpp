// What a method found, in words. Not for: how it is replayed (adaptive.cpp).

#include "report/plain_page.hpp"
#include "simulation/gaussian_field.hpp"
#include "study/adaptive.hpp"
#include "study/fragility.hpp"
#include "study/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

const char* event_name(const Study& study) { return study.settings.adaptive.of_flood ? "P(F)" : "P(I)"; }

/// Of the normal distribution that the estimate has in the limit of many places.
std::optional<Bounds> rough_bounds(const Study& study, const ReliabilityResult& r)
{
  if (!r.cov) return std::nullopt;
  const Real half = normal_quantile(0.5 + 0.5 * study.settings.confidence) * *r.cov * r.probability;
  return Bounds{std::max(0.0, r.probability - half), std::min(1.0, r.probability + half)};
}

std::string result_words(const Study& study, const ReliabilityResult& r)
{
  std::string text = fmt::format("{:.3g}, beta {:.3f}", r.probability, reliability_index(r.probability));
  if (const auto bounds = rough_bounds(study, r))
    text +=
        fmt::format(", coefficient of variation {:.2g}, roughly {:.3g} to {:.3g}", *r.cov, bounds->low, bounds->high);
  return text;
}

/// The number at a coordinate of the design point.
std::string design_value(const Study& study, const std::vector<Real>& values, std::size_t k)
{
  return fmt::format("{} = {:.5g}", study.settings.numbers[k].key, values[k]);
}

}  // namespace

std::string adaptive_text(const Study& study, const Realisations& rows, const ReliabilityResult& r)
{
  std::string out = fmt::format("  {:<8}{}; {} realisations\n", event_name(study), result_words(study, r), rows.size());
  if (r.design_point.empty()) return out;
  out += "  design point, the most probable place of the event, and influence (squares of direction cosines)\n";
  const std::vector<Real> values = draw_at(study, r.design_point).inputs;
  for (std::size_t k = 0; k < values.size(); ++k)
    out += fmt::format("    {:>6.3f}  {}\n", r.importance[k], design_value(study, values, k));
  return out;
}

std::vector<std::string> remarks_on_adaptive(
    const Study& study, const Realisations& rows, const std::optional<ReliabilityResult>& r)
{
  std::vector<std::string> remarks;
  const auto has_none = [](const auto& row) { return !row.second.solved(); };
  if (const auto first = std::ranges::find_if(rows, has_none); first != rows.end())
    remarks.push_back(fmt::format("{} realisations have no result; each counts as the event. The first: {}",
        std::ranges::count_if(rows, has_none), first->second.fault));
  if (!r) {
    remarks.push_back(
        fmt::format("The method is not at its end: {} realisations so far. The same command goes on.", rows.size()));
    return remarks;
  }
  remarks.emplace_back(info_of(study.settings.estimator).remark);
  if (!r->converged)
    remarks.emplace_back(
        "The search ended at a place that is not on the limit state: it is no design point. Give a larger `number`, or "
        "choose `subset`.");
  return remarks;
}

std::string adaptive_section(const Study& study, const std::optional<ReliabilityResult>& r)
{
  if (!r) return "";
  std::string out =
      "<section><h2>Probability</h2>\n" +
      html_cell("p", fmt::format("{} = {}.", event_name(study), result_words(study, *r)), " class=\"answer\"");
  if (r->design_point.empty()) return out + "</section>\n";
  out += "\n<div class=\"scroll\"><table><thead><tr>" + html_cell("th", "design point") + html_cell("th", "influence") +
         "</tr></thead>\n<tbody>";
  const std::vector<Real> values = draw_at(study, r->design_point).inputs;
  for (std::size_t k = 0; k < values.size(); ++k)
    out += "<tr>" + html_cell("th", design_value(study, values, k)) +
           html_cell("td", fmt::format("{:.3f}", r->importance[k])) + "</tr>\n";
  return out + "</tbody></table></div></section>\n";
}

}  // namespace terp
