// Time for which a thread had a processor: what work costs, also where others use the machine.
// Not for: how long somebody waits (std::chrono::steady_clock).
#pragma once

namespace terp {

/// Of the calling thread since it began [s]; other threads that it waits for do not count.
double thread_seconds();

}  // namespace terp
