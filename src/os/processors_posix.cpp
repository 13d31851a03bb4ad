#include "os/instructions.hpp"
#include "os/threads.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sched.h>

namespace terp {
namespace {

/// Processors that the control group grants (cgroup v2), or a large number.
int control_group_processors()
{
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  std::string quota;
  double period = 0.0;
  if (!(file >> quota >> period) || quota == "max" || period <= 0.0) return 1 << 20;
  return std::max(1, static_cast<int>(std::lround(std::stod(quota) / period)));
}

}  // namespace

int available_processors()
{
  cpu_set_t set;
  CPU_ZERO(&set);
  int allowed = static_cast<int>(std::thread::hardware_concurrency());
  if (sched_getaffinity(0, sizeof set, &set) == 0) allowed = CPU_COUNT(&set);
  return std::max(1, std::min(allowed, control_group_processors()));
}

std::string processor_name()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t name = line.find_first_not_of(" \t", line.find(':') + 1);
    if (name == std::string::npos) break;
    return line.substr(name) + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors";
  }
  return {};
}

}  // namespace terp
