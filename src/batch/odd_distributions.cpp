#include "batch/odd_distributions.hpp"

#include "io/case/units.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// A standard deviation given as a coefficient of variation, and bounds that cut off most of what they bound.
void doubt_numbers(const Study& study, std::vector<Problem>& doubts)
{
  constexpr Real little = 0.005;  // soil: 0.05 to 0.5
  for (const RandomNumber& number : study.settings.numbers) {
    const Distribution& d = number.distribution;
    const std::string key = join_path(number.path, number.is_name ? "name" : "key");
    const bool has_spread = d.kind == DistributionKind::normal || d.kind == DistributionKind::lognormal ||
                            d.kind == DistributionKind::truncated_normal;
    if (has_spread && d.sd < little * std::abs(d.mean))
      doubts.push_back({key, fmt::format("`{}` hardly varies", number.key),
          fmt::format("Its standard deviation is {:.3g}, its mean {:.4g}. `sd` has the unit of the mean; a coefficient "
                      "of variation is `cov`.",
              d.sd, d.mean),
          ""});
    if (d.kind == DistributionKind::lognormal && d.sd > d.mean)
      doubts.push_back({key, fmt::format("the standard deviation of `{}` is more than its mean", number.key),
          fmt::format(
              "Its standard deviation is {:.4g}, its mean {:.4g}. `cov` is a share: 35 % is 0.35.", d.sd, d.mean),
          ""});
    constexpr Real hardly = 1e-4;
    const Node* own = number.is_name || !has_spread ? nullptr : find_node(study.base.source.root, number.key);
    const auto quantity = own != nullptr && own->kind == NodeKind::text ? parse_quantity(own->text) : std::nullopt;
    const Real of_case = own == nullptr                                                    ? NAN
                         : own->kind == NodeKind::number || own->kind == NodeKind::integer ? own->number
                         : quantity && quantity->unit                                      ? quantity->value()
                                                                                           : NAN;
    const bool varies = d.kind != DistributionKind::truncated_normal && d.sd >= little * std::abs(d.mean);
    if (const Real p = std::isnan(of_case) || !varies ? 0.5 : d.probability(of_case); std::min(p, 1.0 - p) < hardly)
      doubts.push_back({key, fmt::format("`{}` is hardly drawn where the case has it", number.key),
          fmt::format(
              "The case gives {:.4g}, the median of what is drawn is {:.4g}. Have both the same meaning and unit?",
              of_case, d.quantile(0.5)),
          ""});
    constexpr Real decades = 100.0;
    if (d.kind == DistributionKind::uniform && d.lowest > 0.0 && d.highest > decades * d.lowest)
      doubts.push_back(
          {key, fmt::format("the bounds of `{}` differ by a factor of {:.2g}", number.key, d.highest / d.lowest),
              fmt::format("Got {:.4g} and {:.4g}. Have both the same unit?", d.lowest, d.highest), ""});
    if (d.kind != DistributionKind::truncated_normal || !(d.sd > 0.0)) continue;
    const Real kept = normal_probability((d.highest - d.mean) / d.sd) - normal_probability((d.lowest - d.mean) / d.sd);
    if (kept < 0.5)
      doubts.push_back({key, fmt::format("the bounds cut off most of `{}`", number.key),
          fmt::format(
              "{:.2g} of the normal distribution with mean {:.4g} lies between them. The mean is that before the "
              "cut.",
              kept, d.mean),
          ""});
  }
}

/// Levels of a load that hardly comes, or that nearly always stands above them.
void doubt_levels(const Study& study, std::vector<Problem>& doubts)
{
  constexpr Real most_beyond = 0.1, least_within = 1e-6;
  constexpr Real little = 1e-3;  // of the largest level
  const auto& load = study.settings.fragility;
  if (!load) return;
  for (std::size_t k = 1; k < load->levels.size(); ++k) {
    const Real low = load->levels[k - 1], high = load->levels[k];
    if (high - low >= little * std::max(std::abs(load->levels.front()), std::abs(load->levels.back()))) continue;
    doubts.push_back({"fragility.levels", "two levels hardly differ",
        fmt::format("Got {:.10g} and {:.10g}. Each is solved with all samples: give levels between which P changes.",
            low, high),
        ""});
    break;
  }
  if (!load->distribution) return;
  const Real first = load->levels.front(), last = load->levels.back(),
             beyond = 1.0 - load->distribution->probability(last),
             within = 1.0 - load->distribution->probability(first);
  if (beyond > most_beyond)
    doubts.push_back({"fragility.distribution", "much of the load lies above the last level",
        fmt::format(
            "It exceeds {:g} with probability {:.2g}. P is taken as constant there: give higher levels, or correct "
            "the distribution.",
            last, beyond),
        ""});
  else if (within < least_within)
    doubts.push_back({"fragility.distribution", "the load hardly reaches the first level",
        fmt::format(
            "It exceeds {:g} with probability {:.2g}. Give lower levels, or correct the distribution.", first, within),
        ""});
}

/// The same parameter of two soils, one of which is strong where the other is weak.
void doubt_correlations(const Study& study, std::vector<Problem>& doubts)
{
  const auto parameter = [](const std::string& key) {  // without the name of the material; empty: none
    const auto at = key.starts_with("material.") ? key.find('.', 9) : std::string::npos;
    return at == std::string::npos ? std::string() : key.substr(at);
  };
  for (const StudyCorrelation& c : study.settings.correlations)
    if (c.value < 0.0 && c.a != c.b && !parameter(c.a).empty() && parameter(c.a) == parameter(c.b))
      doubts.push_back({join_path(c.path, "value"), fmt::format("`{}` and `{}` go against each other", c.a, c.b),
          fmt::format(
              "Got {:g}. Layers of one section vary together, or on their own: such correlations are 0 to 1.", c.value),
          ""});
}

}  // namespace

void doubt_distributions(const Study& study, std::vector<Problem>& doubts)
{
  doubt_numbers(study, doubts);
  doubt_levels(study, doubts);
  doubt_correlations(study, doubts);
}

}  // namespace terp
