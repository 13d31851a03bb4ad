// How it thinks: one request may arrive as several signals. GNU `timeout` sends to its child and to the process group,
// a batch system warns, and sends SIGTERM after it; a person who presses Ctrl-C again after a second means it.

#include "os/stop.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace terp {

std::atomic<bool> stop_requested{false};

namespace {

constexpr int outputs[] = {STDOUT_FILENO, STDERR_FILENO};
bool is_terminal[std::size(outputs)] = {};

using Clock = std::chrono::steady_clock;  // a signal handler may read it
constexpr Clock::rep none = 0;
std::atomic<Clock::rep> first_request{none};
static_assert(std::atomic<Clock::rep>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

/// Within this time a signal belongs to the request before it: a person's on the keyboard, a system's.
constexpr Clock::duration same_press = std::chrono::seconds(1), same_request = std::chrono::seconds(5);

/// Time since the first request to stop; zero for the first.
Clock::duration since_first_request()
{
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep first = none;
  stop_requested.store(true);
  return Clock::duration(first_request.compare_exchange_strong(first, now) ? 0 : now - first);
}

void request_stop(int signal)
{
  const bool from_keyboard = signal == SIGINT || signal == SIGQUIT;
  if (since_first_request() < (from_keyboard ? same_press : same_request)) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // takes effect when this handler returns
}

/// Signals that come again by themselves: SIGXCPU every second beyond the limit of processor time.
void request_stop_only(int) { since_first_request(); }

/// The terminal was closed: what was to go there goes nowhere.
void stop_without_terminal(int)
{
  since_first_request();
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (std::size_t k = 0; k < std::size(outputs); ++k)
    if (is_terminal[k] && nowhere >= 0) ::dup2(nowhere, outputs[k]);
  std::signal(SIGHUP, SIG_IGN);  // the shell often sends it once more
}

}  // namespace

void listen_for_stop()
{
  std::transform(std::begin(outputs), std::end(outputs), is_terminal, [](int output) { return ::isatty(output) == 1; });
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2}) std::signal(signal, request_stop);
  std::signal(SIGXCPU, request_stop_only);
  if (std::signal(SIGHUP, stop_without_terminal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
}

}  // namespace terp
