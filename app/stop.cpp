#include "stop.hpp"

#include <algorithm>
#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace terp {

std::atomic<bool> stop_requested{false};

namespace {

constexpr int outputs[] = {STDOUT_FILENO, STDERR_FILENO};
bool is_terminal[std::size(outputs)] = {};

void request_stop(int signal)
{
  stop_requested.store(true);
  std::signal(signal, SIG_DFL);
}

/// The terminal was closed: what was to go there goes nowhere. The shell often sends the signal once more: that one is
/// not heard.
void stop_without_terminal(int)
{
  stop_requested.store(true);
  std::signal(SIGHUP, SIG_IGN);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (std::size_t k = 0; k < std::size(outputs); ++k)
    if (is_terminal[k] && nowhere >= 0) ::dup2(nowhere, outputs[k]);
}

}  // namespace

void listen_for_stop()
{
  std::transform(std::begin(outputs), std::end(outputs), is_terminal, [](int output) { return ::isatty(output) == 1; });
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  if (std::signal(SIGHUP, stop_without_terminal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
}

}  // namespace terp
