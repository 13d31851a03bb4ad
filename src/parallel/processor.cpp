#include "parallel/processor.hpp"

#include <fstream>
#include <thread>

namespace terp {

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
