#include "os/own_copy.hpp"

namespace terp {

std::string call_in_copy(const std::function<void(void* result)>& task, void* result, std::size_t, double)
{
  try {
    task(result);
  } catch (...) {  // as of a copy
  }
  return {};
}

bool is_copy() { return false; }

int fork_count() { return 0; }

}  // namespace terp
