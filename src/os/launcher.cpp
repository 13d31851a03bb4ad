#include "os/launcher.hpp"

#include "math/errors.hpp"
#include "math/number_from.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

/// Names of variables; an mpirun within a job of Slurm sets its own, and they count first. Slurm gives the number of
/// tasks of a job to the batch script, too, which is one process: only that of a step is one of launched processes.
constexpr struct {
  const char *rank, *size;
} launchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
    {"PMI_RANK", "PMI_SIZE"},
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"},
};

/// Slurm numbers the tasks as the user asked: --array=3-9:2 has 3, 5, 7 and 9.
Launched place_in_array(int task, int n, int first, int step)
{
  const int place = step > 0 ? (task - first) / step : -1;
  if (place < 0 || place >= n || first + place * step != task)
    throw FileError(
        fmt::format("SLURM_ARRAY_TASK_ID is {}, of {} tasks: the array has gaps, and this task has no place in it\n"
                    "  Number the tasks evenly, as --array=1-{}, or say which part each makes: --part K/N",
            task, n, n));
  return {.rank = place, .size = n};
}

}  // namespace

Launched find_launch(const std::function<const char*(const char*)>& environment)
{
  const auto number = [&](const char* name) {
    const char* const text = environment(name);
    return text != nullptr ? number_from<int>(text) : std::nullopt;
  };
  Launched found;
  for (const auto& launcher : launchers) {
    const auto rank = number(launcher.rank), size = number(launcher.size);
    if (!rank || !size || *rank < 0 || *rank >= *size) continue;
    found = {.rank = *rank, .size = *size, .shares_machine = *size > 1, .is_silent = *rank > 0};
    break;
  }
  const auto task = number("SLURM_ARRAY_TASK_ID"), n = number("SLURM_ARRAY_TASK_COUNT");
  if (!task || !n) return found;
  const Launched array = place_in_array(
      *task, *n, number("SLURM_ARRAY_TASK_MIN").value_or(1), number("SLURM_ARRAY_TASK_STEP").value_or(1));
  found.rank += array.rank * found.size, found.size *= array.size;
  return found;
}

}  // namespace terp
