#include "os/thread_time.hpp"

#include <windows.h>

namespace terp {

double thread_seconds()
{
  FILETIME begin{}, end{}, kernel{}, user{};
  GetThreadTimes(GetCurrentThread(), &begin, &end, &kernel, &user);
  constexpr double unit = 1e-7;  // s
  const auto seconds = [](const FILETIME& t) {
    return unit * (4294967296.0 * static_cast<double>(t.dwHighDateTime) + static_cast<double>(t.dwLowDateTime));
  };
  return seconds(kernel) + seconds(user);
}

}  // namespace terp
