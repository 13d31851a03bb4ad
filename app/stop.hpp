// Stopping well on Ctrl-C, and when the terminal is closed, for all commands that solve.
#pragma once

#include <atomic>

namespace terp {

/// Becomes true with the first Ctrl-C, or with the signal that systems send before they end a job, of which the second
/// ends the program at once; and when the terminal is closed (SIGHUP), unless the program was started with nohup.
extern std::atomic<bool> stop_requested;

/// Listens to these signals from here on. A file that may grow no more (ulimit -f) is then an error of its write, like
/// a full disk; so is a pipe that nobody reads.
void listen_for_stop();

}  // namespace terp
