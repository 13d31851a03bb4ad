#include "simulation/verdict_words.hpp"

#include <fmt/format.h>

namespace terp {

std::string verdict_clause(const Summary& summary)
{
  const FloodSummary& flood = *summary.flood;
  const std::optional<Real> since = flood.first_time_below ? flood.first_time_below : flood.first_time_damaged;
  std::string words = flood_clause(flood);
  for (std::size_t k = 0; since && k < summary.stages.size(); ++k) {
    const StageSummary& stage = summary.stages[k];
    if (stage.name.empty() || !(*since > stage.record.start) || *since > stage.record.end) continue;  // NaN: it runs
    words += fmt::format("; it began in the stage `{}`", stage.name);
    if (k + 1 < summary.stages.size()) words += fmt::format(", before `{}`", summary.stages.back().name);
    break;
  }
  return words;
}

}  // namespace terp
