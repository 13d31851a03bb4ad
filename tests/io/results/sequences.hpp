// Manufactured sequences: runs on several cells whose front stands for any measure.
#pragma once

#include "io/results/mesh_study.hpp"

#include <optional>
#include <vector>

namespace terp::test {

/// Reads front_x of the summary, whatever it stands for.
inline RunMeasure measure_of(MeasureKind kind)
{
  return {.name = "m", .label = "front", .unit = "m", .kind = kind, .value = [](const RunResults& run) {
            return std::optional(run.summary.values.front_x);
          }};
}

/// Runs on these cells with these values; NaN: the run does not have it.
inline std::vector<StudyRun> runs_with(const std::vector<Real>& cells, const std::vector<Real>& values)
{
  std::vector<StudyRun> runs;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    runs.push_back({.cell = cells[k], .size = cells[k], .folder = "cell"});
    runs.back().results.summary.values.front_x = values[k];
  }
  return runs;
}

inline StudyQuantity judged(
    const std::vector<Real>& cells, const std::vector<Real>& values, MeasureKind kind = MeasureKind::amount)
{
  return judge_sizes(measure_of(kind), runs_with(cells, values), 0.02);
}

}  // namespace terp::test
