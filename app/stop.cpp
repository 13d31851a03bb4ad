#include "stop.hpp"

#include <csignal>

namespace terp {

std::atomic<bool> stop_requested{false};

namespace {

void request_stop(int signal)
{
  stop_requested.store(true);
  std::signal(signal, SIG_DFL);
}

}  // namespace

void listen_for_stop()
{
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

}  // namespace terp
