#include "os/instructions.hpp"
#include "os/threads.hpp"

#include <algorithm>
#include <bit>
#include <cpuid.h>
#include <cstring>
#include <windows.h>

namespace terp {

int available_processors()
{
  DWORD_PTR ours = 0, all = 0;
  if (!GetProcessAffinityMask(GetCurrentProcess(), &ours, &all)) return 1;
  const int here = std::popcount(static_cast<unsigned long long>(ours));
  // A machine of more than 64 processors has several groups of them; the mask is then that of one group, or zero.
  const int groups = GetActiveProcessorGroupCount();
  return std::max(1, groups > 1 ? static_cast<int>(GetActiveProcessorCount(ALL_PROCESSOR_GROUPS)) : here);
}

/// As the processor calls itself: leaves 0x80000002 to 0x80000004.
std::string processor_name()
{
  if (__get_cpuid_max(0x80000000u, nullptr) < 0x80000004u) return {};
  char text[49] = {};
  for (unsigned int k = 0; k < 3; ++k) {
    unsigned int words[4] = {};
    __get_cpuid(0x80000002u + k, &words[0], &words[1], &words[2], &words[3]);
    std::memcpy(text + 16 * k, words, 16);
  }
  std::string name = text;
  name.erase(0, name.find_first_not_of(' '));
  name.erase(name.find_last_not_of(' ') + 1);
  return name + ", " + std::to_string(GetActiveProcessorCount(ALL_PROCESSOR_GROUPS)) + " processors";
}

}  // namespace terp
