#include "os/launcher.hpp"

#include <charconv>
#include <optional>
#include <string_view>

namespace terp {
namespace {

/// Names of variables; an mpirun within a job of Slurm sets its own, and they count first. Slurm gives the number of
/// tasks of a job to the batch script, too, which is one process: only that of a step is one of launched processes.
constexpr struct {
  const char *rank, *size, *job, *step;
} launchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE", ""},
    {"PMI_RANK", "PMI_SIZE", "PMI_JOBID", ""},
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_JOB_ID", "SLURM_STEP_ID"},
};

std::optional<int> number_in(const char* text)
{
  if (text == nullptr) return std::nullopt;
  const std::string_view word = text;
  int value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

Launched find_launch(const std::function<const char*(const char*)>& environment)
{
  const auto word = [&](const char* name) {
    const char* text = environment(name);
    return std::string(text != nullptr ? text : "");
  };
  for (const auto& launcher : launchers) {
    const auto rank = number_in(environment(launcher.rank)), size = number_in(environment(launcher.size));
    if (!rank || !size || *rank < 0 || *rank >= *size) continue;
    const std::string job = word(launcher.job);
    return {.rank = *rank, .size = *size, .job = job.empty() ? job : job + '.' + word(launcher.step)};
  }
  return {};
}

}  // namespace terp
