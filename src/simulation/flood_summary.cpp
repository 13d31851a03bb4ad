#include "simulation/flood_summary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace terp {

void withhold_verdict(FloodSummary& flood)
{
  if (flood.verdict != FloodVerdict::floods) flood.verdict.reset();
}

std::string flood_clause(const FloodSummary& flood)
{
  const bool floods = flood.verdict == FloodVerdict::floods;
  const auto from = [](const char* what, const std::optional<Real>& time) {
    return time ? fmt::format(", {} {:.2f} s on", what, *time) : std::string();
  };
  const std::string verdict(flood.verdict ? info_of(*flood.verdict).words : "no verdict before the end of the run");
  const std::string since =
      floods ? from("from", flood.first_time_below) : from("damaged from", flood.first_time_damaged);
  if (!std::isfinite(flood.residual_height)) return fmt::format("{}{}: no ground remains", verdict, since);
  const std::string width = flood.width_at_level > 0.0
                                ? fmt::format("; the ground is {:.2f} m wide there, {:.2f} m of it intact",
                                      flood.width_at_level, flood.intact_width)
                                : "";
  return fmt::format("{}{}: {} the highest ground stands at {:.2f} m, {:.2f} m {} the water at {:.2f} m{}", verdict,
      since, flood.verdict ? "at the end" : "so far", flood.residual_height, std::abs(flood.freeboard),
      flood.freeboard < 0.0 ? "below" : "above", flood.water_level, width);
}

}  // namespace terp
