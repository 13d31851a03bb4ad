#include "os/thread_time.hpp"

#include <chrono>

namespace terp {

double thread_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace terp
