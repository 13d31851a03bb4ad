// Stopping well on Ctrl-C, for all commands that solve.
#pragma once

#include <atomic>

namespace terp {

/// Becomes true with the first Ctrl-C, or with the signal that systems send before they end a job; the second ends the program at once.
extern std::atomic<bool> stop_requested;

/// Listens to these signals from here on. A file that may grow no more (ulimit -f) is then an error of its write, like a full disk.
void listen_for_stop();

}  // namespace terp
