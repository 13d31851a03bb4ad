#include "simulation/flood_summary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace terp {

std::string flood_sentence(const FloodSummary& flood)
{
  const bool floods = flood.verdict == FloodVerdict::floods;
  const auto from = [](const char* what, const std::optional<Real>& time) {
    return time ? fmt::format(", {} {:.2f} s on", what, *time) : std::string();
  };
  const std::string verdict = std::string(info_of(flood.verdict).words);
  const std::string since = floods                                   ? from("from", flood.first_time_below)
                            : flood.verdict == FloodVerdict::damaged ? from("damaged from", flood.first_time_damaged)
                                                                     : "";
  if (!std::isfinite(flood.residual_height)) return fmt::format("{}{}: no ground remains.", verdict, since);
  const std::string width = flood.width_at_level > 0.0
                                ? fmt::format("; the ground is {:.2f} m wide there, {:.2f} m of it intact",
                                      flood.width_at_level, flood.intact_width)
                                : "";
  return fmt::format("{}{}: at the end the highest ground stands at {:.2f} m, {:.2f} m {} the water at {:.2f} m{}.",
      verdict, since, flood.residual_height, std::abs(flood.freeboard), flood.freeboard < 0.0 ? "below" : "above",
      flood.water_level, width);
}

}  // namespace terp
