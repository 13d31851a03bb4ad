// Stopping well on Ctrl-C, on the signals of batch systems, and when the terminal is closed, for all commands that
// solve.
#pragma once

#include <atomic>

namespace terp {

/// Becomes true with the first SIGINT (Ctrl-C), SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2 or SIGXCPU, and when the terminal is
/// closed (SIGHUP), unless the program was started with nohup. The run then ends after its step with a checkpoint. A
/// repeated signal belongs to the same request: SIGINT and SIGQUIT for 1 s, the others for 5 s after the first. A later
/// one ends the program at once, without a checkpoint; SIGXCPU and SIGHUP never do.
extern std::atomic<bool> stop_requested;

/// Listens to these signals from here on. A file that may grow no more (ulimit -f) is then an error of its write, like
/// a full disk; so is a pipe that nobody reads.
void listen_for_stop();

}  // namespace terp
